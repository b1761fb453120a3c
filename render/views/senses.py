"""Curved arrows of the driver's ω and ε, and thin lines broken for letters."""

import cmath
import math
from collections.abc import Iterable, Sequence
from functools import partial
from itertools import compress

from planes.scene.mechanism import FRAME
from planes.words.naming import Naming
from render.labels import Label, Labelled, place, rough
from render.labels.footprints import ink, polygons
from render.paper import symbols
from render.paper.ink import cut
from render.paper.marks import Hatch, Layer, Line, Mark, Shape, Text
from render.paper.symbols import Marks
from render.paper.typeset import box_of
from render.views.plotted import Places

LETTER_MM = 5.0
POSITION = "position"  # prefixes of names of links in other positions, and of their numbers
CLEAR_MM = 0.6  # between a letter and the thin line broken for it


def driver_arrows(places: Places, naming: Naming, ground: Sequence[Mark]) -> Labelled:
    """Curved arrows of the driver's ω and ε about its pivot, where they cross nothing, and their names."""
    drive, pair = places.mechanism.drive, places.position.plans.structure.drive_pair
    arcs = list[Mark]()
    named = list[Label]()
    if drive.kind == "s" or not places.has(pair.point):
        return arcs, named
    for rate, letter, radius in ((drive.velocity, "ω", 9.0), (drive.acceleration, "ε", 12.5)):
        if rate:
            arrow, middle = _free_arc(places, radius, math.copysign(1, rate), [*ground, *arcs])
            arcs += arrow
            on = "" if drive.on == FRAME else f",{naming.link(drive.on)}"
            text = f"{letter}_{{{naming.link(drive.link)}{on}}}"
            named.append(Label(text, middle, LETTER_MM, clear=0.5, name=text))
    return arcs, named


def _free_arc(places: Places, radius: float, sense: float, ground: Sequence[Mark]) -> tuple[symbols.Marks, complex]:
    """A curved arrow where it crosses nothing, near the crank; and the middle of its arc."""
    pivot = places.at(places.position.plans.structure.drive_pair.point)
    points = places.mechanism.links[places.mechanism.drive.link].points
    crank = max((places.at(p) - pivot for p in points if places.has(p)), key=abs, default=1 + 0j)
    turns = (15, 30, 60, 100, 140, 180, 220, 260, -110, -80)
    ways = [(radius, math.degrees(cmath.phase(crank)) + sense * turn) for turn in turns]
    return freest(pivot, ways, sense * 60, ground, 0.6)


def freest(
    centre: complex,
    ways: Iterable[tuple[float, float]],
    sweep: float,
    ground: Sequence[Mark],
    clear: float,
    style: str = "thin",
    layer: Layer = "scheme",
) -> tuple[symbols.Marks, complex]:
    """Of curved arrows about a place, by their radii and start angles, the first with the most clearance; with the
    middle of its arc."""
    arrows = (
        (symbols.turn_arrow(centre, r, start, sweep, style, layer), centre + r * symbols.unit(start + sweep / 2))
        for r, start in ways
    )
    if rough():
        return next(iter(arrows))
    inked, least, freest_arrow = ink(ground), math.inf, None
    for arrow in arrows:
        near = len(inked.within(ink(arrow[0]).shapes, clear)[0])
        if near < least:
            least, freest_arrow = near, arrow
        if not near:
            break
    assert freest_arrow
    return freest_arrow


def labelled(named: Sequence[Label], marks: Sequence[Mark]) -> Marks:
    """Marks with their letters in places found for them; construction lines and hatching are broken under a letter, but
    links in other positions not for their numbers, which are placed first."""
    kept = [m for m in marks if isinstance(m, Line) and m.name == POSITION]
    numbers = [x for x in named if x.name.startswith(POSITION)]
    gives = [isinstance(m, Hatch) or (isinstance(m, Line) and m.layer == "construction") for m in marks]
    thin, rest = list(compress(marks, gives)), [m for m, way in zip(marks, gives, strict=True) if not way]
    broken = [m for m in thin if m not in kept]
    first = place(numbers, [*rest, *kept], None, broken)
    others = [x for x in named if x not in numbers]
    placed = place(others, [*rest, *first.marks], None, thin)
    lines = (*parted(broken, [*first.texts, *placed.texts]), *parted(kept, placed.texts))
    return (*lines, *rest, *first.marks, *placed.marks)


def parted(lines: Sequence[Mark], texts: Sequence[Text]) -> Marks:
    """The lines broken under letters, as a draughtsman breaks them."""
    if not lines or not texts or rough():
        return tuple(lines)
    boxes = polygons([box_of(t) for t in texts])
    struck = sorted(set(ink(lines).within(boxes, CLEAR_MM / 2)[0].tolist()))
    return cut(lines, [_around(texts[k]) for k in struck])


def _around(text: Text) -> Shape:
    """The box of a text with a small margin."""
    box, sign = box_of(text), partial(math.copysign, 1.0)
    out = (z - sum(box) / 4 for z in box)
    return Shape(tuple(z + CLEAR_MM * complex(sign(w.real), sign(w.imag)) for z, w in zip(box, out, strict=True)))
