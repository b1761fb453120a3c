"""The scatter of pencil drawings."""

from collections.abc import Mapping

from planes.drafting.drawing import draw_program
from planes.drafting.instruments import DRAUGHTSMEN_COUNT, Pencil
from planes.drafting.program import Program
from planes.drafting.tools import Things
from planes.words.names import NamePair


def length_scatter_mm(
    program: Program, given: Things, repeated: str, pencil: Pencil, spans: Mapping[str, NamePair]
) -> dict[str, float]:
    """Standard deviation, in mm, of the length between marks over many draughtsmen with the same pencil; a single
    drawing is ``repeated`` for each of them."""
    import numpy

    crowd = draw_program(program, {**given, repeated: numpy.full(DRAUGHTSMEN_COUNT, given[repeated])}, pencil)
    scatter = {name: numpy.nanstd(abs(crowd[end] - crowd[start])) for name, (start, end) in spans.items()}
    return {name: float(size) for name, size in scatter.items()}
