"""Curved arrows of the driver's ω and ε, and thin lines broken for letters."""

import cmath
import math
from collections.abc import Iterable, Sequence
from functools import partial
from itertools import compress

from planes.scene.mechanism import FRAME
from planes.words.naming import Naming
from render.labels import Label, Labelled, is_rough_placement, place_labels
from render.labels.footprints import inked_shapes, make_polygons
from render.paper import symbols
from render.paper.ink import cut_out_shapes
from render.paper.marks import Hatch, Layer, Line, Mark, Shape, Text
from render.paper.symbols import Marks
from render.paper.typeset import text_box_corners
from render.views.plotted import Places

SENSE_LETTER_MM = 5.0
POSITION_NAME_PREFIX = "position"  # prefixes of names of links in other positions, and of their numbers
TEXT_LINE_GAP_MM = 0.6  # between a letter and the thin line broken for it


def driver_arrows(places: Places, naming: Naming, ground: Sequence[Mark]) -> Labelled:
    """Curved arrows of the driver's ω and ε about its pivot, where they cross nothing, and their names."""
    drive = places.mechanism.drive
    pair = places.position.plans.structure.drive_pair
    arcs = list[Mark]()
    named = list[Label]()
    if drive.kind == "s" or not places.is_drawn(pair.point):
        return arcs, named
    for rate, letter, radius in ((drive.velocity, "ω", 9.0), (drive.acceleration, "ε", 12.5)):
        if rate:
            arrow, middle = _free_arc(places, radius, math.copysign(1, rate), [*ground, *arcs])
            arcs += arrow
            on = "" if drive.on == FRAME else f",{naming.link_number(drive.on)}"
            text = f"{letter}_{{{naming.link_number(drive.link)}{on}}}"
            named.append(Label(text, middle, SENSE_LETTER_MM, clear=0.5, name=text))
    return arcs, named


def _free_arc(places: Places, radius: float, sense: float, ground: Sequence[Mark]) -> tuple[symbols.Marks, complex]:
    """A curved arrow where it crosses nothing, near the crank; and the middle of its arc."""
    pivot = places.point_place(places.position.plans.structure.drive_pair.point)
    points = places.mechanism.links[places.mechanism.drive.link].points
    crank = max((places.point_place(p) - pivot for p in points if places.is_drawn(p)), key=abs, default=1 + 0j)
    turns = (15, 30, 60, 100, 140, 180, 220, 260, -110, -80)
    ways = [(radius, math.degrees(cmath.phase(crank)) + sense * turn) for turn in turns]
    return freest_turn_arrow(pivot, ways, sense * 60, ground, 0.6)


def freest_turn_arrow(
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
        (symbols.turn_arrow(centre, r, start, sweep, style, layer), centre + r * symbols.unit_vector(start + sweep / 2))
        for r, start in ways
    )
    if is_rough_placement():
        return next(iter(arrows))
    inked = inked_shapes(ground)
    least = math.inf
    freest_arrow = None
    for arrow in arrows:
        near = len(inked.pairs_within(inked_shapes(arrow[0]).shapes, clear)[0])
        if near < least:
            least = near
            freest_arrow = arrow
        if not near:
            break
    assert freest_arrow
    return freest_arrow


def marks_with_labels(named: Sequence[Label], marks: Sequence[Mark]) -> Marks:
    """Marks with their letters in places found for them; construction lines and hatching are broken under a letter, but
    links in other positions not for their numbers, which are placed first."""
    kept = [m for m in marks if isinstance(m, Line) and m.name == POSITION_NAME_PREFIX]
    numbers = [x for x in named if x.name.startswith(POSITION_NAME_PREFIX)]
    gives = [isinstance(m, Hatch) or (isinstance(m, Line) and m.layer == "construction") for m in marks]
    thin = list(compress(marks, gives))
    rest = [m for m, way in zip(marks, gives, strict=True) if not way]
    broken = [m for m in thin if m not in kept]
    first = place_labels(numbers, [*rest, *kept], None, broken)
    others = [x for x in named if x not in numbers]
    placed = place_labels(others, [*rest, *first.marks], None, thin)
    lines = (*break_lines_at_texts(broken, [*first.texts, *placed.texts]), *break_lines_at_texts(kept, placed.texts))
    return (*lines, *rest, *first.marks, *placed.marks)


def break_lines_at_texts(lines: Sequence[Mark], texts: Sequence[Text]) -> Marks:
    """The lines broken under letters, as a draughtsman breaks them."""
    if not lines or not texts or is_rough_placement():
        return tuple(lines)
    boxes = make_polygons([text_box_corners(t) for t in texts])
    struck = sorted(set(inked_shapes(lines).pairs_within(boxes, TEXT_LINE_GAP_MM / 2)[0].tolist()))
    return cut_out_shapes(lines, [_box_with_margin(texts[k]) for k in struck])


def _box_with_margin(text: Text) -> Shape:
    """The box of a text with a small margin."""
    box = text_box_corners(text)
    sign = partial(math.copysign, 1.0)
    out = (z - sum(box) / 4 for z in box)
    return Shape(
        tuple(z + TEXT_LINE_GAP_MM * complex(sign(w.real), sign(w.imag)) for z, w in zip(box, out, strict=True))
    )
