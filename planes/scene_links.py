"""The frame and the links of a scene: their points, guides, slides and masses."""

from __future__ import annotations

from types import MappingProxyType

from planes.mechanism import FRAME, Guide, Link, Slide
from planes.scene_reader import Reader
from planes.source import Node, Table, Text

_LINK_KEYS = ("points", "guides", "slides", "centre", "mass", "inertia")
_FRAME_KEYS = ("points", "guides", "number")
_GUIDE_KEYS = ("x", "y", "through", "angle", "mark")


def read_frame(reader: Reader, node: Node) -> Link:
    """The frame: fixed points and guides, at least one of either."""
    table = reader.table(node, "the frame", _FRAME_KEYS)
    points = _points(reader, reader.optional(table, "points"), "the frame")
    guides = _guides(reader, reader.optional(table, "guides"), points, "the frame")
    if not points and not guides:
        raise reader.error("the frame needs points or guides", table)
    return Link(FRAME, MappingProxyType(points), MappingProxyType(guides))


def read_links(reader: Reader, node: Node, frame: Link) -> dict[str, Link]:
    """The moving links in the order of the file, with every name they use checked."""
    table = reader.names(node, "links", "a link")
    if not table.entries:
        raise reader.error("links is empty; a mechanism needs at least one link", table)
    if FRAME in table.entries:
        raise reader.error("a link cannot be named 0, the frame's own name; write its points under frame",
                           table.lines[FRAME])
    links = {name: _link(reader, name, entry) for name, entry in table.entries.items()}
    owners = _owners(reader, table, links, frame)
    for link in links.values():
        if link.slides:
            _check_slide(reader, table, link, owners)
    return links


def _link(reader: Reader, name: str, node: Node) -> Link:
    what = f"link {name}"
    table = reader.table(node, what, _LINK_KEYS)
    points = _points(reader, reader.required(table, "points", what), what)
    if not points:
        raise reader.error(f"{what} has no points; name at least one", table.lines["points"])
    guides = _guides(reader, reader.optional(table, "guides"), points, what)
    slides, centre = reader.optional(table, "slides"), reader.optional(table, "centre")
    return Link(
        name, MappingProxyType(points), MappingProxyType(guides),
        None if slides is None else _slide(reader, slides, what),
        _mass(reader, table, "mass", what), _mass(reader, table, "inertia", what),
        None if centre is None else reader.known(centre, f"centre of {what}", points, f"point of {what}"))


def _mass(reader: Reader, table: Table, key: str, what: str) -> float | None:
    node = reader.optional(table, key)
    return None if node is None else reader.positive(node, f"{key} of {what}")


def _points(reader: Reader, node: Node | None, what: str) -> dict[str, complex]:
    if node is None:
        return {}
    table = reader.names(node, f"points of {what}", "a point")
    if "p" in table.entries:
        raise reader.error(f"a point of {what} cannot be named p, the pole of every plan; write P", table.lines["p"])
    return {name: reader.place(entry, f"point {name} of {what}", on_axis=True)
            for name, entry in table.entries.items()}


def _guides(reader: Reader, node: Node | None, points: dict[str, complex], what: str) -> dict[str, Guide]:
    if node is None:
        return {}
    table = reader.names(node, f"guides of {what}", "a guide")
    return {name: _guide(reader, name, entry, points, what) for name, entry in table.entries.items()}


def _guide(reader: Reader, name: str, node: Node, points: dict[str, complex], owner: str) -> Guide:
    what = f"guide {name}"
    table = reader.table(node, what, _GUIDE_KEYS)
    form = reader.one_of(table, ("x", "y", "through"), what)
    entry = reader.required(table, form, what)
    mark = None
    if (given := reader.optional(table, "mark")) is not None:
        mark = reader.check_name(reader.text(given, f"mark of {what}"), "a mark", given)
    if form != "through":
        if "angle" in table.entries:
            raise reader.error(f"{what} is given by {form}, so it has its angle already; remove angle "
                               "or write through", table.lines["angle"])
        value = reader.number(entry, f"{form} of {what}")
        through, angle = (complex(value, 0.0), 90.0) if form == "x" else (complex(0.0, value), 0.0)
        return Guide(name, through, angle, None, mark, origin_given=False)
    angle = reader.angle(table, what) or 0.0
    if isinstance(entry, Text):
        point = reader.known(entry, f"through of {what}", points, f"point of {owner}")
        return Guide(name, points[point], angle, point, mark)
    return Guide(name, reader.place(entry, f"through of {what}"), angle, None, mark)


def _slide(reader: Reader, node: Node, what: str) -> Slide:
    if isinstance(node, Text):
        return Slide(reader.text(node, f"slides of {what}"))
    table = reader.table(node, f"slides of {what}", ("guide", "angle", "offset"))
    guide = reader.text(reader.required(table, "guide", f"slides of {what}"), f"guide {what} slides on")
    offset = reader.optional(table, "offset")
    return Slide(guide, reader.angle(table, f"slides of {what}"),
                 None if offset is None else reader.number(offset, f"offset of {what}"))


def _owners(reader: Reader, table: Table, links: dict[str, Link], frame: Link) -> dict[str, str]:
    owners = dict.fromkeys(frame.guides, FRAME)
    for name, link in links.items():
        for guide in link.guides:
            if guide in owners:
                first = "the frame" if owners[guide] == FRAME else f"link {owners[guide]}"
                raise reader.error(f"the guide {guide} of link {name} has the name of a guide of {first}; "
                                   "guide names are unique in a scene", _at(table, name, "guides", guide))
            owners[guide] = name
    return owners


def _check_slide(reader: Reader, table: Table, link: Link, owners: dict[str, str]) -> None:
    guide = link.slides.guide if link.slides else ""
    if guide not in owners:
        others = [name for name, owner in owners.items() if owner != link.name]
        raise reader.error(f'link {link.name} slides on "{guide[:60]}", but there is no such guide'
                           f"{reader.offer(guide, others, 'guide')}", _at(table, link.name, "slides"))
    if owners[guide] == link.name:
        raise reader.error(f"link {link.name} slides on its own guide {guide}; the guide must be another link's "
                           "or the frame's", _at(table, link.name, "slides"))


def _at(node: Node, *path: str) -> int:
    """The line of a key somewhere below a table."""
    line = node.line
    for key in path:
        if isinstance(node, Table):
            line, node = node.lines[key], node.entries[key]
    return line
