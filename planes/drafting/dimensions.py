"""A given number or place computed from the dimensions of links."""

from collections.abc import Callable, Hashable
from typing import Any, NamedTuple

from planes.drafting.tools import Thing
from planes.geometry.arithmetic import Arithmetic


class Dimension(NamedTuple):
    """The value, the formula for it, and the dimensions ``of`` which it is computed: two that agree by chance are not
    the same dimension."""

    value: Thing
    by: Callable[[Any, Arithmetic], Any]
    of: Hashable

    def __neg__(self) -> "Dimension":
        return Dimension(-self.value, lambda shape, ar: -self.by(shape, ar), ("-", self.of))
