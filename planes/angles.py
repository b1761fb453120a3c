"""Ranges of the drive's value as a person writes them: "30", "0:360:30", "-90"."""

from __future__ import annotations

import math

from planes.wording import SceneError
from planes.words import Phrase

MOST = 10_000_000


def read_range(text: str, option: str = "--phi") -> list[float]:
    """The values of "a", or of "a:b:step" with b included when it falls on it."""
    parts = text.split(":")
    try:
        numbers = [float(p.replace("−", "-")) for p in parts]
    except ValueError:
        raise SceneError(Phrase("range_not_number", option=option, text=repr(text))) from None
    if len(numbers) not in (1, 3) or not all(math.isfinite(n) for n in numbers):
        raise SceneError(Phrase("range_parts", option=option, text=repr(text)))
    if len(numbers) == 1:
        return numbers
    start, end, step = numbers
    if step == 0 or (end - start) * step < 0:
        raise SceneError(Phrase("range_endless", option=option, text=repr(text), step=step, start=start, end=end))
    count = math.floor((end - start) / step * (1 + 1e-12) + 1e-9) + 1
    if count > MOST:
        raise SceneError(Phrase("range_long", option=option, text=repr(text), count=count, most=MOST))
    return [start + i * step for i in range(count)]
