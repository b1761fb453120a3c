"""Results by the names people give them."""

from collections.abc import Mapping
from typing import TypeVar

from planes.words.errors import PlanesError
from planes.words.naming import Naming

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
        self._names = naming.names(found, poles=False, more={name: f"{letter}_{name}" for name in found})

    def __missing__(self, name: object) -> T:
        try:
            return self[self._names.one(str(name), "no_reading")]
        except PlanesError as error:
            raise UnknownName(error.phrase) from None
