"""The frame and the links of a scene: their points, guides, slides and masses.

A slider on a guide along a circle is a link that turns about its centre, and is solved as such a link.
"""

import cmath
import math
from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import chain, count
from types import MappingProxyType

from planes.scene.mechanism import FRAME, Guide, Link, RoundGuide, Slide
from planes.scene.reader import Reader, line_of, part
from planes.scene.source import Node, SourceScalar, SourceTable
from planes.words import Phrase
from planes.words.names import latin

LINK_KEYS = ("points", "guides", "slides", "centre", "mass", "inertia")
FRAME_KEYS = ("points", "guides", "number")
GUIDE_KEYS = ("x", "y", "through", "angle", "mark", "centre", "radius")
SLIDE_KEYS = ("guide", "angle", "offset", "length")
LETTERS = "KMNQTUVW"  # of a centre given by its place


def read_round(reader: Reader, name: str, table: SourceTable, points: dict[str, complex], owner: Phrase) -> RoundGuide:
    """A guide by its centre, a point of its link or a place that becomes one, and its radius."""
    what = Phrase("guide_named", name=name)
    for key in ("angle", "mark"):
        if key in table.entries:
            raise reader.error(Phrase("round_has_no", what=what, key=key), table.lines[key])
    entry, radius = reader.required(table, "centre", what), reader.required(table, "radius", what)
    if not (long := reader.positive(radius, part("radius", what))):
        raise reader.error(Phrase("round_radius", what=what), radius)
    if isinstance(entry, SourceScalar):
        centre = reader.known(entry, part("centre", what), points, Phrase("points_of", owner=owner))
    else:
        centre = next(x for x in chain(LETTERS, (f"K{k}" for k in count(1))) if x not in reader.taken)
        reader.taken.add(centre)
        points[centre] = reader.place(entry, part("centre", what))
    return RoundGuide(name, centre, long)


def parted(guides: Mapping[str, Guide | RoundGuide]) -> tuple[Mapping[str, Guide], Mapping[str, RoundGuide]]:
    """Straight guides and round ones."""
    straight = {name: g for name, g in guides.items() if isinstance(g, Guide)}
    return MappingProxyType(straight), MappingProxyType(
        {name: g for name, g in guides.items() if isinstance(g, RoundGuide)}
    )


def turning(link: Link, guides: Mapping[str, RoundGuide]) -> Link:
    """A slider on a round guide as the link that turns about its centre, which is to the left of the way it slides."""
    slide = link.slides
    if slide is None or slide.guide not in guides:
        return link
    guide, back = guides[slide.guide], cmath.rect(1.0, -math.radians(slide.angle_deg or 0.0))
    centre = link.points[link.first_point] + 1j * back * (guide.radius - (slide.offset or 0.0))
    points = MappingProxyType({**link.points, guide.centre: centre})
    return replace(link, points=points, slides=None, slides_round=slide)


def read_frame(reader: Reader, node: Node) -> Link:
    """The frame: fixed points and guides, at least one of either."""
    what = Phrase("the_frame")
    table = reader.table(node, what, FRAME_KEYS)
    points = _points(reader, reader.optional(table, "points"), what)
    guides, round_guides = parted(_guides(reader, reader.optional(table, "guides"), points, what))
    if not points and not guides:
        raise reader.error(Phrase("frame_empty"), table)
    return Link(FRAME, MappingProxyType(points), guides, round_guides=round_guides)


def read_links(reader: Reader, node: Node, frame: Link) -> dict[str, Link]:
    """The moving links in the order of the file, with every name they use checked."""
    table = reader.names(node, "links", Phrase("a_link"))
    if not table.entries:
        raise reader.error(Phrase("links_empty"), table)
    if FRAME in table.entries:
        raise reader.error(Phrase("link_zero"), table.lines[FRAME])
    links = {name: _link(reader, name, entry) for name, entry in table.entries.items()}
    _check_alike(reader, table, (frame, *links.values()))
    owners = _owners(reader, table, links, frame)
    for link in links.values():
        if link.slides:
            _check_slide(reader, table, link, owners)
    round_guides = {name: g for link in (frame, *links.values()) for name, g in link.round_guides.items()}
    for name, link in links.items():
        if link.slides and link.slides.guide in round_guides and round_guides[link.slides.guide].centre in link.points:
            raise reader.error(
                Phrase("round_held", name=name, guide=link.slides.guide), line_of(table, (name, "slides"))
            )
    return {name: turning(link, round_guides) for name, link in links.items()}


def _link(reader: Reader, name: str, node: Node) -> Link:
    what = Phrase("link", name=name)
    table = reader.table(node, what, LINK_KEYS)
    points = _points(reader, reader.required(table, "points", what), what)
    if not points:
        raise reader.error(Phrase("no_points", what=what), table.lines["points"])
    guides, round_guides = parted(_guides(reader, reader.optional(table, "guides"), points, what))
    slides, centre = reader.optional(table, "slides"), reader.optional(table, "centre")
    return Link(
        name,
        MappingProxyType(points),
        guides,
        None if slides is None else _slide(reader, slides, what),
        _mass(reader, table, "mass", what),
        _mass(reader, table, "inertia", what),
        None if centre is None else reader.known(centre, part("centre", what), points, Phrase("points_of", owner=what)),
        round_guides,
    )


def _mass(reader: Reader, table: SourceTable, key: str, what: Phrase) -> float | None:
    node = reader.optional(table, key)
    return None if node is None else reader.positive(node, part(key, what))


def _points(reader: Reader, node: Node | None, what: Phrase) -> dict[str, complex]:
    if node is None:
        return {}
    table = reader.names(node, part("points", what), Phrase("a_point"))
    if "p" in table.entries:
        raise reader.error(Phrase("point_pole", what=what), table.lines["p"])
    return {
        name: reader.place(entry, Phrase("point", name=name, owner=what), on_axis=True)
        for name, entry in table.entries.items()
    }


def _guides(
    reader: Reader, node: Node | None, points: dict[str, complex], what: Phrase
) -> dict[str, Guide | RoundGuide]:
    if node is None:
        return {}
    table = reader.names(node, part("guides", what), Phrase("a_guide"))
    return {name: _guide(reader, name, entry, points, what) for name, entry in table.entries.items()}


def _guide(reader: Reader, name: str, node: Node, points: dict[str, complex], owner: Phrase) -> Guide | RoundGuide:
    what = Phrase("guide_named", name=name)
    table = reader.table(node, what, GUIDE_KEYS)
    form = reader.one_of(table, ("x", "y", "through", "centre"), what)
    if form == "centre":
        return read_round(reader, name, table, points, owner)
    if "radius" in table.entries:
        raise reader.error(Phrase("radius_without_centre", what=what), table.lines["radius"])
    entry = reader.required(table, form, what)
    mark = None
    if (given := reader.optional(table, "mark")) is not None:
        mark = reader.check_name(reader.text(given, part("mark", what)), Phrase("a_mark"), given)
    if form != "through":
        if "angle" in table.entries:
            raise reader.error(Phrase("angle_already", what=what, form=form), table.lines["angle"])
        value = reader.number(entry, part(form, what))
        through, angle = (complex(value, 0.0), 90.0) if form == "x" else (complex(0.0, value), 0.0)
        return Guide(name, through, angle, None, mark, origin_given=False)
    angle = reader.said(table, "angle", what) or 0.0
    if isinstance(entry, SourceScalar):
        point = reader.known(entry, part("through", what), points, Phrase("points_of", owner=owner))
        return Guide(name, points[point], angle, point, mark)
    return Guide(name, reader.place(entry, part("through", what)), angle, None, mark)


def _slide(reader: Reader, node: Node, what: Phrase) -> Slide:
    slides = part("slides", what)
    if isinstance(node, SourceScalar):
        return Slide(reader.text(node, slides))
    table = reader.table(node, slides, SLIDE_KEYS)
    guide = reader.text(reader.required(table, "guide", slides), Phrase("guide_of_slider", what=what))
    length = reader.said(table, "length", slides)
    if length is not None and length <= 0.0:
        raise reader.error(Phrase("face_length", what=part("length", slides)), table.lines["length"])
    return Slide(guide, reader.said(table, "angle", slides), reader.said(table, "offset", what), length)


def _owner(link: str) -> Phrase:
    return Phrase("the_frame") if link == FRAME else Phrase("link", name=link)


def _check_alike(reader: Reader, table: SourceTable, links: Iterable[Link]) -> None:
    """C and С, one of them Cyrillic, are two points to a program and one to a reader."""
    seen: dict[str, tuple[str, Phrase]] = {}
    for link in links:
        owner = _owner(link.name)
        for point in link.points:
            first, other = seen.setdefault(latin(point), (point, owner))
            if first != point:
                one, two = Phrase("point", name=point, owner=owner), Phrase("point", name=first, owner=other)
                line = table.line if link.name == FRAME else line_of(table, (link.name, "points", point))
                raise reader.error(Phrase("points_alike", one=one, two=two), line)


def _owners(reader: Reader, table: SourceTable, links: dict[str, Link], frame: Link) -> dict[str, str]:
    owners = dict.fromkeys((*frame.guides, *frame.round_guides), FRAME)
    for name, link in links.items():
        for guide in (*link.guides, *link.round_guides):
            if guide in owners:
                line = line_of(table, (name, "guides", guide))
                raise reader.error(Phrase("guide_twice", guide=guide, name=name, owner=_owner(owners[guide])), line)
            owners[guide] = name
    return owners


def _check_slide(reader: Reader, table: SourceTable, link: Link, owners: dict[str, str]) -> None:
    guide, line = link.slides.guide if link.slides else "", line_of(table, (link.name, "slides"))
    if guide not in owners:
        others = [name for name, owner in owners.items() if owner != link.name]
        valid = reader.offer(guide, others, Phrase("guides_all"))
        raise reader.error(Phrase("no_guide", name=link.name, guide=guide[:60], valid=valid), line)
    if owners[guide] == link.name:
        raise reader.error(Phrase("own_guide", name=link.name, guide=guide), line)
