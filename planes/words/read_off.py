"""Results as read off a plan: as many digits as a ruler and a protractor give."""

import math

from planes.words import Lang, decimal
from planes.words.units import number

READ_DIGITS = 3
"""A ruler shows no more."""


def measured(value: float | None, lang: Lang) -> str:
    """A result as read off a plan: three significant digits, trailing zeros kept."""
    if not value or not math.isfinite(value) or not 1e-4 <= abs(value) < 1e7:
        return number(value, lang, READ_DIGITS)
    rounded = float(f"{value:.{READ_DIGITS - 1}e}")
    return fixed(rounded, max(READ_DIGITS - 1 - math.floor(math.log10(abs(rounded))), 0), lang)


def fixed(value: float, decimals: int, lang: Lang) -> str:
    """A number with a fixed count of decimals: millimetres and degrees have one."""
    return decimal(f"{round(value, decimals) + 0.0:.{decimals}f}".replace("-", "−"), lang)
