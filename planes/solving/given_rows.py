"""A row of what a scene gives, and whether a parameter says the same."""

from planes.words.frozen import frozen
from planes.words.lettering import flat

SAME = 1e-9


@frozen
class GivenRow:
    """A name as it is lettered, a value in the unit of the table (SI, degrees), the unit's key; ``given`` is its name
    in the program, "" of what the scheme is drawn by."""

    name: str
    value: float
    unit: str
    given: str = ""
    of_drive: bool = False
    place: bool = False  # a coordinate, which is told even where it is 0

    @property
    def same(self) -> tuple[str, str]:
        """What names of one thing have in common: l_{CD} and l_{DC} the letter and the points, J_{S2} and J_{2} the
        unit and the link."""
        spatial, index = self.unit in ("m", "°"), sorted(set(flat(self.name[1:])) - {"–"})
        return self.name[0] if spatial else self.unit, "".join(x for x in index if spatial or x.isdigit())


def alike(row: GivenRow, named: GivenRow) -> bool:
    """Whether a parameter says the same as a row: the same of the same, or e the coordinate of a guide."""
    if row.place and named.name == "e" and named.value and "–" in row.name and row.name[0] in "xy":
        return equal(abs(row.value), abs(named.value))
    return row.same == named.same and equal(row.value, named.value)


def beside(row: GivenRow, value: float) -> str:
    """The name of a row beside a parameter's, with its sign where it is the opposite."""
    return row.name if equal(row.value, value) else f"−{row.name}"


def equal(a: float, b: float) -> bool:
    """Whether two numbers are one."""
    return abs(a - b) <= SAME * max(abs(a), abs(b))
