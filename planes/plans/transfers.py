"""Transfer functions: the ratios of a position's velocities to the driver's, by segments of its velocity plan.

The driver's rate is computed from its own vector: pb/l_AB is ω₁ as drawn, so v_qC = pc·l_AB/pb and u_31 = ω_3·l_AB/pb.
"""

from collections.abc import Iterator

from planes.drafting.steps import LayOff
from planes.drafting.steps.reckoning import Calculate
from planes.plans import Plans
from planes.plans.columns import DriverVector
from planes.plans.force.derived import Derived
from planes.scene.mechanism import FRAME
from planes.words.names import POLE_LABEL, VELOCITY_PLAN, NamesByName, with_analogue_in_index

TRANSFER_PLAN = VELOCITY_PLAN


def vector_giving_driver_rate(plans: Plans) -> DriverVector | None:
    """The vector from which the driver's rate is computed; None where the driver is at rest or its vector is not
    drawn."""
    drive = plans.drive
    steps = {s.makes: s for s in plans.program.steps}
    if not drive.velocity:
        return None
    if drive.kind == "s":
        slide = plans.velocity_slides.get(drive.link)
        return DriverVector(*slide.ends, slide.along, "") if slide else None
    for laid in (s for s in steps.values() if isinstance(s, LayOff) and s.start == TRANSFER_PLAN.pole):
        value = steps.get(laid.length)
        factors = value.terms[0].factors if isinstance(value, Calculate) and len(value.terms) == 1 else ()
        if len(factors) == 2 and factors[0] == (drive.rate_names[0], 1) and factors[1][1] == 1:
            length = factors[1][0]
            if plans.given.get(length, 1.0):
                return DriverVector(laid.start, laid.makes, laid.along, length)
            return None
    return None


def transfer_functions(plans: Plans) -> Iterator[Derived]:
    """Ratios for all turning links (u_31; with a drive that slides or is inside, omega_q3), and analogues of the
    velocities for all points with vectors from the pole, those of guides too (v_qC, v_qB3); without the driver's
    own."""
    vector = vector_giving_driver_rate(plans)
    if vector is None:
        return
    units = analogue_units(plans.drive.rotates)
    for link in turning_links(plans):
        names = dict.fromkeys(
            (with_analogue_in_index(transfer_ratio_name(plans, link)), f"omega_q{link}", f"omegaq_{link}")
        )
        yield Derived((*names,), units["omega"], plans.links[link].omega, "transfers", per=vector)
    named = {marks.velocity.label: point for point, marks in plans.points.items()}
    parts = {t.end for e in plans.equations for t in e.all_terms if t.means and t.means.quantity == "relative"}
    supposed = {mark for mark, meant in plans.means.items() if meant.quantity == "false"}
    for end in dict.fromkeys(
        s.end for s in plans.segments_on(TRANSFER_PLAN) if s.start == POLE_LABEL != s.end not in parts
    ):
        mark = TRANSFER_PLAN.mark(end)
        if mark != vector.end and mark not in supposed:
            name = f"vq_{named.get(end) or end.upper()}"
            yield Derived(
                (with_analogue_in_index(name), name), units["v"], "", "transfers", (TRANSFER_PLAN.pole, mark), vector
            )


def analogue_units(turns: bool) -> NamesByName:
    """Units of the analogues: the derivatives by an angle in radians, or by metres."""
    if turns:
        return {"v": "m", "a": "m", "omega": "1", "epsilon": "1"}
    return {"v": "1", "a": "1/m", "omega": "1/m", "epsilon": "1/m²"}


def transfer_ratio_name(plans: Plans, link: str) -> str:
    """The name of the transfer ratio ω_link/ω_driver: u_31; with a drive that slides or is inside, omegaq_3."""
    drive = plans.drive
    if not drive.rotates or drive.on != FRAME:
        return f"omegaq_{link}"
    driver = drive.link
    if len(link) == len(driver) == 1:
        return f"u_{link}{driver}"
    return f"u_{link}_{driver}"


def turning_links(plans: Plans) -> list[str]:
    """Links that turn, without a driver whose rotation is given."""
    drive = plans.drive
    given = drive.link if drive.rotates and drive.on == FRAME else ""
    return [n for n, v in plans.links.items() if n not in (FRAME, given) and v.omega]
