"""A plan photographed from aside, on paper that tells nothing of it: the tilt its own marks tell, and what they owe to
the tilt that nothing tells.

A tilt moves all marks by one rule of two numbers; a hand's errors, and one mark drawn wrongly, do not. What tilt
remains is an error that marks share: one mark off by it is expected to have others off with it.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy

from planes.check.grading.paper import ReadMark
from planes.check.vision.image.lens import Lens
from planes.geometry.arrays import Array, Complexes

TURN = math.radians(0.7)  # σ of how sheets lie
HAND_MM, LENGTH_MM = 0.7, 0.6  # σ of a mark, and of the vector a scale was taken from
LEAST_TILT = math.tan(math.radians(2.0))  # less is not worth looking again
LEAST_MARKS = 4
BETTER = 1.2  # how much likelier, as a logarithm, marks must be: a careful hand's own errors gain 1.1 now and then
WIDE_MM = (6.0, 3.0, 1.5, *(HAND_MM,) * 7)  # marks farther off tell less and less, step by step


def as_sure(spot: ReadMark, about: complex, share: float, lens: Lens | None) -> ReadMark:
    """A mark with an error of a share of its distance, and with what an untold tilt of the camera moves it by."""
    z = spot.place - about
    shared = () if lens is None else tuple(lens.leaning(z, way) - z for way in lens.held.loose)
    tilted = math.hypot(*(abs(move) for move in shared)) / math.sqrt(2)
    return replace(spot, error_mm=math.hypot(spot.error_mm, share * abs(z), tilted), shared=shared)


def tilt_told(lens: Lens, pole: complex, spots: Sequence[ReadMark], true: Mapping[str, complex]) -> complex | None:
    """What more of a tilt (slopes to the right and up) makes a plan's marks most like the right ones; None where it is
    little or tells little."""
    pairs = [(s.place - pole, true[s.name]) for s in spots if s.name in true]
    if len(pairs) < LEAST_MARKS:
        return None
    seen, right = (numpy.array(part) for part in zip(*pairs, strict=True))
    plain, tilted = (_fitted(lens, seen, right, free) for free in (0.0, 1.0))
    tilt = lens.held.more(tilted)
    gain = _cost(lens, seen, right, plain) - _cost(lens, seen, right, tilted)
    return tilt if abs(tilt) > LEAST_TILT and gain > BETTER else None


def strange(lens: Lens, pole: complex, spots: Sequence[ReadMark], true: Mapping[str, complex]) -> float:
    """How unlike the right plan marks are, as a logarithm; those not read count as far off."""
    places = {s.name: s.place - pole for s in spots}
    seen = numpy.array([places.get(n, math.inf) for n in true])
    off = numpy.where(numpy.isfinite(seen), seen - numpy.array([*true.values()]), 10 * HAND_MM)
    return _unlike(off)


def _unlike(off: Complexes) -> float:
    """How unlike a hand's it is that marks are so far off, as a logarithm."""
    return float(numpy.log1p((abs(off) / HAND_MM) ** 2 / 2).sum())


def _off(lens: Lens, seen: Complexes, right: Complexes, k: Array) -> Complexes:
    """How far marks are off, with a tilt (in its σ), a turn and a stretch."""
    there = lens.leaning(seen, lens.held.more(k)) * numpy.exp(1j * k[2]) * (1 + k[3])
    out: Complexes = there - right
    return out


def _unlikely(lens: Lens) -> Array:
    return numpy.array([1.0, 1.0, TURN, LENGTH_MM / abs(lens.mark)])


def _cost(lens: Lens, seen: Complexes, right: Complexes, k: Array) -> float:
    return _unlike(_off(lens, seen, right, k)) + 0.5 * float(((k / _unlikely(lens)) ** 2).sum())


def _fitted(lens: Lens, seen: Complexes, right: Complexes, free: float) -> Array:
    """Tilt (if it is ``free``), turn and stretch that make marks most like the right ones, Gauss and Newton's way."""
    k, sigma = numpy.zeros(4), _unlikely(lens) * [max(free, 1e-6), max(free, 1e-6), 1, 1]
    for wide in WIDE_MM:
        off = _off(lens, seen, right, k)
        slopes = [(_off(lens, seen, right, k + d) - off) / 1e-5 for d in 1e-5 * numpy.eye(4)]
        weight = 1 / numpy.sqrt(HAND_MM**2 * (1 + (abs(off) / wide) ** 2 / 2))
        rows = numpy.stack([numpy.concatenate([(s * weight).real, (s * weight).imag]) for s in slopes], axis=1)
        left = numpy.concatenate([(off * weight).real, (off * weight).imag])
        rows, left = numpy.vstack([rows, numpy.diag(1 / sigma)]), numpy.concatenate([left, k / sigma])
        k = k - numpy.linalg.lstsq(rows, left, rcond=None)[0]
    return k
