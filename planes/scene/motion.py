"""Motion and loading of a mechanism in a scene: assembly, drive, loads."""

from collections.abc import Iterable
from typing import cast

from planes.scene.load_laws import LawReader
from planes.scene.mechanism import (
    DRIVE_RATE_KEYS,
    FRAME,
    LOAD_KEYS,
    LOAD_KINDS,
    Amount,
    Assembly,
    Drive,
    DriveKind,
    Link,
    Links,
    Load,
    Order,
    Sense,
    StrokeLoad,
)
from planes.scene.reader import MOST_ANGLE_TURNS, Fields, Reader, section_in_words
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.words import Phrase

ASSEMBLY_ORDERS = ("left", "right", "ahead", "behind")
_DIRECTION_KEYS = ("direction", "along", "against")
DRIVE_KEYS = ("link", "on", "phi", "omega", "epsilon", "s", "velocity", "acceleration", "balance")
BALANCE_KEYS = ("point", "angle")


def read_assembly(reader: Reader, node: Node, frame: Link, links: Links) -> dict[str, Assembly]:
    """The chosen assembly of each group, by the name of a point or a guide."""
    table = reader.read_table(node, "assembly")
    points = {point: None for link in (*links.values(), frame) for point in link.points}
    guides = {guide: None for link in (*links.values(), frame) for guide in link.guides}
    for name, line in table.lines.items():
        if name not in points and name not in guides:
            reader.check_colon(table, name, (*points, *guides))
            valid = reader.valid_names_in_words(name, (*points, *guides))
            raise reader.error_by_key("assembly_name", line, name=name[:60], valid=valid)
    return {
        name: _read_assembly_choice(reader, name, entry, (*links.values(), frame))
        for name, entry in table.entries.items()
    }


def _read_assembly_choice(reader: Reader, name: str, node: Node, links: Iterable[Link]) -> Assembly:
    what = Phrase("assembly_of", name=name)
    if isinstance(node, SourceScalar):
        own = [link.slides for link in links if name in link.points]
        fitting = ASSEMBLY_ORDERS[2:] if any(own[:2]) or not own else ASSEMBLY_ORDERS[:2]
        return Assembly(
            cast(Order, reader.read_word(node, what, ASSEMBLY_ORDERS if node.text in ASSEMBLY_ORDERS else fitting))
        )
    return Assembly(near=Fields(reader, node, what, ("near",)).read_place("near"))


def read_drive(reader: Reader, node: Node, links: Links) -> Drive:
    """The driver, its position and its motion."""
    if isinstance(node, Items):
        raise reader.error_by_key("one_drive", node)
    drive = Fields(reader, node, section_in_words("drive"), DRIVE_KEYS)
    link = _read_moving_link(drive, links)
    kind = cast(DriveKind, drive.require_one_key("phi", "s"))
    for wrong, right in zip(DRIVE_RATE_KEYS["s" if kind == "phi" else "phi"], DRIVE_RATE_KEYS[kind], strict=True):
        if wrong in drive:
            raise drive.error_by_key("other_rate", wrong, kind=kind, wrong=wrong, right=right)
    if kind == "s" and links[link].slides is None:
        raise drive.error_by_key("drive_no_slide", "s", link=link)
    velocity, acceleration = (drive.read_number(key, 0.0) for key in DRIVE_RATE_KEYS[kind])
    position = drive.read_number(kind)
    if kind == "phi" and abs(position) > 360.0 * MOST_ANGLE_TURNS:
        why = Phrase("range_far", option=drive.phrase_of_key(kind), text=f"{position:.10g}", most=MOST_ANGLE_TURNS)
        raise drive.error(why, kind)
    on = _read_carrier_of_driver(drive, kind, link, links)
    return Drive(link, kind, position, velocity, acceleration, on, _read_balancing_force(drive, kind, links[link]))


def _read_balancing_force(drive: Fields, kind: DriveKind, link: Link) -> tuple[str, float] | None:
    """The point and the line of a balancing force on a turning driver, beside the balancing moment."""
    if drive.optional_node("balance") is None:
        return None
    if kind == "s":
        raise drive.error_by_key("balance_slides", "balance")
    own = drive.inner_fields("balance", BALANCE_KEYS)
    return own.read_known_name("point", link.points, _points_of_link_in_words(link.name)), own.read_number(
        "angle", 90.0
    )


def _points_of_link_in_words(link: str) -> Phrase:
    return Phrase("points_of", owner=Phrase("link", name=link))


def _read_carrier_of_driver(drive: Fields, kind: DriveKind, link: str, links: Links) -> str:
    """The link that the driver turns on."""
    if "on" not in drive:
        return FRAME
    if kind == "s":
        raise drive.error_by_key("drive_on_guide", "on", link=link)
    return drive.read_known_name("on", {k: None for k in (FRAME, *links) if k != link}, Phrase("links_all"))


def _read_moving_link(fields: Fields, links: Links) -> str:
    node = fields.required_node("link")
    kind = Phrase("links_all")
    if isinstance(node, SourceScalar) and node.text == FRAME and FRAME not in links:
        valid = fields.reader.valid_names_in_words(FRAME, links)
        raise fields.reader.error_by_key("frame_still", node, what=fields.phrase_of_key("link"), valid=valid)
    return fields.read_known_name("link", links, kind)


def read_loads(laws: LawReader, node: Node, bodies: Links) -> tuple[Load, ...]:
    """The loads in the order of the file; ``bodies`` are the links and the frame."""
    entries = enumerate(laws.reader.read_list(node, "loads"), 1)
    return tuple(_read_load(laws, entry, Phrase("load", number=number), bodies) for number, entry in entries)


def _read_load(laws: LawReader, node: Node, what: Phrase, bodies: Links) -> Load:
    load = Fields(laws.reader, node, what, LOAD_KEYS)
    link = _read_moving_link(load, laws.links)
    kind = load.require_one_key(*LOAD_KINDS)
    value = laws.read_load_magnitude(load.required_node(kind), load.phrase_of_key(kind), link)
    if kind == "moment":
        return _read_moment(load, link, value)
    points = bodies[link].points
    if "point" not in load:
        valid = laws.reader.valid_names_in_words("", points)
        raise load.error_by_key("force_no_point", what=what, valid=valid)
    point = load.read_known_name("point", points, _points_of_link_in_words(link))
    if not any(key in load for key in _DIRECTION_KEYS):
        raise load.error_by_key("force_no_direction", what=what)
    form = load.require_one_key(*_DIRECTION_KEYS)
    if form != "direction":
        return Load(link, "force", value, point, sense=_read_sense(load, form))
    return Load(link, "force", value, point, *_read_direction(laws, load, bodies))


def _read_moment(load: Fields, link: str, value: Amount | StrokeLoad) -> Load:
    for key in ("direction", "point"):
        if key in load:
            raise load.error_by_key("moment_has_no", key, what=load.what, key=key)
    if "along" not in load and "against" not in load:
        return Load(link, "moment", value)
    return Load(link, "moment", value, sense=_read_sense(load, load.require_one_key("along", "against")))


def _read_sense(load: Fields, form: str) -> Sense:
    load.read_word(form, ("motion",))
    return "along" if form == "along" else "against"


def _read_direction(laws: LawReader, load: Fields, bodies: Links) -> tuple[Amount, str | None]:
    node = load.required_node("direction")
    if not isinstance(node, SourceTable):
        return laws.read_amount_or_law(node, load.phrase_of_key("direction")), None
    turned = load.inner_fields("direction", ("link", "angle"))
    owner = turned.read_known_name("link", bodies, Phrase("links_all"))
    degrees = laws.read_amount_or_law(turned.required_node("angle"), turned.phrase_of_key("angle"))
    return degrees, None if owner == FRAME else owner
