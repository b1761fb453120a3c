"""How the numbers of a scene were written: the decimal behind each double, known where a text gives one."""

from dataclasses import dataclass, field

from planes.scene.expressions import is_plain_number

SURE_DECIMAL_DIGITS = 15  # decimals of no more digits with the same double are equal


@dataclass
class WrittenNumbers:
    """The decimals of the numbers read, by magnitude, and radius and angle of the places given so."""

    numbers: dict[float, str] = field(default_factory=dict)  # "" for a computed number, or for two different decimals
    places: dict[complex, tuple[float, ...]] = field(default_factory=dict)  # None for those with coordinates

    def remember_number_text(self, value: float, text: str) -> None:
        """Remember the text of a number."""
        text = text.lstrip("+-−") if is_plain_number(text) else ""
        known = self.numbers.setdefault(abs(value), text)
        if known != text and not (known and text and max(len(known), len(text)) <= SURE_DECIMAL_DIGITS):
            self.numbers[abs(value)] = ""

    def remember_polar_place(self, place: complex, *polar: float) -> complex:
        """Remember the radius and angle of a place given so; a place given in both forms is forgotten."""
        if self.places.setdefault(place, polar) != polar:
            self.places[place] = ()
            self.numbers |= dict.fromkeys((abs(place.real), abs(place.imag)), "")
        return place

    def decimal_of_number(self, x: float) -> str:
        """The decimal of a number; "" where it is unknown."""
        text = self.numbers.get(abs(x)) or (repr(abs(x)) if (x * 1024).is_integer() else "")
        return f"-{text}" if text and x < 0 else text
