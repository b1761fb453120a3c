"""Possible but improbable values in a scene, reported as warnings, each with its line. A negative length is refused."""

import math
import re
from collections import Counter
from collections.abc import Container, Iterator
from dataclasses import fields
from itertools import combinations

from planes.scene.mechanism import DRIVE_RATE_KEYS, FRAME, LOAD_KINDS, Link, Mechanism
from planes.scene.parameters import names_in_node, names_reachable_from
from planes.scene.paths import Keys, line_of_path, nodes_along_path, texts_with_paths
from planes.scene.reader import Reader
from planes.scene.source import Nodes, SourceScalar, SourceTable
from planes.words import Phrase, Written
from planes.words.errors import Doubt

Doubts = Iterator[tuple[Phrase, Keys]]
DOUBTFUL_LINK_LENGTH_M = 10.0  # a link this long is more likely given in millimetres
MOST_PARAMETER_HOPS = 20  # from parameter to parameter
DOUBTFUL_GRAVITY = 30.0  # m/s²: no planet weighs so much
DOUBTFUL_LINK_DENSITY = 1e6  # kg/m³, of the cube of a link's length: the heaviest flywheels of textbooks have 7e4
DOUBTFUL_GYRATION_RATIO = 10.0  # a radius of gyration of so many lengths of its link: the inertia is not in kg·m²
DOUBTFUL_FRICTION_COEFFICIENT = 1.0  # a coefficient of friction this large is more likely a misprint
RADIAN_MULTIPLE_TOLERANCE = 5e-4  # how close to a multiple of π/12 a number must be to count as one
RADIAN_MULTIPLE_STEP = math.pi / 12
LARGEST_ANGLE_RAD = 6.29  # radians of a turn
UNIT_DOUBT_KEYS = [
    f"doubt_{key}" for key in ("radians", "ratio", "gravity", "friction", "inertia", "heavy", "long", "far")
]
"""The doubts whether a number is in the units of scenes, SI and degrees."""
_LINK_FIELD_NAMES = {f.name for f in fields(Link)} - {"name"}
_ANGLE_KEYS = ("phi", "angle", "direction", "perpendicular_to", "near")
_TRIGONOMETRIC_PATTERN = re.compile(r"\s*-?\s*(sin|cos|tan)\s*\(")
_RADIANS_IN_LAW_PATTERN = re.compile(r"\b(?:sin|cos|tan)\s*\([^()]*(?<![/\w])pi\b")
_WHOLE_NUMBER_PATTERN = re.compile(r"-?\d+(\.0*)?")
_WORD_PATTERN = re.compile(r"\w+")
_PARAMETER_SECTIONS = ("parameters", "variants")
_SECTIONS_ALLOWING_EMPTY = (*_PARAMETER_SECTIONS, "vectors")  # where an empty value has a meaning


def read_doubts(file: str, table: SourceTable, parameters: Nodes, mechanism: Mechanism | None) -> list[Doubt]:
    """All doubts of a scene in the order of the file."""
    doubts = [
        *_empty_value_doubts(table),
        *_unused_parameter_doubts(table, parameters),
        *_angle_doubts(table, parameters),
        *_reversed_vector_doubts(table, parameters),
    ]
    if mechanism:
        doubts += [
            *_link_doubts(mechanism, "missing" in table.entries),
            *_drive_doubts(mechanism),
            *_assembly_place_doubts(mechanism),
        ]
        doubts += _distance_doubts(mechanism.frame)
        if (mechanism.gravity or 0) > DOUBTFUL_GRAVITY:
            doubts.append((Phrase("doubt_gravity", value=_brief_number(mechanism.gravity or 0.0)), ("gravity",)))
        doubts += [
            (Phrase("doubt_friction", guide=guide, value=float(value)), ("friction", guide))
            for guide, value in {
                **mechanism.friction,
                **{n: j.coefficient for n, j in mechanism.journals.items()},
            }.items()
            if value >= DOUBTFUL_FRICTION_COEFFICIENT
        ]
    said = [
        Doubt(phrase, file, line_of_path(table, _place_of_doubtful_number(table, parameters, phrase, path)))
        for phrase, path in doubts
    ]
    return sorted(said, key=lambda doubt: doubt.line)


def _place_of_doubtful_number(table: SourceTable, parameters: Nodes, phrase: Phrase, path: Keys) -> Keys:
    """The place of a number that seems to be in other units: its only parameter, if it has just one."""
    if phrase.key not in UNIT_DOUBT_KEYS:
        return path
    met = [node for node, _ in nodes_along_path(table, path)]
    written = texts_with_paths(met[-1]) if len(met) == len(path) else ()
    names = {node.text for _, node in written if node.text in parameters}
    if len(names) == 1 and "parameters" in table.entries:
        return ("parameters", *names)
    return path


def check_rod_lengths(reader: Reader, mechanism: Mechanism) -> None:
    """Refuse a negative length: the second hinge of a rod with all points on its axis must not lie behind the first."""
    shared = Counter(point for link in mechanism.bodies for point in link.points)
    for link in mechanism.links.values():
        hinges = [point for point in link.points if shared[point] > 1]
        rod = len(hinges) == 2 and not (link.guides or link.slides or any(z.imag for z in link.points.values()))
        if rod and (length := (link.points[hinges[1]] - link.points[hinges[0]]).real) < 0 == link.points[hinges[0]]:
            numbers = {"link": link.name, "one": hinges[0], "two": hinges[1], "length": _brief_number(length)}
            where = mechanism.where.get(("links", link.name, "points", hinges[1]), 1)
            raise reader.error_by_key("negative_length", where, **numbers)


def _brief_number(number: float) -> Written:
    return Written(f"{number:g}")


def _empty_value_doubts(table: SourceTable) -> Doubts:
    for path, node in texts_with_paths(table):
        if node.plain and not node.text and path[0] not in _SECTIONS_ALLOWING_EMPTY:
            yield Phrase("doubt_empty", key=".".join(path)), path


def _unused_parameter_doubts(table: SourceTable, parameters: Nodes) -> Doubts:
    """Unused parameters: a length misspelt or left behind; those that the note mentions are skipped."""
    idle = parameters_used_only_under(table, parameters, _PARAMETER_SECTIONS)
    yield from ((Phrase("doubt_unused", name=name), ("parameters", name)) for name in idle)


def parameters_used_only_under(table: SourceTable, parameters: Nodes, without: Container[str]) -> list[str]:
    """The parameters used nowhere but under the keys ``without``."""
    besides = (node.text for path, node in texts_with_paths(table) if path[0] not in without)
    words = {word for text in besides for word in _WORD_PATTERN.findall(text)}
    used = names_reachable_from(words, {name: names_in_node(node) for name, node in parameters.items()})
    return [name for name in parameters if name not in used]


def _angle_doubts(table: SourceTable, parameters: Nodes) -> Doubts:
    """Angles that look like radians, by π in them or by their value, or like a ratio of a triangle's sides."""
    for path, node in texts_with_paths(table):
        if path[0] == "loads" and path[-1] in LOAD_KINDS and _RADIANS_IN_LAW_PATTERN.search(node.text):
            yield Phrase("doubt_radians", key=path[-1], text=node.text[:60]), path
        named = path[0] in _PARAMETER_SECTIONS or path[-2:-1] in (("points",), ("parameters",))
        if path[-1] in _ANGLE_KEYS and not named:  # a point or parameter may happen to have the name of an angle
            text = _expression_behind(node.text, parameters)
            if (re.search(r"\bpi\b", text) and "180" not in text) or _looks_like_radians(text):
                yield Phrase("doubt_radians", key=path[-1], text=text[:60]), path
            elif _TRIGONOMETRIC_PATTERN.match(text):
                yield Phrase("doubt_ratio", key=path[-1], text=text[:60]), path


def _reversed_vector_doubts(table: SourceTable, parameters: Nodes) -> Doubts:
    """Negative loads along or against a motion, and negative vectors: the minus reverses them."""
    every = [(path, _expression_behind(node.text, parameters)) for path, node in texts_with_paths(table)]
    sensed = {path[:2] for path, _ in every if path[0] == "loads" and path[-1] in ("along", "against")}
    for path, text in every:
        if path[:2] in sensed and len(path) == 3 and path[-1] in LOAD_KINDS and _value_of_number_text(text) < 0:
            yield Phrase("doubt_backwards", key=path[-1], text=text[:60]), path
        elif path[0] == "vectors" and path[2:] == ("value",) and _value_of_number_text(text) < 0:
            yield Phrase("doubt_vector_size", name=path[1], text=text[:60]), path


def _value_of_number_text(text: str) -> float:
    """The value of a written number; None for anything else."""
    try:
        return float(text)
    except ValueError:
        return math.nan


def _expression_behind(text: str, parameters: Nodes) -> str:
    """The expression, or that of the parameter it consists of."""
    for _ in range(MOST_PARAMETER_HOPS):
        node = parameters.get(text.strip())
        if not isinstance(node, SourceScalar):
            break
        text = node.text
    return text


def _looks_like_radians(text: str) -> bool:
    value = abs(_value_of_number_text(text))
    if not math.isfinite(value):
        return False
    twelfths = value / RADIAN_MULTIPLE_STEP
    near = abs(twelfths - round(twelfths)) * RADIAN_MULTIPLE_STEP < RADIAN_MULTIPLE_TOLERANCE
    return not _WHOLE_NUMBER_PATTERN.fullmatch(text.strip()) and 0.2 < value < LARGEST_ANGLE_RAD and near


def _link_doubts(mechanism: Mechanism, incomplete: bool) -> Doubts:
    for link in mechanism.links.values():
        path = ("links", link.name)
        for point in link.points:
            if point in _LINK_FIELD_NAMES:
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
        size = _link_size(link)
        flywheel = link.name == mechanism.drive.link
        if (
            size
            and link.mass
            and not flywheel
            and (link.inertia or 0) > link.mass * (DOUBTFUL_GYRATION_RATIO * size) ** 2
        ):
            numbers = {"radius": math.sqrt((link.inertia or 0) / link.mass), "size": size}
            yield Phrase("doubt_inertia", link=link.name, **numbers), (*path, "inertia")
        if size and (link.mass or 0) > DOUBTFUL_LINK_DENSITY * size**3:
            heavy = {"mass": _brief_number(link.mass or 0.0), "size": _brief_number(size)}
            yield Phrase("doubt_heavy", link=link.name, **heavy), (*path, "mass")
        if size >= DOUBTFUL_LINK_LENGTH_M:
            yield (Phrase("doubt_long", link=link.name, size=_brief_number(size)), (*path, "points"))


def _assembly_place_doubts(mechanism: Mechanism) -> Doubts:
    """Points under ``assembly`` that have only one possible place: those of the driver, or of a single link without a
    slider."""
    drive = mechanism.drive
    links = mechanism.links
    driven = links[drive.link].points if (drive.kind, drive.on) == ("phi", FRAME) else ()
    for name, said in mechanism.assembly.items():
        own = [link for link in links.values() if name in link.points]
        alone = len(own) == 1 and not (own[0].slides or own[0].slides_round) and said.near is None
        if own and name not in mechanism.frame.guides and (name in driven or alone):
            yield Phrase("doubt_assembly", point=name), ("assembly", name)


def _distance_doubts(frame: Link) -> Doubts:
    """Fixed points and guides so far from the origin that metres are hardly meant."""
    for kind, places in ("points", frame.points), ("guides", {name: g.through for name, g in frame.guides.items()}):
        for name, z in places.items():
            if abs(z) >= DOUBTFUL_LINK_LENGTH_M:
                yield Phrase("doubt_far", name=name, size=_brief_number(abs(z))), ("frame", kind, name)


def _link_size(link: Link) -> float:
    """The longest distance between points of a link; where there are very many, only from the first one."""
    places = list(link.points.values())
    pairs = combinations(places, 2) if len(places) < 50 else ((places[0], z) for z in places)
    return max((abs(a - b) for a, b in pairs), default=0.0)


def _drive_doubts(mechanism: Mechanism) -> Doubts:
    drive = mechanism.drive
    rate = DRIVE_RATE_KEYS[drive.kind][0]
    at_rest = all(link.inertia is None for link in mechanism.links.values())
    statics = at_rest and (mechanism.loads or mechanism.gravity)
    if ("drive", rate) not in mechanism.where and not statics:
        yield Phrase("doubt_at_rest", key=rate), ("drive",)
    link = mechanism.links[drive.link]
    if drive.rotates and len(link.points) > 1 and not _link_size(link):
        yield Phrase("doubt_no_crank", link=link.name), ("links", link.name, "points")
