"""A circular guide on the scheme: the slider's block on its arc, instead of the link it is solved as."""

import math
from collections.abc import Iterator

from planes.geometry.plane import toward
from planes.scene.mechanism import FRAME, Link, RoundGuide
from render.paper.marks import Arc, Line, Mark
from render.paper.style import BLOCK_MM, ROUND_GAP_MM, ROUND_HATCH_MM, ROUND_MM
from render.paper.symbols import block, unit
from render.views.plotted import Places, degrees


def round_slider(places: Places, link: Link, guide: RoundGuide, owner: str) -> Iterator[Mark]:
    """The block turned along its arc, and the arc beneath it, hatched if it is the frame's."""
    centre, z = places.at(guide.centre), places.at(link.first_point)
    radius, out = abs(z - centre), toward(centre, z)
    yield from block(z, degrees(1j * out))
    rail, here = radius + BLOCK_MM[1] / 2, degrees(out)
    half = min(math.degrees(ROUND_MM / radius), 180.0)
    yield Arc(centre, rail, here - half, here + half)
    if owner == FRAME:
        step = math.degrees(ROUND_GAP_MM / rail)
        for k in range(int(2 * half / step)):
            way = unit(here - half + (k + 0.5) * step)
            yield Line((centre + rail * way, centre + rail * way + ROUND_HATCH_MM * way * unit(45)), "thin")
