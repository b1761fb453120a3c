"""A scene rebuilt only from the words and numbers given to a student.

The content of the figure (links, their points and guides, their loads) is taken from the scene with all its numbers
blanked; every number is looked up in the text by its name. One not stated in the text is 0, as in a figure without that
dimension.
"""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from functools import cached_property

from planes.plans.force.loads import names_of_loads
from planes.scene import Scene
from planes.scene.mechanism import Amount, Drive, Guide, Journal, Link, Load, LoadLaw, Mechanism, RoundGuide, StrokeLoad
from planes.scene.structures import Framework, StaticLoad
from planes.scene.vectors import Statement
from planes.words.lettering import parameter_lettering
from planes.words.naming import Naming

_VALUE = r"(?: ?= ?[^\W\d][^=]{0,12}?)*?(?: ?= ?| )([-−]?\d[\d ]*(?:[.,]\d+)?(?:(?:·10|[eE])[-−]?\d+)?)(?![\w·^])"
_SIGNS = str.maketrans({"−": "-", "–": "-", "‑": "-", "\u00a0": " ", "\u202f": " ", "\u2009": " ", ",": "."})


class Paper:
    """A student's text, queried for numbers by their names; ``missed`` are names that were not found."""

    def __init__(self, text: str, naming: Naming) -> None:
        self.text = " ".join(text.replace("\ufffe", "-").translate(_SIGNS).split())
        self.naming, self.missed = naming, list[str]()

    def of(self, *names: str) -> float | None:
        """The number under any of the names, with any braces and lettering."""
        for name in names:
            plain = " ?".join(map(re.escape, re.sub(r"[\s_^{}]", "", name.translate(_SIGNS))))
            if found := re.search(rf"(= ?-)?(?<![\w∠]){plain}{_VALUE}", self.text):
                size = float(found[2].replace(" ", ""))
                return -size if found[1] else size  # e = −y
        return None

    def number(self, *names: str) -> float:
        """The same, 0 if there is none."""
        found = self.of(*names)
        if found is None:
            self.missed.append(" or ".join(names))
        return found or 0.0

    def stated_near(self, name: str) -> float:
        """The approximate direction of a vector."""
        plain = " ?".join(re.sub(r"[\s_^{}]", "", name))
        found = re.search(rf"(?<!\w){plain} (?:has|имеет|має|мае) .{{0,40}}? (-?\d+(?:\.\d+)?)°", self.text)
        return float(found[1]) if found else 0.0

    def law(self, name: str, shape: Amount | StrokeLoad) -> Amount | StrokeLoad:
        """The law of a load of this name in the text (in English); None if not of the kind of ``shape``."""
        plain = " ?".join(map(re.escape, re.sub(r"[\s_^{}]", "", name.translate(_SIGNS))))
        found = re.search(rf"law: {plain} ?= (.*?)\.(?= ?[A-Z∠]|$| The | Centres )", self.text)
        if found is None:
            self.missed.append(f"law of {name}")
            return 0.0
        return read_law(found[1])

    def place(self, name: str) -> complex:
        """Coordinates."""
        both = self.of(f"x{name} = y{name}")
        return complex(both, both) if both is not None else complex(self.number(f"x{name}"), self.number(f"y{name}"))


def read_law(told: str) -> Amount | StrokeLoad:
    """A law from its words."""
    strokes = re.fullmatch(
        r"(.*) in the working stroke \(link (\S+) goes (\w+) along its guide\)\. (.*) in the idle one", told
    )
    if strokes:
        working, slider, way, idle = strokes.groups()
        stroke = {"forwards": "ahead", "backwards": "behind"}[way]
        return StrokeLoad(read_amount(working), read_amount(idle), slider, stroke)  # type: ignore[arg-type]
    return read_amount(told)


def read_amount(told: str) -> Amount:
    """A number, an expression, or a table over one."""
    if table := re.fullmatch(r"table over (.*) \((.*→.*)\)", told):
        pairs = [pair.split("→") for pair in table[2].split(";")]
        return LoadLaw(read_expression(table[1]), tuple((float(x), float(y)) for x, y in pairs))
    try:
        return float(told)
    except ValueError:
        return LoadLaw(read_expression(told))


def read_expression(told: str) -> str:
    """An expression in the notation of a scene."""
    text = re.sub(r"φ ?1", "phi", told).replace("·", "*").replace("^", "**").replace("π", "pi")
    text = re.sub("[²³⁴]", lambda m: "**" + str("²³⁴".index(m[0]) + 2), text)
    return re.sub(r"\b([a-z]) ?(\d+)\b", r"\1_\2", text).replace(";", ",")


class Rebuilt:
    """A mechanism with the numbers of a paper."""

    def __init__(self, scene: Scene, paper: Paper) -> None:
        assert scene.mechanism
        self.paper, self.shape, self.naming = paper, scene.mechanism, paper.naming

    @cached_property
    def mechanism(self) -> Mechanism:
        """All of it."""
        m, paper = self.shape, self.paper
        return replace(
            m,
            frame=self.frame(m.frame),
            links={name: self.link(link) for name, link in m.links.items()},
            drive=self.drive(m.drive),
            loads=tuple(self.load(name, x) for name, x in zip(names_of_loads(m), m.loads, strict=True)),
            gravity=None if m.gravity is None else paper.number("g"),
            friction={name: paper.number(f"f{name}") for name in m.friction},
            journals={name: self.journal(name, x) for name, x in m.journals.items()},
            laws={},
        )

    def frame(self, frame: Link) -> Link:
        points = {name: self.paper.place(name) for name in frame.points}
        guides = {name: self.frame_guide(guide, points) for name, guide in frame.guides.items()}
        return replace(frame, points=points, guides=guides, round_guides=self.round_guides(frame))

    def round_guides(self, link: Link) -> dict[str, RoundGuide]:
        riders = [x for x in self.shape.links.values() if x.slides_round]
        found = {}
        for name, guide in link.round_guides.items():
            (rider,) = (x for x in riders if x.slides_round and x.slides_round.guide == name)
            found[name] = replace(guide, radius=self.length(rider.first_point, guide.centre))
        return found

    def frame_guide(self, guide: Guide, points: Mapping[str, complex]) -> Guide:
        """Vertical ones are given by a coordinate."""
        name, paper = guide.name, self.paper
        through = points.get(guide.through_point or "", 0j)
        for axis, angle, unit in (("y", 0.0, 1j), ("x", 90.0, 1 + 0j)):
            other = "x" if axis == "y" else "y"
            alone = not guide.through_point and paper.of(f"∠{name}") is None and paper.of(f"{other}{name}") is None
            if alone and (value := paper.of(f"{axis}{name}")) is not None:
                return replace(guide, through=value * unit, angle_deg=angle)
        through = through if guide.through_point else paper.place(name)
        return replace(guide, through=through, angle_deg=paper.number(f"∠{name}"))

    def length(self, one: str, two: str) -> float:
        return self.paper.number(f"l{one}{two}", f"l{two}{one}")

    def way(self, one: str, two: str) -> complex:
        """From a link's first point to another, in its axes."""
        if self.paper.of(f"x{one}{two}") is not None or self.paper.of(f"x{one}{two} = y{one}{two}") is not None:
            return self.paper.place(one + two)
        angle = math.radians(self.paper.of(f"∠{one}{two}") or 0.0)
        return cmath.rect(self.length(one, two), angle)

    def link(self, link: Link) -> Link:
        paper, first, n = self.paper, link.first_point, self.naming.link_number(link.name)
        points = {name: self.way(first, name) if name != first else 0j for name in link.points}
        guides = {}
        for name, guide in link.guides.items():
            through = points[guide.through_point] if guide.through_point else paper.place(f"{first}{name}")
            guides[name] = replace(guide, through=through, angle_deg=paper.of(f"∠{name}") or 0.0)
        slides = link.slides and replace(
            link.slides,
            angle_deg=None if link.slides.angle_deg is None else paper.of(f"∠{n}") or 0.0,
            offset=None if link.slides.offset is None else paper.of(f"e{n}") or 0.0,
        )
        mass, inertia = paper.of(f"m{n}", f"m{link.name}"), paper.of(*self.inertias(link))
        return replace(
            link, points=points, guides=guides, slides=slides, round_guides=self.round_guides(link),
            mass=mass if link.mass is not None else None, inertia=inertia if link.inertia is not None else None,
        )  # fmt: skip

    def inertias(self, link: Link) -> Iterable[str]:
        n = self.naming.link_number(link.name)
        return f"J{n}", f"JS{n}", f"J{link.mass_centre}"

    def drive(self, drive: Drive) -> Drive:
        names = [self.naming.lettered_vector(name) for name in drive.motion_names]
        position, velocity, acceleration = (self.paper.of(name) or 0.0 for name in names)
        return replace(drive, position=position, velocity=velocity, acceleration=acceleration)

    def load(self, name: str, load: Load) -> Load:
        """A law is given as a sentence; if not in English, it is left unchanged."""
        sign, value, angle = self.naming.lettered_vector(name), load.value, load.direction_deg
        if isinstance(value, float | int):
            value = self.paper.number(sign)
        elif self.naming.lang == "en":
            value = self.paper.law(sign, value)
        if isinstance(angle, float | int):
            of = f"({self.naming.link_number(load.direction_link)})" if load.direction_link else ""
            angle = self.paper.number(f"∠{sign}{of}")
        return replace(load, value=value, direction_deg=angle)

    def journal(self, name: str, journal: Journal) -> Journal:
        return replace(journal, coefficient=self.paper.number(f"f{name}"), radius=self.paper.number(f"r{name}"))


def restated(scene: Scene, paper: Paper) -> Statement:
    """The vectors of a paper: sizes, directions and numeric parameters."""
    stated = scene.statement
    assert stated
    vectors = {}
    for name, v in stated.vectors.items():
        sign = paper.naming.lettered_vector(name)
        size = paper.number(sign) if isinstance(v.value, float | int) else v.value
        way = paper.number(f"∠{sign}") if isinstance(v.direction, float | int) else v.direction
        near = None if v.near_deg is None else paper.stated_near(sign)
        vectors[name] = replace(v, value=size, direction=way, near_deg=near)
    parameters = {name: paper.number(parameter_lettering(name)) for name in stated.parameters if name in scene.used}
    return replace(stated, vectors=vectors, parameters={**stated.parameters, **parameters})


def restated_statics(scene: Scene, paper: Paper) -> Statement:
    """Bodies in equilibrium from a paper: positions, sizes and directions of loads, the pole of a string polygon."""
    stated = scene.statement
    assert stated and isinstance(stated.subject, Framework)
    shape = stated.subject
    points = {name: paper.place(name) for name in shape.points}
    loads = tuple(static_load(x, points, paper) for x in shape.loads)
    supports = tuple(
        replace(s, normal_deg=paper.number(f"∠{paper.naming.lettered_vector(s.name)}")) if s.kind == "roller" else s
        for s in shape.supports
    )
    pole = None if shape.pole is None else paper.place("O")
    framework = replace(shape, points=points, loads=loads, supports=supports, pole=pole)
    return replace(stated, subject=framework, parameters={})


def static_load(load: StaticLoad, points: Mapping[str, complex], paper: Paper) -> StaticLoad:
    """A load of a body; a distributed one acts at the joint resultant of its triangle and its rectangle."""
    sign = paper.naming.lettered_vector(load.name)
    way = load.direction_deg if load.direction_deg is None else paper.number(f"∠{sign}")
    if load.spread is None:
        return replace(load, size=paper.number(sign), direction_deg=way, place=points.get(load.point, 0j))
    start, end = (points[p] for p in load.spread)
    index = "".join(load.spread)
    even = paper.of(f"q{index}")
    first, last = (even, even) if even is not None else (paper.number(f"q{index}{p}") for p in load.spread)
    rectangle, triangle = abs(end - start) * first, abs(end - start) * (last - first) / 2
    moment = rectangle * (start + end) / 2 + triangle * (start + 2 * end) / 3
    size = rectangle + triangle
    place = moment / size if size else start
    return replace(load, size=size, direction_deg=way, place=place, intensity=(first, last))


def rebuilt(scene: Scene, text: str, naming: Naming) -> tuple[Scene, list[str]]:
    """The scene of a paper, and the names of the numbers missing there."""
    paper = Paper(text, naming)
    if scene.statement and scene.statement.subject:
        return replace(scene, statement=restated_statics(scene, paper)), paper.missed
    if scene.statement:
        return replace(scene, statement=restated(scene, paper)), paper.missed
    of = Rebuilt(scene, paper)
    return replace(scene, mechanism=of.mechanism, reading=replace(scene.reading, parameters={})), of.paper.missed
