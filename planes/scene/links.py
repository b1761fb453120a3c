"""The frame and the links of a scene: their points, guides, slides and masses.

A slider on a circular guide is a link that turns about the guide's centre, and is solved as such.
"""

import cmath
import math
from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import chain, count
from types import MappingProxyType

from planes.scene.mechanism import FRAME, Guide, Link, RoundGuide, Slide
from planes.scene.paths import line_of
from planes.scene.reader import Fields, Reader
from planes.scene.source import Node, SourceScalar, SourceTable
from planes.words import Phrase, Told
from planes.words.names import latin

LINK_KEYS = ("points", "guides", "slides", "centre", "mass", "inertia", "bearings")
FRAME_KEYS = ("points", "guides", "number")
GUIDE_KEYS = ("x", "y", "through", "angle", "mark", "centre", "radius")
SLIDE_KEYS = ("guide", "angle", "offset", "length")
LETTERS = "KMNQTUVW"  # name of a centre given by coordinates


def read_round(guide: Fields, name: str, points: dict[str, complex], owner: Told) -> RoundGuide:
    """A circular guide: its radius, and its centre, a point of its link or a place that becomes one."""
    reader = guide.reader
    for key in ("angle", "mark"):
        if key in guide:
            raise guide.fault("round_has_no", key, what=guide.what, key=key)
    entry, radius = guide.required("centre"), guide.required("radius")
    if not (long := guide.positive("radius")):
        raise reader.fault("round_radius", radius, what=guide.what)
    if isinstance(entry, SourceScalar):
        centre = guide.known("centre", points, Phrase("points_of", owner=owner))
    else:
        centre = next(x for x in chain(LETTERS, (f"K{k}" for k in count(1))) if x not in reader.taken)
        reader.taken.add(centre)
        points[centre] = guide.place("centre")
    return RoundGuide(name, centre, long)


def parted(guides: Mapping[str, Guide | RoundGuide]) -> tuple[Mapping[str, Guide], Mapping[str, RoundGuide]]:
    """Straight guides and circular ones, separated."""
    straight = {name: g for name, g in guides.items() if isinstance(g, Guide)}
    return MappingProxyType(straight), MappingProxyType(
        {name: g for name, g in guides.items() if isinstance(g, RoundGuide)}
    )


def turning(link: Link, guides: Mapping[str, RoundGuide]) -> Link:
    """A slider on a circular guide as a link that turns about its centre; the centre is to the left of the sliding
    direction."""
    slide = link.slides
    if slide is None or slide.guide not in guides:
        return link
    guide, back = guides[slide.guide], cmath.rect(1.0, -math.radians(slide.angle_deg or 0.0))
    centre = link.points[link.first_point] + 1j * back * (guide.radius - (slide.offset or 0.0))
    points = MappingProxyType({**link.points, guide.centre: centre})
    return replace(link, points=points, slides=None, slides_round=slide)


def read_frame(reader: Reader, node: Node) -> Link:
    """The frame: fixed points and guides, at least one of either."""
    frame = Fields(reader, node, Phrase("the_frame"), FRAME_KEYS)
    points = _points(frame)
    guides, round_guides = parted(_guides(frame, points))
    if not points and not guides:
        raise frame.fault("frame_empty")
    return Link(FRAME, MappingProxyType(points), guides, round_guides=round_guides)


def read_links(reader: Reader, node: Node, frame: Link) -> dict[str, Link]:
    """The moving links in the order of the file; every name in them is checked."""
    table = reader.names(node, "links", Phrase("a_link"))
    if not table.entries:
        raise reader.fault("links_empty", table)
    if FRAME in table.entries:
        raise reader.fault("link_zero", table.lines[FRAME])
    links = {name: _link(reader, name, entry) for name, entry in table.entries.items()}
    _check_alike(reader, table, (frame, *links.values()))
    owners = _owners(reader, table, links, frame)
    for link in links.values():
        if link.slides:
            _check_slide(reader, table, link, owners)
        if link.bearings is not None and link.points.keys().isdisjoint(frame.points):
            raise reader.error(Phrase("bearings_no_hinge", name=link.name), line_of(table, (link.name, "bearings")))
    round_guides = {name: g for link in (frame, *links.values()) for name, g in link.round_guides.items()}
    for name, link in links.items():
        if link.slides and link.slides.guide in round_guides and round_guides[link.slides.guide].centre in link.points:
            raise reader.fault("round_held", line_of(table, (name, "slides")), name=name, guide=link.slides.guide)
    return {name: turning(link, round_guides) for name, link in links.items()}


def _link(reader: Reader, name: str, node: Node) -> Link:
    what = Phrase("link", name=name)
    link = Fields(reader, node, what, LINK_KEYS)
    link.required("points")
    points = _points(link)
    if not points:
        raise link.fault("no_points", "points", what=what)
    guides, round_guides = parted(_guides(link, points))
    slides = link.optional("slides")
    return Link(
        name,
        MappingProxyType(points),
        guides,
        None if slides is None else _slide(link, slides),
        _mass(link, "mass"),
        _mass(link, "inertia"),
        None if link.optional("centre") is None else link.known("centre", points, Phrase("points_of", owner=what)),
        round_guides,
        bearings=_bearings(link),
    )


def _bearings(link: Fields) -> complex | None:
    """The places of a shaft's two bearings along its axis, from the plane of motion."""
    if link.optional("bearings") is None:
        return None
    places = link.place("bearings")
    if places.real == places.imag:
        raise link.error(Phrase("bearings_same", what=link.what, place=places.real), "bearings")
    return places


def _mass(link: Fields, key: str) -> float | None:
    return None if link.optional(key) is None else link.positive(key)


def _points(link: Fields) -> dict[str, complex]:
    if (node := link.optional("points")) is None:
        return {}
    table = link.reader.names(node, link.named("points"), Phrase("a_point"))
    if "p" in table.entries:
        raise link.reader.fault("point_pole", table.lines["p"], what=link.what)
    return {
        name: link.reader.place(entry, Phrase("point", name=name, owner=link.what), on_axis=True)
        for name, entry in table.entries.items()
    }


def _guides(link: Fields, points: dict[str, complex]) -> dict[str, Guide | RoundGuide]:
    if (node := link.optional("guides")) is None:
        return {}
    table = link.reader.names(node, link.named("guides"), Phrase("a_guide"))
    return {name: _guide(link, name, entry, points) for name, entry in table.entries.items()}


def _guide(link: Fields, name: str, node: Node, points: dict[str, complex]) -> Guide | RoundGuide:
    reader, what = link.reader, Phrase("guide_named", name=name)
    guide = Fields(reader, node, what, GUIDE_KEYS)
    form = guide.one_of("x", "y", "through", "centre")
    if form == "centre":
        return read_round(guide, name, points, link.what)
    if "radius" in guide:
        raise guide.fault("radius_without_centre", "radius", what=what)
    entry = guide.required(form)
    mark = None
    if (given := guide.optional("mark")) is not None:
        mark = reader.check_name(guide.text("mark"), Phrase("a_mark"), given)
    if form != "through":
        if "angle" in guide:
            raise guide.fault("angle_already", "angle", what=what, form=form)
        value = guide.number(form)
        through, angle = (complex(value, 0.0), 90.0) if form == "x" else (complex(0.0, value), 0.0)
        return Guide(name, through, angle, None, mark, origin_given=False)
    angle = guide.said("angle") or 0.0
    if isinstance(entry, SourceScalar):
        point = guide.known("through", points, Phrase("points_of", owner=link.what))
        return Guide(name, points[point], angle, point, mark)
    return Guide(name, guide.place("through"), angle, None, mark)


def _slide(link: Fields, node: Node) -> Slide:
    if isinstance(node, SourceScalar):
        return Slide(link.text("slides"))
    slide = link.inner("slides", SLIDE_KEYS)
    guide = link.reader.text(slide.required("guide"), Phrase("guide_of_slider", what=link.what))
    length = slide.said("length")
    if length is not None and length <= 0.0:
        raise slide.fault("face_length", "length", what=slide.named("length"))
    return Slide(guide, slide.said("angle"), slide.said("offset"), length)


def _owner(link: str) -> Phrase:
    return Phrase("the_frame") if link == FRAME else Phrase("link", name=link)


def _check_alike(reader: Reader, table: SourceTable, links: Iterable[Link]) -> None:
    """Refuse C beside С, one of them Cyrillic: two points to a program, but one to a reader."""
    seen: dict[str, tuple[str, Phrase]] = {}
    for link in links:
        owner = _owner(link.name)
        for point in link.points:
            first, other = seen.setdefault(latin(point), (point, owner))
            if first != point:
                one, two = Phrase("point", name=point, owner=owner), Phrase("point", name=first, owner=other)
                line = table.line if link.name == FRAME else line_of(table, (link.name, "points", point))
                raise reader.fault("points_alike", line, one=one, two=two)


def _owners(reader: Reader, table: SourceTable, links: dict[str, Link], frame: Link) -> dict[str, str]:
    owners = dict.fromkeys((*frame.guides, *frame.round_guides), FRAME)
    for name, link in links.items():
        for guide in (*link.guides, *link.round_guides):
            if guide in owners:
                line = line_of(table, (name, "guides", guide))
                raise reader.fault("guide_twice", line, guide=guide, name=name, owner=_owner(owners[guide]))
            owners[guide] = name
    return owners


def _check_slide(reader: Reader, table: SourceTable, link: Link, owners: dict[str, str]) -> None:
    guide, line = link.slides.guide if link.slides else "", line_of(table, (link.name, "slides"))
    if guide not in owners:
        others = [name for name, owner in owners.items() if owner != link.name]
        valid = reader.offer(guide, others)
        raise reader.fault("no_guide", line, name=link.name, guide=guide[:60], valid=valid)
    if owners[guide] == link.name:
        raise reader.fault("own_guide", line, name=link.name, guide=guide)
