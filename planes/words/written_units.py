"""Units as people write them beside a number, in any language."""

import math
from functools import cache

from planes.words import available_languages, say

_RESULT_UNITS = ("m", "m/s", "m/s²", "rad/s", "rad/s²", "N", "N·m", "W", "kg", "kgm2")
_OTHER_UNITS = {
    "об/мин об/хв обхв аб/хв rpm r/min 1/min min-1": (math.pi / 30, "rad/s"),
    "deg/s °/s °/с град/с": (math.pi / 180, "rad/s"),
    "deg/s2 °/s2 °/с2 град/с2": (math.pi / 180, "rad/s²"),
    "rad рад": (180 / math.pi, "°"),
    "1 mm мм": (1.0, ""),
    "° deg": (1.0, "°"),
    "1/s 1/с s-1 с-1": (1.0, "rad/s"),
    "1/s2 1/с2 s-2 с-2": (1.0, "rad/s²"),
}
COMMON_INPUT_UNITS = ("mm", "cm", "mm/s", "cm/s", "mm/s²", "kN", "kN·m", "kW", "rpm", "°/s", "°/s²", "rad")
"""Units other than those of results that numbers are often in, by their keys."""
_PREFIXED_UNITS = {"mm": ("m", 1e-3), "мм": ("м", 1e-3), "cm": ("m", 1e-2), "см": ("м", 1e-2), "kn": ("n", 1e3)}
_PREFIXED_UNITS |= {"кн": ("н", 1e3), "mn": ("n", 1e6), "kw": ("w", 1e3), "kg": ("kg", 1.0)}
_UNIT_SIGN_TRANSLATION = str.maketrans({"²": "2", "⁻": "-", "¹": "1", "−": "-"} | dict.fromkeys("^*·⋅. "))


@cache
def unit_in_si(unit: str, result: str = "") -> tuple[float, str] | None:
    """A unit as written in any language (mm/s, kN, rpm): how much of the unit of results it is, and the key of that,
    "" where it fits any value; None of a unit that is not known. Millimetres are those of a segment, unless the
    ``result`` is in metres."""
    text = _normalized_unit(unit)
    if result == "m" and text in ("mm", "мм"):
        return 1e-3, "m"
    known = {_normalized_unit(say(key, lang)): key for key in _RESULT_UNITS for lang in available_languages()} | {
        "": ""
    }
    if text in known:
        return 1.0, known[text]
    if other := next((_OTHER_UNITS[row] for row in _OTHER_UNITS if text in row.split()), None):
        return other
    prefix, factor = _PREFIXED_UNITS.get(text[:2], ("", 1.0))
    if prefix and prefix + text[2:] in known:
        return (factor, known[prefix + text[2:]])
    return None


def _normalized_unit(unit: str) -> str:
    return unit.strip().casefold().translate(_UNIT_SIGN_TRANSLATION)
