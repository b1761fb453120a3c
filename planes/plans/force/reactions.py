"""Reactions as they are found: segments of the force plans, arms and couples of sliders, passed from link to link.

With Coulomb friction the reaction in a sliding pair is inclined by arctan f against the sliding, on the bearing side.
Which side of the guide bears is known only after the plan is drawn; so each assumption is drawn, and the one that
proves true is kept. None, or two different ones, means self-locking.
"""

from dataclasses import dataclass, field, replace
from itertools import product

from planes.drafting.equations import Chain, MomentTerms, Term
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Choose, Lean, Product, Trial
from planes.plans.assur.groups import Pair
from planes.plans.force.hinges import Grip, friction_and_sliding_direction
from planes.plans.force.loads import Acting, Couple, Force, force_pair_index, name_of_force
from planes.plans.position.bodies import Bodies
from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen
from planes.words.names import POLE_LABEL, Mark, Meaning, NamePair, NamesByName, PlanId, vector_end_label


@frozen
class Reaction:
    """A reaction: the segment of its plan, its pair, and for a slider the names of arm and couple at the foot; with
    friction the names of the friction force along the guide and of its power. In a hinge with friction the couple is
    that of friction, and the arm is about its centre: the line of action is tangent to the friction circle."""

    key: str
    plan: PlanId
    start: Mark
    end: Mark
    pair: Pair
    normal: str = ""
    arm: str = ""
    moment: str = ""
    friction: str = ""
    power: str = ""
    # the forces at both edges of a slider's face, ahead and behind; or in both bearings of a shaft, along the reaction
    edges: NamePair | None = None

    @property
    def both_reaction_names(self) -> NamesByName:
        """Both its names, each with the link it acts on."""
        one = self.pair.link
        two = self.pair.other
        return {name_of_force(one, two): one, name_of_force(two, one): two}

    @property
    def index(self) -> str:
        """The index of its names, 30 of F_30, N_30 and T_30."""
        return force_pair_index(self.pair.link, self.pair.other)

    @property
    def leans(self) -> bool:
        """Whether friction on a guide inclines it from the normal."""
        return bool(self.friction and self.pair.guide)


@dataclass
class Statics:
    """The common part of force plans: the loads, the reactions found so far, and how one link passes them to the
    next."""

    bodies: Bodies
    acting: Acting
    reactions: dict[str, Reaction] = field(default_factory=dict)
    balancing: str = ""
    balancing_force: str = ""  # of a turning driver, where requested
    beside_force: tuple[str, Mark, Mark] | None = None  # the frame's reaction that goes with it, and its marks
    centres: NamesByName = field(default_factory=dict)  # the point about which each force's arm was taken first

    def moments_about_mark(
        self, about: Mark, forces: list[Force], couples: list[Couple], sign: float, over: str | None = None
    ) -> MomentTerms:
        """The moments about a mark, times ``sign``, divided by the value ``over``."""
        tail = ((over, -1),) if over else ()
        levers = [(f, self.arm_about_mark(f, about)) for f in forces if f.point != about]
        terms = [(f.name, arm, Product(sign, ((f.size, 1), (arm, 1), *tail))) for f, arm in levers]
        return terms + [(c.name, "", Product(sign * c.sign, ((c.value, 1), *tail))) for c in couples]

    def arm_about_mark(self, f: Force, about: Mark) -> str:
        """The arm of a force about a mark."""
        centre = about.label
        name = f"h_{f.name}_{centre}"
        if self.centres.setdefault(f.name, centre) != centre:  # about another point: named too
            name += f"^{centre.lstrip('°')}"
        return self.bodies.draft.draw_arm(f.name, f.point, f.along, about, f.link, name)

    def lay_off_forces(self, plan: PlanId, forces: list[Force], start: str = POLE_LABEL) -> tuple[Chain, str]:
        """Forces laid off one after another on a plan from the mark with that label, each to a mark with its name;
        returns their terms, and the label reached."""
        chain = []
        for f in forces:
            end = vector_end_label(f.name)
            chain.append(Term(f.name, start, end, f.size, f.along, f.along, means=f.meaning_of_mark))
            self.bodies.draft.lay_off_known_vector(plan, chain[-1])
            start = end
        return tuple(chain), start

    def copy_for_trial(self) -> "Statics":
        """The same for a trial on a separate draft, without effect on this one."""
        b = replace(self.bodies, draft=self.bodies.draft.copy_for_trial())
        return Statics(b, replace(self.acting, bodies=b), centres=dict(self.centres))

    def record_reaction(self, pair: Pair, plan: PlanId, start: Mark, end: Mark, grip: Grip | None = None) -> Reaction:
        """Record the reaction on ``pair.link``, with the ``grip`` of a hinge with friction; it acts on both links from
        now on. A slider's couple comes later."""
        key = name_of_force(pair.link, pair.other)
        reaction = Reaction(key, plan, start, end, pair)
        if grip:
            reaction = replace(reaction, arm=grip.factor, moment=grip.couple, friction=grip.couple)
        bearings = self.bodies.mechanism.link(pair.link).bearings
        if bearings is not None and pair.point and pair.other == FRAME:
            reaction = replace(reaction, edges=self.bearing_reactions(reaction, bearings))
        self.reactions[key] = reaction
        self.bodies.draft.name_segment(plan, start.label, end.label, key)
        return reaction

    def bearing_reactions(self, r: Reaction, bearings: complex) -> NamePair:
        """The parts of a reaction in the two bearings of a shaft: moments about each give the other (the lever rule).
        One is against the whole reaction where both bearings are on one side of the plane of motion."""
        d = self.bodies.draft
        share = bearings.imag / (bearings.imag - bearings.real)
        size = d.measure_segment(f"|{r.key}|", r.start, r.end)
        return d.add_product(f"{r.key}^1", share, **{size: 1}), d.add_product(f"{r.key}^2", 1.0 - share, **{size: 1})

    def reaction_as_force(self, r: Reaction, on: str) -> Force:
        """The reaction as a force on one of its links, at the hinge or at the foot of the perpendicular from the
        slider's first point."""
        d = self.bodies.draft
        ends = (r.start, r.end) if on == r.pair.link else (r.end, r.start)
        name = name_of_force(on, r.pair.other_link_of_pair(on))
        size = d.measure_segment(f"|{r.key}|", r.start, r.end)
        along = d.draw_direction_through_marks(f"→{name}", *ends, Meaning("own", name))
        return Force(name, on, size, along, self.bodies.mark_of_pair(r.pair), "reaction")

    def find_slider_couple_and_arm(
        self, r: Reaction, link: str, about: Mark, forces: list[Force], couples: list[Couple]
    ) -> Reaction:
        """Find the couple and the arm of a sliding pair's reaction from the moments on ``link`` about a mark."""
        d = self.bodies.draft
        pair = r.pair
        side = -1.0 if link == pair.link else 1.0
        terms = self.moments_about_mark(about, [*forces, self.reaction_as_force(r, link)], couples, side)
        moment = d.solve_moment_equation(f"MR_{r.key}", about, (link,), terms, means=Meaning("couple", r.key))
        normal = d.measure_segment(f"N_{r.key}", r.start, r.end, d.draw_perpendicular(f"∥{pair.guide}"))
        arm = d.add_product(f"arm_{r.key}", **{moment: 1, normal: -1})
        edges = self.slider_edge_forces(r, normal, moment)
        self.reactions[r.key] = seated = replace(r, normal=normal, arm=arm, moment=moment, edges=edges)
        return seated

    def slider_edge_forces(self, r: Reaction, normal: str, moment: str) -> NamePair | None:
        """The forces at both edges of a slider's face, with the same sum and moment, where its length is given."""
        slides = self.bodies.mechanism.links[r.pair.link].slides
        if slides is None or slides.length is None:
            return None
        d = self.bodies.draft
        face = d.add_given(f"face_{r.pair.link}", slides.length)
        ends = ((f"N_{r.key}^{k}", sign) for k, sign in (("1", 1.0), ("2", -1.0)))
        one, two = (
            d.add_sum(n, [Product(0.5, ((normal, 1),)), Product(s, ((moment, 1), (face, -1)))]) for n, s in ends
        )
        return one, two

    def pass_reaction_on(self, r: Reaction, to: str) -> None:
        """Apply the reaction (and, of a slider, its couple), reversed, to the other link of a pair."""
        self.acting.forces[to].append(self.reaction_as_force(r, to))
        if r.moment:
            sign = 1 if to == r.pair.link else -1
            self.acting.couples[to].append(Couple(r.moment, to, r.moment, sign, True))


def cross_reactions_with_friction(
    acting: Acting, plan: PlanId, lines: list[Term], x: str, pairs: list[Pair]
) -> dict[str, Term]:
    """Cross two lines of reactions at mark ``x``, those of the rubbing ``pairs`` inclined, by a trial for each side.
    Returns the inclined terms by name, with the directions found."""
    d = acting.bodies.draft
    pair_of = {name: p for p in pairs for name in (name_of_force(p.link, p.other), name_of_force(p.other, p.link))}
    rubbing = [(t, pair_of[t.name]) for t in lines if t.name in pair_of]
    trials = []
    for signs in product((1, -1), repeat=len(rubbing)):
        tag = "".join("+" if sign > 0 else "-" for sign in signs)
        leaning = {t.name: _lean_direction_step(acting, p, sign) for (t, p), sign in zip(rubbing, signs, strict=True)}
        mark = plan.mark(f"{x}{tag}")
        starts = [plan.mark(t.start) for t in lines]
        along = [leaning.get(t.name, t.direction or "") for t in lines]
        d.add_step(Cross(mark, starts[0], along[0], starts[1], along[1], supposed=True, means=Meaning("trial")))
        pushes = tuple(_trial_normal_force(acting, plan, t, p, mark, tag) for t, p in rubbing)
        trials.append(Trial(mark, pushes, signs))
    d.add_step(Choose(plan.mark(x), tuple(trials), plan.mark(lines[0].start), plan.mu_name))
    return {t.name: _inclined_term(acting, plan, t, p, x) for t, p in rubbing}


def _inclined_term(acting: Acting, plan: PlanId, term: Term, pair: Pair, x: str) -> Term:
    ends = plan.marks(term.start, x)
    leaning = Meaning("leaning", pair.guide)
    along = acting.bodies.draft.draw_direction_through_marks(
        f"∡{term.name}", *(ends if term.sign > 0 else ends[::-1]), leaning
    )
    return replace(term, direction=along, action=f"∠{term.action}")


def _lean_direction_step(acting: Acting, pair: Pair, sign: int) -> str:
    d = acting.bodies.draft
    guide = f"∥{pair.guide}"
    coefficient, sense = friction_and_sliding_direction(acting, pair)
    name = f"lean_{pair.link}{'+' if sign > 0 else '-'}"
    means = Meaning("leaning", pair.guide)
    return d.add_step(Lean(name, d.draw_perpendicular(guide), guide, coefficient, sense, sign, means=means))


def _trial_normal_force(acting: Acting, plan: PlanId, term: Term, pair: Pair, mark: Mark, tag: str) -> str:
    """The trial's normal force on the slider, signed along the guide's normal."""
    forward = (term.sign > 0) == (term.name == name_of_force(pair.link, pair.other))
    start = plan.mark(term.start)
    ends = (start, mark) if forward else (mark, start)
    return acting.bodies.draft.measure_segment(f"N_{pair.link}{pair.other}{tag}", *ends, f"⊥∥{pair.guide}")
