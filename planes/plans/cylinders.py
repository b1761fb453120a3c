"""The end of a cylinder on the plans of rates: it moves about the pivot with the guide's link, and along the guide as
the drive says, so that v_A = v_D + v_AA1 + v_A1D with v_AA1 given; in accelerations with Coriolis."""

from collections.abc import Iterator
from typing import Protocol

from planes.drafting.equations import Term
from planes.drafting.steps import Carry
from planes.plans.bodies import Bodies, BodyPoint
from planes.plans.groups import Pair
from planes.plans.legs import Leg, SlideReading
from planes.words.names import POLE, Meaning, at


class PlanOfRates(Protocol):
    """What a cylinder asks of the plan it is drawn on."""

    bodies: Bodies
    plan: str
    driven: list[str]

    @property
    def quick(self) -> bool: ...
    @property
    def letter(self) -> str: ...
    def label(self, name: str) -> str: ...
    def mark(self, name: str) -> str: ...
    def normal(self, leg: Leg, start: str) -> Term: ...


def driven_terms(r: PlanOfRates, leg: Leg, drive: Pair) -> Iterator[Term]:
    """The vectors from the pivot's end to the new one: what is given first, the turning last."""
    along, new = f"∥{drive.guide}", r.label(leg.new.name)
    known, tail = (_across(r, leg, along), "^r") if r.quick else (None, "")
    start = known.end if known else r.label(leg.known.name)
    if known:
        yield known
    name, means = r.letter + leg.driven + tail, Meaning("relative", leg.driven)
    yield Term(name, start, _end(r, leg), length=f"{r.letter}drive", direction=along, action=along, means=means)
    name, end = r.letter + leg.symbol, _end(r, leg)
    if r.quick:
        inward = r.normal(leg, end)
        yield inward
        name, end = f"{name}^t", inward.end
    yield Term(name, end, new, direction=leg.along, action=leg.along)


def _across(r: PlanOfRates, leg: Leg, along: str) -> Term:
    """Coriolis: 2ω×v of the drive."""
    across, name = r.bodies.draft.square(along), f"{r.letter}{leg.driven}^k"
    value = r.bodies.draft.product(name, 2.0, **{f"omega_{leg.turns}": 1, "v_drive": 1})
    means, start = Meaning("coriolis", leg.driven), r.label(leg.known.name)
    return Term(name, start, f"k_{leg.driven}", length=value, direction=across, action=across, means=means)


def _end(r: PlanOfRates, leg: Leg) -> str:
    return f"r_{leg.driven}" + ("'" if r.quick else "")


def driven_end(r: PlanOfRates, leg: Leg) -> str:
    """The mark where what the drive gives ends."""
    return at(r.plan, _end(r, leg))


def driven_spot(r: PlanOfRates, leg: Leg, drive: Pair, spot: BodyPoint) -> SlideReading:
    """Draw the point of the guide's link under the end of the cylinder; the reading of its sliding."""
    d, along, end = r.bodies.draft, f"∥{drive.guide}", driven_end(r, leg)
    known, middle = r.mark(leg.known.name), at(r.plan, f"k_{leg.driven}")
    d.step(Carry(r.mark(spot.name), r.mark(leg.new.name), end, known))
    d.show(r.plan, POLE, r.label(spot.name), r.letter + spot.name)
    r.driven.append(end)
    ends = (middle if r.quick else known, end)
    value, coriolis = d.measure(f"{r.letter}slide_{drive.link}", *ends, along), (known, middle) if r.quick else None
    return SlideReading(drive.guide, value, ends, along, coriolis, r.mark(spot.name))
