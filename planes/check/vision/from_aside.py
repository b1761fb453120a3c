"""A plan photographed at an angle on paper without marks: the camera tilt from its marks, and the remaining error.

A tilt moves all marks by one rule with two parameters; drawing errors, and a single wrong mark, do not. The remaining
tilt is an error shared by all marks: if one mark is off by it, others are expected to be off with it.
"""

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy

from planes.check.grading.paper import MarkPlaces, ReadMark
from planes.check.vision.image.lens import Lens
from planes.geometry.arrays import Array, Complexes

SHEET_TURN_SIGMA_RAD = math.radians(0.7)  # σ of a sheet's rotation
MARK_SIGMA_MM, SCALE_VECTOR_SIGMA_MM = 0.7, 0.6  # σ of a mark, and of the vector that set the scale
LEAST_TILT_SLOPE = math.tan(math.radians(2.0))  # a smaller tilt is not worth another pass
LEAST_MARKS = 4
HARDLY_FREE = 1e-6  # of its σ, a tilt that is held
LEAST_LIKELIHOOD_GAIN = 1.2  # minimum gain in log likelihood: the errors of a careful hand gain 1.1 now and then
OUTLIER_WIDTHS_MM = (6.0, 3.0, 1.5, *(MARK_SIGMA_MM,) * 7)  # weights of distant marks decrease step by step


def with_scale_and_tilt_errors(spot: ReadMark, about: complex, share: float, lens: Lens | None) -> ReadMark:
    """A mark with an error proportional to its distance, and with the displacement by an unknown camera tilt."""
    z = spot.place - about
    shared = () if lens is None else tuple(lens.positions_under_tilt(z, way) - z for way in lens.held.loose)
    tilted = math.hypot(*(abs(move) for move in shared)) / math.sqrt(2)
    return replace(spot, error_mm=math.hypot(spot.error_mm, share * abs(z), tilted), shared=shared)


def fitted_camera_tilt(lens: Lens, pole: complex, spots: Sequence[ReadMark], true: MarkPlaces) -> complex | None:
    """The additional tilt (slopes to the right and up) that fits a plan's marks to the right ones best.

    None if it is small or poorly determined.
    """
    pairs = [(s.place - pole, true[s.name]) for s in spots if s.name in true]
    if len(pairs) < LEAST_MARKS:
        return None
    seen, right = (numpy.array(part) for part in zip(*pairs, strict=True))
    plain, tilted = (_fit_tilt(lens, seen, right, free) for free in (HARDLY_FREE, 1.0))
    tilt = lens.held.slopes_for_sigmas(tilted)
    gain = _fit_cost(lens, seen, right, plain) - _fit_cost(lens, seen, right, tilted)
    if abs(tilt) > LEAST_TILT_SLOPE and gain > LEAST_LIKELIHOOD_GAIN:
        return tilt
    return None


def log_deviation_from_plan(pole: complex, spots: Sequence[ReadMark], true: MarkPlaces) -> float:
    """The deviation of marks from the right plan, as a logarithm; unread ones count as far off."""
    places = {s.name: s.place - pole for s in spots}
    seen = numpy.array([places.get(n, math.inf) for n in true])
    off = numpy.where(numpy.isfinite(seen), seen - numpy.array([*true.values()]), 10 * MARK_SIGMA_MM)
    return _log_deviation(off)


def _log_deviation(off: Complexes) -> float:
    """The deviation of marks this far off from drawing errors, as a logarithm."""
    return float(numpy.log1p((abs(off) / MARK_SIGMA_MM) ** 2 / 2).sum())


def _mark_errors(lens: Lens, seen: Complexes, right: Complexes, k: Array) -> Complexes:
    """The errors of marks after a tilt (in its σ), a rotation and a scaling."""
    there = lens.positions_under_tilt(seen, lens.held.slopes_for_sigmas(k)) * numpy.exp(1j * k[2]) * (1 + k[3])
    out: Complexes = there - right
    return out


def _parameter_sigmas(lens: Lens) -> Array:
    return numpy.array([1.0, 1.0, SHEET_TURN_SIGMA_RAD, SCALE_VECTOR_SIGMA_MM / abs(lens.mark)])


def _fit_cost(lens: Lens, seen: Complexes, right: Complexes, k: Array) -> float:
    return _log_deviation(_mark_errors(lens, seen, right, k)) + 0.5 * float(((k / _parameter_sigmas(lens)) ** 2).sum())


def _fit_tilt(lens: Lens, seen: Complexes, right: Complexes, free: float) -> Array:
    """Tilt (as far as it is ``free``), rotation and scaling that fit marks to the right ones best (Gauss-Newton)."""
    k = numpy.zeros(4)
    sigma = _parameter_sigmas(lens) * [free, free, 1, 1]
    for wide in OUTLIER_WIDTHS_MM:
        off = _mark_errors(lens, seen, right, k)
        slopes = [(_mark_errors(lens, seen, right, k + d) - off) / 1e-5 for d in 1e-5 * numpy.eye(4)]
        weight = 1 / numpy.sqrt(MARK_SIGMA_MM**2 * (1 + (abs(off) / wide) ** 2 / 2))
        rows = numpy.stack([(s * weight).view(float) for s in slopes], axis=1)
        left = (off * weight).view(float)
        rows = numpy.vstack([rows, numpy.diag(1 / sigma)])
        left = numpy.concatenate([left, k / sigma])
        k = k - numpy.linalg.lstsq(rows, left, rcond=None)[0]
    return k
