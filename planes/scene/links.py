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
from planes.scene.paths import line_of_path
from planes.scene.reader import Fields, Reader
from planes.scene.source import Node, SourceScalar, SourceTable
from planes.words import Phrase, Told
from planes.words.names import NamesByName, with_latin_letters

LINK_KEYS = ("points", "guides", "slides", "centre", "mass", "inertia", "bearings")
FRAME_KEYS = ("points", "guides", "number")
GUIDE_KEYS = ("x", "y", "through", "angle", "mark", "centre", "radius")
SLIDE_KEYS = ("guide", "angle", "offset", "length")
CENTRE_LETTERS = "KMNQTUVW"  # name of a centre given by coordinates


def read_circular_guide(guide: Fields, name: str, points: dict[str, complex], owner: Told) -> RoundGuide:
    """A circular guide: its radius, and its centre, a point of its link or a place that becomes one."""
    reader = guide.reader
    for key in ("angle", "mark"):
        if key in guide:
            raise guide.error_by_key("round_has_no", key, what=guide.what, key=key)
    entry = guide.required_node("centre")
    radius = guide.required_node("radius")
    if not (long := guide.read_non_negative("radius")):
        raise reader.error_by_key("round_radius", radius, what=guide.what)
    if isinstance(entry, SourceScalar):
        centre = guide.read_known_name("centre", points, Phrase("points_of", owner=owner))
    else:
        centre = next(x for x in chain(CENTRE_LETTERS, (f"K{k}" for k in count(1))) if x not in reader.taken)
        reader.taken.add(centre)
        points[centre] = guide.read_place("centre")
    return RoundGuide(name, centre, long)


def straight_and_circular_guides(
    guides: Mapping[str, Guide | RoundGuide],
) -> tuple[Mapping[str, Guide], Mapping[str, RoundGuide]]:
    """Straight guides and circular ones, separated."""
    straight = {name: g for name, g in guides.items() if isinstance(g, Guide)}
    return MappingProxyType(straight), MappingProxyType(
        {name: g for name, g in guides.items() if isinstance(g, RoundGuide)}
    )


def link_turning_about_guide_centre(link: Link, guides: Mapping[str, RoundGuide]) -> Link:
    """A slider on a circular guide as a link that turns about its centre; the centre is to the left of the sliding
    direction."""
    slide = link.slides
    if slide is None or slide.guide not in guides:
        return link
    guide = guides[slide.guide]
    back = cmath.rect(1.0, -math.radians(slide.angle_deg or 0.0))
    centre = link.points[link.first_point] + 1j * back * (guide.radius - (slide.offset or 0.0))
    points = MappingProxyType({**link.points, guide.centre: centre})
    return replace(link, points=points, slides=None, slides_round=slide)


def read_frame(reader: Reader, node: Node) -> Link:
    """The frame: fixed points and guides, at least one of either."""
    frame = Fields(reader, node, Phrase("the_frame"), FRAME_KEYS)
    points = _read_points(frame)
    guides, round_guides = straight_and_circular_guides(_read_guides(frame, points))
    if not points and not guides:
        raise frame.error_by_key("frame_empty")
    return Link(FRAME, MappingProxyType(points), guides, round_guides=round_guides)


def read_links(reader: Reader, node: Node, frame: Link) -> dict[str, Link]:
    """The moving links in the order of the file; every name in them is checked."""
    table = reader.read_table_of_names(node, "links", Phrase("a_link"))
    if not table.entries:
        raise reader.error_by_key("links_empty", table)
    if FRAME in table.entries:
        raise reader.error_by_key("link_zero", table.lines[FRAME])
    links = {name: _read_link(reader, name, entry) for name, entry in table.entries.items()}
    _check_lookalike_points(reader, table, (frame, *links.values()))
    owners = _guide_owners(reader, table, links, frame)
    for link in links.values():
        if link.slides:
            _check_slide(reader, table, link, owners)
        if link.bearings is not None and link.points.keys().isdisjoint(frame.points):
            raise reader.error(
                Phrase("bearings_no_hinge", name=link.name), line_of_path(table, (link.name, "bearings"))
            )
    round_guides = {name: g for link in (frame, *links.values()) for name, g in link.round_guides.items()}
    for name, link in links.items():
        if link.slides and link.slides.guide in round_guides and round_guides[link.slides.guide].centre in link.points:
            raise reader.error_by_key(
                "round_held", line_of_path(table, (name, "slides")), name=name, guide=link.slides.guide
            )
    return {name: link_turning_about_guide_centre(link, round_guides) for name, link in links.items()}


def _read_link(reader: Reader, name: str, node: Node) -> Link:
    what = Phrase("link", name=name)
    link = Fields(reader, node, what, LINK_KEYS)
    link.required_node("points")
    points = _read_points(link)
    if not points:
        raise link.error_by_key("no_points", "points", what=what)
    guides, round_guides = straight_and_circular_guides(_read_guides(link, points))
    slides = link.optional_node("slides")
    return Link(
        name,
        MappingProxyType(points),
        guides,
        None if slides is None else _read_slide(link, slides),
        _read_mass(link, "mass"),
        _read_mass(link, "inertia"),
        None
        if link.optional_node("centre") is None
        else link.read_known_name("centre", points, Phrase("points_of", owner=what)),
        round_guides,
        bearings=_read_bearings(link),
    )


def _read_bearings(link: Fields) -> complex | None:
    """The places of a shaft's two bearings along its axis, from the plane of motion."""
    if link.optional_node("bearings") is None:
        return None
    places = link.read_place("bearings")
    if places.real == places.imag:
        raise link.error(Phrase("bearings_same", what=link.what, place=places.real), "bearings")
    return places


def _read_mass(link: Fields, key: str) -> float | None:
    if link.optional_node(key) is None:
        return None
    return link.read_non_negative(key)


def _read_points(link: Fields) -> dict[str, complex]:
    if (node := link.optional_node("points")) is None:
        return {}
    table = link.reader.read_table_of_names(node, link.phrase_of_key("points"), Phrase("a_point"))
    if "p" in table.entries:
        raise link.reader.error_by_key("point_pole", table.lines["p"], what=link.what)
    return {
        name: link.reader.read_place(entry, Phrase("point", name=name, owner=link.what), on_axis=True)
        for name, entry in table.entries.items()
    }


def _read_guides(link: Fields, points: dict[str, complex]) -> dict[str, Guide | RoundGuide]:
    if (node := link.optional_node("guides")) is None:
        return {}
    table = link.reader.read_table_of_names(node, link.phrase_of_key("guides"), Phrase("a_guide"))
    return {name: _read_guide(link, name, entry, points) for name, entry in table.entries.items()}


def _read_guide(link: Fields, name: str, node: Node, points: dict[str, complex]) -> Guide | RoundGuide:
    reader = link.reader
    what = Phrase("guide_named", name=name)
    guide = Fields(reader, node, what, GUIDE_KEYS)
    form = guide.require_one_key("x", "y", "through", "centre")
    if form == "centre":
        return read_circular_guide(guide, name, points, link.what)
    if "radius" in guide:
        raise guide.error_by_key("radius_without_centre", "radius", what=what)
    entry = guide.required_node(form)
    mark = None
    if (given := guide.optional_node("mark")) is not None:
        mark = reader.check_name(guide.read_text("mark"), Phrase("a_mark"), given)
    if form != "through":
        if "angle" in guide:
            raise guide.error_by_key("angle_already", "angle", what=what, form=form)
        value = guide.read_number(form)
        through, angle = (complex(value, 0.0), 90.0) if form == "x" else (complex(0.0, value), 0.0)
        return Guide(name, through, angle, None, mark, origin_given=False)
    angle = guide.number_if_given("angle") or 0.0
    if isinstance(entry, SourceScalar):
        point = guide.read_known_name("through", points, Phrase("points_of", owner=link.what))
        return Guide(name, points[point], angle, point, mark)
    return Guide(name, guide.read_place("through"), angle, None, mark)


def _read_slide(link: Fields, node: Node) -> Slide:
    if isinstance(node, SourceScalar):
        return Slide(link.read_text("slides"))
    slide = link.inner_fields("slides", SLIDE_KEYS)
    guide = link.reader.read_text(slide.required_node("guide"), Phrase("guide_of_slider", what=link.what))
    length = slide.number_if_given("length")
    if length is not None and length <= 0.0:
        raise slide.error_by_key("face_length", "length", what=slide.phrase_of_key("length"))
    return Slide(guide, slide.number_if_given("angle"), slide.number_if_given("offset"), length)


def _owner_in_words(link: str) -> Phrase:
    return Phrase("the_frame") if link == FRAME else Phrase("link", name=link)


def _check_lookalike_points(reader: Reader, table: SourceTable, links: Iterable[Link]) -> None:
    """Refuse C beside С, one of them Cyrillic: two points to a program, but one to a reader."""
    seen: dict[str, tuple[str, Phrase]] = {}
    for link in links:
        owner = _owner_in_words(link.name)
        for point in link.points:
            first, other = seen.setdefault(with_latin_letters(point), (point, owner))
            if first != point:
                one = Phrase("point", name=point, owner=owner)
                two = Phrase("point", name=first, owner=other)
                line = table.line if link.name == FRAME else line_of_path(table, (link.name, "points", point))
                raise reader.error_by_key("points_alike", line, one=one, two=two)


def _guide_owners(reader: Reader, table: SourceTable, links: dict[str, Link], frame: Link) -> NamesByName:
    owners = dict.fromkeys((*frame.guides, *frame.round_guides), FRAME)
    for name, link in links.items():
        for guide in (*link.guides, *link.round_guides):
            if guide in owners:
                line = line_of_path(table, (name, "guides", guide))
                raise reader.error_by_key(
                    "guide_twice", line, guide=guide, name=name, owner=_owner_in_words(owners[guide])
                )
            owners[guide] = name
    return owners


def _check_slide(reader: Reader, table: SourceTable, link: Link, owners: NamesByName) -> None:
    guide = link.slides.guide if link.slides else ""
    line = line_of_path(table, (link.name, "slides"))
    if guide not in owners:
        others = [name for name, owner in owners.items() if owner != link.name]
        valid = reader.valid_names_in_words(guide, others)
        raise reader.error_by_key("no_guide", line, name=link.name, guide=guide[:60], valid=valid)
    if owners[guide] == link.name:
        raise reader.error_by_key("own_guide", line, name=link.name, guide=guide)
