"""Units people write after a number, and what they are in SI: a refusal offers it."""

from collections.abc import Iterable, Sequence

from planes.words import Phrase, Told

_UNITS = {
    "rpm rev/min об/мин об/хв аб/хв": "pi/30",
    "deg/s град/с": "pi/180",
    "rev/s об/с аб/с": "2*pi",
    "mm мм mm/s мм/с": "0.001",
    "cm см": "0.01",
    "km км": "1000",
    "kn кн": "1000",
    "in inch дюйм": "0.0254",
    "ft": "0.3048",
    "lb": "0.4536",
    "lbf": "4.448",
}
FACTORS = {unit: factor for units, factor in _UNITS.items() for unit in units.split()}


def same_unit(words: Sequence[str], names: Iterable[str]) -> str:
    """The name among these that the words begin with, or that is the same unit in other letters; "" for none."""
    begun = {"".join(words[:count]).lower() for count in (3, 1)}
    alike = {unit for row in _UNITS if begun & {*row.split()} for unit in row.split()}
    return next((name for name in names if name == words[0] or name.lower() in alike), "")


def in_si(words: Sequence[str]) -> Told:
    """What is written for the unit that words begin with; "" of one that is not known."""
    begun = ("".join(words[:count]) for count in (3, 1))
    unit = next((unit for unit in begun if unit.lower() in FACTORS), "")
    return unit and Phrase("unit_in_si", unit=unit, factor=FACTORS[unit.lower()])
