"""Units that people write after a number, and the SI value that the error message offers."""

from collections.abc import Sequence

_FACTOR_BY_UNITS = {
    "rpm rev/min об/мин об/хв аб/хв": "pi/30",
    "deg/s град/с": "pi/180",
    "rev/s об/с аб/с": "2*pi",
    "mm мм mm/s мм/с": "0.001",
    "cm см": "0.01",
    "km км": "1e3",
    "kn кн": "1000",
    "in inch дюйм": "0.0254",
    "ft": "0.3048",
    "lb": "0.4536",
    "lbf": "4.448",
}
"""Each row has a different factor, by which units of one kind are known."""
UNIT_FACTORS = {unit: factor for units, factor in _FACTOR_BY_UNITS.items() for unit in units.split()}
SI_REPLACEMENTS = {unit: f"*{factor}" for unit, factor in UNIT_FACTORS.items()} | dict.fromkeys(
    ("n", "н", "m", "м", "kg", "кг"), ""
)
"""What is written instead of a unit: a factor, or nothing where it is of SI."""


def unit_at_start(words: Sequence[str]) -> str:
    """The unit that words begin with; "" of one that is not known."""
    return next((unit for unit in ("".join(words[:3]), words[0]) if unit.lower() in UNIT_FACTORS), "")
