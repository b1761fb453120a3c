"""The same work by others: kernels written by hand for one mechanism, pylinkage's quickest way, kinepy."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from importlib.util import find_spec

import kernels
import numpy as np
from conftest import angles, plans

from planes.accuracy.comparison import Comparison
from planes.batch.cycle import Cycle
from planes.plans import Plans
from tests.helpers.other_programs import Pylinkage, kinepy_run, near_of, pylinkage_run

COLUMNS = {
    "four-bar": kernels.FOUR_BAR_NAMES,
    "slider-crank": kernels.SLIDER_CRANK_NAMES,
    "slotted lever": kernels.SLOTTED_NAMES,
    "six-link": kernels.SIX_LINK_NAMES,
    "tangent": kernels.TANGENT_NAMES,
}
KERNELS = {
    "four-bar": kernels.four_bar,
    "slider-crank": kernels.slider_crank,
    "slotted lever": kernels.slotted_lever,
    "six-link": kernels.six_link,
    "tangent": kernels.tangent,
}
Work = Callable[[], object]


def numbers(name: str, stated: Plans | None = None) -> list[float]:
    """What a kernel is told of its mechanism; ``stated``, if that is not as its scene has it."""
    own = stated or plans(name)
    given, m = own.given, own.mechanism
    drive = [m.drive.velocity, m.drive.acceleration]
    if name == "slotted lever":
        return [given["l_AB"], given["place_C"].real, given["place_C"].imag, *drive]
    if name in ("slider-crank", "tangent"):
        foot, way = given["place_°q-q"], cmath.exp(1j * math.radians(given["angle_∥q-q"]))
        guide = [foot.real, foot.imag, way.real, way.imag]
        if name == "tangent":
            return [given["l_AK"], given["angle_∥KB"], *guide, *drive]
        return [given["l_AB"], given["l_BC"], *guide, 1.0, *drive]
    d = given["place_D"]
    lengths = [given["l_AB"], given["l_BC"], given["l_DC"], d.real, d.imag, given["side_C"]]
    if name == "four-bar":
        return [*lengths, *drive]
    masses = [x for k in "123" for x in (m.links[k].mass, m.links[k].inertia)]
    return [*lengths, 0.2, -0.42, *drive, *masses, m.links["5"].mass, 6000.0, m.gravity]


def by_hand(name: str, count: int) -> Work:
    """The kernel of a mechanism, checked first against the drawing."""
    phis, told = angles(name, count), numbers(name)
    out = np.empty((len(Cycle(plans(name), COLUMNS[name]).columns), count))
    KERNELS[name](phis, out, *told)
    each = count // 300 + 1
    (block,) = Cycle(plans(name), COLUMNS[name]).blocks(phis[::each], fast=False)
    size = np.nanmax(np.abs(block.table), axis=1, keepdims=True) + 1e-3
    assert np.nanmax(np.abs(block.table - out[:, ::each]) / size) < 1e-9
    return lambda: KERNELS[name](phis, out, *told)


def pylinkage(name: str, count: int) -> Work | None:
    """Places, velocities and accelerations by its numba path; None where it has not the groups."""
    p, phis = plans(name), angles(name, count)
    if not find_spec("pylinkage") or not Pylinkage.can(p):
        return None
    run = pylinkage_run(p, float(phis[0]), near_of(Comparison(p), phis[:1])(0))
    return lambda: run(phis)


def kinepy(name: str, count: int) -> Work | None:
    """Places; what differences cost beside them is left out."""
    if not find_spec("kinepy"):
        return None
    run, phis = kinepy_run(plans(name)), angles(name, count)
    return lambda: run(phis)
