"""How likely misses are, and from that how sure a verdict on a drawing is.

What was read is explained by a right drawing; by one mistake of the catalogue; by a mark that is wrong for a reason of
its own; or, of a picture, by another place taken for the mark that seems wrong. Priors are stated as shares of marks.
"""

import math
from collections.abc import Iterable, Mapping

import numpy

from planes.check.grading.handwork import Miss

SLIP = 0.02  # the share of marks that are wrong for a reason of their own; so likely is each mistake of the catalogue
MISREAD_MM = 0.7  # half of the places taken for a mark by error are no more than 1.7 times this from it
ANYWHERE = 0.2  # the share of them that may be anywhere on the drawing
SURE = 0.98  # what is less likely is only said to be likely
ASKED = 0.5  # what is no likelier than its opposite is not said of a picture: it is asked


def breadth(extent_mm: float) -> float:
    """Logarithm of the density of a mark that may be anywhere on the drawing."""
    return -2 * math.log(2 * max(extent_mm, 20.0))


def misread(off: complex, broad: float, doubt: float) -> float:
    """Logarithm of the density of a place taken for a mark by error: near by most often, now and then anywhere."""
    if not doubt:
        return -math.inf
    near = -math.log(2 * math.pi * MISREAD_MM**2) - 1.5 * math.log1p(abs(off) ** 2 / MISREAD_MM**2)
    return math.log(doubt) + float(numpy.logaddexp(near, math.log(ANYWHERE) + broad))


def density(miss: Miss, broad: float, doubt: float) -> float:
    """Logarithm of the density of a miss of a mark that is right, but for the errors of hand and reading."""
    if not math.isfinite(miss.sigmas):
        return -math.inf
    return float(numpy.logaddexp(miss.log_density + math.log1p(-doubt), misread(miss.off, broad, doubt)))


def mixed(miss: Miss, broad: float, doubt: float) -> float:
    """The same of any mark: now and then it slipped."""
    return float(numpy.logaddexp(density(miss, broad, doubt) + math.log1p(-SLIP), broad + math.log(SLIP)))


def all_drawn(misses: Mapping[str, Miss], broad: float, doubts: Mapping[str, float]) -> float:
    """Logarithm of how likely it is that none of the marks slipped."""
    return sum(density(m, broad, doubts[n]) + math.log1p(-SLIP) - mixed(m, broad, doubts[n]) for n, m in misses.items())


def chance_wrong(right: float, otherwise: float, mistakes: Iterable[float]) -> float:
    """How likely a drawing is wrong: against all that makes up its marks' densities, of which ``right`` is the share
    where none slipped, ``otherwise`` weighs another reading under which it is right, ``mistakes`` each mistake (all as
    logarithms)."""
    named = math.log(SLIP) + float(numpy.logaddexp.reduce([-math.inf, *mistakes]))
    slipped = math.log(-math.expm1(right)) if right < 0 else -math.inf
    good = float(numpy.logaddexp(right, otherwise))
    return float(1 / (1 + numpy.exp(min(good - numpy.logaddexp(named, slipped), 700.0))))


def chance_off(off: float, sigma: float, size: float) -> float:
    """How likely a number of a known size is wrong that is so far off, and not only measured with an error σ."""
    drawn = -0.5 * (off / sigma) ** 2 - math.log(sigma * math.sqrt(2 * math.pi)) if sigma else -math.inf
    slipped = math.log(SLIP) - math.log(2 * max(size, off, sigma))
    return 1 / (1 + math.exp(min(drawn - slipped, 700.0)))
