"""Units as people write them beside a number, in any language."""

import math
from functools import cache

from planes.words import langs, say

_RESULTS = ("m", "m/s", "m/s²", "rad/s", "rad/s²", "N", "N·m", "W", "kg", "kgm2")
_OTHERS = {
    "об/мин об/хв обхв аб/хв rpm r/min 1/min min-1": (math.pi / 30, "rad/s"),
    "deg/s °/s °/с град/с": (math.pi / 180, "rad/s"),
    "deg/s2 °/s2 °/с2 град/с2": (math.pi / 180, "rad/s²"),
    "rad рад": (180 / math.pi, "°"),
    "1 mm мм": (1.0, ""),
    "° deg": (1.0, "°"),
    "1/s 1/с s-1 с-1": (1.0, "rad/s"),
    "1/s2 1/с2 s-2 с-2": (1.0, "rad/s²"),
}
COMMON = ("mm", "cm", "mm/s", "cm/s", "mm/s²", "kN", "kN·m", "kW", "rpm", "°/s", "°/s²", "rad")
"""Units other than those of results that numbers are often in, by their keys."""
_PREFIXED = {"mm": ("m", 1e-3), "мм": ("м", 1e-3), "cm": ("m", 1e-2), "см": ("м", 1e-2), "kn": ("n", 1e3)}
_PREFIXED |= {"кн": ("н", 1e3), "mn": ("n", 1e6), "kw": ("w", 1e3), "kg": ("kg", 1.0)}
_SAME_UNIT = str.maketrans({"²": "2", "⁻": "-", "¹": "1", "−": "-"} | dict.fromkeys("^*·⋅. "))


@cache
def unit_in_si(unit: str, result: str = "") -> tuple[float, str] | None:
    """A unit as written in any language (mm/s, kN, rpm): how much of the unit of results it is, and the key of that,
    "" where it fits any value; None of a unit that is not known. Millimetres are those of a segment, unless the
    ``result`` is in metres."""
    text = _bare_unit(unit)
    if result == "m" and text in ("mm", "мм"):
        return 1e-3, "m"
    known = {_bare_unit(say(key, lang)): key for key in _RESULTS for lang in langs()} | {"": ""}
    if text in known:
        return 1.0, known[text]
    if other := next((_OTHERS[row] for row in _OTHERS if text in row.split()), None):
        return other
    prefix, factor = _PREFIXED.get(text[:2], ("", 1.0))
    return (factor, known[prefix + text[2:]]) if prefix and prefix + text[2:] in known else None


def _bare_unit(unit: str) -> str:
    return unit.strip().casefold().translate(_SAME_UNIT)
