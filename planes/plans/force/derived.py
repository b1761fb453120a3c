"""Intermediate results of the force calculation that are also results: weights, inertia forces, load laws, friction."""

from collections.abc import Iterator
from typing import NamedTuple

from planes.plans import Plans
from planes.plans.columns import DriverVector
from planes.words.names import NO_MARK, UNIT_OF_LOADING, MarkPair, NameTuple
from planes.words.units import unit_of_parameter


class Derived(NamedTuple):
    """A value of the program, or the magnitude of a segment by its ``ends``, with all its ``names``; the first is its
    key in the JSON. ``per``: divided by the driver's speed."""

    names: NameTuple
    unit: str
    value: str
    group: str
    ends: MarkPair = (NO_MARK, NO_MARK)
    per: DriverVector | None = None


def derived_values(plans: Plans) -> Iterator[Derived]:
    """Weights, inertia forces and couples of every link, then normal force, friction and its power in every pair; in a
    hinge the couple of friction and its power."""
    loads = plans.acting
    for link in plans.mechanism.links:
        for f in (f for f in loads.forces[link] if f.quantity in ("weight", "inertia")):
            names = (f"G_{link}",) if f.quantity == "weight" else (f"I_{link}", f"Φ_{link}")
            yield Derived(names, "N", f.size, "loads")
        for couple in (c for c in loads.couples[link] if c.inertia):
            yield Derived((f"MI_{link}", f"M_I{link}", f"M_Φ{link}"), "N·m", couple.value, "loads")
    for r in (r for r in plans.reactions.values() if r.edges):
        letter, group = ("N", "edges") if r.pair.guide else ("F", "bearings")
        for k, edge in enumerate(r.edges or (), 1):
            yield Derived((f"{letter}_{r.index}^{k}",), "N", edge, group)
    for r in (r for r in plans.reactions.values() if r.friction):
        if r.pair.kind == "R":
            yield Derived((f"M_T{r.index}",), "N·m", r.friction, "friction")
        else:
            yield Derived((f"N_{r.index}",), "N", r.normal, "friction")
            yield Derived((f"T_{r.index}",), "N", r.friction, "friction")
        yield Derived((f"P_T{r.index}",), "W", r.power, "friction")


def values_given_by_laws(plans: Plans) -> Iterator[Derived]:
    """Loads given by laws, with their values in the position; values computed from stated vectors."""
    figure = plans.figure
    members = {name for name, _, _ in figure.members} | {n for _, _, n in figure.shears} if figure else set[str]()
    for name, value in plans.values.items():
        yield Derived((name,), "N" if name in members else unit_key_of_value(name), value, "values")

    for name in plans.acting.laws:
        load = plans.means[name].of
        unit = UNIT_OF_LOADING.get(plans.means[name].quantity)
        if unit and load in plans.program.result_names:
            yield Derived((load,), unit, load, "loads")


def unit_key_of_value(name: str) -> str:
    """The key of the unit of a stated value, "" where its name does not show it; P_T is a power of friction."""
    return "W" if name.startswith("P_T") else unit_of_parameter(name)
