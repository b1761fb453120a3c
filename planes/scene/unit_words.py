"""Units that people write after a number, and the SI value that the error message offers."""

from collections.abc import Sequence

from planes.words import Phrase, Told

_UNITS = {
    "rpm rev/min об/мин об/хв аб/хв": "pi/30",
    "deg/s град/с": "pi/180",
    "rev/s об/с аб/с": "2*pi",
    "mm мм mm/s мм/с": "0.001",
    "cm см": "0.01",
    "km км kn кн": "1000",
    "in inch дюйм": "0.0254",
    "ft": "0.3048",
    "lb": "0.4536",
    "lbf": "4.448",
}
FACTORS = {unit: factor for units, factor in _UNITS.items() for unit in units.split()}


def in_si(words: Sequence[str]) -> Told:
    """The SI text for the unit a string begins with; "" for an unknown one."""
    begun = ("".join(words[:count]) for count in (3, 1))
    unit = next((unit for unit in begun if unit.lower() in FACTORS), "")
    return unit and Phrase("unit_in_si", unit=unit, factor=FACTORS[unit.lower()])
