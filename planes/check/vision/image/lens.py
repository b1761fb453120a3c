"""What a telephone's camera makes of a sheet's plane when it is tilted, and nothing tells by how much."""

import math

import numpy

from planes.check.vision.image.bend import Place, through
from planes.geometry.arrays import Array
from planes.words.frozen import frozen

FOCAL = 0.73  # of a telephone's lens, in lengths of its picture's longer side
MOST_TILT_DEG = 40.0
HELD = math.tan(math.radians(6.0))  # σ of how telephones are held


@frozen
class CameraTilt:
    """How a camera was tilted (slopes to the sheet's right and up, or down where pixels are meant), one σ of that along
    two axes, and how the sheet's lines are turned in the picture (radians)."""

    slopes: complex = 0j
    loose: tuple[complex, complex] = (complex(HELD), complex(0, HELD))
    turn: float = 0.0

    @property
    def sure(self) -> float:
        """By how many σ it is no straight view."""
        return math.hypot(*((self.slopes * way.conjugate()).real / abs(way) ** 2 for way in self.loose))

    def more(self, shares: Array) -> complex:
        """Slopes of so many σ along both axes."""
        return complex(shares[0] * self.loose[0] + shares[1] * self.loose[1])

    def mirrored(self) -> "CameraTilt":
        """The same with y the other way."""
        first, second = self.loose
        return CameraTilt(self.slopes.conjugate(), (first.conjugate(), second.conjugate()), -self.turn)


UNTOLD = CameraTilt()


@frozen
class Lens:
    """A camera over a flat picture, mm from the pole (y up): the place it looks at, how far it is, and the mark that
    the picture's scale (``turned``: direction, too) was taken from; and what tilt was taken out of it."""

    middle: complex
    far: float
    mark: complex
    turned: bool = False
    held: CameraTilt = UNTOLD

    def leaning(self, z: Place, tilt: complex) -> Place:
        """Where places of the sheet are, were the camera tilted by so much more (slopes to the right and up), the scale
        taken from the same mark again."""
        view = level(self.middle, self.far, tilt)
        if view is None:
            return z
        pole, mark = through(view, 0j), through(view, self.mark)
        way = self.mark / (mark - pole)
        return (through(view, z) - pole) * (way if self.turned else abs(way))


def level(middle: complex, far: float, tilt: complex) -> Array | None:
    """The view of a plane that a camera sees tilted by so much (the slope of its depth along both axes), as from
    straight above; in its middle nothing moves. None where no camera is held so."""
    if abs(tilt) > math.tan(math.radians(MOST_TILT_DEG)):
        return None
    normal = numpy.array([tilt.real, tilt.imag, 1.0])
    normal /= numpy.linalg.norm(normal)
    x, y, z = normal.tolist()
    across = numpy.array([[0, 0, -x], [0, 0, -y], [x, y, 0]])  # the tilt: about this axis the plane is turned level
    turn = numpy.eye(3) + across + across @ across / (1 + z)
    camera = numpy.array([[far, 0, middle.real], [0, far, middle.imag], [0, 0, 1.0]])
    out: Array = camera @ turn @ numpy.linalg.inv(camera)
    return out
