"""Results as read off a plan: as many digits as a ruler and a protractor give."""

import math

from planes.words import Lang, with_decimal_sign
from planes.words.units import number_text

READ_OFF_DIGITS = 3
"""A ruler shows no more."""


def read_off_text(value: float | None, lang: Lang) -> str:
    """A result as read off a plan: three significant digits, trailing zeros kept."""
    if not value or not math.isfinite(value) or not 1e-4 <= abs(value) < 1e7:
        return number_text(value, lang, READ_OFF_DIGITS)
    rounded = float(f"{value:.{READ_OFF_DIGITS - 1}e}")
    return fixed_decimals_text(rounded, max(READ_OFF_DIGITS - 1 - math.floor(math.log10(abs(rounded))), 0), lang)


def fixed_decimals_text(value: float, decimals: int, lang: Lang) -> str:
    """A number with a fixed count of decimals: millimetres and degrees have one."""
    return with_decimal_sign(f"{round(value, decimals) + 0.0:.{decimals}f}".replace("-", "−"), lang)
