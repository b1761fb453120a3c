"""One sheet: views composed, the smallest format that holds them, places, frame and title block."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import product

from planes.scene import Scene
from planes.wording import SceneError
from planes.words import Lang
from render.marks import Mark
from render.sheet.frame import FORMATS, Paper, sheet_number
from render.sheet.layout import GAP_MM, pack
from render.typeset import plain
from render.views import View
from render.words import say

FACTORS = (1.6, 1.25, 1.0, 0.8)
"""How large, against the usual, the plans are drawn to fill a format, where the scene leaves μ open."""
SMALLER = (0.63, 0.5, 0.4)
"""How small they may become on the largest format, or the one the scene names."""
LETTERS = {"A4": (2.5,), "A3": (3.5, 2.5), "A2": (3.5,), "A1": (5.0, 3.5)}
"""Letter heights of tables to try on a format, in mm; equations are a step larger."""

Views = Callable[[float, float, bool], tuple[list[View], list[View]]]
"""The views of a sheet (those it must hold, and those that may fill it) for a size of plans, a letter height of
tables, and whether equations stand under their plans."""


@dataclass(frozen=True)
class Sheet:
    """A composed sheet: its format, its marks, and its views with their places (left, top)."""

    paper: Paper
    marks: tuple[Mark, ...]
    views: tuple[tuple[View, float, float], ...]
    title: str

    @property
    def size(self) -> tuple[float, float]:
        """Width and height in mm."""
        return self.paper.size


def compose(scene: Scene, views: Views, free: bool, lang: Lang, number: int | None = None) -> Sheet:
    """The sheet of a scene: the smallest format, or the one it names, on which all views find room.

    ``free`` says whether the scene leaves any μ open, so that plans may grow and shrink.
    """
    chosen = scene.sheet.get("format")
    formats = [wanted_format(str(chosen), scene, lang)] if chosen and chosen != "auto" else list(FORMATS)
    tried: list[View] = []
    for name in formats:
        for factor, letter, together in _tries(name, free, name == formats[-1]):
            tried, fillers = views(factor, letter, together)
            places = arranged(tried, fillers, Paper(name))
            if places:
                return finished(scene, Paper(name), places, lang, number)
    raise no_room(tried, Paper(formats[-1]), lang)


def _tries(name: str, free: bool, last: bool) -> list[tuple[float, float, bool]]:
    """Sizes of plans, letter heights and whether equations stand under their plans, the best looking first."""
    large = [f for f in FACTORS if f >= 1.0] if free else [1.0]
    small = [f for f in FACTORS if f < 1.0] + list(SMALLER if last else ()) if free else []
    first = [*product(large, LETTERS[name], (True,)), *product(large, LETTERS[name], (False,))]
    return [*first, *product(small, LETTERS[name], (True, False))]


def arranged(views: list[View], fillers: list[View], paper: Paper) -> list[tuple[View, float, float]] | None:
    """Places of the views on the paper, with the filling ones if there is room; None if there is not for the rest."""
    for some in ([*views, *fillers], views) if fillers else (views,):
        figures = sum(v.figure for v in some)
        spots = pack([(v.width, v.height) for v in some], paper.field, [paper.block], figures)
        if spots:
            return [(v, s.x, s.top) for v, s in zip(some, spots, strict=True)]
    return None


def finished(
    scene: Scene, paper: Paper, places: Sequence[tuple[View, float, float]], lang: Lang, number: int | None = None
) -> Sheet:
    """The views in their places within frame and title block."""
    marks = [m for v, left, top in places for m in v.placed(left, top)]
    title = scene.title.get(lang, "")
    return Sheet(paper, (*paper.marks(cells(scene, lang, number), lang), *marks), tuple(places), title)


def cells(scene: Scene, lang: Lang, number: int | None = None) -> dict[str, str]:
    """What the title block says."""
    said = {key: str(value) for key, value in scene.sheet.items()}
    plain = ("student", "teacher", "date", "checked", "approved", "material", "letter", "mass")
    found: dict[str, str] = {key: said[key] for key in plain if key in said}
    found["title"] = said.get("title") or scene.title.get(lang, "")
    found["designation"] = said.get("designation") or said.get("number", "")
    company = [said.get(key, "") for key in ("company", "university", "department", "group")]
    found["company"] = " ".join(text for text in company if text)
    found["scale"] = said.get("scale_note", "")
    if number:
        found["title"] += f". {say(f'sheet_{number}', lang)}" if "title" not in said else ""
    found["sheet"] = sheet_number(lang, "Лист", said.get("sheet", str(number or "")).removesuffix(".0"))
    found["sheets"] = sheet_number(lang, "Листов", said.get("sheets", "2" if number else "1").removesuffix(".0"))
    return found


def wanted_format(name: str, scene: Scene, lang: Lang) -> str:
    """The format a scene names: A4 … A1, in Latin or Russian letters."""
    known = name.strip().upper().replace("А", "A")
    if known not in FORMATS:
        line = scene.where.get(("sheet", "format"))
        raise SceneError(say("bad_format", lang, format=name, known=", ".join(FORMATS)), scene.file, line)
    return known


def no_room(views: Sequence[View], paper: Paper, lang: Lang) -> SceneError:
    """Which view is too large, and what would hold it."""
    largest = max(views, key=lambda v: v.width * v.height)
    width, height = round(largest.width), round(largest.height)
    names = list(FORMATS)
    larger = names[names.index(paper.name) + 1 :]
    title = plain(largest.title or largest.key)
    if not larger:
        return SceneError(say("no_room_at_all", lang, view=title, width=width, height=height))
    need = sum((v.width + GAP_MM) * (v.height + GAP_MM) for v in views) * 1.1
    fitting = next((n for n in larger if FORMATS[n][0] * FORMATS[n][1] > need), larger[-1])
    words = {"format": paper.name, "view": title, "width": width, "height": height, "larger": fitting}
    return SceneError(say("no_room", lang, **words))
