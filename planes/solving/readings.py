"""Results by the names people use."""

from collections.abc import Callable, Collection, Mapping
from typing import TYPE_CHECKING, Any, TypeVar

from planes.words import Phrase
from planes.words.errors import PlanesError, UnknownName, list_valid_choices
from planes.words.naming import Naming

S = TypeVar("S")
T = TypeVar("T")
_MOTION_RESULT_KINDS = ("points.r", "points.v", "points.a", "links.omega", "links.epsilon")
RESULT_KINDS = (
    *_MOTION_RESULT_KINDS,
    "reactions",
    "transfers",
    "friction",
    "edges",
    "bearings",
    "loads",
    "vectors",
    "values",
)
"""Kinds of results there may be, or none of."""
BALANCING_LOAD_NAMES = ("balancing_moment", "balancing_force", "zhukovsky_moment", "zhukovsky_force")


def require_known_name(name: str, names: Collection[str]) -> None:
    """An :class:`UnknownName` for a name that is not among these; it lists them."""
    if name not in names:
        raise UnknownName(Phrase("no_reading", name=name, valid=list_valid_choices(name, names)))


class Readings(dict[str, T]):
    """Results by name. ``[…]`` also accepts a number, and a name as people write it: 2, "omega_2", "F_36".

    Raises :class:`UnknownName`, a KeyError, with the valid names.
    """

    def __init__(self, readings: Mapping[str, T], naming: Naming, letter: str = "") -> None:
        super().__init__(readings)
        self.naming = naming
        self.letter = letter

    if TYPE_CHECKING:

        def __getitem__(self, name: str | int) -> T: ...

    def __contains__(self, name: object) -> bool:
        return super().__contains__(name) or self.get(name) is not None

    def get(self, name: Any, other: Any = None) -> Any:
        """The result for a name, in any of its spellings; otherwise ``other``."""
        try:
            return self[name]
        except UnknownName:
            return other

    def __missing__(self, name: object) -> T:
        names = self.naming.name_finder(self, poles=False, more={own: (f"{self.letter}_{own}",) for own in self})
        try:
            return self[names.require_name(str(name), "no_reading")]
        except PlanesError as error:
            raise UnknownName(error.phrase) from None

    def attribute_of_each(self, take: Callable[[T], S]) -> "Readings[S]":
        """One attribute of each result."""
        return Readings({name: take(one) for name, one in self.items()}, self.naming, self.letter)
