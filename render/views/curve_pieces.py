"""Preparation of curves for drawing: round values on their axes, clipping, the runs between gaps."""

import math
from collections.abc import Sequence

from planes.words.units import standard_mu

MOST_END_ORDINATE_RATIO = 5.0  # to the median, at the ends of a range, which are dead points: the rest is clipped
MOST_SPREAD_RATIO = 10.0  # to the ninth decile of distances from the median; 7 at most on whole turns of 92 mechanisms


def round_value_step(mu: float, apart_mm: float) -> float:
    """The smallest round step of values with that least distance on a scale."""
    return 1.0 / standard_mu(apart_mm, mu)


def round_values_between(low: float, high: float, step: float) -> list[float]:
    """The round values between two."""
    return [step * k for k in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1)]


def continuous_runs(path: Sequence[complex | None], across: float = math.inf) -> list[tuple[list[complex], bool]]:
    """Runs of a path, with jumps across its single gaps, if they are short."""
    pieces = []
    run = list[complex]()
    gap = 0
    for z in path:
        if z is None:
            gap += 1
            continue
        if gap and run:
            pieces.append((run, False))
        if gap == 1 and run and abs(z.real - run[-1].real) <= across:
            pieces.append(([run[-1], z], True))
        run = [z] if gap else [*run, z]
        gap = 0
    return [(piece, jump) for piece, jump in [*pieces, (run, False)] if len(piece) > 1]


def drop_steep_ordinates(values: Sequence[float | None], full_turn: bool) -> tuple[float | None, ...]:
    """A curve without ordinates far from the rest, which grow without bound beside dead points; those are also the ends
    of a range that is no ``full_turn``."""
    known = sorted(v for v in values if v is not None)
    if not known:
        return tuple(values)
    middle = known[len(known) // 2]
    spread = sorted(abs(v - middle) for v in known)[len(known) * 9 // 10]
    near = [v is not None and (not spread or abs(v - middle) <= MOST_SPREAD_RATIO * spread) for v in values]
    usual = sorted(map(abs, known))[len(known) // 2]
    calm = [
        k for k, v in enumerate(values) if v is not None and (full_turn or abs(v) <= MOST_END_ORDINATE_RATIO * usual)
    ]
    return tuple(v if near[k] and calm[0] <= k <= calm[-1] else None for k, v in enumerate(values))
