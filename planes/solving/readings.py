"""Results by the names people give them."""

from collections.abc import Callable, Mapping
from typing import TypeVar

from planes.words.errors import PlanesError
from planes.words.naming import Naming

S = TypeVar("S")
T = TypeVar("T")


class UnknownName(PlanesError, KeyError):
    """There is no result of this name; the sentence says which there are."""

    __str__ = Exception.__str__  # a KeyError would put it in quotes


class Readings(dict[str, T]):
    """What was found, by name. ``[…]`` also takes a number, and a name as people write it: 2, "omega_2", "F_36".

    Raises :class:`UnknownName`, a KeyError, that names what there is.
    """

    def __init__(self, found: Mapping[str, T], naming: Naming, letter: str = "") -> None:
        super().__init__(found)
        self.naming, self.letter = naming, letter

    def __missing__(self, name: object) -> T:
        names = self.naming.names(self, poles=False, more={own: (f"{self.letter}_{own}",) for own in self})
        try:
            return self[names.one(str(name), "no_reading")]
        except PlanesError as error:
            raise UnknownName(error.phrase) from None

    def each(self, take: Callable[[T], S]) -> "Readings[S]":
        """Something of each."""
        return Readings({name: take(one) for name, one in self.items()}, self.naming, self.letter)
