"""The effect of an unknown tilt of a phone camera on the plane of a sheet."""

import math

import numpy

from planes.check.vision.image.bend import Place, apply_homography
from planes.geometry.arrays import Array
from planes.words.frozen import frozen

PHONE_FOCAL_LENGTH = 0.73  # focal length of a phone camera, in longer sides of its picture
MOST_TILT_DEG = 40.0
PHONE_TILT_SIGMA = math.tan(math.radians(6.0))  # σ of the tilt of phones


@frozen
class CameraTilt:
    """The tilt of a camera (slopes to the sheet's right and up, or down for pixels), with one σ of it along two axes.

    Also the rotation of the sheet's lines in the picture (radians).
    """

    slopes: complex = 0j
    loose: tuple[complex, complex] = (complex(PHONE_TILT_SIGMA), complex(0, PHONE_TILT_SIGMA))
    turn: float = 0.0

    @property
    def tilt_significance(self) -> float:
        """Its significance as an oblique view, in σ."""
        return math.hypot(*((self.slopes * way.conjugate()).real / abs(way) ** 2 for way in self.loose))

    def slopes_for_sigmas(self, shares: Array) -> complex:
        """Slopes for multiples of σ along both axes."""
        return complex(shares[0] * self.loose[0] + shares[1] * self.loose[1])

    def mirrored(self) -> "CameraTilt":
        """The same with y reversed."""
        first, second = self.loose
        return CameraTilt(self.slopes.conjugate(), (first.conjugate(), second.conjugate()), -self.turn)


UNKNOWN_TILT = CameraTilt()


@frozen
class Lens:
    """A camera over a rectified picture, mm from the pole (y up): the point it is aimed at and its distance.

    Also the mark that set the scale of the picture (if ``turned``, its direction, too), and the tilt already corrected.
    """

    middle: complex
    far: float
    mark: complex
    turned: bool = False
    held: CameraTilt = UNKNOWN_TILT

    def positions_under_tilt(self, z: Place, tilt: complex) -> Place:
        """The positions of points of the sheet under an additional camera tilt (slopes to the right and up).

        The scale is set again by the same mark.
        """
        view = levelled_view(self.middle, self.far, tilt)
        if view is None:
            return z
        pole = apply_homography(view, 0j)
        way = self.mark / (apply_homography(view, self.mark) - pole)
        return (apply_homography(view, z) - pole) * (way if self.turned else abs(way))


def levelled_view(middle: complex, far: float, tilt: complex) -> Array | None:
    """The view from straight above of a plane seen by a tilted camera (the slope of its depth along both axes).

    Its middle is fixed. None if no camera is held like that.
    """
    if abs(tilt) > math.tan(math.radians(MOST_TILT_DEG)):
        return None
    normal = numpy.array([tilt.real, tilt.imag, 1.0])
    normal /= numpy.linalg.norm(normal)
    x, y, z = normal.tolist()
    across = numpy.array([[0, 0, -x], [0, 0, -y], [x, y, 0]])  # the tilt: rotation about this axis levels the plane
    turn = numpy.eye(3) + across + across @ across / (1 + z)
    camera = numpy.array([[far, 0, middle.real], [0, far, middle.imag], [0, 0, 1.0]])
    out: Array = camera @ turn @ numpy.linalg.inv(camera)
    return out
