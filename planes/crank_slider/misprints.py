"""What the source text's equations would give where they are wrong, beside the true numbers of one position."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from planes.crank_slider.engine import EngineCycle, RodMotion
from planes.crank_slider.forces import CycleForces
from planes.crank_slider.shape import CrankSliderShape


@dataclass(frozen=True)
class Printed:
    """R_B by (22), T by (25), K by (26), J_C by (20), as printed; N and kg·m². Signs of T, K as in ``CycleForces``."""

    R_B: float
    T: float
    K: float
    J_C: float


def printed(shape: CrankSliderShape, m: EngineCycle, way: RodMotion, f: CycleForces, k: int) -> Printed:
    """The text's equations at step ``k``: (22) lacks the crank's torque, (25), (26) the vertical force in B."""
    phi, at_c, inertia = float(m.phi[k]), complex(way.r["C"][k]), -shape.m2 * complex(way.a["C"][k])
    g1, g2, g3 = (mass * shape.g for mass in (shape.m1, shape.m2, shape.m3))
    moments = (
        -g1 * shape.s * np.cos(phi)
        - g2 * at_c.real
        + at_c.real * inertia.imag
        - at_c.imag * inertia.real
        - shape.j2 * float(way.epsilon[k])
    )
    p = float(f.P[k])
    t = -g2 * np.cos(phi) + p * np.sin(phi) - inertia.real * np.sin(phi) + inertia.imag * np.cos(phi)
    out = -g2 * np.sin(phi) + inertia.imag * np.sin(phi) + inertia.real * np.cos(phi) - p * np.cos(phi)
    return Printed(g3 - moments / float(way.r["B"][k].real), float(t), -float(out), 4 / 9 * shape.m2 * shape.l**2)
