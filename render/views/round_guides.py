"""A circular guide on the scheme: the slider's block on its arc, instead of the link it is solved as."""

import math
from collections.abc import Iterator

from planes.geometry.plane import direction_between
from planes.scene.mechanism import FRAME, Link, RoundGuide
from render.paper.marks import Arc, Line, Mark
from render.paper.style import (
    HALF_ROUND_GUIDE_LENGTH_MM,
    ROUND_HATCH_SPACING_MM,
    ROUND_HATCHING_DEPTH_MM,
    SLIDER_BLOCK_SIZE_MM,
)
from render.paper.symbols import block, unit_vector
from render.views.plotted import Places, direction_deg


def round_slider_marks(places: Places, link: Link, guide: RoundGuide, owner: str) -> Iterator[Mark]:
    """The block turned along its arc, and the arc beneath it, hatched if it is the frame's."""
    centre = places.point_place(guide.centre)
    z = places.point_place(link.first_point)
    radius = abs(z - centre)
    out = direction_between(centre, z)
    yield from block(z, direction_deg(1j * out))
    rail = radius + SLIDER_BLOCK_SIZE_MM[1] / 2
    here = direction_deg(out)
    half = min(math.degrees(HALF_ROUND_GUIDE_LENGTH_MM / radius), 180.0)
    yield Arc(centre, rail, here - half, here + half)
    if owner == FRAME:
        step = math.degrees(ROUND_HATCH_SPACING_MM / rail)
        for k in range(int(2 * half / step)):
            way = unit_vector(here - half + (k + 0.5) * step)
            yield Line(
                (centre + rail * way, centre + rail * way + ROUND_HATCHING_DEPTH_MM * way * unit_vector(45)), "thin"
            )
