"""Possible but improbable values in a scene, reported as warnings, each with its line. A negative length is refused."""

import math
import re
from collections import Counter
from collections.abc import Container, Iterator, Mapping
from dataclasses import fields
from itertools import combinations

from planes.scene.mechanism import FRAME, RATES, Link, Mechanism
from planes.scene.parameters import names_of, reached
from planes.scene.paths import Keys, down, line_of, texts
from planes.scene.reader import Reader
from planes.scene.source import Node, SourceScalar, SourceTable
from planes.words import Phrase, Written
from planes.words.errors import Doubt

Doubts = Iterator[tuple[Phrase, Keys]]
Parameters = Mapping[str, Node]  # as written
LONG_M = 10.0  # a link this long is more likely given in millimetres
MOST_HOPS = 20  # from parameter to parameter
HEAVY = 30.0  # m/s²: no planet weighs so much
HEAVIEST = 1e6  # kg/m³, of the cube of a link's length: the heaviest flywheels of textbooks have 7e4
GYRATION = 10.0  # a radius of gyration of so many lengths of its link: the inertia is not in kg·m²
STEEP = 1.0  # a coefficient of friction this large is more likely a misprint
RADIANS = 5e-4  # how close to a multiple of π/12 a number must be to count as one
STEP = math.pi / 12
LARGEST = 6.29  # radians of a turn
OF_UNITS = [f"doubt_{key}" for key in ("radians", "ratio", "gravity", "friction", "inertia", "heavy", "long", "far")]
"""The doubts whether a number is in the units of scenes, SI and degrees."""
_OF_LINK = {f.name for f in fields(Link)} - {"name"}
_ANGLES = ("phi", "angle", "direction", "perpendicular_to", "near")
_RATIO = re.compile(r"\s*-?\s*(sin|cos|tan)\s*\(")
_IN_LAW = re.compile(r"\b(?:sin|cos|tan)\s*\([^()]*(?<![/\w])pi\b")
_WHOLE = re.compile(r"-?\d+(\.0*)?")
_SIZES = ("force", "moment")  # of loads
_WORD = re.compile(r"\w+")
_STATED = ("parameters", "variants")
_NAMED_FREELY = (*_STATED, "vectors")  # where an empty value has a meaning


def read_doubts(file: str, table: SourceTable, parameters: Parameters, mechanism: Mechanism | None) -> list[Doubt]:
    """All doubts of a scene in the order of the file."""
    doubts = [*_empty(table), *_unused(table, parameters), *_angles(table, parameters), *_backwards(table, parameters)]
    if mechanism:
        doubts += [*_links(mechanism, "missing" in table.entries), *_drive(mechanism), *_places(mechanism)]
        doubts += _far(mechanism.frame)
        if (mechanism.gravity or 0) > HEAVY:
            doubts.append((Phrase("doubt_gravity", value=_brief(mechanism.gravity or 0.0)), ("gravity",)))
        doubts += [
            (Phrase("doubt_friction", guide=guide, value=float(value)), ("friction", guide))
            for guide, value in {
                **mechanism.friction,
                **{n: j.coefficient for n, j in mechanism.journals.items()},
            }.items()
            if value >= STEEP
        ]
    said = [Doubt(phrase, file, line_of(table, _home(table, parameters, phrase, path))) for phrase, path in doubts]
    return sorted(said, key=lambda doubt: doubt.line)


def _home(table: SourceTable, parameters: Parameters, phrase: Phrase, path: Keys) -> Keys:
    """The place of a number that seems to be in other units: its only parameter, if it has just one."""
    if phrase.key not in OF_UNITS:
        return path
    met = [node for node, _ in down(table, path)]
    written = texts(met[-1]) if len(met) == len(path) else ()
    names = {node.text for _, node in written if node.text in parameters}
    return ("parameters", *names) if len(names) == 1 and "parameters" in table.entries else path


def check_lengths(reader: Reader, mechanism: Mechanism) -> None:
    """Refuse a negative length: the second hinge of a rod with all points on its axis must not lie behind the first."""
    shared = Counter(point for link in mechanism.bodies for point in link.points)
    for link in mechanism.links.values():
        hinges = [point for point in link.points if shared[point] > 1]
        rod = len(hinges) == 2 and not (link.guides or link.slides or any(z.imag for z in link.points.values()))
        if rod and (length := (link.points[hinges[1]] - link.points[hinges[0]]).real) < 0 == link.points[hinges[0]]:
            numbers = {"link": link.name, "one": hinges[0], "two": hinges[1], "length": _brief(length)}
            where = mechanism.where.get(("links", link.name, "points", hinges[1]), 1)
            raise reader.fault("negative_length", where, **numbers)


def _brief(number: float) -> Written:
    return Written(f"{number:g}")


def _empty(table: SourceTable) -> Doubts:
    for path, node in texts(table):
        if node.plain and not node.text and path[0] not in _NAMED_FREELY:
            yield Phrase("doubt_empty", key=".".join(path)), path


def _unused(table: SourceTable, parameters: Parameters) -> Doubts:
    """Unused parameters: a length misspelt or left behind; those that the note mentions are skipped."""
    idle = idle_parameters(table, parameters, _STATED)
    yield from ((Phrase("doubt_unused", name=name), ("parameters", name)) for name in idle)


def idle_parameters(table: SourceTable, parameters: Parameters, without: Container[str]) -> list[str]:
    """The parameters used nowhere but under the keys ``without``."""
    besides = (node.text for path, node in texts(table) if path[0] not in without)
    words = {word for text in besides for word in _WORD.findall(text)}
    used = reached(words, {name: names_of(node) for name, node in parameters.items()})
    return [name for name in parameters if name not in used]


def _angles(table: SourceTable, parameters: Parameters) -> Doubts:
    """Angles that look like radians, by π in them or by their value, or like a ratio of a triangle's sides."""
    for path, node in texts(table):
        if path[0] == "loads" and path[-1] in _SIZES and _IN_LAW.search(node.text):
            yield Phrase("doubt_radians", key=path[-1], text=node.text[:60]), path
        named = path[0] in _STATED or path[-2:-1] in (("points",), ("parameters",))
        if path[-1] in _ANGLES and not named:  # a point or parameter may happen to have the name of an angle
            text = _written(node.text, parameters)
            if (re.search(r"\bpi\b", text) and "180" not in text) or _radians(text):
                yield Phrase("doubt_radians", key=path[-1], text=text[:60]), path
            elif _RATIO.match(text):
                yield Phrase("doubt_ratio", key=path[-1], text=text[:60]), path


def _backwards(table: SourceTable, parameters: Parameters) -> Doubts:
    """Negative loads along or against a motion, and negative vectors: the minus reverses them."""
    every = [(path, _written(node.text, parameters)) for path, node in texts(table)]
    sensed = {path[:2] for path, _ in every if path[0] == "loads" and path[-1] in ("along", "against")}
    for path, text in every:
        if path[:2] in sensed and len(path) == 3 and path[-1] in _SIZES and _value(text) < 0:
            yield Phrase("doubt_backwards", key=path[-1], text=text[:60]), path
        elif path[0] == "vectors" and path[2:] == ("value",) and _value(text) < 0:
            yield Phrase("doubt_vector_size", name=path[1], text=text[:60]), path


def _value(text: str) -> float:
    """The value of a written number; None for anything else."""
    try:
        return float(text)
    except ValueError:
        return math.nan


def _written(text: str, parameters: Parameters) -> str:
    """The expression, or that of the parameter it consists of."""
    for _ in range(MOST_HOPS):
        node = parameters.get(text.strip())
        if not isinstance(node, SourceScalar):
            break
        text = node.text
    return text


def _radians(text: str) -> bool:
    value = abs(_value(text))
    if not math.isfinite(value):
        return False
    twelfths = value / STEP
    near = abs(twelfths - round(twelfths)) * STEP < RADIANS
    return not _WHOLE.fullmatch(text.strip()) and 0.2 < value < LARGEST and near


def _links(mechanism: Mechanism, incomplete: bool) -> Doubts:
    for link in mechanism.links.values():
        path = ("links", link.name)
        for point in link.points:
            if point in _OF_LINK:
                yield Phrase("doubt_point", key=point, link=link.name), (*path, "points", point)
        weighed = bool(mechanism.gravity or link.centre) and not incomplete
        if weighed and link.inertia is not None and link.mass is None:
            yield Phrase("doubt_massless", link=link.name), (*path, "inertia")
        apart = (
            len(link.points) > 1
            and not (link.slides or link.slides_round)
            and link.first_point not in mechanism.frame.points
        )
        if apart and link.mass and link.centre is None and not incomplete:
            yield Phrase("doubt_centre", link=link.name, point=link.first_point), (*path, "mass")
        size = _size(link)
        flywheel = link.name == mechanism.drive.link
        if size and link.mass and not flywheel and (link.inertia or 0) > link.mass * (GYRATION * size) ** 2:
            numbers = {"radius": math.sqrt((link.inertia or 0) / link.mass), "size": size}
            yield Phrase("doubt_inertia", link=link.name, **numbers), (*path, "inertia")
        if size and (link.mass or 0) > HEAVIEST * size**3:
            heavy = {"mass": _brief(link.mass or 0.0), "size": _brief(size)}
            yield Phrase("doubt_heavy", link=link.name, **heavy), (*path, "mass")
        if size >= LONG_M:
            yield (Phrase("doubt_long", link=link.name, size=_brief(size)), (*path, "points"))


def _places(mechanism: Mechanism) -> Doubts:
    """Points under ``assembly`` that have only one possible place: those of the driver, or of a single link without a
    slider."""
    drive, links = mechanism.drive, mechanism.links
    driven = links[drive.link].points if (drive.kind, drive.on) == ("phi", FRAME) else ()
    for name, said in mechanism.assembly.items():
        own = [link for link in links.values() if name in link.points]
        alone = len(own) == 1 and not (own[0].slides or own[0].slides_round) and said.near is None
        if own and name not in mechanism.frame.guides and (name in driven or alone):
            yield Phrase("doubt_assembly", point=name), ("assembly", name)


def _far(frame: Link) -> Doubts:
    """Fixed points and guides so far from the origin that metres are hardly meant."""
    for kind, places in ("points", frame.points), ("guides", {name: g.through for name, g in frame.guides.items()}):
        for name, z in places.items():
            if abs(z) >= LONG_M:
                yield Phrase("doubt_far", name=name, size=_brief(abs(z))), ("frame", kind, name)


def _size(link: Link) -> float:
    """The longest distance between points of a link; where there are very many, only from the first one."""
    places = list(link.points.values())
    pairs = combinations(places, 2) if len(places) < 50 else ((places[0], z) for z in places)
    return max((abs(a - b) for a, b in pairs), default=0.0)


def _drive(mechanism: Mechanism) -> Doubts:
    drive = mechanism.drive
    rate = RATES[drive.kind][0]
    at_rest = all(link.inertia is None for link in mechanism.links.values())
    statics = at_rest and (mechanism.loads or mechanism.gravity)
    if ("drive", rate) not in mechanism.where and not statics:
        yield Phrase("doubt_at_rest", key=rate), ("drive",)
    link = mechanism.links[drive.link]
    if drive.rotates and len(link.points) > 1 and not _size(link):
        yield Phrase("doubt_no_crank", link=link.name), ("links", link.name, "points")
