"""One sheet: views composed, the smallest format that holds them, places, frame and title block."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import product

from planes.drafting import mu_of
from planes.scales import kind_of
from planes.scene import Scene
from planes.solving import Position
from planes.units import mu_text
from planes.words import Lang
from planes.wording import SceneError
from render.formulas import Formulas
from render.frame import FORMATS, Paper, sheet_number
from render.layout import GAP_MM, pack
from render.marks import Mark
from render.names import Naming
from render.polygon import Polygon
from render.scheme import Scheme
from render.tables import Tables
from render.view import View, stacked, view
from render.words import decimal, say

FACTORS = (1.6, 1.25, 1.0, 0.8, 0.63, 0.5)
"""How large, against the usual, the plans are drawn to fill a format, where the scene leaves μ open."""
LETTERS = {"A4": (2.5,), "A3": (3.5, 2.5), "A2": (3.5,), "A1": (5.0, 3.5)}
"""Letter heights of tables to try on a format, in mm; equations are a step larger."""
LARGER = {2.5: 3.5, 3.5: 5.0, 5.0: 7.0}

Draw = Callable[[float], Position]


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


@dataclass
class Composer:
    """Makes the views of a scene; the same view at the same scale is made once."""

    scene: Scene
    draw: Draw
    lang: Lang
    made: dict[tuple[object, ...], View | None] = field(default_factory=dict)

    @property
    def naming(self) -> Naming:
        """How this sheet names things."""
        return Naming(self.lang, self.scene.frame_number, self.scene.sheet.get("reactions") == "from-on")

    def views(self, position: Position, letter: float, together: bool = True) -> list[View]:
        """Every view of one position, in the order they are read; ``together``: equations under their plans."""
        plans = [p for p in position.plans.drawn if p in ("velocity", "acceleration") or p.startswith("force")]
        found = [self.scheme(position)]
        for plan in plans:
            pair = self.plan(position, plan), self.formulas(position, (plan,), LARGER[letter])
            found += [stacked(plan, [pair[0], pair[1]])] if together and pair[0] and pair[1] else pair
        return [v for v in (*found, *self.tables(position, letter)) if v]

    def once(self, key: tuple[object, ...], make: Callable[[], View | None]) -> View | None:
        """The view of that key, made the first time it is asked for."""
        if key not in self.made:
            self.made[key] = make()
        return self.made[key]

    def mu(self, position: Position, plan: str) -> str:
        """μ of a plan as it is written in titles: "μ_{v} = 30 мм/(м·с⁻¹)"."""
        letter = {"position": "l", "velocity": "v", "acceleration": "a", "force": "F"}[kind_of(plan)]
        convention = self.scene.sheet.get("mu_convention", "mm_per_unit")
        text = mu_text(position.scales[mu_of(plan)], kind_of(plan), self.lang, convention)  # type: ignore[arg-type]
        return f"μ_{{{letter}}} = {decimal(text, self.lang)}"

    def scheme(self, position: Position) -> View | None:
        """The scheme in the calculated position."""
        mu = position.scales[mu_of("position")]
        title = f"{say('scheme', self.lang)}, {self.mu(position, 'position')}"
        return self.once(("scheme", mu), lambda: view("scheme", title, Scheme(position, self.naming).drawn()))

    def plan(self, position: Position, plan: str) -> View | None:
        """A plan of rates or forces."""
        title = f"{self.plan_name(plan)}, {self.mu(position, plan)}"
        key = ("plan", plan, position.scales[mu_of(plan)])
        return self.once(key, lambda: view(plan, title, Polygon(position, plan, self.naming).drawn()))

    def plan_name(self, plan: str) -> str:
        """The name of a plan in its title."""
        kind, _, links = plan.partition(":")
        numbers = "–".join(self.naming.link(x) for x in links.split("-"))
        if kind != "force":
            return say(kind, self.lang)
        return say("force_group" if "-" in links else "force_driver", self.lang, links=numbers)

    def formulas(self, position: Position, plans: tuple[str, ...], letter: float) -> View | None:
        """The vector equations of some plans."""

        def make() -> View | None:
            marks = Formulas(position, self.naming, letter).drawn(plans)
            return view("equations", "", marks) if marks else None

        return self.once(("formulas", plans, letter), make)

    def tables(self, position: Position, letter: float) -> list[View]:
        """The tables of given and found values."""
        return Tables(position, self.naming, letter).all()


def compose(scene: Scene, draw: Draw, lang: Lang) -> Sheet:
    """The sheet of a scene: the smallest format, or the one it names, on which all views find room."""
    composer = Composer(scene, draw, lang)
    chosen = scene.sheet.get("format")
    formats = [wanted_format(str(chosen), scene)] if chosen and chosen != "auto" else list(FORMATS)
    free = any(scene.mu.get(kind) is None for kind in ("position", "velocity", "acceleration", "force"))
    tried: list[View] = []
    for name in formats:
        paper = Paper(name)
        for factor in FACTORS if free else FACTORS[:1]:
            position = draw(factor)
            for letter, together in product(LETTERS[name], (True, False)):
                tried = composer.views(position, letter, together)
                spots = pack([(v.width, v.height) for v in tried], paper.field, [paper.block])
                if spots:
                    places = [(v, s.x, s.top) for v, s in zip(tried, spots, strict=True)]
                    return finished(scene, paper, places, position, lang)
    raise no_room(tried, Paper(formats[-1]), lang)


def finished(
    scene: Scene, paper: Paper, places: Sequence[tuple[View, float, float]], position: Position, lang: Lang
) -> Sheet:
    """The views in their places within frame and title block."""
    marks = [m for v, left, top in places for m in v.placed(left, top)]
    title = scene.title.get(lang, "")
    return Sheet(paper, (*paper.marks(cells(scene, position, lang), lang), *marks), tuple(places), title)


def cells(scene: Scene, position: Position, lang: Lang) -> dict[str, str]:
    """What the title block says."""
    said = {key: str(value) for key, value in scene.sheet.items()}
    found = {key: said[key] for key in ("student", "teacher", "date", "checked", "approved", "material", "letter") if key in said}
    found["title"] = said.get("title") or scene.title.get(lang, "")
    found["designation"] = said.get("designation") or said.get("number", "")
    company = [said.get(key, "") for key in ("company", "university", "department", "group")]
    found["company"] = " ".join(text for text in company if text)
    found["scale"] = said.get("scale_note", "")
    found["sheet"] = sheet_number(lang, "Лист", said.get("sheet", "").removesuffix(".0"))
    found["sheets"] = sheet_number(lang, "Листов", said.get("sheets", "1").removesuffix(".0"))
    return found


def wanted_format(name: str, scene: Scene) -> str:
    """The format a scene names: A4 … A1, in Latin or Russian letters."""
    known = name.strip().upper().replace("А", "A")
    if known not in FORMATS:
        raise SceneError(
            say("bad_format", "en", format=name, known=", ".join(FORMATS)), scene.file, scene.where.get(("sheet", "format"))
        )
    return known


def no_room(views: Sequence[View], paper: Paper, lang: Lang) -> SceneError:
    """Which view is too large, and what would hold it."""
    largest = max(views, key=lambda v: v.width * v.height)
    width, height = round(largest.width), round(largest.height)
    names = list(FORMATS)
    larger = names[names.index(paper.name) + 1 :]
    title = largest.title or largest.key
    if not larger:
        return SceneError(say("no_room_at_all", lang, view=title, width=width, height=height))
    need = sum((v.width + GAP_MM) * (v.height + GAP_MM) for v in views) * 1.1
    fitting = next((n for n in larger if FORMATS[n][0] * FORMATS[n][1] > need), larger[-1])
    words = {"format": paper.name, "view": title, "width": width, "height": height, "larger": fitting}
    return SceneError(say("no_room", lang, **words))
