"""Hodographs, the curves of a vector's end over the cycle about a pole, and paths of points; positions are numbered."""

from collections.abc import Sequence

from planes.geometry.plane import bounding_corners
from planes.words import Lang, say
from planes.words.frozen import frozen
from planes.words.names import letter_of
from planes.words.naming import Naming
from planes.words.units import number_text, standard_mu
from render.labels import Label
from render.paper.letters import mu_with_unit, name_with_unit
from render.paper.marks import Arrow, Line, Mark, Text
from render.paper.symbols import Marks, dot
from render.paper.typeset import ink_width
from render.views import View, make_view, put_views_in_row
from render.views.curve_pieces import continuous_runs, round_value_step, round_values_between
from render.views.senses import marks_with_labels

HODOGRAPH_SIDE_MM = 70.0  # the larger side of a hodograph
AXIS_OVERRUN_MM = 8.0  # of the axes beyond it
HODOGRAPH_GAP_MM = 14.0
LEAST_GRID_SPACING_MM = 12.0  # least distance of grid lines


@frozen
class Hodograph:
    """A vector over the cycle, as complex numbers in ``unit`` (None where the mechanism does not assemble; a single one
    is a jump), and at the numbered positions; ``point`` is that of a path."""

    name: str
    unit: str
    path: tuple[complex | None, ...]
    stations: tuple[complex | None, ...]
    point: str = ""


def hodograph_view(loops: Sequence[Hodograph], naming: Naming, to_read: bool = False) -> View:
    """Hodographs side by side, each under its name and scale; those ``to_read`` on a grid of round values."""
    row = put_views_in_row([_single_hodograph_view(loop, naming, to_read) for loop in loops], HODOGRAPH_GAP_MM, top=0.0)
    return make_view("hodographs", "", row.marks, figure=True)


def _single_hodograph_view(loop: Hodograph, naming: Naming, to_read: bool) -> View:
    lang = naming.lang
    path = bool(loop.point and to_read)
    known = [z for z in loop.path if z is not None]
    known += [0j] * (not path or not known)
    least, most = bounding_corners(known)
    mu = standard_mu(max((most - least).real, (most - least).imag), HODOGRAPH_SIDE_MM)
    name = say("path_of", lang, name=loop.point) if path else say("hodograph", lang, name=loop.name)
    title = f"{name}, μ_{{{letter_of(loop.name)}}} = {mu_with_unit(mu, loop.unit, naming)}"
    low = mu * least - AXIS_OVERRUN_MM * (1 + 1j)
    high = mu * most + AXIS_OVERRUN_MM * (1 + 1j)
    pole = low if path else 0j
    ends = complex(high.real, pole.imag), complex(pole.real, high.imag)
    ground = [
        *(_round_value_grid(low, high, mu, lang) if to_read else ()),
        Arrow(complex(low.real, pole.imag), ends[0], "thin", "dimension"),
        Arrow(complex(pole.real, low.imag), ends[1], "thin", "dimension"),
    ]
    axes = [name_with_unit(letter, loop.unit if to_read else "", lang) for letter in "xy"]
    letters = zip((*axes, "p")[: 2 if path else 3], (*ends, pole), strict=False)
    named = [Label(text, z, 3.5, clear=0.8, name=text) for text, z in letters]
    return make_view("hodograph", title, _hodograph_marks(loop, mu, ground, named))


def _round_value_grid(low: complex, high: complex, mu: float, lang: Lang) -> list[Mark]:
    """Thin lines at round values with these beside them, beneath and at the left."""
    marks = list[Mark]()
    widest = max(ink_width(number_text(x / mu, lang, 2), 2.5) for x in (low.real, high.real))
    step = round_value_step(mu, max(LEAST_GRID_SPACING_MM, widest + 3.0))
    for x in round_values_between(low.real / mu, high.real / mu, step):
        ends = complex(mu * x, low.imag), complex(mu * x, high.imag)
        marks += [
            Line(ends, "construction", "construction"),
            Text(number_text(x, lang, 6), ends[0] - 4j, 2.5, "middle"),
        ]
    for y in round_values_between(low.imag / mu, high.imag / mu, step):
        ends = complex(low.real, mu * y), complex(high.real, mu * y)
        marks += [
            Line(ends, "construction", "construction"),
            Text(number_text(y, lang, 6), ends[0] - complex(1.5, 1.25), 2.5, "end"),
        ]
    return marks


def _hodograph_marks(loop: Hodograph, mu: float, ground: list[Mark], named: list[Label]) -> Marks:
    """The curve on its axes, and the numbered positions."""
    for piece, jump in continuous_runs([None if z is None else z * mu for z in loop.path]):
        ground.append(Line(tuple(piece), "dash" if jump else "thick", "plan"))
    seen = list[complex]()
    for k, z in enumerate(loop.stations):
        if z is None or any(abs(z - other) * mu < 0.4 for other in seen):
            continue
        seen.append(z)
        ground += dot(z * mu, 0.6, "plan")
        named.append(Label(str(k), z * mu, 2.5, clear=0.8, name=f"position {k}"))
    return marks_with_labels(named, ground)
