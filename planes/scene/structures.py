"""A scene of statics: bodies or a truss by their points, supports and loads, and the method for the reactions."""

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Literal, get_args

from planes.scene.load_laws import LawReader
from planes.scene.mechanism import LoadLaw, PlacesByName
from planes.scene.packs import PACKS
from planes.scene.reader import LARGEST_SCENE_NUMBER, Fields, section_in_words
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.words import Phrase, Told
from planes.words.frozen import field, frozen
from planes.words.names import NamePair, NameTuple

SupportKind = Literal["hinge", "roller", "rod", "rope", "clamp"]
SUPPORT_KINDS: tuple[SupportKind, ...] = get_args(SupportKind)
KEYS_BY_TABLE = PACKS["points"].schema["keys"]
SOLUTION_METHODS = ("moments", "string", "three-forces", "composition", "culmann")
MOST_FRAMEWORK_POINTS = 60
Bodies = Mapping[str, NameTuple]  # the points of each
ONLY_BODY_NAME = "1"
"""The name of the only body of a scene that names no bodies."""


@frozen
class Support:
    """A support of a body at a point: a roller by its normal, a rod or a rope by the fixed point it leads ``to``."""

    kind: SupportKind
    point: str
    name: str  # names of its reaction
    normal_deg: float = 90.0
    to: str = ""

    @property
    def unknown_count(self) -> int:
        """The number of unknowns in its reaction."""
        return {"hinge": 2, "clamp": 3}.get(self.kind, 1)


@frozen
class StaticLoad:
    """A force of ``size`` N at a place, or a couple of ``size`` N·m on a body; ``spread`` are the end points of the
    distributed load that has this resultant."""

    name: str
    body: str
    size: float | LoadLaw
    direction_deg: float | LoadLaw | None = None  # None for a couple
    place: complex = 0j
    point: str = ""  # the named point it acts at; "" for the resultant of a distributed load
    spread: NamePair | None = None
    intensity: tuple[float, float] = (0.0, 0.0)  # N/m at both ends

    @property
    def constant_direction_deg(self) -> float:
        """The direction of a distributed load, which is constant."""
        assert isinstance(self.direction_deg, float | int)
        return float(self.direction_deg) + (180.0 if sum(self.intensity) < 0 else 0.0)


@frozen
class Framework:
    """The contents of a scene of statics. ``method`` is None where the program chooses; the ``pole`` of a string
    polygon is in N from the start of the force polygon, or such that the strings pass ``through`` given points."""

    points: PlacesByName
    bodies: Bodies
    members: tuple[NamePair, ...] = ()
    supports: tuple[Support, ...] = ()
    loads: tuple[StaticLoad, ...] = ()
    method: str | None = None
    pole: complex | None = None
    through: NameTuple = ()
    fixed: frozenset[str] = field(default_factory=frozenset)  # fixed points at the ends of rods and ropes


class FrameworkReader:
    """Reads a scene of statics: first the points, then all that refers to them."""

    def __init__(self, scene: Fields, laws: LawReader | None) -> None:
        self.scene = scene
        self.laws = laws
        self.reader = reader = scene.reader
        table = reader.read_table_of_names(scene.table.entries["points"], "points", Phrase("a_point"))
        if len(table.entries) > MOST_FRAMEWORK_POINTS:
            raise reader.error_by_key("points_many", table, count=len(table.entries), most=MOST_FRAMEWORK_POINTS)
        self.points = {n: reader.read_place(x, Phrase("point_of", name=n)) for n, x in table.entries.items()}
        self.taken: dict[str, int] = {}

    def read_framework(self) -> Framework:
        members = tuple(self.read_members())
        supports = tuple(
            s for name, node in self.named_entries("supports") for s in self.read_supports_at_point(name, node)
        )
        fixed = frozenset(s.to for s in supports if s.to)
        bodies = self.bodies(members, fixed)
        loads = tuple(
            self.read_load(node, Phrase("load", number=k), bodies) for k, node in self.numbered_entries("loads")
        )
        method = self.scene.optional_node("method")
        way = None if method is None else self.reader.read_word(method, section_in_words("method"), SOLUTION_METHODS)
        pole, through = self.read_string_pole()
        places = MappingProxyType(self.points)
        return Framework(places, MappingProxyType(bodies), members, supports, loads, way, pole, through, fixed)

    def numbered_entries(self, key: str) -> Iterator[tuple[int, Node]]:
        """The entries of a list in the scene, with their numbers."""
        node = self.scene.optional_node(key)
        yield from enumerate([] if node is None else self.reader.read_list(node, key), 1)

    def named_entries(self, key: str) -> Iterator[tuple[str, Node]]:
        """The entries under a key of the scene, by name."""
        node = self.scene.optional_node(key)
        yield from () if node is None else self.reader.read_table(node, section_in_words(key)).entries.items()

    def read_point_name(self, node: Node, what: Told) -> str:
        """A point of the scene."""
        return self.reader.read_known_name(node, what, self.points, Phrase("points_all"))

    def unused_name(self, name: str) -> str:
        """An unused name: numbered where the plain one is taken."""
        self.taken[name] = self.taken.get(name, 0) + 1
        return name if self.taken[name] == 1 else f"{name}_{self.taken[name]}"

    def bodies(self, members: tuple[NamePair, ...], fixed: frozenset[str]) -> dict[str, NameTuple]:
        """The rigid bodies by their points: a truss is one; where no body is named, one body has all points."""
        own = {
            name: self.read_point_list(node, Phrase("body_of", name=name))
            for name, node in self.named_entries("bodies")
        }
        if own and members:
            self.scene.require_one_key("bodies", "members")
        return own or {ONLY_BODY_NAME: tuple(p for p in self.points if p not in fixed)}

    def read_point_list(self, node: Node, what: Told) -> NameTuple:
        """Points in a list."""
        return tuple(dict.fromkeys(self.read_point_name(x, what) for x in self.reader.read_list(node, what)))

    def read_members(self) -> Iterator[NamePair]:
        """The members of a truss: [AB, BC] or [[A1, B], …]."""
        seen = set()
        for k, entry in self.numbered_entries("members"):
            what = Phrase("entry", number=k, what=section_in_words("members"))
            ends = (
                self.read_point_list(entry, what) if isinstance(entry, Items) else self.split_member_name(entry, what)
            )
            if len(ends) != 2 or frozenset(ends) in seen:
                raise self.reader.error_by_key("member_ends", entry, what=what, names=ends)
            seen.add(frozenset(ends))
            yield ends

    def split_member_name(self, node: Node, what: Told) -> NameTuple:
        """The two points of a member's name."""
        text = self.reader.read_text(node, what)
        ways = [(text[:k], text[k:]) for k in range(1, len(text)) if {text[:k], text[k:]} <= self.points.keys()]
        if len(ways) != 1:
            raise self.reader.error_by_key("member_name", node, what=what, name=text[:60])
        return ways[0]

    def read_supports_at_point(self, point: str, node: Node) -> Iterator[Support]:
        """The supports at a point, one or several."""
        name = self.reader.read_known_name(
            SourceScalar(point, node.line), section_in_words("supports"), self.points, Phrase("points_all")
        )
        for entry in node.items if isinstance(node, Items) else [node]:
            yield self.read_support(name, entry)

    def read_support(self, point: str, node: Node) -> Support:
        what = Phrase("support_of", name=point)
        reader = self.reader
        if not isinstance(node, SourceTable):
            kind = reader.read_word(node, what, SUPPORT_KINDS)
            if kind in ("rod", "rope"):
                raise reader.error_by_key("rod_to", node, what=what, kind=kind)
            return Support(kind, point, self.unused_name(f"R_{point}"))  # type: ignore[arg-type]  # one of its words
        support = Fields(reader, node, what, KEYS_BY_TABLE["support"])
        kind = support.require_one_key(*KEYS_BY_TABLE["support"])
        if kind == "roller":
            normal = reader.read_number(node.entries[kind], support.phrase_of_key(kind))
            return Support("roller", point, self.unused_name(f"R_{point}"), normal)
        to = self.read_point_name(node.entries[kind], support.phrase_of_key(kind))
        if self.points[to] == self.points[point]:
            raise reader.error_by_key("rod_to", node, what=what, kind=kind)
        return Support(kind, point, self.unused_name(f"S_{point}{to}"), to=to)  # type: ignore[arg-type]  # one of its words

    def read_load(self, node: Node, what: Phrase, bodies: Bodies) -> StaticLoad:
        load = Fields(self.reader, node, what, KEYS_BY_TABLE["static_load"])
        kind = load.require_one_key("force", "moment", "intensity")
        if kind == "moment":
            alone = next(iter(bodies)) if len(bodies) == 1 and "body" not in load else None
            body = alone or self.read_load_body(load, bodies)
            return StaticLoad(self.unused_name(f"M_{body}"), body, self.read_number_or_law(load, kind))
        if load.optional_node("direction") is None and kind == "force":
            raise load.error_by_key("force_no_direction", what=what)
        angle = -90.0 if load.optional_node("direction") is None else self.read_number_or_law(load, "direction")
        if kind == "intensity":
            if isinstance(angle, LoadLaw):
                raise load.error_by_key("intensity_turns", "direction", what=what)
            return self.read_distributed_load(load, bodies, angle)
        point = self.read_load_point(load, "point")
        size = self.read_number_or_law(load, kind)
        body = self.read_load_body(load, bodies) if "body" in load else self.body_of_points(load, bodies, point)
        return StaticLoad(self.unused_name(f"P_{point}"), body, size, angle, self.points[point], point)

    def read_number_or_law(self, load: Fields, key: str) -> float | LoadLaw:
        """A number, or a law of the drive."""
        node = load.required_node(key)
        if not (self.laws and self.laws.changes_with_drive(node)):
            return load.read_number(key)
        amount = self.laws.read_amount_or_law(node, load.phrase_of_key(key))
        return amount if isinstance(amount, LoadLaw) else float(amount)

    def read_load_point(self, load: Fields, key: str) -> str:
        """The named point of a load."""
        return self.read_point_name(load.required_node(key), load.phrase_of_key(key))

    def read_load_body(self, load: Fields, bodies: Bodies) -> str:
        """The named body of a load."""
        return load.read_known_name("body", bodies, Phrase("bodies_all"))

    def body_of_points(self, load: Fields, bodies: Bodies, *points: str) -> str:
        """The first body that has all the points."""
        own = next((name for name, its_points in bodies.items() if {*points} <= {*its_points}), None)
        if own is None:
            raise load.error_by_key("point_loose", what=load.what, name=points[-1])
        return own

    def read_distributed_load(self, load: Fields, bodies: Bodies, angle: float) -> StaticLoad:
        """The resultant of a distributed load: N/m, constant or from one value to another."""
        reader = self.reader
        what = load.what
        ends = self.read_load_point(load, "from"), self.read_load_point(load, "to")
        node = load.required_node("intensity")
        nodes = reader.read_list(node, what) if isinstance(node, Items) else [node, node]
        if len(nodes) != 2:
            raise reader.error_by_key("intensity_pair", node, what=what, count=len(nodes))
        first, last = (reader.read_number(x, load.phrase_of_key("intensity")) for x in nodes)
        start, end = (self.points[p] for p in ends)
        size = abs(end - start) * (first + last) / 2
        if not 0.0 < abs(size) < LARGEST_SCENE_NUMBER or first * last < 0.0:
            raise load.error_by_key("intensity_none", what=what, one=ends[0], two=ends[1])
        place = start + (end - start) * (first + 2 * last) / (3 * (first + last))
        body = self.body_of_points(load, bodies, *ends)
        name = self.unused_name(f"Q_{''.join(ends)}")
        return StaticLoad(name, body, size, angle, place, spread=ends, intensity=(first, last))

    def read_string_pole(self) -> tuple[complex | None, NameTuple]:
        """The pole of a string polygon, or the points its strings must pass through."""
        node = self.scene.optional_node("pole")
        if not isinstance(node, SourceTable) or "through" not in node.entries:
            return None if node is None else self.reader.read_place(node, section_in_words("pole")), ()
        pole = Fields(self.reader, node, section_in_words("pole"), KEYS_BY_TABLE["pole"])
        names = self.read_point_list(pole.required_node("through"), pole.phrase_of_key("through"))
        if len(names) not in (2, 3):
            raise self.reader.error_by_key("through_count", node, count=len(names))
        return None, names


def read_subject(scene: Fields, laws: LawReader | None) -> Framework:
    """The bodies, supports and loads of a scene."""
    return FrameworkReader(scene, laws).read_framework()


WORDS_BY_LIST = {"supports": SUPPORT_KINDS, "methods": SOLUTION_METHODS}
