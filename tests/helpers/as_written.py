"""The true solution of a scene as written: its decimals with 50 digits, and all values computed from them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from typing import Any

import numpy as np

from planes.accuracy.digits import Long
from planes.batch.cycle import Cycle
from planes.batch.tracing import given_values_by_name
from planes.plans import plans_of
from planes.plans.position import reckoned
from planes.scene.mechanism import Mechanism
from tests.helpers.double_double import Two, read_long

LONG = Long(50)


def decimal(x: float) -> Any:
    """The decimal number of a scene for a double: its shortest digits."""
    return LONG.mp.mpf(repr(float(x)))


def long(thing: Any, places: Mapping[complex, tuple[float, ...]]) -> Any:
    """A mechanism, or a part of it, with all digits of its numbers; ``places`` are those given by radius and angle."""
    if isinstance(thing, complex):
        polar = places.get(thing)
        if polar:
            return decimal(polar[0]) * LONG.cis_deg(decimal(polar[1]))
        return LONG.mp.mpc(decimal(thing.real), decimal(thing.imag))
    if isinstance(thing, float):
        return decimal(thing)
    if isinstance(thing, Mapping):
        return {k: long(v, places) for k, v in thing.items()}
    if isinstance(thing, tuple):
        return tuple(long(x, places) for x in thing)
    if is_dataclass(thing) and not isinstance(thing, type):
        names = [f.name for f in fields(thing) if f.name not in ("where", "written")]
        return replace(thing, **{name: long(getattr(thing, name), places) for name in names})
    return thing


def givens(mechanism: Mechanism) -> dict[str, Any]:
    """All givens of the drawing, computed with long numbers."""
    kept, reckoned.FLOAT_ARITHMETIC = reckoned.FLOAT_ARITHMETIC, LONG
    try:
        return dict(plans_of(long(mechanism, mechanism.written.places)).given)
    finally:
        reckoned.FLOAT_ARITHMETIC = kept


def pair(x: Any) -> Two:
    """A long number as two doubles."""
    high = float(x)
    return np.float64(high), np.float64(float(x - LONG.mp.mpf(high)))


def truth(c: Cycle, values: Any) -> list[Two]:
    """The columns of scenes as written, computed in numbers of 106 bits."""
    true = givens(c.plans.mechanism)
    flat: dict[str, Any] = {}
    for name, rounded in given_values_by_name(c.given).items():
        value: object = rounded
        own, part = (name[:-2], name[-1]) if name.endswith((".x", ".y")) else (name, "")
        if own in true:
            x = true[own]
            value = pair({"": lambda x: x, "x": lambda x: x.real, "y": lambda x: x.imag}[part](LONG.mp.mpmathify(x)))
        flat[name] = value
    parts = [pair(decimal(v)) for v in values]
    flat[c.plans.drive_given_name] = np.array([p[0] for p in parts]), np.array([p[1] for p in parts])
    return read_long(c, flat, values.shape)
