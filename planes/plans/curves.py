"""The quantities of a mechanism as curves over the driver's position: their names, units, and columns.

A curve is read from columns of the batch program; "q:" before a column means the run with a unit drive, where a
velocity is the analogue of velocity (transfer function) dr/dφ₁ and an acceleration the analogue d²r/dφ₁². Names: r_C_x,
phi_3, s_5 (positions) · vq_C, u_31, aq_C, epsilonq_3 (analogues) · v_C, omega_3, a_C (rates) · F_21, M_1.
"""

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from operator import itemgetter
from typing import Literal, Self, TypeVar

import numpy as np

from planes.drafting.tools import AskedFor
from planes.geometry.arithmetic import Real
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.columns import Column
from planes.plans.force.loads import name_of_force
from planes.plans.quantities import MOTION_GROUPS, Quantity, quantities_by_name, results_wanted
from planes.plans.transfers import analogue_units, transfer_ratio_name, turning_links
from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen, replace
from planes.words.names import NameTuple, with_analogue_in_index
from planes.words.units import UNIT_OF_RATE_LETTER

Sample = Mapping[str, Array]
"""Columns of many positions by name: "v_C_x", and "q:v_C_x" of the unit drive."""
Reading = Callable[[Sample], Real]

Group = Literal["place", "analogue", "rate", "force"]
CHAPTERS_BY_GROUP: Mapping[Group, NameTuple] = {
    "place": ("place",),
    "analogue": ("analogue_v", "analogue_a"),
    "rate": ("rate_v", "rate_a"),
    "force": ("force",),
}
"""The groups of curves in the order of a summary, each with its chapters in a list of positions; their titles are the
words ``group_…``."""
UNIT_DRIVE_PREFIX = "q:"
T = TypeVar("T", bound="Curve | CycleVector")
FULL_TURN_DEG = 360.0
CURVE_ROUNDING_RATIO = 1e-15  # of the numbers a curve is computed from, where they are several: four last places


@frozen
class Curve:
    """One quantity over the cycle. ``slope`` has the sign of its derivative by the driver's position, where that is
    known exactly; ``angular`` values are only defined up to a full turn (degrees)."""

    name: str
    unit: str
    group: Group
    read: Reading
    slope: Reading | None = None
    angular: bool = False

    def error_bounds_of_curve(self, sample: Sample, margins: Sample) -> Real:
        """± at every position, by the ``margins`` of the columns it reads. None of them moves it by more than it moves
        itself; an angle moves a place along a guide by as much as it turns the lengths read."""
        names = columns_needed([self], False)
        if len(names) == 1:
            return margins[names[0]]
        lengths = sum(np.abs(sample[n]) for n in names)
        turned = (np.radians(margins[n]) * lengths if n[0] == "p" else margins[n] for n in names)
        return sum(turned) + CURVE_ROUNDING_RATIO * lengths


@frozen
class CycleVector:
    """A vector over the cycle, as complex numbers: for a path or a hodograph."""

    name: str
    unit: str
    base: str

    def read(self, s: Sample) -> Real:
        """x + iy at every position."""
        return s[f"{self.base}_x"] + 1j * s[f"{self.base}_y"]


def columns_needed(things: Iterable[Curve | CycleVector], slopes: bool = True) -> list[str]:
    """The columns for curves, with their ``slopes`` or without, and for vectors."""
    asked = AskedFor()
    for one in things:
        one.read(asked)
        if slopes and isinstance(one, Curve) and one.slope:
            one.slope(asked)
    return list(asked)


def curves_by_name(plans: Plans) -> dict[str, Curve]:
    """Every curve of a mechanism by its name, in listing order; a reaction's second name is included too, as is the
    lettered name of an analogue."""
    curves = {
        c.name: c
        for c in (*_position_curves(plans), *_rate_curves(plans, "q"), *_rate_curves(plans), *_force_curves(plans))
    }
    for r in plans.reactions.values():
        curves.setdefault(name_of_force(r.pair.other, r.pair.link), curves[r.key])
    for link in turning_links(plans):
        curves.setdefault(f"omegaq_{link}", curves[transfer_ratio_name(plans, link)])
    return {with_analogue_in_index(name): curve for name, curve in curves.items()} | curves


def vectors_by_name(plans: Plans) -> dict[str, CycleVector]:
    """Every vector of a mechanism by its name: r_C, v_C, vq_C, a_C, aq_C, F_21."""
    units = analogue_units(plans.drive.rotates)
    own = [q for q in results_wanted(plans) if q.group in ("points", "reactions")]
    vectors = {q.name: CycleVector(q.name, q.columns[0].unit, q.name) for q in own}
    named = ((f"{letter}q_{p}", letter, p) for p in plans.points for letter in "va")
    return vectors | {
        name: CycleVector(name, units[letter], f"{UNIT_DRIVE_PREFIX}{letter}_{p}") for name, letter, p in named
    }


def curves_meant_by_name(plans: Plans, name: str) -> list[Curve]:
    """What a name means as curves: the columns of a quantity, or a curve that is none. :class:`PlanesError` where it
    means nothing."""
    quantities = quantities_by_name(plans)
    names = plans.default_naming.name_finder(quantities, poles=False)
    if names.possible_names(name):
        return curves_of_quantity(
            quantities[names.require_name(name, "no_quantity", lambda n: quantities[n].json_path)]
        )
    curves = askable_curves(plans)
    name = plans.default_naming.name_finder(curves, poles=False).require_name(
        name, "no_quantity", lambda n: curves[n].name
    )
    return [replace(curves[name], name=name)]  # an analogue has two names


def curves_meant_by_names(plans: Plans, names: Iterable[str] | None) -> list[Curve]:
    """The curves that names mean (None: those of all results), each once."""
    read = (
        map(curves_of_quantity, results_wanted(plans))
        if names is None
        else (curves_meant_by_name(plans, name) for name in names)
    )
    return list({c.name: c for some in read for c in some}.values())


def askable_names(plans: Plans) -> list[str]:
    """Every name that can be asked for, as it is typed."""
    return list(
        dict.fromkeys(map(plans.default_naming.typed_name, (*quantities_by_name(plans), *askable_curves(plans))))
    )


def askable_curves(plans: Plans) -> dict[str, Curve]:
    """The curves, with numbers and parts of vectors that are none."""
    return {c.name: c for q in quantities_by_name(plans).values() for c in curves_of_quantity(q)} | curves_by_name(
        plans
    )


def curves_of_quantity(q: Quantity) -> list[Curve]:
    """The columns of a quantity as curves: of F_12 those of F_21, opposite."""
    if len(q.columns) == 1:
        return [Curve(q.name, q.columns[0].unit, "rate", itemgetter(q.columns[0].name))]
    parts = ((f"{q.name}_{c.name[len(q.name) + 1 :]}", c) for c in q.columns if c.part or not q.is_reversed)
    return [
        Curve(n, c.unit, "rate", _negated_column(c.name) if q.is_reversed else itemgetter(c.name)) for n, c in parts
    ]


def columns_by_name(plans: Plans) -> dict[str, Column]:
    """What curves are read from, by name."""
    return {c.name: c for q in reversed(quantities_by_name(plans).values()) for c in q.columns}


def curve_or_vector_by_name(written: str, known: Mapping[str, T], plans: Plans, file: str) -> T:
    """The curve or vector for a typed name. :class:`PlanesError` lists the valid ones."""
    names = plans.default_naming.name_finder(known, poles=False)
    return known[names.require_name(written, "no_curve", lambda name: known[name].name, file=file)]


# the groups of the list


def _position_curves(plans: Plans) -> Iterator[Curve]:
    m = plans.mechanism
    for link, names in plans.links.items():
        if link != FRAME:
            slope = itemgetter(f"{UNIT_DRIVE_PREFIX}omega_{link}") if names.omega else None
            yield Curve(f"phi_{link}", "°", "place", itemgetter(f"phi_{link}"), slope, True)
    for link in plans.velocity_slides:
        yield Curve(
            f"s_{link}",
            "m",
            "place",
            _slider_position_curve(plans, link),
            itemgetter(f"{UNIT_DRIVE_PREFIX}v_slide_{link}"),
        )
    for p in plans.points:
        if p not in m.frame.points:
            for axis in "xy":
                name = f"r_{p}_{axis}"
                yield Curve(name, "m", "place", itemgetter(name), itemgetter(f"{UNIT_DRIVE_PREFIX}v_{p}_{axis}"))


def _slider_position_curve(plans: Plans, link: str) -> Reading:
    """The position of a slider's first point along its guide, from the point that defines the guide."""
    m = plans.mechanism
    guide = m.guide(plans.velocity_slides[link].guide)
    owner = m.owner_of_guide(plans.velocity_slides[link].guide)
    first = m.links[link].first_point
    way = np.exp(1j * math.radians(guide.angle_deg))
    base = m.links[owner].first_point if owner != FRAME else ""
    place, start = CycleVector("", "m", f"r_{first}"), CycleVector("", "m", f"r_{base}")
    shift = guide.through - (m.links[owner].points[base] if base else 0)

    def read(s: Sample) -> Real:
        here = place.read(s)
        if base:
            here = (here - start.read(s)) * np.exp(-1j * np.radians(s[f"phi_{owner}"]))
        return ((here - shift) * np.conj(way)).real

    return read


def _rate_curves(plans: Plans, q: str = "") -> Iterator[Curve]:
    """Rates of links, sliders and points, or with "q" their analogues: the same columns of the run with a unit drive.
    The derivative of a velocity is that run's acceleration."""
    rate = plans.drive.velocity
    run = ""
    units = UNIT_OF_RATE_LETTER
    if q:
        rate = 1.0
        run = UNIT_DRIVE_PREFIX
        units = analogue_units(plans.drive.rotates)
    group: Group = "analogue" if q else "rate"
    slope = UNIT_DRIVE_PREFIX if rate else ""
    for link in turning_links(plans):
        name = transfer_ratio_name(plans, link) if q else f"omega_{link}"
        quick = f"epsilon_{link}"
        yield _scalar_curve(name, units["omega"], group, f"{run}omega_{link}", slope and slope + quick, rate)
        yield _scalar_curve(f"epsilon{q}_{link}", units["epsilon"], group, run + quick)
    for link in (n for n in plans.velocity_slides if n != plans.drive.link):
        need = f"{run}v_slide_{link}"
        quick = f"a_slide_{link}"
        yield _scalar_curve(f"v{q}_slide_{link}", units["v"], group, need, slope and slope + quick, rate)
        yield _scalar_curve(f"a{q}_slide_{link}", units["a"], group, run + quick)
    for p in (p for p in plans.points if p not in plans.mechanism.frame.points):
        yield from _vector_curves(f"v{q}_{p}", units["v"], group, f"{run}v_{p}", slope and f"{slope}a_{p}", rate)
        yield from _vector_curves(f"a{q}_{p}", units["a"], group, f"{run}a_{p}")
    for link, slide in plans.acceleration_slides.items():
        if slide.coriolis and not q:
            yield from _vector_curves(f"coriolis_{link}", units["a"], group, f"coriolis_{link}")


def _force_curves(plans: Plans) -> Iterator[Curve]:
    for q in (q for q in results_wanted(plans) if q.group not in MOTION_GROUPS):
        vector = len(q.columns) > 1
        if vector:
            yield from _vector_curves(q.name, q.columns[0].unit, "force", q.name)
        for c in q.columns[2:] if vector else q.columns:
            yield _scalar_curve(c.name, c.unit, "force", c.name)


def _negated_column(name: str) -> Reading:
    return lambda s: -s[name]


def _scalar_curve(name: str, unit: str, group: Group, need: str, slope: str = "", factor: float = 1.0) -> Curve:
    return Curve(name, unit, group, itemgetter(need), (lambda s: factor * s[slope]) if slope else None)


def _vector_curves(
    name: str, unit: str, group: Group, base: str, slope: str = "", factor: float = 1.0
) -> Iterator[Curve]:
    """The magnitude of a vector, then its components."""
    speed = slope.replace(":a_", ":v_")  # the vector is ``factor`` times its analogue, and so are their slopes

    def growing(s: Sample) -> Real:
        return s[f"{speed}_x"] * s[f"{slope}_x"] + s[f"{speed}_y"] * s[f"{slope}_y"]

    yield Curve(name, unit, group, lambda s: np.hypot(s[f"{base}_x"], s[f"{base}_y"]), growing if slope else None)
    for axis in "xy":
        yield _scalar_curve(f"{name}_{axis}", unit, group, f"{base}_{axis}", f"{slope}_{axis}" if slope else "", factor)


def driven_link_curves(plans: Plans) -> NameTuple:
    """The principal curves of a mechanism's driven link: its position, velocity and acceleration; none without one."""
    if not plans.has_mechanism:
        return ()
    link, slides = driven_link_and_sliding(plans)
    letters = ("s", "v_slide", "a_slide") if slides else ("phi", "omega", "epsilon")
    return tuple(f"{letter}_{link}" for letter in letters)


def driven_link_analogues(plans: Plans) -> NameTuple:
    """The analogues of the driven link: of velocity (or its transfer ratio), and of acceleration."""
    link, slides = driven_link_and_sliding(plans)
    if slides:
        return (f"vq_slide_{link}", f"aq_slide_{link}")
    return (transfer_ratio_name(plans, link), f"epsilonq_{link}")


def driven_link_and_sliding(plans: Plans) -> tuple[str, bool]:
    """The output link of a mechanism, and whether it slides on the frame: of the last group that has one. A link that
    only keeps its angle to the frame or to the driver is none, unless there is no other."""
    m = plans.mechanism
    structure = plans.structure
    groups = [g for g in reversed(structure.groups) if not structure.is_driving_cylinder(g)]
    unturned = "", plans.links[m.drive.link].omega  # the angular velocities of the frame and of the driver
    on_frame = {link for p in structure.pairs if p.has_link(FRAME) for link in (p.link, p.other)}
    for group in groups:
        for name in group.output_link_candidates:
            slides = m.links[name].slides
            if slides and m.owner_of_guide(slides.guide) == FRAME:
                return name, True
        turning = [n for n in group.output_link_candidates if plans.links[n].omega not in unturned]
        if turning:
            return next((n for n in turning if n in on_frame), turning[0]), False
    return groups[0].output_link_candidates[0], False


@frozen
class WorkingRange:
    """The driver's working range (degrees or metres) about its position; ``whole``: a full turn."""

    start: float
    end: float
    whole: bool = False

    def range_without_ends(self, margin: float) -> Self:
        """The range without a part at each end, where rates grow without bound."""
        away = margin * (self.end - self.start)
        return replace(self, start=self.start + away, end=self.end - away, whole=False)

    def evenly_spaced_values(self, count: int) -> list[float]:
        """So many values plus one, evenly spaced from end to end."""
        return [self.start + (self.end - self.start) * k / count for k in range(count + 1)]
