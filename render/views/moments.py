"""Moments as drawn: equations with the value of every product beneath, and Zhukovsky's lever.

The lever is the velocity plan turned by a right angle, with the external forces at the images of their points.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from planes.drafting.equations import Moments
from planes.drafting.steps.reckoning import Calculate, Drop
from planes.plans.scales import ZERO_VECTOR_MM
from planes.solving import Position
from planes.words import say
from planes.words.frozen import frozen
from planes.words.lettering import without_index_markup
from planes.words.names import MOTION_PLAN, POLE_LABEL, VELOCITY_PLAN, NameTuple
from planes.words.naming import Naming
from planes.words.read_off import fixed_decimals_text, read_off_text
from render.labels import Label
from render.paper.marks import Arrow, Line, Mark
from render.paper.symbols import Marks, dot
from render.views.arms import Arm, Arms, arm_length_mm, arm_steps_by_result, nonzero_terms, with_unseen_arm_names
from render.views.formulas import Setter, Word
from render.views.loading import Arrows
from render.views.plotted import Ends, group_names_by_place, length_of, plot_position, scheme_mu
from render.views.senses import marks_with_labels


@frozen
class MomentLines:
    """The moment equations of a position, set one beneath another."""

    position: Position
    naming: Naming
    letter: float = 5.0

    def drawn_marks(self, links: NameTuple | None = None) -> Marks:
        """All nontrivial equations (those of some links), from the top down."""
        setter = Setter(self.letter)
        y = 0.0
        plans = self.position.plans
        equations = (m for m in plans.moments if m.links != ("lever",))
        for equation in equations if links is None else plans.moment_equations_of_plan(links):
            if words := self.equation_words(equation):
                y = setter.set_row(words, y) - 1.9 * self.letter
        return tuple(setter.marks)

    def equation_words(self, equation: Moments) -> list[Word]:
        """ΣM_C: F^t l = ± G h ± … with the value of every product beneath."""
        drawing = self.position.drawing
        made = drawing.program.steps_by_result.get(equation.unknown)
        shown = nonzero_terms(drawing, equation)
        if not isinstance(made, Calculate) or not shown:
            return []
        unknown_value = float(drawing[equation.unknown])
        acting = (
            -1.0 if equation.arm and unknown_value < 0 else 1.0
        )  # a force is positive as drawn, a couple counter-clockwise
        shown = [(name, arm, acting * value) for name, arm, value in shown]
        about = without_index_markup(self.naming.lettered_point(equation.about))
        links = ",".join(self.naming.link_number(x) for x in equation.links if x != "lever")
        # the common divisor of the products: the unknown's arm, or on the lever the driver's rate
        factor = next((name for name, power in made.terms[0].factors if power < 0), "")
        by = float(drawing[factor]) if factor else 1.0
        by = abs(by) if factor == equation.arm else by  # an arm has no sign, an angular velocity has
        unknown_value *= acting
        over = (
            self.naming.lettered_arm(equation.unknown, factor)
            if factor in self.arm_steps
            else self.naming.lettered_vector(factor)
        )
        head = self.unknown_letter(equation) + (over if factor else "")
        lang = self.naming.lang
        unit = say(self.product_unit(factor != equation.arm), lang)
        armed = {
            lever: arm_length_mm(drawing, self.arm_steps[lever]) for _, lever, _ in shown if lever in self.arm_steps
        }
        if factor and factor == equation.arm:
            armed[factor] = by * scheme_mu(self.position)
        mm = {name: fixed_decimals_text(length, 1, lang) for name, length in armed.items()}
        height = "H" if equation.links == ("lever",) else "h"
        arms = f"{height}, {say('mm', lang)}" if mm else ""
        text = f"ΣM_{{{about}}}" + (f"^{{({links})}}:" if links else ":")
        words = [Word(text, 0, arms, unit, False)]
        words.append(Word(head, 0, mm.get(factor, ""), read_off_text(unknown_value * by, lang), False))
        for k, (name, lever, value) in enumerate(shown):
            product = self.product_text(name, lever)
            below = value * by < 0
            words.append(Word("=" if k == 0 else "−" if below else "+", vector=False))
            product = "−" + product if below and k == 0 else product
            ends = ";" if equation.arm and k == len(shown) - 1 else ""
            words.append(Word(product + ends, 0, mm.get(lever, ""), read_off_text(abs(value * by), lang), False))
        if not equation.arm:
            return words
        return [
            *words,
            Word(
                f"{self.unknown_letter(equation)} = {read_off_text(unknown_value, lang)} {say('N', lang)}", vector=False
            ),
        ]

    def product_unit(self, of_power: bool) -> str:
        """The unit of every product: on the lever that of power, or the rest of it for rates of a unit drive."""
        plans = self.position.plans
        if not of_power or (plans.at_rest and plans.drive.rotates):
            return "N·m"
        return "N" if plans.at_rest else "W"

    def unknown_letter(self, equation: Moments) -> str:
        """The letter of what the equation is solved for."""
        plans = self.position.plans
        return self.naming.lettered_vector(plans.balancing if equation.unknown == plans.zhukovsky else equation.unknown)

    def product_text(self, name: str, lever: str) -> str:
        """A force times its arm, a couple, either times its rate."""
        force = self.naming.lettered_vector(name) if lever in self.arm_steps else self.letter_in_bars(name)
        return force + self.factor_text(name, lever)

    def letter_in_bars(self, name: str) -> str:
        """The letter of a couple or a rate, in bars where it is negative: its sign is before the product."""
        letter = self.naming.lettered_vector(name)
        if name in self.position.drawing and float(self.position.drawing[name]) < 0:
            return f"|{letter}|"
        return letter

    def factor_text(self, name: str, lever: str) -> str:
        """The factor of a force: its arm, a length or a rate; None without an arm."""
        if lever in self.arm_steps:
            return self.naming.lettered_arm(name, lever)
        if lever:
            return self.letter_in_bars(lever)
        return ""

    @cached_property
    def arm_steps(self) -> Mapping[str, Drop]:
        """The steps that measure arms, by the names of the arms."""
        return arm_steps_by_result(self.position.drawing)


@dataclass
class Lever:
    """The lever of one position; with a driver at rest the plan of a unit drive is turned instead."""

    position: Position
    naming: Naming

    def drawn_marks(self) -> Marks:
        """The turned plan, the forces, their arms and all names."""
        plan = MOTION_PLAN if self.position.plans.at_rest else VELOCITY_PLAN
        plotted = plot_position(self.position)
        marks = list[Mark]()
        lines = []
        helping = ("false", "relative")  # not part of the loaded figure
        aside = {s.makes for s in plotted.drawing.program.steps if s.quantity_represented in helping}
        for s in plotted.drawn_segments(plan):
            if {*s.ends} & aside:
                continue
            ends = 1j * plotted.mark(plan, s.start), 1j * plotted.mark(plan, s.end)
            if length_of(ends) > ZERO_VECTOR_MM:
                marks.append(Line(ends, "thick" if s.start == POLE_LABEL else "thin", "plan"))
                lines.append(ends)
        letters = (
            (self.naming.mark(x, VELOCITY_PLAN), 1j * plotted.mark(plan, x))
            for x in plotted.mark_labels(plan)
            if plan.mark(x) not in aside
        )
        places = group_names_by_place(letters)  # letters of coinciding marks share one label
        named = [Label(", ".join(n), z, 5.0, clear=0.8, priority=1, name=n[0]) for z, n in places]
        marks += dot(0j, 0.8, "plan")
        loaded = self.forces_and_arms(lines)
        named += loaded.named
        drawn = marks_with_labels(named, [*marks, *loaded.marks])
        return with_unseen_arm_names(named, loaded.short, drawn, self.naming.lang)

    def forces_and_arms(self, lines: list[Ends]) -> Arms:
        """Arrows of the forces at their images, not to scale, and their arms about the pole."""
        drawing = self.position.drawing
        marks = []
        named = []
        drops = arm_steps_by_result(drawing)
        arms = Arms()
        arrows = Arrows(lines)
        lever = next((m for m in self.position.plans.moments if m.links == ("lever",)), None)
        for name, arm in lever.terms if lever else ():
            step = drops.get(arm)
            if not step or arm not in drawing or abs(complex(drawing[step.point])) < ZERO_VECTOR_MM:
                continue
            size = float(drawing[name]) if name in drawing else 1.0
            if size == 0:
                continue
            drawn = Arm.of_step(drawing, step, name, self.naming.lettered_arm(name, arm))
            along = complex(drawing[step.along]) * (1 if size >= 0 else -1)
            start, end, far = arrows.place_force_arrow(drawn.point, along, arm=drawn.length)
            marks.append(Arrow(start, end, "vector", "force", name))
            ends = (start + end) / 2, far
            named.append(Label(self.naming.lettered_vector(name), ends, 3.5, name=name, also=(far,)))
            arms.add_arm(drawn)
        return Arms([*marks, *arms.marks], [*named, *arms.named], arms.short)
