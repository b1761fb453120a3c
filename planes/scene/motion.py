"""Motion and loading of a mechanism in a scene: assembly, drive, loads."""

from collections.abc import Iterable, Mapping
from typing import cast

from planes.scene.load_laws import LawReader
from planes.scene.mechanism import (
    FRAME,
    RATES,
    Amount,
    Assembly,
    Drive,
    DriveKind,
    Link,
    Load,
    Order,
    Sense,
    StrokeLoad,
)
from planes.scene.reader import MOST_TURNS, Fields, Reader, section
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.words import Phrase

ORDERS = ("left", "right", "ahead", "behind")
_DIRECTIONS = ("direction", "along", "against")
LOAD_KEYS = ("link", "point", "force", "moment", *_DIRECTIONS)
DRIVE_KEYS = ("link", "on", "phi", "omega", "epsilon", "s", "velocity", "acceleration", "balance")
BALANCE_KEYS = ("point", "angle")
Links = Mapping[str, Link]


def read_assembly(reader: Reader, node: Node, frame: Link, links: Links) -> dict[str, Assembly]:
    """The chosen assembly of each group, by the name of a point or a guide."""
    table = reader.table(node, "assembly")
    points = {point: None for link in (*links.values(), frame) for point in link.points}
    guides = {guide: None for link in (*links.values(), frame) for guide in link.guides}
    for name, line in table.lines.items():
        if name not in points and name not in guides:
            reader.check_colon(table, name, (*points, *guides))
            valid = reader.offer(name, (*points, *guides))
            raise reader.fault("assembly_name", line, name=name[:60], valid=valid)
    return {name: _assembly(reader, name, entry, (*links.values(), frame)) for name, entry in table.entries.items()}


def _assembly(reader: Reader, name: str, node: Node, links: Iterable[Link]) -> Assembly:
    what = Phrase("assembly_of", name=name)
    if isinstance(node, SourceScalar):
        own = [link.slides for link in links if name in link.points]
        fitting = ORDERS[2:] if any(own[:2]) or not own else ORDERS[:2]
        return Assembly(cast(Order, reader.word(node, what, ORDERS if node.text in ORDERS else fitting)))
    return Assembly(near=Fields(reader, node, what, ("near",)).place("near"))


def read_drive(reader: Reader, node: Node, links: Links) -> Drive:
    """The driver, its position and its motion."""
    if isinstance(node, Items):
        raise reader.fault("one_drive", node)
    drive = Fields(reader, node, section("drive"), DRIVE_KEYS)
    link = _moving(drive, links)
    kind = cast(DriveKind, drive.one_of("phi", "s"))
    for wrong, right in zip(RATES["s" if kind == "phi" else "phi"], RATES[kind], strict=True):
        if wrong in drive:
            raise drive.fault("other_rate", wrong, kind=kind, wrong=wrong, right=right)
    if kind == "s" and links[link].slides is None:
        raise drive.fault("drive_no_slide", "s", link=link)
    velocity, acceleration = (drive.number(key, 0.0) for key in RATES[kind])
    position = drive.number(kind)
    if kind == "phi" and abs(position) > 360.0 * MOST_TURNS:
        why = Phrase("range_far", option=drive.named(kind), text=f"{position:.10g}", most=MOST_TURNS)
        raise drive.error(why, kind)
    on = _turned_on(drive, kind, link, links)
    return Drive(link, kind, position, velocity, acceleration, on, _balance(drive, kind, links[link]))


def _balance(drive: Fields, kind: DriveKind, link: Link) -> tuple[str, float] | None:
    """The point and the line of a balancing force on a turning driver, beside the balancing moment."""
    if drive.optional("balance") is None:
        return None
    if kind == "s":
        raise drive.fault("balance_slides", "balance")
    own = drive.inner("balance", BALANCE_KEYS)
    return own.known("point", link.points, _points_of(link.name)), own.number("angle", 90.0)


def _points_of(link: str) -> Phrase:
    return Phrase("points_of", owner=Phrase("link", name=link))


def _turned_on(drive: Fields, kind: DriveKind, link: str, links: Links) -> str:
    """The link that the driver turns on."""
    if "on" not in drive:
        return FRAME
    if kind == "s":
        raise drive.fault("drive_on_guide", "on", link=link)
    return drive.known("on", {k: None for k in (FRAME, *links) if k != link}, Phrase("links_all"))


def _moving(fields: Fields, links: Links) -> str:
    node, kind = fields.required("link"), Phrase("links_all")
    if isinstance(node, SourceScalar) and node.text == FRAME and FRAME not in links:
        valid = fields.reader.offer(FRAME, links)
        raise fields.reader.fault("frame_still", node, what=fields.named("link"), valid=valid)
    return fields.known("link", links, kind)


def read_loads(laws: LawReader, node: Node, links: Links) -> tuple[Load, ...]:
    """Forces and couples in the order of the file."""
    entries = enumerate(laws.reader.items(node, "loads"), 1)
    return tuple(_load(laws, entry, Phrase("load", number=number), links) for number, entry in entries)


def _load(laws: LawReader, node: Node, what: Phrase, links: Links) -> Load:
    load = Fields(laws.reader, node, what, LOAD_KEYS)
    link = _moving(load, links)
    kind = load.one_of("force", "moment")
    value = laws.value(load.required(kind), load.named(kind), link)
    if kind == "moment":
        return _moment(load, link, value)
    points = links[link].points
    if "point" not in load:
        valid = laws.reader.offer("", points)
        raise load.fault("force_no_point", what=what, valid=valid)
    point = load.known("point", points, _points_of(link))
    if not any(key in load for key in _DIRECTIONS):
        raise load.fault("force_no_direction", what=what)
    form = load.one_of(*_DIRECTIONS)
    if form != "direction":
        return Load(link, "force", value, point, sense=_sense(load, form))
    return Load(link, "force", value, point, *_direction(laws, load, links))


def _moment(load: Fields, link: str, value: Amount | StrokeLoad) -> Load:
    for key in ("direction", "point"):
        if key in load:
            raise load.fault("moment_has_no", key, what=load.what, key=key)
    if "along" not in load and "against" not in load:
        return Load(link, "moment", value)
    return Load(link, "moment", value, sense=_sense(load, load.one_of("along", "against")))


def _sense(load: Fields, form: str) -> Sense:
    load.word(form, ("motion",))
    return "along" if form == "along" else "against"


def _direction(laws: LawReader, load: Fields, links: Links) -> tuple[Amount, str | None]:
    node = load.required("direction")
    if not isinstance(node, SourceTable):
        return laws.amount(node, load.named("direction")), None
    turned = load.inner("direction", ("link", "angle"))
    owner = turned.known("link", {FRAME: None, **links}, Phrase("links_all"))
    degrees = laws.amount(turned.required("angle"), turned.named("angle"))
    return degrees, None if owner == FRAME else owner
