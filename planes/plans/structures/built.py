"""The plans of a scene of statics: body after body, each as soon as only three unknowns of its reactions are left."""

from collections.abc import Iterator
from functools import cached_property

from planes.drafting.drawing import draw_program
from planes.drafting.program import Program
from planes.drafting.steps import MarkStep
from planes.drafting.steps.reckoning import Pull
from planes.geometry.plane import sine_between
from planes.plans.force.loads import Force, Loads
from planes.plans.record import Plans
from planes.plans.scales import unit_scales_of_plans
from planes.plans.statements.still import plans_of_still_draft
from planes.plans.statements.turning import STANDING_DRIVE
from planes.plans.structures.arch import Arch
from planes.plans.structures.figure import framework_as_mechanism
from planes.plans.structures.free_body import FreeBody
from planes.plans.structures.stated_loads import StatedLoads
from planes.plans.structures.trusses import ZERO_FORCE_RATIO, check_truss, truss_plan
from planes.plans.structures.ways import PARALLEL_LINES_SINE, WayFinder
from planes.scene import Scene
from planes.scene.structures import ONLY_BODY_NAME, Framework, Support
from planes.words import Phrase
from planes.words.errors import PlanFailure, ProgramError, SceneError
from planes.words.frozen import replace
from planes.words.names import NO_MARK, NO_PLAN, MarkPair, Meaning, NamePair, PlanId, scheme_mark

REVERSED_FORCE_SUFFIX = "'"  # suffix of a hinge's force on the body found later


def framework_plans(scene: Scene, framework: Framework) -> Plans:
    """State every plan of a scene of statics; :class:`SceneError` where it is a mechanism, or not determinate."""
    try:
        return FrameworkBuilder(scene, framework).build_plans()
    except ProgramError as error:
        raise SceneError(error.phrase, scene.file, scene.where.get(("points",))) from None


class FrameworkBuilder(StatedLoads):
    """Draws the bodies of a framework."""

    def build_plans(self) -> Plans:
        """All bodies; then the members of a truss."""
        self.state_points_and_loads()
        self.check_statical_determinacy()
        while self.left:
            name = next((n for n in self.left if sum(s.unknown_count for s in self.supports_of(n)) <= 3), None)
            if name is None:
                self.draw_arch()
                continue
            if (own := sum(s.unknown_count for s in self.supports_of(name))) < 3 and self.framework.supports:
                raise self.error(Phrase("body_loose", name=name, held=own), "supports")
            self.solve(name)
            self.left.remove(name)
        if self.framework.members:
            self.draw_truss_plan()
        for s in self.framework.supports:
            if s.kind == "rope":
                self.require_rope_tension(s)
        return self.refuse_undrawable_figures(self.record_of_plans())

    @property
    def has_no_supports(self) -> bool:
        """Whether it is a system of loads without supports: its resultant is asked for."""
        f = self.framework
        forces = bool(f.loads) and all(load.direction_deg is not None for load in f.loads)
        alone = not (f.supports or f.members) and len(f.bodies) == 1
        return forces and alone and f.method in (None, "string", "composition")

    @cached_property
    def shared_hinges(self) -> dict[str, NamePair]:
        """The points two bodies share."""
        bodies = self.framework.bodies
        hinges = {}
        for point in self.framework.points:
            owners = [name for name, points in bodies.items() if point in points]
            if len(owners) > 2:
                raise self.error(Phrase("hinge_many", point=point, names=tuple(owners)), "bodies")
            if len(owners) == 2:
                hinges[point] = (owners[0], owners[1])
        return hinges

    def check_statical_determinacy(self) -> None:
        """Check that there are as many reactions as equations."""
        f = self.framework
        self.check_points()
        if f.members:
            check_truss(f, self.error)
        held = self.number_of_unknowns
        needed = 3 * len(f.bodies)
        if held != needed and not self.has_no_supports:
            key = "statics_loose" if held < needed else "statics_redundant"
            raise self.error(Phrase(key, held=held, needed=needed, count=abs(held - needed)), "supports")

    @cached_property
    def number_of_unknowns(self) -> int:
        """The number of unknowns in the reactions and the hinges between bodies."""
        return sum(s.unknown_count for s in self.framework.supports) + 2 * len(self.shared_hinges)

    def determinacy_explanation(self) -> Iterator[Phrase]:
        """Why it is statically determinate."""
        f = self.framework
        if f.members:
            yield Phrase(
                "truss_count", joints=len(f.points) - len(f.fixed), members=len(f.members), held=self.number_of_unknowns
            )
        elif f.supports:
            yield Phrase("bodies_count", bodies=len(f.bodies), held=self.number_of_unknowns, needed=3 * len(f.bodies))

    def supports_of(self, name: str) -> list[Support]:
        """The supports of a body, and its hinges with bodies that are not solved yet."""
        points = self.framework.bodies[name]
        owners = {p: next(n for n, own in self.framework.bodies.items() if p in own) for p in points}
        own = [s for s in self.framework.supports if owners.get(s.point) == name]
        return own + self.unsolved_hinges_of_body(name)

    def unsolved_hinges_of_body(self, name: str) -> list[Support]:
        """The hinges of a body with bodies that are not solved yet."""
        there = [p for p, two in self.shared_hinges.items() if name in two and {*two} <= {*self.left}]
        return [Support("hinge", p, f"R_{p}") for p in there]

    # one body

    def solve(self, name: str) -> None:
        """The plan of a body, and its reactions on the bodies it hangs on."""
        plan = PlanId("force", *([name] if len(self.framework.bodies) > 1 else []))
        body = self.draw_single_body(name, plan, self.supports_of(name))
        WayFinder(self.scene, self.framework, body, self.sizes, self.turning).find_all_reactions()
        self.spans |= {n: plan.marks(a, b) for n, (a, b) in body.found.items()}
        if body.hinge_or_clamp and body.hinge_or_clamp.kind == "clamp":
            self.values[f"M_{body.hinge_or_clamp.point}"] = f"M_{body.hinge_or_clamp.point}"
        for s in self.unsolved_hinges_of_body(name):
            other = next(n for n in self.shared_hinges[s.point] if n != name)
            size = self.draft.measure_segment(s.name, *self.spans[s.name])
            self.forces[other].append(self.reaction_on_body(s, other, size, REVERSED_FORCE_SUFFIX))
            self.sizes[s.name + REVERSED_FORCE_SUFFIX] = -self.measured_reaction(s.name)

    def draw_single_body(self, name: str, plan: PlanId, supports: list[Support]) -> FreeBody:
        """A single body."""
        return FreeBody(self.draft, self.figure, name, plan, self.forces[name], self.couples[name], supports)

    def draw_arch(self) -> None:
        """Two bodies that can only be solved together: each on a hinge of the ground, and joined in a third hinge."""
        for point, names in self.shared_hinges.items():
            held = [[s for s in self.supports_of(x) if s.point != point] for x in names]
            if {*names} <= {*self.left} and all([s.kind for s in own] == ["hinge"] for own in held):
                springings = [s for own in held for s in own if s.point not in self.shared_hinges]
                if len(springings) == 2:
                    break
        else:
            raise self.error(Phrase("bodies_together", names=tuple(self.left)), "bodies")
        flat = [springings[0].point, point, springings[1].point]
        a, c, b = (self.framework.points[x] for x in flat)
        if sine_between(a - c, b - c) <= PARALLEL_LINES_SINE:
            raise self.error(Phrase("arch_flat", names=tuple(flat)), "points")
        plan = PlanId("force", *(names if len(self.framework.bodies) > 2 else []))
        one, two = (self.draw_single_body(x, plan, own) for x, own in zip(names, held, strict=True))
        spans = Arch(one, two, Support("hinge", point, f"R_{point}")).draw_arch_plan()
        self.spans |= {n: plan.marks(start, end) for n, (start, end) in spans.items()}
        self.left = [x for x in self.left if x not in names]

    def reaction_on_body(self, s: Support, body: str, size: str, beside: str = "") -> Force:
        """A known reaction, as a force on a body: ``beside`` is the suffix of its name where it is reversed."""
        d = self.draft
        start, end = self.spans[s.name]
        name = s.name + beside
        means, ends = (Meaning("against", s.name), (end, start)) if beside else (Meaning("with", s.name), (start, end))
        along = d.draw_direction_through_marks(f"→{name}", *ends, means)
        return Force(name, body, d.measure_segment(size, start, end), along, scheme_mark(s.point), "reaction")

    def measured_reaction(self, name: str) -> complex:
        """A drawn reaction, N."""
        start, end = self.spans[name]
        program = Program(tuple(self.draft.steps.values())).cut_to_names([start, end])
        drawing = draw_program(
            program, {**self.draft.given, **{f"mu_{plan}": 1.0 for plan in program.mark_steps_by_plan}}
        )
        return complex(drawing[end] - drawing[start])

    def draw_truss_plan(self) -> None:
        """The plan of the members, from loads and reactions."""
        outer = {f.name: f for f in self.forces[ONLY_BODY_NAME]}
        outer |= {s.name: self.reaction_on_body(s, ONLY_BODY_NAME, f"{s.name}″") for s in self.framework.supports}
        sizes = self.sizes | {s.name: self.measured_reaction(s.name) for s in self.framework.supports}
        if self.turning:  # a force that is zero now has a place around the truss, too
            sizes = {name: size or 1j for name, size in sizes.items()}
        plan = truss_plan(self.draft, self.framework, outer, sizes, ZERO_FORCE_RATIO * (not self.turning), self.error)
        self.figure.said |= dict.fromkeys(plan.joints, "region")
        self.values |= plan.measure_member_forces()
        self.figure.letters = plan.regions.places

    # all together

    def record_of_plans(self) -> Plans:
        """The record of the drawing."""
        d = self.draft
        f = self.framework
        self.figure.counted = tuple(self.determinacy_explanation())
        mechanism = replace(framework_as_mechanism(f, self.scene.drive or STANDING_DRIVE), where=self.scene.where)
        acting = {name: self.forces.get(name, []) for name in (*mechanism.links, *f.bodies)}
        couples = {name: self.couples.get(name, []) for name in acting}
        loads = {x.name: self.load_end_marks(x.name) for x in f.loads if x.direction_deg is not None}
        return plans_of_still_draft(
            d,
            mechanism,
            Loads(acting, couples),
            vectors={
                **{n: ends for n, ends in loads.items() if ends},
                **dict(self.resultants_of_plans()),
                **self.spans,
            },
            values=self.values | {name: name for *_, name in (*self.figure.moments, *self.figure.shears)},
            figure=self.figure,
        )

    def load_end_marks(self, name: str) -> MarkPair:
        """The end marks of a load."""
        terms = ((e.plan, t) for e in self.draft.equations for t in e.all_terms if t.name == name)
        plan, term = next(terms, (NO_PLAN, None))
        if term:
            return plan.marks(term.start, term.end)
        return (NO_MARK, NO_MARK)

    def resultants_of_plans(self) -> Iterator[tuple[str, MarkPair]]:
        """The resultants of whole plans."""
        for e in self.draft.equations:
            if e.total:
                yield (e.total, e.plan.marks(e.chains[0][0].start, e.chains[0][-1].end))

    def refuse_undrawable_figures(self, plans: Plans) -> Plans:
        """Refuse figures that cannot be drawn, and ropes that would have to push; where loads turn, that is for each
        position to say."""
        try:
            draw_program(plans.program, {**plans.given, **unit_scales_of_plans(plans)})
        except PlanFailure as failure:
            if not self.turning:
                raise self.error(Phrase("about", what=Phrase("the_scene"), why=failure.phrase), "method") from None
        return plans

    def require_rope_tension(self, rope: Support) -> None:
        """Hold a rope to pulling in every position."""
        d = self.draft
        start, end = self.spans[rope.name]
        plan = start.plan
        along = d.direction_between_marks(rope.point, rope.to)
        beside = tuple(s.makes for s in d.steps.values() if isinstance(s, MarkStep) and s.plan == plan)
        d.add_step(Pull(f"pull_{rope.point}{rope.to}", start, end, along, plan.mu_name, rope.point + rope.to, beside))
