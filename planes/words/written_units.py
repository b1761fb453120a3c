"""Units as people write them beside a number, in any language."""

import math

from planes.words import langs, say

_RESULTS = ("m", "m/s", "m/s²", "rad/s", "rad/s²", "N", "N·m", "W", "kg", "kgm2")
_PLAIN = [
    "1",
    "°",
    "deg",
    "rad",
    "рад",
    "mm",
    "мм",
    "1/s",
    "1/с",
    "s-1",
    "с-1",
    "1/s2",
    "1/с2",
    "s-2",
    "с-2",
]  # the same as SI in a table
_TURNS = ["об/мин", "обхв", "rpm", "r/min", "1/min", "min-1"]
_PREFIXED = {"mm": ("m", 1e-3), "мм": ("м", 1e-3), "cm": ("m", 1e-2), "см": ("м", 1e-2), "kn": ("n", 1e3)}
_PREFIXED |= {"кн": ("н", 1e3), "mn": ("n", 1e6), "kw": ("w", 1e3), "kg": ("kg", 1.0)}
_SAME_UNIT = str.maketrans({"²": "2", "⁻": "-", "¹": "1", "−": "-"} | dict.fromkeys("^*·⋅. "))


def unit_factor(unit: str) -> float | None:
    """SI units per unit written in any language: mm/s, kN, rpm; None for an unknown unit."""
    text = _bare_unit(unit)
    if text in _TURNS:
        return math.pi / 30
    known = {_bare_unit(say(key, lang)) for key in _RESULTS for lang in langs()}
    if not text or text in known or text in _PLAIN:
        return 1.0
    prefix, factor = _PREFIXED.get(text[:2], ("", 1.0))
    return factor if prefix and prefix + text[2:] in known else None


def _bare_unit(unit: str) -> str:
    return unit.strip().casefold().translate(_SAME_UNIT)
