"""Names for arrays in annotations; numpy itself is imported only where it is used."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array = NDArray[np.float64]
    Complexes = NDArray[np.complex128]
    Booleans = NDArray[np.bool_]
    Indices = NDArray[np.intp]
    Texts = NDArray[np.str_]
    Greys = NDArray[np.uint8]
    """A picture: grey, or another array of bytes."""
    Floats = float | Array
    """A number of one position, or an array with one for each position."""
    FloatsByName = Mapping[str, Floats]
    ArrayPair = tuple[Array, Array]
    Points = complex | Complexes
    """A place or a vector of one position, or an array with one for each position."""
else:
    Array = Complexes = Booleans = Indices = Texts = Greys = Floats = FloatsByName = ArrayPair = Points = object
