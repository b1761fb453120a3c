"""A returned practice: its code decoded, the scene drawn again with its numbers, its answers judged again."""

import base64
import json
import math
from collections.abc import Callable, Mapping
from pathlib import Path

from planes.geometry.plane import bounding_corners
from planes.lesson.live import Live
from planes.lesson.practice import JUDGING_TOLERANCES, known_data_digits
from planes.lesson.told import SceneLesson
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import frozen
from planes.words.names import Mark, NumbersByName, PlanId
from planes.words.records import Json

Numbers = Mapping[str, complex]  # marks and values of the lesson's tape
Given = Mapping[str, float]
CODE_HEAD = "planes-practice"
MOST_FILE_BYTES = 200_000


@frozen
class HandedPractice:
    """The contents of a code, judged again: whose it is, with which numbers, how many answers were right at the first
    attempt."""

    name: str
    seed: int
    right: int
    count: int


def read_practice_file(file: str) -> Json:
    """The contents of a practice file; :class:`PlanesError` for a damaged or foreign file."""
    try:
        text = Path(file).read_bytes()[:MOST_FILE_BYTES].decode().strip()
        head, letters, total = text.split(".")
        data = base64.urlsafe_b64decode(letters + "=" * (-len(letters) % 4))
        practice: Json = json.loads(data)
        good = (
            head == CODE_HEAD
            and total == f"{fnv_checksum(data):08x}"
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


def fnv_checksum(data: bytes) -> int:
    """Detects copying errors (FNV-1a)."""
    total = 2166136261
    for byte in data:
        total = (total ^ byte) * 16777619 & 0xFFFFFFFF
    return total


def random_stream(seed: int) -> Callable[[], float]:
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

    def __init__(self, lesson: SceneLesson) -> None:
        self.told = lesson
        self.items = lesson.practice.practice_items()
        self.home = lesson.knobs.values_in_scene
        self.live = Live(lesson)
        self.things = {f"{group} {n}": z for group, own in self.live.things.items() for n, z in own.items()}
        self.marks = [item["what"] for item in self.items if item["kind"] == "mark"]
        self.slips = [(slip["at"], f"slips {k}") for k, slip in enumerate(self.live.slips)]

    def judge_file(self, file: str) -> HandedPractice:
        """The practice, judged; :class:`PlanesError` where a file is damaged, belongs to another scene, or contradicts
        its answers."""
        practice = read_practice_file(file)
        if practice["id"] != self.told.practice.practice_id or len(practice["answers"]) != len(self.items):
            raise PlanesError(Phrase("practice_other_scene", file=file, scene=self.told.scene.file))
        given = self.numbers_of_seed(practice["seed"]) if practice["seed"] else self.home
        right = 0
        numbers = self.live.evaluate_on_tape(self.things, given)
        for item, answer in zip(self.items, practice["answers"], strict=True):
            right += self.is_answer_right(item, answer, numbers, given)
            scale = practice["scales"].get(item["what"]) if item["kind"] == "mu" else None
            if scale is not None and self.is_answer_right(item, scale, numbers, given):
                given = self.numbers_at_scale(item["what"], scale, given)
                numbers = self.live.evaluate_on_tape(self.things, given)
        if right != practice["right"]:
            names = {"file": file, "said": str(practice["right"]), "right": str(right)}
            raise PlanesError(Phrase("practice_altered", **names, count=str(len(self.items))))
        return HandedPractice(practice["name"], practice["seed"], right, len(self.items))

    def is_answer_right(self, item: Json, answer: object, numbers: Numbers, given: Given) -> bool:
        """Whether an answer is right, by the rule of the page."""
        what = item["what"]
        kind = item["kind"]
        if kind == "known":
            return answer == known_data_digits(self.told.equations[what])
        if kind == "mark":
            match answer:
                case [int() | float() as x, int() | float() as y]:
                    return abs(complex(x, y) - numbers[f"marks {what}"]) <= self.mark_tolerance_mm(what, numbers)
            return False
        if kind in ("order", "reason", "first"):
            return any(one["value"] == answer and "why" not in one for one in item["offered"])
        if not isinstance(answer, (int, float)):
            return False
        if kind == "mu":
            return self.is_scale_acceptable(item, float(answer), numbers, given)
        value = numbers[f"values {what}"].real
        if kind == "sense":
            return answer == math.copysign(1, value)
        ruler = JUDGING_TOLERANCES["ruler_mm"] / given[item["mu"]] if item["mu"] else 0.0
        off = answer - value if "signed" in item else abs(answer) - abs(value)
        return bool(abs(off) <= max(JUDGING_TOLERANCES["number_share"] * abs(value), ruler))

    def is_scale_acceptable(self, item: Json, scale: float, numbers: Numbers, given: Given) -> bool:
        """Whether a plan fits its place at a scale, and can be measured as well as at that of the lesson."""
        mu = item["what"].mu_name
        places = [numbers[f"marks {m}"] for m in item["marks"]]
        places = [z for z in places if z == z] + [0j] * (item["what"] != "position")
        across = bounding_corners(places)[1] - bounding_corners(places)[0] if places else complex(math.nan, math.nan)
        size = max(across.real, across.imag) / given[mu]
        own = size * self.home[mu]
        least = JUDGING_TOLERANCES["ruler_mm"] / JUDGING_TOLERANCES["number_share"]
        return bool(min(least, own / 2) <= size * scale <= max(item["most"], own))

    def numbers_at_scale(self, plan: PlanId, scale: float, given: Given) -> NumbersByName:
        """The numbers with a plan's scale, and with the scales tied to it."""
        times = scale / given[plan.mu_name]
        tied = [k["tied"] for k in self.told.knobs.offered_numbers if k["given"] == plan.mu_name]
        return {**given, plan.mu_name: scale, **{n: given[n] * times for names in tied for n in names}}

    def mark_tolerance_mm(self, mark: Mark, numbers: Numbers) -> float:
        """The tolerance of a mark, mm: closer to its place than to any mistake, within the limits of a hand."""
        wide = max(
            JUDGING_TOLERANCES["fits_mm"], JUDGING_TOLERANCES["fits_share"] * self.plan_size_mm(mark.plan, numbers)
        )
        wrong = (abs(numbers[slip] - numbers[f"marks {mark}"]) for at, slip in self.slips if at == mark)
        nearest = min((off for off in wrong if off == off), default=math.inf)
        return float(max(JUDGING_TOLERANCES["least_mm"], min(wide, nearest / 2)))

    def plan_size_mm(self, plan: PlanId, numbers: Numbers) -> float:
        """The size of a plan: the distance of its farthest mark, mm."""
        return max((abs(numbers[f"marks {m}"]) for m in self.marks if m.plan == plan), default=0.0)

    def numbers_of_seed(self, seed: int) -> NumbersByName:
        """The numbers for a seed; :class:`PlanesError` where there are none."""
        plans = [p for p in self.told.plans.plan_names if p != "motion"]
        home = self.live.evaluate_on_tape(self.things, self.home)
        sizes = [self.plan_size_mm(p, home) for p in plans]
        sharp = _least_crossing_sharpness(home)
        for k in range(JUDGING_TOLERANCES["draws"]):
            given = self.draw_random_numbers(random_stream(seed * JUDGING_TOLERANCES["draws"] + k))
            now = self.live.evaluate_on_tape(self.things, given)
            holds = all(now[n].real for n in now if n.startswith("holds "))
            near = all(0.5 * s <= self.plan_size_mm(p, now) <= 1.8 * s for p, s in zip(plans, sizes, strict=True))
            if holds and near and not _least_crossing_sharpness(now) < 0.5 * sharp:
                return given
        raise PlanesError(Phrase("practice_other_scene", file=str(seed), scene=self.told.scene.file))

    def draw_random_numbers(self, draw: Callable[[], float]) -> NumbersByName:
        """Numbers near the scene's own."""
        given = dict(self.home)
        drive = self.told.drive
        for knob in self.told.knobs.offered_numbers:
            name = knob["given"]
            if "plan" not in knob and "stays" not in knob:
                given[name] = float(f"{knob['at'] * (1 + JUDGING_TOLERANCES['fresh'] * (2 * draw() - 1)):.3g}")
        if not drive["held"]:
            turn = 2 * draw() - 1
            reach = drive["to"] - drive["from"]
            turned = math.floor(drive["at"] + JUDGING_TOLERANCES["swing"] * turn + 0.5)
            given[drive["given"]] = (
                turned if drive["symbol"] == "φ" else float(f"{drive['at'] + reach / 20 * turn:.3g}")
            )
        return given


def _least_crossing_sharpness(numbers: Numbers) -> float:
    return min((z.real for n, z in numbers.items() if n.startswith("sharp ")), default=math.inf)
