"""A given number or place computed from the dimensions of links."""

from typing import Any, NamedTuple

from planes.drafting.tools import Thing


class Dimension(NamedTuple):
    """Its kind, the values it is found ``of``, and how: two that are equal by chance are not the same dimension."""

    value: Thing
    of: tuple[Any, ...]

    def __neg__(self) -> "Dimension":
        return Dimension(-self.value, ("-", self.of))
