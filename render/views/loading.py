"""Forces and couples on a scheme: arrows at their points, curved arrows of couples, arms with their lines of action."""

import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from itertools import product

from planes.drafting.equations import Moments
from planes.geometry.plane import direction_between
from planes.plans.force.loads import name_of_force
from planes.solving import Position
from planes.words import say
from planes.words.names import NamesByName, NameTuple, PlanId
from planes.words.naming import Naming
from planes.words.units import number_text
from render.labels import Label
from render.paper.marks import Arc, Arrow, Line, Mark
from render.paper.style import SLIDER_BLOCK_SIZE_MM
from render.paper.symbols import unit_vector
from render.views.arms import HALF_BREAK_GAP_MM, Arm, Arms, arm_steps_by_result, line_with_break, nonzero_terms
from render.views.plotted import Ends, Places, lines_overlap, scheme_mu, shift_clear_of_others
from render.views.senses import freest_turn_arrow

LEAST_FORCE_ARROW_MM = 15.0  # shortest arrow of a force; forces are not to scale
FORCE_LENGTH_STEP_MM = 6.0  # extra length of the next force with the same point and direction
FORCE_SHIFT_MM = 1.5  # lateral shift of a force
LEAST_DISTANCES_MM = 1.2, 0.4  # least distances from another force or a rod, and where they are slightly inclined
MOST_SHIFT_ARM_RATIO = 0.25  # largest lateral shift of a force, over its arm in the figure, which it falsifies
REACTION_TIP_GAP_MM = 1.6  # from the tip of a reaction to its point of application: the radius of a hinge
# from a force's point to an arrow on its line of action
FARTHER_ALONG_STEP_MM = 6.0
MOST_STEPS_ALONG = 8
COUPLE_RADIUS_MM = 6.5  # radius of a couple's curved arrow
HALF_TANGENT_LENGTH_MM = 5.0  # half the length of the tangent to a friction circle
NAME_LETTER_MM = 3.5
ZERO_FORCE_RATIO = 1e-9  # of the largest force: below this it is zero
MOST_UNBROKEN_ARM_MM = 60.0  # an arm longer than this, and than its links, is drawn with a break
MOST_ARM_M = 10.0  # a longer arm means a couple


@dataclass
class Arrows:
    """The places of force arrows, not to scale, so that each is visible; ``upon`` are the lines that none may overlap,
    and the arrows already drawn."""

    upon: list[Ends] = field(default_factory=list)
    taken: list[Ends] = field(default_factory=list)

    def place_force_arrow(
        self, point: complex, way: complex, from_outside: bool = False, arm: float = math.inf
    ) -> tuple[complex, complex, complex]:
        """Start and end of a force, and which of them is far from its point. It is longer if others of its point are on
        the same side, and shifted beside them; one with an ``arm`` (mm) in the figure keeps to its line of action: it
        is drawn on the other side of its point, or farther along."""
        first, *others = self._places_on_line(point, way, from_outside)
        near, far = shift_clear_of_others(first, self.upon, FORCE_SHIFT_MM, *LEAST_DISTANCES_MM)
        if abs(near - first[0]) > MOST_SHIFT_ARM_RATIO * arm:
            others += self._places_on_line(point, way, not from_outside)
            others.sort(key=lambda ends: round(abs(ends[0] - point) / FARTHER_ALONG_STEP_MM))
            near, far = next(filter(self.is_clear, others), (near, far))
        self.taken.append((point, direction_between(near, far)))
        self.upon.append((near, far))
        if ((far - near) * way.conjugate()).real < 0:
            return (far, near, far)
        return (near, far, far)

    def _places_on_line(self, point: complex, way: complex, from_outside: bool) -> Iterator[Ends]:
        """Places of an arrow on one side of its point: at it, longer than others there, and farther along."""
        side = -way if from_outside else way
        like = sum(abs(p - point) < 0.5 and (s * side.conjugate()).real > 0.9 for p, s in self.taken)
        near = point + REACTION_TIP_GAP_MM * side * from_outside
        yield near, point + (LEAST_FORCE_ARROW_MM + FORCE_LENGTH_STEP_MM * like) * side
        for k in range(1, MOST_STEPS_ALONG + 1):
            off = k * FARTHER_ALONG_STEP_MM * side
            yield near + off, point + LEAST_FORCE_ARROW_MM * side + off

    def is_clear(self, ends: Ends) -> bool:
        """Whether an arrow overlaps no other line."""
        return not any(lines_overlap(ends, other, *LEAST_DISTANCES_MM) for other in self.upon)


@dataclass
class Loading:
    """The forces on some links, drawn over their scheme, with their arms in moment ``equations``."""

    position: Position
    naming: Naming
    links: NameTuple
    equations: list[Moments] = field(default_factory=list)
    marks: list[Mark] = field(default_factory=list)
    named: list[Label] = field(default_factory=list)
    short_arms: list[str] = field(default_factory=list)
    arrows: Arrows = field(init=False)

    def __post_init__(self) -> None:
        self.places = Places(self.position)
        self.drawing = self.position.drawing
        self.plans = self.position.plans
        self.arrows = Arrows([rod for link in self.links for rod in self.places.link_bars(link)])

    def draw_loads(self, carried: bool, from_outside: bool = False) -> None:
        """Weights, inertia, loads; and, where ``carried``, the reactions from groups solved before."""
        acting = self.plans.acting
        inner = self.inner_reaction_names() if carried else set[str]()
        for link in self.links:
            for f in acting.forces[link]:
                acts = f.size in self.drawing and (f.spot or (carried and f.name not in inner))
                if acts and self.is_above_noise(float(self.drawing[f.size])):
                    way = complex(self.drawing[f.along]) * _sign_of(self.drawing[f.size])
                    self.draw_force(f.name, complex(self.drawing[f.point]), way, from_outside)
            couples = (c for c in acting.couples[link] if not c.handed or (carried and c.value not in inner))
            for k, couple in enumerate(couples):
                value = float(self.drawing[couple.value]) * couple.sign if couple.value in self.drawing else 0.0
                if abs(value) > 1e-9:
                    self.draw_couple(couple.name, link, value, k, about=self.friction_hinge_place(couple.value))

    def draw_reactions(self, plan: PlanId) -> None:
        """The reactions of a plan's outer pairs, in the components found on the plan, at their points."""
        outer = self.outer()
        rubbing = dict[str, None]()
        guides = dict.fromkeys(outer.values())
        for equation in self.plans.equations:
            for term in equation.all_terms if equation.plan == plan else ():
                marks = [plan.mark(end) for end in (term.start, term.end)]
                if term.name in outer and all(mark in self.drawing for mark in marks):
                    way = term.sign * (complex(self.drawing[marks[1]]) - complex(self.drawing[marks[0]]))
                    key = outer.pop(term.name)
                    if abs(way) >= 1e-6:
                        self.draw_force(
                            term.name,
                            self.reaction_application_point(key, aside=False),
                            way / abs(way),
                            from_outside=True,
                        )
                        rubbing.setdefault(key)
        for key in rubbing:
            self.draw_friction_circle(key)
            self.rub(key)
        for key in guides:
            self.draw_guide_couple(key)

    def draw_whole_reactions(self) -> None:
        """Every whole reaction on these links from outside, on its line of action."""
        results = self.position.of("reactions")
        for key, reaction in self.plans.reactions.items():
            pair = reaction.pair
            result = results.get(key)
            if result is None or (pair.link in self.links) == (pair.other in self.links):
                continue
            name, _, sign = self.acting_reaction(key)
            force = result.vector * sign
            if self.is_above_noise(abs(force)):
                self.draw_friction_circle(key)
                self.draw_force(name, self.reaction_application_point(key), force / abs(force), from_outside=True)
            self.draw_guide_couple(key)

    def draw_guide_couple(self, key: str) -> None:
        """The couple of a slider's reaction that is zero, or whose arm is too long to draw."""
        pair = self.plans.reactions[key].pair
        result = self.position.of("reactions").get(key)
        if result and pair.kind == "P" and self.reaction_arm(key) is None and abs(result.moment) > ZERO_FORCE_RATIO:
            name, link, sign = self.acting_reaction(key)
            self.draw_couple(f"MR_{name}", link, result.moment * sign, 0)

    def acting_reaction(self, key: str) -> tuple[str, str, int]:
        """A reaction as it acts on these links: its name, the link under it, and the sign of its vector and couple."""
        pair = self.plans.reactions[key].pair
        if pair.link in self.links:
            return key, pair.link, 1
        return name_of_force(pair.other, pair.link), pair.other, -1

    def reaction_arm(self, key: str) -> float | None:
        """The arm of a slider's reaction, m; None where it is negligible."""
        name = self.plans.reactions[key].arm
        arm = float(self.drawing[name]) if name in self.drawing else math.nan
        return arm if math.isfinite(arm) and abs(arm) < MOST_ARM_M else None

    def friction_hinge_place(self, couple: str) -> complex | None:
        """The place of the hinge with that friction couple; None for any other couple."""
        own = (r.pair.point for r in self.plans.reactions.values() if r.moment == couple and r.pair.point)
        return next(map(self.places.point_place, own), None)

    def rub(self, key: str) -> None:
        """The friction couple on one of these links, in its hinge."""
        r = self.plans.reactions[key]
        pair = r.pair
        value = float(self.drawing[r.friction]) if pair.point and r.friction in self.drawing else 0.0
        if abs(value) > ZERO_FORCE_RATIO:
            on = pair.link if pair.link in self.links else pair.other
            self.draw_couple(
                r.moment, on, value if on == pair.link else -value, 0, about=self.places.point_place(pair.point)
            )

    def draw_friction_circle(self, key: str) -> None:
        """The friction circle in a hinge, and the line of the reaction tangent to it."""
        pair = self.plans.reactions[key].pair
        place = self.reaction_application_point(key) if pair.kind == "R" else 0j
        if place and (shift := place - (centre := self.places.point_place(pair.point))):
            along = 1j * shift / abs(shift) * HALF_TANGENT_LENGTH_MM
            self.marks.append(Arc(centre, abs(shift), style="thin", layer="construction"))
            self.marks.append(Line((place - along, place + along), "thin", "construction"))

    def reaction_application_point(self, key: str, aside: bool = True) -> complex:
        """The point of application of a reaction: in its hinge, or ``aside`` on its friction circle; its arm from the
        foot on the guide, which is drawn up to there."""
        r = self.plans.reactions[key]
        pair = r.pair
        metres = self.reaction_arm(key) or 0.0
        mu = scheme_mu(self.position)
        if pair.kind == "R":
            way = complex(self.drawing[r.end]) - complex(self.drawing[r.start])
            shift = -1j * way / abs(way) * metres * mu if way and aside else 0j
            return self.places.point_place(pair.point) + shift
        foot, along = self.places.foot_on_guide(self.places.mechanism.links[pair.link])
        arm = metres * mu
        shown = math.copysign(min(abs(arm), max(MOST_UNBROKEN_ARM_MM, self.places.larger_box_side(self.links))), arm)
        if shown != arm:
            ends = foot, foot + shown * along
            text = f"{number_text(abs(metres), self.naming.lang)} {say('m', self.naming.lang)}"
            self.named.append(
                Label(text, (sum(ends) / 2, ends[1]), NAME_LETTER_MM, clear=HALF_BREAK_GAP_MM, name="arm")
            )
            self.marks += line_with_break(*ends)
        elif abs(arm) > SLIDER_BLOCK_SIZE_MM[0] / 2:
            self.marks.append(Line((foot, foot + arm * along), "axis", "axis"))
        return foot + shown * along

    def draw_balancing_load(self, link: str) -> None:
        """The balancing couple (or force) on the driver, or the opposite force on the link that drives it."""
        plans = self.plans
        driver = self.plans.structure.driver
        if plans.balancing not in self.drawing:
            return
        load = float(self.drawing[plans.balancing]) * (1 if link == driver else -1)
        if plans.drive.kind == "s":
            foot, along = self.places.foot_on_guide(plans.mechanism.links[driver])
            self.draw_force(plans.balancing, foot, along * _sign_of(load))
        else:
            taken = sum(not c.handed for c in plans.acting.couples[link])
            self.draw_couple(plans.balancing, link, load, taken)

    def inner_reaction_names(self) -> set[str]:
        """Names of the reactions between these links, and of their couples."""
        names = set()
        for key, r in self.plans.reactions.items():
            if {r.pair.link, r.pair.other} <= set(self.links):
                names |= {key, name_of_force(r.pair.other, r.pair.link), r.moment}
        return names

    def outer(self) -> NamesByName:
        """Names of the reactions from outside on these links, whole and in components, that are not known from an
        earlier plan; with the reaction that each is, or is opposite to."""
        known = {f.name for link in self.links for f in self.plans.acting.forces[link]}
        reactions: NamesByName = {}
        for key, reaction in self.plans.reactions.items():
            link = reaction.pair.link
            other = reaction.pair.other
            for name, on, by in ((key, link, other), (name_of_force(other, link), other, link)):
                if on in self.links and by not in self.links and name not in known:
                    reactions |= {name + part: key for part in ("", "^t", "^n")}
        return reactions

    def is_above_noise(self, size: float) -> bool:
        """Whether a force is more than rounding noise."""
        names = {f.size for f in self.plans.acting.every}
        sizes = (abs(float(self.drawing[name])) for name in names if name in self.drawing)
        return abs(size) > ZERO_FORCE_RATIO * max(sizes, default=0.0)

    def draw_force(self, name: str, point: complex, way: complex, from_outside: bool = False) -> None:
        """An arrow from its point (a load), or with its head there (a reaction), clear of the rods and forces there."""
        arm = min((arm.length for arm in self.arms if arm.force == name), default=math.inf)
        start, end, far = self.arrows.place_force_arrow(point, way, from_outside, arm)
        self.marks.append(Arrow(start, end, "vector", "force", name))
        ends = far, (start + end) / 2
        self.named.append(Label(self.naming.lettered_vector(name), ends, NAME_LETTER_MM, name=name, also=(far,)))

    def draw_couple(self, name: str, link: str, value: float, number: int, about: complex | None = None) -> None:
        """A curved arrow about a place, or the mass centre of its link, where it crosses least."""
        body = self.places.mechanism.links[link]
        centre = self.places.point_place(body.mass_centre) if about is None else about
        sense = math.copysign(1.0, value)
        radii = (COUPLE_RADIUS_MM + 3 * number + grow for grow in (0.0, -2.0, 3.0, 6.0))
        begins = [start if sense > 0 else 180.0 - start for start in (100.0, 190.0, 10.0, -80.0)]
        arrow, middle = freest_turn_arrow(
            centre, product(radii, begins), sense * 150, self.marks, 0.8, "vector", "force"
        )
        self.marks += arrow
        ends = tuple(centre + (middle - centre) * unit_vector(turn) for turn in (50, -50))
        self.named.append(
            Label(self.naming.lettered_vector(name), middle, NAME_LETTER_MM, clear=0.4, name=name, also=ends)
        )

    @cached_property
    def arms(self) -> list[Arm]:
        """The arms in the moment equations."""
        drops = arm_steps_by_result(self.drawing)
        arms = []
        for name, arm, _ in (term for one in self.equations for term in nonzero_terms(self.drawing, one)):
            step = drops.get(arm)
            if step and step.makes in self.drawing:
                arms.append(Arm.of_step(self.drawing, step, name, self.naming.lettered_arm(name, arm)))
        return arms

    def draw_arms(self) -> None:
        """Thin perpendiculars from the moment point to the lines of action, which are extended to meet them."""
        drawn = Arms()
        for arm in self.arms:
            drawn.add_arm(arm)
        self.marks += drawn.marks
        self.named += drawn.named
        self.short_arms += drawn.short


def _sign_of(value: object) -> float:
    return math.copysign(1.0, float(value))  # type: ignore[arg-type]
