"""Guides along a circle: a slider on one is a link that turns about its centre, and is solved as such a link."""

import cmath
import math
from collections.abc import Mapping
from dataclasses import replace
from itertools import chain, count
from types import MappingProxyType

from planes.scene.mechanism import Guide, Link, RoundGuide
from planes.scene.reader import Reader, part
from planes.scene.source import SourceScalar, SourceTable
from planes.words import Phrase

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
