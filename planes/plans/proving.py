"""The proofs of a mechanism's plans: its links rigid, its sliders on their guides, every link in equilibrium, every
polygon closed, and both balancing loads equal."""

import cmath
import math
from collections.abc import Iterator
from dataclasses import replace

from planes.drafting.draft import Draft
from planes.drafting.link_proofs import Balanced, LinkMotion, Point, Rigid, Slid
from planes.drafting.proofs import Proof, Twofold, VectorProof
from planes.drafting.steps.reckoning import Calculate
from planes.plans.force.loads import name_of_force
from planes.plans.force.reactions import Statics
from planes.plans.motion.kinematics import Rates
from planes.scene.mechanism import FRAME
from planes.words.names import RATE_PLANS, SCHEME_PLAN, PlanId, scheme_mark


def proofs_of(s: Statics, velocity: Rates, acceleration: Rates, lever: str) -> tuple[Proof, ...]:
    """All proofs, the easiest to understand first."""
    motion = _Motion(s, velocity, acceleration)
    return (
        *closing_proofs(s.bodies.draft),
        *motion.rigidity_proofs(),
        *motion.sliding_proofs(),
        *_equilibrium_proofs(s),
        _two_way_moment_proof(s, lever),
    )


class _Motion:
    """The poses and rotations of the links."""

    def __init__(self, s: Statics, velocity: Rates, acceleration: Rates) -> None:
        self.bodies = s.bodies
        self.rates = (velocity, acceleration)
        self.beside = {SCHEME_PLAN: (), **{r.plan: tuple(r.driven) for r in self.rates}}

    def proof_point(self, link: str, name: str) -> Point:
        marks = scheme_mark(name), *(r.mark(name) for r in self.rates)
        return Point(self.bodies.mechanism.link(link).points[name], marks)

    def frame_motion(self, link: str) -> LinkMotion:
        if link == FRAME:
            return LinkMotion(Point(0j, tuple(plan.pole for plan in (SCHEME_PLAN, *RATE_PLANS))))
        body = self.bodies.known[link]
        origin = self.proof_point(link, body.link.first_point)
        omega, epsilon = ("" if body.root == FRAME else r.spin(body.root) for r in self.rates)
        return LinkMotion(origin, body.axis, omega, epsilon)

    def rigidity_proofs(self) -> Iterator[Proof]:
        for name, link in self.bodies.mechanism.links.items():
            points = tuple(self.proof_point(name, p) for p in link.points if p != link.first_point)
            for plan in (SCHEME_PLAN, *RATE_PLANS) if points else ():
                yield Rigid(plan, name, self.frame_motion(name), points, beside=self.beside[plan])

    def sliding_proofs(self) -> Iterator[Proof]:
        for name, link in self.bodies.mechanism.links.items():
            if link.slides:
                guide = link.slides.guide
                owner = self.bodies.mechanism.owner_of_guide(guide)
                line = self.bodies.mechanism.guide(guide)
                turn = cmath.rect(1.0, math.radians(line.angle_deg))
                slider = replace(self.proof_point(name, link.first_point), local=line.through)
                for plan in (SCHEME_PLAN, *RATE_PLANS):
                    apart = link.slides.offset or 0.0
                    beside = self.beside[plan]
                    yield Slid(plan, name, slider, self.frame_motion(owner), turn, apart, beside=beside)


def closing_proofs(draft: Draft) -> Iterator[Proof]:
    """The proof for every equation drawn: its vectors are as stated."""
    for e in draft.equations:
        stated = (t for t in e.all_terms if not t.drawn and (t.length or t.direction))
        ends = ((t, *e.plan.marks(t.start, t.end)) for t in stated)
        if rows := tuple((start, end, t.direction or "", t.sign, t.length or "") for t, start, end in ends):
            yield VectorProof(e.plan, e.equation_text, rows)


def _equilibrium_proofs(s: Statics) -> Iterator[Proof]:
    drive = s.bodies.mechanism.drive
    for link in s.bodies.mechanism.links:
        forces = [(f.size, f.along, f.point) for f in s.acting.forces[link] if f.spot]
        couples = [(c.value, c.sign) for c in s.acting.couples[link] if not c.handed]
        sides = []
        for r in s.reactions.values():
            if r.pair.has_link(link):
                sides.append(
                    (r.start, r.end, 1 if link == r.pair.link else -1, s.bodies.mark_of_pair(r.pair), r.moment)
                )
        pair = s.bodies.structure.drive_pair
        sign = 1 if link == drive.link else -1
        if drive.rotates and pair.has_link(link):
            couples.append((s.balancing, sign))
        elif pair.has_link(link):
            plan = PlanId("force", drive.link)
            sides.append(
                (plan.mark(name_of_force(drive.link, pair.other)), plan.pole, sign, s.bodies.foot_on_guide(pair), "")
            )
        groups = [plan for g in s.bodies.structure.groups for plan in g.links_by_force_plan if link in plan]
        plan = PlanId("force", *(groups[0] if groups else (link,)))
        yield Balanced(plan, link, tuple(forces), tuple(sides), tuple(couples))


def _two_way_moment_proof(s: Statics, lever: str) -> Proof:
    made = (s.bodies.draft.steps[name] for name in (s.balancing, lever))
    terms = tuple(t for step in made if isinstance(step, Calculate) for t in step.terms)
    return Twofold(PlanId("force", s.bodies.mechanism.drive.link), s.balancing, s.balancing, lever, terms)
