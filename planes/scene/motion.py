"""What moves and loads a mechanism of a scene: assembly, drive, loads."""

from collections.abc import Mapping
from typing import cast

from planes.scene.load_laws import LawReader
from planes.scene.mechanism import FRAME, RATES, Amount, Assembly, Drive, Link, Load, Order, Sense, StrokeLoad
from planes.scene.reader import MOST_TURNS, Reader, part, section
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.words import Phrase

ORDERS = ("left", "right", "ahead", "behind")
_DIRECTIONS = ("direction", "along", "against")
LOAD_KEYS = ("link", "point", "force", "moment", *_DIRECTIONS)
DRIVE_KEYS = ("link", "on", "phi", "omega", "epsilon", "s", "velocity", "acceleration", "balance")
BALANCE_KEYS = ("point", "angle")
Links = Mapping[str, Link]


def read_assembly(reader: Reader, node: Node, frame: Link, links: Links) -> dict[str, Assembly]:
    """Which place of each group is meant, by the name of a point or a guide."""
    table = reader.table(node, "assembly")
    points = {point: None for link in (*links.values(), frame) for point in link.points}
    guides = {guide: None for link in (*links.values(), frame) for guide in link.guides}
    for name, line in table.lines.items():
        if name not in points and name not in guides:
            reader.check_colon(table, name, (*points, *guides))
            valid = reader.offer(name, (*points, *guides), Phrase("points_all"))
            raise reader.error(Phrase("assembly_name", name=name[:60], valid=valid), line)
    return {name: _assembly(reader, name, entry) for name, entry in table.entries.items()}


def _assembly(reader: Reader, name: str, node: Node) -> Assembly:
    what = Phrase("assembly_of", name=name)
    if isinstance(node, SourceScalar):
        return Assembly(cast(Order, reader.word(node, what, ORDERS)))
    table = reader.table(node, what, ("near",))
    return Assembly(near=reader.place(reader.required(table, "near", what), part("near", what)))


def read_drive(reader: Reader, node: Node, frame: Link, links: Links) -> Drive:
    """The driver, where it stands and how it moves."""
    what = section("drive")
    if isinstance(node, Items):
        raise reader.error(Phrase("one_drive"), node)
    table = reader.table(node, what, DRIVE_KEYS)
    link = _moving(reader, reader.required(table, "link", what), part("link", what), links)
    kind = reader.one_of(table, ("phi", "s"), what)
    _check_rates(reader, table, kind)
    slides = links[link].slides
    if kind == "s" and slides is None:
        raise reader.error(Phrase("drive_no_slide", link=link), table.lines["s"])
    rates = (reader.said(table, key, what) for key in RATES[kind])
    velocity, acceleration = (0.0 if rate is None else rate for rate in rates)
    position = reader.number(reader.required(table, kind, what), part(kind, what))
    if kind == "phi" and abs(position) > 360.0 * MOST_TURNS:
        why = Phrase("range_far", option=part(kind, what), text=f"{position:.10g}", most=MOST_TURNS)
        raise reader.error(why, table.lines[kind])
    on = _turned_on(reader, table, kind, link, links)
    balance = _balance(reader, table, kind, links[link])
    return Drive(link, "phi" if kind == "phi" else "s", position, velocity, acceleration, on, balance)


def _balance(reader: Reader, table: SourceTable, kind: str, link: Link) -> tuple[str, float] | None:
    """The point and the line of a balancing force on a driver that turns, beside the balancing moment."""
    node, what = reader.optional(table, "balance"), part("balance", section("drive"))
    if node is None:
        return None
    if kind == "s":
        raise reader.error(Phrase("balance_slides"), table.lines["balance"])
    own = reader.table(node, what, BALANCE_KEYS)
    points = Phrase("points_of", owner=Phrase("link", name=link.name))
    point = reader.known(reader.required(own, "point", what), part("point", what), link.points, points)
    angle = reader.said(own, "angle", what)
    return point, 90.0 if angle is None else angle


def _turned_on(reader: Reader, table: SourceTable, kind: str, link: str, links: Links) -> str:
    """The link that the driver turns on."""
    if "on" not in table.entries:
        return FRAME
    if kind == "s":
        raise reader.error(Phrase("drive_on_guide", link=link), table.lines["on"])
    what, known = part("on", section("drive")), {FRAME: None, **links}
    return reader.known(table.entries["on"], what, {k: v for k, v in known.items() if k != link}, Phrase("links_all"))


def _check_rates(reader: Reader, table: SourceTable, kind: str) -> None:
    other = "s" if kind == "phi" else "phi"
    for wrong, right in zip(RATES[other], RATES[kind], strict=True):
        if wrong in table.entries:
            raise reader.error(Phrase("other_rate", kind=kind, wrong=wrong, right=right), table.lines[wrong])


def _moving(reader: Reader, node: Node, what: Phrase, links: Links) -> str:
    if isinstance(node, SourceScalar) and node.text == FRAME and FRAME not in links:
        valid = reader.offer(FRAME, links, Phrase("links_all"))
        raise reader.error(Phrase("frame_still", what=what, valid=valid), node)
    return reader.known(node, what, links, Phrase("links_all"))


def read_loads(laws: LawReader, node: Node, links: Links) -> tuple[Load, ...]:
    """Forces and couples in the order of the file."""
    entries = enumerate(laws.reader.items(node, "loads"), 1)
    return tuple(_load(laws, entry, Phrase("load", number=number), links) for number, entry in entries)


def _load(laws: LawReader, node: Node, what: Phrase, links: Links) -> Load:
    reader = laws.reader
    table = reader.table(node, what, LOAD_KEYS)
    link = _moving(reader, reader.required(table, "link", what), part("link", what), links)
    kind = reader.one_of(table, ("force", "moment"), what)
    value = laws.value(reader.required(table, kind, what), part(kind, what), link)
    if kind == "moment":
        return _moment(reader, table, what, link, value)
    if "point" not in table.entries:
        valid = reader.offer("", links[link].points, Phrase("points_all"))
        raise reader.error(Phrase("force_no_point", what=what, valid=valid), table)
    node, points = reader.required(table, "point", what), Phrase("points_of", owner=Phrase("link", name=link))
    point = reader.known(node, part("point", what), links[link].points, points)
    if not any(key in table.entries for key in _DIRECTIONS):
        raise reader.error(Phrase("force_no_direction", what=what), table)
    form = reader.one_of(table, _DIRECTIONS, what)
    if form != "direction":
        return Load(link, "force", value, point, sense=_sense(reader, table, form, what))
    degrees, owner = _direction(laws, reader.required(table, form, what), part("direction", what), links)
    return Load(link, "force", value, point, degrees, owner)


def _moment(reader: Reader, table: SourceTable, what: Phrase, link: str, value: Amount | StrokeLoad) -> Load:
    for key in ("direction", "point"):
        if key in table.entries:
            raise reader.error(Phrase("moment_has_no", what=what, key=key), table.lines[key])
    if not any(key in table.entries for key in ("along", "against")):
        return Load(link, "moment", value)
    form = reader.one_of(table, ("along", "against"), what)
    return Load(link, "moment", value, sense=_sense(reader, table, form, what))


def _sense(reader: Reader, table: SourceTable, form: str, what: Phrase) -> Sense:
    reader.word(reader.required(table, form, what), part(form, what), ("motion",))
    return "along" if form == "along" else "against"


def _direction(laws: LawReader, node: Node, what: Phrase, links: Links) -> tuple[Amount, str | None]:
    reader = laws.reader
    if not isinstance(node, SourceTable):
        return laws.amount(node, what), None
    table = reader.table(node, what, ("link", "angle"))
    said, known = reader.required(table, "link", what), {FRAME: None, **links}
    owner = reader.known(said, part("link", what), known, Phrase("links_all"))
    degrees = laws.amount(reader.required(table, "angle", what), part("angle", what))
    return degrees, None if owner == FRAME else owner
