"""A returned practice: its code decoded, the scene drawn again with its numbers, its answers judged again."""

import base64
import json
import math
from collections.abc import Callable, Mapping
from pathlib import Path

from planes.geometry.plane import corners
from planes.lesson.live import Live
from planes.lesson.practice import JUDGING, goal
from planes.lesson.told import Told
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import frozen
from planes.words.names import mu_of, plan_of
from planes.words.records import Json

Numbers = Mapping[str, complex]  # marks and values of the lesson's tape
Given = Mapping[str, float]
HEAD, LARGEST = "planes-practice", 200_000


@frozen
class HandedPractice:
    """The contents of a code, judged again: whose it is, with which numbers, how many answers were right at the first
    attempt."""

    name: str
    seed: int
    right: int
    count: int


def read_code(file: str) -> Json:
    """The contents of a practice file; :class:`PlanesError` for a damaged or foreign file."""
    try:
        text = Path(file).read_bytes()[:LARGEST].decode().strip()
        head, letters, total = text.split(".")
        data = base64.urlsafe_b64decode(letters + "=" * (-len(letters) % 4))
        practice: Json = json.loads(data)
        good = (
            head == HEAD
            and total == f"{checksum(data):08x}"
            and isinstance(practice["answers"], list)
            and all(isinstance(practice[key], int) for key in ("seed", "right"))
            and isinstance(practice["name"], str)
            and all(isinstance(mu, (int, float)) and mu > 0 for mu in practice.setdefault("scales", {}).values())
        )
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        good = False
    if not good:
        raise PlanesError(Phrase("practice_damaged", file=file))
    return practice


def checksum(data: bytes) -> int:
    """Detects copying errors (FNV-1a)."""
    total = 2166136261
    for byte in data:
        total = (total ^ byte) * 16777619 & 0xFFFFFFFF
    return total


def random(seed: int) -> Callable[[], float]:
    """A stream of numbers from 0 to 1, identical to that of a page (mulberry32)."""
    state = seed & 0xFFFFFFFF

    def draw() -> float:
        nonlocal state
        state = state + 0x6D2B79F5 & 0xFFFFFFFF
        t = (state ^ state >> 15) * (state | 1) & 0xFFFFFFFF
        t ^= t + ((t ^ t >> 7) * (t | 61) & 0xFFFFFFFF) & 0xFFFFFFFF
        return ((t ^ t >> 14) & 0xFFFFFFFF) / 4294967296

    return draw


class PracticeJudge:
    """Judges the practices of one scene."""

    def __init__(self, lesson: Told) -> None:
        self.told, self.items, self.home = lesson, lesson.practice.items(), lesson.knobs.home
        self.live = Live(lesson)
        self.things = {f"{group} {n}": z for group, own in self.live.things.items() for n, z in own.items()}
        self.marks = [f"marks {item['what']}" for item in self.items if item["kind"] == "mark"]
        self.slips = [(f"marks {slip['at']}", f"slips {k}") for k, slip in enumerate(self.live.slips)]

    def judged(self, file: str) -> HandedPractice:
        """The practice, judged; :class:`PlanesError` where a file is damaged, belongs to another scene, or contradicts
        its answers."""
        practice = read_code(file)
        if practice["id"] != self.told.practice.id or len(practice["answers"]) != len(self.items):
            raise PlanesError(Phrase("practice_other_scene", file=file, scene=self.told.scene.file))
        given = self.fresh(practice["seed"]) if practice["seed"] else self.home
        right, numbers = 0, self.live.numbers_of(self.things, given)
        for item, answer in zip(self.items, practice["answers"], strict=True):
            right += self.right(item, answer, numbers, given)
            scale = practice["scales"].get(item["what"]) if item["kind"] == "mu" else None
            if scale is not None and self.right(item, scale, numbers, given):
                given = self.drawn_at(item["what"], scale, given)
                numbers = self.live.numbers_of(self.things, given)
        if right != practice["right"]:
            names = {"file": file, "said": str(practice["right"]), "right": str(right)}
            raise PlanesError(Phrase("practice_altered", **names, count=str(len(self.items))))
        return HandedPractice(practice["name"], practice["seed"], right, len(self.items))

    def right(self, item: Json, answer: object, numbers: Numbers, given: Given) -> bool:
        """Whether an answer is right, by the rule of the page."""
        what, kind = item["what"], item["kind"]
        if kind == "known":
            return answer == goal(self.told.equations[what])
        if kind == "mark":
            match answer:
                case [int() | float() as x, int() | float() as y]:
                    return abs(complex(x, y) - numbers[f"marks {what}"]) <= self.fits(f"marks {what}", numbers)
            return False
        if kind in ("order", "reason", "first"):
            return any(one["value"] == answer and "why" not in one for one in item["offered"])
        if not isinstance(answer, (int, float)):
            return False
        if kind == "mu":
            return self.holds(item, float(answer), numbers, given)
        value = numbers[f"values {what}"].real
        if kind == "sense":
            return answer == math.copysign(1, value)
        ruler = JUDGING["ruler_mm"] / given[item["mu"]] if item["mu"] else 0.0
        off = answer - value if "signed" in item else abs(answer) - abs(value)
        return bool(abs(off) <= max(JUDGING["number_share"] * abs(value), ruler))

    def holds(self, item: Json, scale: float, numbers: Numbers, given: Given) -> bool:
        """Whether a plan fits its place at a scale, and can be measured as well as at that of the lesson."""
        mu, places = mu_of(item["what"]), [numbers[f"marks {m}"] for m in item["marks"]]
        places = [z for z in places if z == z] + [0j] * (item["what"] != "position")
        across = corners(places)[1] - corners(places)[0] if places else complex(math.nan, math.nan)
        size = max(across.real, across.imag) / given[mu]
        own, least = size * self.home[mu], JUDGING["ruler_mm"] / JUDGING["number_share"]
        return bool(min(least, own / 2) <= size * scale <= max(item["most"], own))

    def drawn_at(self, plan: str, scale: float, given: Given) -> dict[str, float]:
        """The numbers with a plan's scale, and with the scales tied to it."""
        times, tied = scale / given[mu_of(plan)], [k["tied"] for k in self.told.knobs.all if k["given"] == mu_of(plan)]
        return {**given, mu_of(plan): scale, **{n: given[n] * times for names in tied for n in names}}

    def fits(self, mark: str, numbers: Numbers) -> float:
        """The tolerance of a mark, mm: closer to its place than to any mistake, within the limits of a hand."""
        wide = max(JUDGING["fits_mm"], JUDGING["fits_share"] * self.size(plan_of(mark), numbers))
        wrong = (abs(numbers[slip] - numbers[mark]) for at, slip in self.slips if at == mark)
        nearest = min((off for off in wrong if off == off), default=math.inf)
        return float(max(JUDGING["least_mm"], min(wide, nearest / 2)))

    def size(self, plan: str, numbers: Numbers) -> float:
        """The size of a plan: the distance of its farthest mark, mm."""
        return max((abs(numbers[m]) for m in self.marks if plan_of(m) == plan), default=0.0)

    def fresh(self, seed: int) -> dict[str, float]:
        """The numbers for a seed; :class:`PlanesError` where there are none."""
        plans = [f"marks {p}" for p in self.told.plans.drawn if p != "motion"]
        home = self.live.numbers_of(self.things, self.home)
        sizes, sharp = [self.size(p, home) for p in plans], _bluntest(home)
        for k in range(JUDGING["draws"]):
            given = self.drawn(random(seed * JUDGING["draws"] + k))
            now = self.live.numbers_of(self.things, given)
            holds = all(now[n].real for n in now if n.startswith("holds "))
            near = all(0.5 * s <= self.size(p, now) <= 1.8 * s for p, s in zip(plans, sizes, strict=True))
            if holds and near and not _bluntest(now) < 0.5 * sharp:
                return given
        raise PlanesError(Phrase("practice_other_scene", file=str(seed), scene=self.told.scene.file))

    def drawn(self, draw: Callable[[], float]) -> dict[str, float]:
        """Numbers near the scene's own."""
        given, drive = dict(self.home), self.told.drive
        for knob in self.told.knobs.all:
            name = knob["given"]
            if "plan" not in knob and "stays" not in knob:
                given[name] = float(f"{knob['at'] * (1 + JUDGING['fresh'] * (2 * draw() - 1)):.3g}")
        if not drive["held"]:
            turn, reach = 2 * draw() - 1, drive["to"] - drive["from"]
            turned = math.floor(drive["at"] + JUDGING["swing"] * turn + 0.5)
            given[drive["given"]] = (
                turned if drive["symbol"] == "φ" else float(f"{drive['at'] + reach / 20 * turn:.3g}")
            )
        return given


def _bluntest(numbers: Numbers) -> float:
    return min((z.real for n, z in numbers.items() if n.startswith("sharp ")), default=math.inf)
