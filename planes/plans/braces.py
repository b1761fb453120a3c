"""A cylinder across the hinge of two links: it is drawn aside how far their outer hinges are apart, and what turns them
against each other is reckoned from how it grows.

Its length L between the hinges Q and P of the links that turn about A has the arm h about A, so L' = ω·h; and as A is g
from the foot of that arm to P, h' = −ω·(g − g²/L), which gives ε from L''.
"""

from dataclasses import dataclass

from planes.drafting.steps import Similar
from planes.drafting.steps.crossings import CrossArcs
from planes.drafting.steps.reckoning import Drop, Product, SenseOf
from planes.plans.bodies import SCHEME, AssemblyChoice, Bodies, BraceReach
from planes.plans.groups import Brace, Group, Pair
from planes.plans.positions import Elbow, cylinder, place_reached
from planes.plans.reckoned import angle_deg, ratio
from planes.words.names import Meaning, at, mu_of


def place_braced(b: Bodies, g: Group) -> None:
    """The two links that are one with the cylinder stopped, and the third; then how the cylinder works on them."""
    assert g.drive and g.brace
    motor, near, far = g.drive.point, g.brace.near.point, g.brace.far.point
    elbow, reach = _elbow(b, g, g.drive, g.brace)
    place_reached(b, g, elbow.length)
    elbow.place(b)
    d, line = b.draft, b.draft.ray(SCHEME, near, far)
    means = Meaning("arm", f"{near}{far}", motor)
    arm = Drop(f"h_{near}{far}", at(SCHEME, far), line, at(SCHEME, motor), mu_of(SCHEME), means=means)
    along = d.measure(f"g_{near}{far}", at(SCHEME, motor), at(SCHEME, far), line)
    b.reach = BraceReach(*reach, d.step(arm), along)


def _elbow(b: Bodies, g: Group, drive: Pair, brace: Brace) -> tuple[Elbow, tuple[str, str, str, bool]]:
    """Both links drawn aside, the first one's axis level: the cylinder's hinge where two arcs meet."""
    d, first, second = b.draft, b.mechanism.link(drive.other), b.mechanism.link(drive.link)
    pivot, hinge, motor, near, far = (p.point for p in (g.first_outer, g.inner, drive, brace.near, brace.far))
    level, helper = d.aim("→", 0.0, Meaning("given", first.name)), Meaning("guide", motor)

    def aside(point: str) -> str:
        if point == pivot:
            return at(SCHEME, pivot)
        way = d.turn(
            f"→{pivot}{point}", level, *angle_deg(first.points[pivot], first.points[point]), Meaning("given", pivot)
        )
        return d.lay_off(SCHEME, f"{point}°{pivot}", at(SCHEME, pivot), way, b.length(first, pivot, point), helper)

    ends = (near, far) if brace.near.link == brace.slide.other else (far, near)
    reach, offset, length = cylinder(b, brace.slide, ends, near, pivot)
    way = d.step(SenseOf(f"way_{brace.slide.guide}", reach))
    elbow = aside(motor)
    arcs = [(second.name, elbow, b.length(second, motor, far)), (brace.far.link, aside(near), length)]
    (one, *first_arc), (two, *other_arc) = sorted(arcs, key=lambda arc: [*b.mechanism.links].index(arc[0]))
    shape = Group((one, two), 1, second.name, brace.far.link, brace.far, drive, brace.near)
    side = d.give(f"side_{far}", 1.0)
    b.choices.append(AssemblyChoice(side, far, shape, False))
    pin = d.step(CrossArcs(at(SCHEME, f"{far}°{pivot}"), *first_arc, *other_arc, mu_of(SCHEME), side, means=helper))
    end = pin
    if hinge != far:
        given = ratio(*(second.points[p] for p in (hinge, motor, far)))
        like = d.give(f"ratio_{hinge}_{second.name}", *given)
        end = d.step(Similar(at(SCHEME, f"{hinge}°{pivot}"), elbow, pin, like, means=helper))
    whole = d.measure(f"l_{pivot}{hinge}", at(SCHEME, pivot), end)
    return Elbow(g, motor, pivot, hinge, whole, (elbow, end)), (way, reach, length, offset is not None)


def braced_rate(b: Bodies, plan: str, name: str, drive: str, omega: str) -> str:
    """How fast the far link turns against the near one, by the ``drive``'s rate on a plan; in accelerations by ``omega``
    too."""
    r, d = b.reach, b.draft
    assert r
    grows: dict[str, int] = {r.reach: 1, r.length: -1} if r.offset else {r.way: 1}
    per_arm = [*grows.items(), (r.arm, -1)]
    if plan != "acceleration":
        return d.product(name, 1.0, **dict([(drive, 1), *per_arm]))
    terms = [Product(1.0, ((drive, 1), *per_arm))]
    if r.offset:
        terms += [
            Product(1.0, (("v_drive", 2), (r.length, -1), (r.arm, -1))),
            Product(-1.0, (("v_drive", 2), (r.reach, 2), (r.length, -3), (r.arm, -1))),
        ]
    terms += [
        Product(1.0, ((omega, 2), (r.along, 1), (r.arm, -1))),
        Product(-1.0, ((omega, 2), (r.along, 2), (r.length, -1), (r.arm, -1))),
    ]
    return d.total(name, terms)
