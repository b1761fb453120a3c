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
from planes.plans.force.loads import force_name
from planes.plans.force.reactions import Statics
from planes.plans.motion.kinematics import Rates
from planes.plans.position.bodies import SCHEME
from planes.scene.mechanism import FRAME
from planes.words.names import POLE, at, force_plan

RATES = ("velocity", "acceleration")


def proofs_of(s: Statics, velocity: Rates, acceleration: Rates, lever: str) -> tuple[Proof, ...]:
    """All proofs, the easiest to understand first."""
    motion = _Motion(s, velocity, acceleration)
    return (*closed(s.bodies.draft), *motion.rigid(), *motion.slid(), *_balanced(s), _twofold(s, lever))


class _Motion:
    """The poses and rotations of the links."""

    def __init__(self, s: Statics, velocity: Rates, acceleration: Rates) -> None:
        self.bodies, self.rates = s.bodies, (velocity, acceleration)
        self.beside = {SCHEME: (), **{r.plan: tuple(r.driven) for r in self.rates}}

    def point(self, link: str, name: str) -> Point:
        marks = at(SCHEME, name), *(r.mark(name) for r in self.rates)
        return Point(self.bodies.mechanism.link(link).points[name], marks)

    def frame(self, link: str) -> LinkMotion:
        if link == FRAME:
            return LinkMotion(Point(0j, tuple(at(plan, POLE) for plan in (SCHEME, *RATES))))
        body = self.bodies.known[link]
        origin = self.point(link, body.link.first_point)
        omega, epsilon = ("" if body.root == FRAME else r.spin(body.root) for r in self.rates)
        return LinkMotion(origin, body.axis, omega, epsilon)

    def rigid(self) -> Iterator[Proof]:
        for name, link in self.bodies.mechanism.links.items():
            points = tuple(self.point(name, p) for p in link.points if p != link.first_point)
            for plan in (SCHEME, *RATES) if points else ():
                yield Rigid(plan, name, self.frame(name), points, beside=self.beside[plan])

    def slid(self) -> Iterator[Proof]:
        for name, link in self.bodies.mechanism.links.items():
            if link.slides:
                guide, owner = link.slides.guide, self.bodies.mechanism.owner(link.slides.guide)
                line = self.bodies.mechanism.guide(guide)
                turn = cmath.rect(1.0, math.radians(line.angle_deg))
                slider = replace(self.point(name, link.first_point), local=line.through)
                for plan in (SCHEME, *RATES):
                    apart, beside = link.slides.offset or 0.0, self.beside[plan]
                    yield Slid(plan, name, slider, self.frame(owner), turn, apart, beside=beside)


def closed(draft: Draft) -> Iterator[Proof]:
    """The proof for every equation drawn: its vectors are as stated."""
    for e in draft.equations:
        stated = (t for t in e.terms if not t.drawn and (t.length or t.direction))
        ends = ((t, at(e.plan, t.start), at(e.plan, t.end)) for t in stated)
        if rows := tuple((start, end, t.direction or "", t.sign, t.length or "") for t, start, end in ends):
            yield VectorProof(e.plan, e.text, rows)


def _balanced(s: Statics) -> Iterator[Proof]:
    drive = s.bodies.mechanism.drive
    for link in s.bodies.mechanism.links:
        forces = [(f.size, f.along, f.point) for f in s.acting.forces[link] if f.spot]
        couples = [(c.value, c.sign) for c in s.acting.couples[link] if not c.handed]
        sides = []
        for r in s.reactions.values():
            if r.pair.joins(link):
                sides.append((r.start, r.end, 1 if link == r.pair.link else -1, s.bodies.place(r.pair), r.moment))
        pair, sign = s.bodies.structure.drive_pair, 1 if link == drive.link else -1
        if drive.rotates and pair.joins(link):
            couples.append((s.balancing, sign))
        elif pair.joins(link):
            plan = force_plan(drive.link)
            sides.append((at(plan, force_name(drive.link, pair.other)), at(plan, POLE), sign, s.bodies.foot(pair), ""))
        groups = [plan for g in s.bodies.structure.groups for plan in g.balances if link in plan]
        plan = force_plan(*(groups[0] if groups else (link,)))
        yield Balanced(plan, link, tuple(forces), tuple(sides), tuple(couples))


def _twofold(s: Statics, lever: str) -> Proof:
    made = (s.bodies.draft.steps[name] for name in (s.balancing, lever))
    terms = tuple(t for step in made if isinstance(step, Calculate) for t in step.terms)
    return Twofold(force_plan(s.bodies.mechanism.drive.link), s.balancing, s.balancing, lever, terms)
