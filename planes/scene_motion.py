"""What moves and loads a mechanism of a scene: assembly, drive, loads, friction."""

from __future__ import annotations

from collections.abc import Mapping
from typing import cast

from planes.mechanism import FRAME, Assembly, Drive, Link, Load, Order, Sense
from planes.scene_reader import Reader
from planes.source import Node, Table, Text

_ORDERS = ("left", "right", "ahead", "behind")
_RATES: dict[str, tuple[str, str]] = {"phi": ("omega", "epsilon"), "s": ("velocity", "acceleration")}
_DIRECTIONS = ("direction", "along", "against")
Links = Mapping[str, Link]


def read_assembly(reader: Reader, node: Node, frame: Link, links: Links) -> dict[str, Assembly]:
    """Which place of each group is meant, by the name of a point or a guide."""
    table = reader.table(node, "assembly")
    points = {point: None for link in (*links.values(), frame) for point in link.points}
    guides = {guide: None for link in (*links.values(), frame) for guide in link.guides}
    for name, line in table.lines.items():
        if name not in points and name not in guides:
            raise reader.error(f'assembly: there is no point or guide "{name[:60]}"'
                               f"{reader.offer(name, (*points, *guides), 'point')}", line)
    return {name: _assembly(reader, name, entry) for name, entry in table.entries.items()}


def _assembly(reader: Reader, name: str, node: Node) -> Assembly:
    what = f"assembly of {name}"
    if isinstance(node, Text):
        return Assembly(cast(Order, reader.word(node, what, _ORDERS)))
    table = reader.table(node, what, ("near",))
    return Assembly(near=reader.place(reader.required(table, "near", what), f"near of {what}"))


def read_drive(reader: Reader, node: Node, frame: Link, links: Links) -> Drive:
    """The driver, where it stands and how it moves."""
    table = reader.table(node, "drive", ("link", "phi", "omega", "epsilon", "s", "velocity", "acceleration"))
    link = _moving(reader, reader.required(table, "link", "drive"), "link of drive", links)
    kind = reader.one_of(table, ("phi", "s"), "drive")
    _check_rates(reader, table, kind)
    slides = links[link].slides
    if kind == "s" and (slides is None or slides.guide not in frame.guides):
        raise reader.error(f"drive gives s, but link {link} slides on no guide of the frame; write phi, "
                           f"or slides of link {link}", table.lines["s"])
    rates = [reader.optional(table, key) for key in _RATES[kind]]
    velocity, acceleration = (0.0 if rate is None else reader.number(rate, f"{key} of drive")
                              for key, rate in zip(_RATES[kind], rates, strict=True))
    position = reader.number(reader.required(table, kind, "drive"), f"{kind} of drive")
    return Drive(link, "phi" if kind == "phi" else "s", position, velocity, acceleration)


def _check_rates(reader: Reader, table: Table, kind: str) -> None:
    other = "s" if kind == "phi" else "phi"
    for wrong, right in zip(_RATES[other], _RATES[kind], strict=True):
        if wrong in table.entries:
            raise reader.error(f"a drive given by {kind} has no {wrong}; write {right}", table.lines[wrong])


def _moving(reader: Reader, node: Node, what: str, links: Links) -> str:
    if isinstance(node, Text) and node.text == FRAME and FRAME not in links:
        raise reader.error(f"{what} is 0, the frame, which does not move{reader.offer(FRAME, links, 'link')}", node)
    return reader.known(node, what, links, "link")


def read_loads(reader: Reader, node: Node, links: Links) -> tuple[Load, ...]:
    """Forces and couples in the order of the file."""
    return tuple(_load(reader, entry, f"load {number}", links)
                 for number, entry in enumerate(reader.items(node, "loads"), 1))


def _load(reader: Reader, node: Node, what: str, links: Links) -> Load:
    table = reader.table(node, what, ("link", "point", "force", "moment", *_DIRECTIONS))
    link = _moving(reader, reader.required(table, "link", what), f"link of {what}", links)
    kind = reader.one_of(table, ("force", "moment"), what)
    value = reader.number(reader.required(table, kind, what), f"{kind} of {what}")
    if kind == "moment":
        return _moment(reader, table, what, link, value)
    if "point" not in table.entries:
        raise reader.error(f"{what} is a force, so it needs the key point"
                           f"{reader.offer('', links[link].points, 'point')}", table)
    point = reader.known(reader.required(table, "point", what), f"point of {what}", links[link].points,
                         f"point of link {link}")
    if not any(key in table.entries for key in _DIRECTIONS):
        raise reader.error(f"{what} has no direction; write direction: degrees, along: motion or against: motion",
                           table)
    form = reader.one_of(table, _DIRECTIONS, what)
    if form != "direction":
        return Load(link, "force", value, point, sense=_sense(reader, table, form, what))
    degrees, owner = _direction(reader, reader.required(table, form, what), f"direction of {what}", links)
    return Load(link, "force", value, point, degrees, owner)


def _moment(reader: Reader, table: Table, what: str, link: str, value: float) -> Load:
    for key in ("direction", "point"):
        if key in table.entries:
            raise reader.error(f"{what} is a moment, so it has no {key}; a positive one turns counter-clockwise",
                               table.lines[key])
    if not any(key in table.entries for key in ("along", "against")):
        return Load(link, "moment", value)
    form = reader.one_of(table, ("along", "against"), what)
    return Load(link, "moment", value, sense=_sense(reader, table, form, what))


def _sense(reader: Reader, table: Table, form: str, what: str) -> Sense:
    reader.word(reader.required(table, form, what), f"{form} of {what}", ("motion",))
    return "along" if form == "along" else "against"


def _direction(reader: Reader, node: Node, what: str, links: Links) -> tuple[float, str | None]:
    if not isinstance(node, Table):
        return reader.number(node, what), None
    table = reader.table(node, what, ("link", "angle"))
    owner = reader.known(reader.required(table, "link", what), f"link of {what}", {FRAME: None, **links}, "link")
    degrees = reader.number(reader.required(table, "angle", what), f"angle of {what}")
    return degrees, None if owner == FRAME else owner


def read_friction(reader: Reader, node: Node, frame: Link, links: Links) -> dict[str, float]:
    """Coefficients of friction by the name of the guide."""
    table = reader.table(node, "friction")
    slid = {link.slides.guide: None for link in links.values() if link.slides}
    guides = {guide for link in (frame, *links.values()) for guide in link.guides}
    for name, line in table.lines.items():
        if name not in slid:
            why = "no link slides on guide" if name in guides else "there is no guide"
            raise reader.error(f'friction: {why} "{name[:60]}"{reader.offer(name, slid, "sliding pair")}', line)
    return {name: reader.positive(entry, f"friction of {name}") for name, entry in table.entries.items()}


def read_gravity(reader: Reader, node: Node) -> float:
    """The acceleration of gravity, downwards."""
    return reader.positive(node, "gravity (it acts downwards)")


