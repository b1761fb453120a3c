"""A row of a scene's data, and whether a parameter gives the same."""

from planes.words.frozen import frozen
from planes.words.lettering import without_index_markup
from planes.words.names import NamePair

EQUAL_NUMBERS_RATIO = 1e-9


@frozen
class GivenRow:
    """A lettered name, a value in the unit of the table (SI, degrees), the unit's key; ``given`` is its name in the
    program, "" for data that the scheme is drawn by."""

    name: str
    value: float
    unit: str
    given: str = ""
    of_drive: bool = False
    place: bool = False  # a coordinate, which is listed even where it is 0

    @property
    def key_of_quantity(self) -> NamePair:
        """The key common to all names of one quantity: for l_{CD} and l_{DC} the letter and the points, for J_{S2} and
        J_{2} the unit and the link."""
        spatial = self.unit in ("m", "°")
        index = sorted(set(without_index_markup(self.name[1:])) - {"–"})
        return self.name[0] if spatial else self.unit, "".join(x for x in index if spatial or x.isdigit())


def gives_same_quantity(row: GivenRow, named: GivenRow) -> bool:
    """Whether a parameter gives the same as a row: the same quantity of the same object, or e the coordinate of a
    guide."""
    if row.place and named.name == "e" and named.value and "–" in row.name and row.name[0] in "xy":
        return are_numbers_equal(abs(row.value), abs(named.value))
    return row.key_of_quantity == named.key_of_quantity and are_numbers_equal(row.value, named.value)


def name_beside_parameter(row: GivenRow, value: float) -> str:
    """The name of a row beside a parameter's, with a minus where it is the opposite."""
    return row.name if are_numbers_equal(row.value, value) else f"−{row.name}"


def are_numbers_equal(a: float, b: float) -> bool:
    """Whether two numbers are equal."""
    return abs(a - b) <= EQUAL_NUMBERS_RATIO * max(abs(a), abs(b))
