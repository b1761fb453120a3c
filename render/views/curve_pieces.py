"""Preparation of curves for drawing: round values on their axes, clipping, the runs between gaps."""

import math
from collections.abc import Sequence

from planes.words.units import standard_mu

# ordinates are clipped at so many times their median at the ends of a range, which are dead points
MOST_END_ORDINATE_RATIO = 5.0
MOST_ORDINATE_RATIO = 30.0  # and at so many elsewhere


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


def drop_steep_ordinates(values: Sequence[float | None]) -> tuple[float | None, ...]:
    """A curve without ordinates far beyond the rest, which grow without bound beside dead points."""
    sizes = sorted(abs(v) for v in values if v is not None)
    usual = sizes[len(sizes) // 2] if sizes else 0.0
    calm = [k for k, v in enumerate(values) if v is not None and abs(v) <= MOST_END_ORDINATE_RATIO * usual]
    low, high = (calm[0], calm[-1]) if calm else (0, 0)
    near = [v is not None and abs(v) <= MOST_ORDINATE_RATIO * usual for v in values]
    return tuple(v if near[k] and low <= k <= high else None for k, v in enumerate(values))
