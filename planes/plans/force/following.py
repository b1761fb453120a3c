"""The inputs of load laws: values of the motion, drawn before any force."""

from functools import cached_property

from planes.drafting.steps.laws import ByStroke, Follow
from planes.drafting.steps.reckoning import Protractor, Sense
from planes.plans.motion.kinematics import Rates
from planes.plans.position.bodies import Bodies
from planes.scene.expressions import names_in_expression
from planes.scene.load_laws import Coordinate, check_law, coordinates_by_name
from planes.scene.mechanism import FRAME, Amount, Load, LoadLaw, StrokeLoad
from planes.words import Phrase
from planes.words.errors import ExpressionError, SceneError, list_valid_choices
from planes.words.frozen import field, frozen
from planes.words.names import SCHEME_PLAN, Meaning, scheme_mark


@frozen
class LawValues:
    """Makes the values of loads; ``said`` are the laws by name."""

    bodies: Bodies
    velocity: Rates
    accelerations: Rates
    said: dict[str, LoadLaw | StrokeLoad] = field(default_factory=dict)

    def name_of_load_value(self, name: str, load: Load, means: Meaning) -> str:
        """The name of a load's value: given, or found in every position."""
        value = load.value
        if not isinstance(value, StrokeLoad):
            return self.name_of_amount(name, load, value, means)
        self.said[name] = value
        slid = self.velocity.slides.get(value.slider)  # with the driver at rest there is no stroke
        if slid is None:
            what = Phrase("load", number=self.load_numbers[id(load)] + 1)
            why = Phrase("law_slider", what=what, link=value.slider, valid=list_valid_choices("", self.velocity.slides))
            raise SceneError(why, self.bodies.file, self._line(load))
        sense = 1 if value.stroke == "ahead" else -1
        stroke = self.bodies.draft.add_step(
            Sense(f"moves_{value.slider}", *slid.ends, slid.along, tuple(self.velocity.driven))
        )
        working = self.name_of_amount(f"‖{name}", load, value.working, means, stroke, sense)
        idle = self.name_of_amount(f"|{name}", load, value.idle, means, stroke, -sense)
        return self.bodies.draft.add_step(ByStroke(name, stroke, sense, working, idle, means=means))

    def name_of_amount(
        self, name: str, load: Load, amount: Amount, means: Meaning, stroke: str = "", sense: int = 1
    ) -> str:
        """A given number, or the value of a law in its stroke."""
        if not isinstance(amount, LoadLaw):
            return self.bodies.draft.add_given(name, amount, means=None if stroke else means)
        if not stroke:
            self.said[name] = amount
        try:  # laws built in Python were not checked on reading
            check_law(amount.text, self.names_for_laws)
        except ExpressionError as error:
            raise SceneError(error.phrase, self.bodies.file, self._line(load)) from None
        values = tuple(
            (n, self._coordinate_value_name(self.names_for_laws[n][0]))
            for n in dict.fromkeys(names_in_expression(amount.text))
        )
        line = str(self._line(load) or "")
        law_means = None if stroke else means
        return self.bodies.draft.add_step(Follow(name, amount, values, stroke, sense, line, means=law_means))

    @cached_property
    def names_for_laws(self) -> dict[str, list[Coordinate]]:
        """The names a law may use."""
        return coordinates_by_name(self.bodies.mechanism.links, self.bodies.mechanism.drive)

    @cached_property
    def load_numbers(self) -> dict[int, int]:
        """The number of each load among the loads."""
        return {id(load): k for k, load in enumerate(self.bodies.mechanism.loads)}

    def _line(self, load: Load) -> int | None:
        return self.bodies.mechanism.where.get(("loads", str(self.load_numbers[id(load)])))

    def _coordinate_value_name(self, c: Coordinate) -> str:
        """The name of a coordinate's value."""
        if c.sort == "drive":
            return self.bodies.mechanism.drive.coordinate_name
        return {
            "link": self._link_coordinate_value,
            "slider": self._slider_coordinate_value,
            "point": self._point_coordinate_value,
        }[c.sort](c)

    def _link_coordinate_value(self, c: Coordinate) -> str:
        body = self.bodies.known[c.of]
        if c.letter == "phi":
            return self.bodies.draft.add_step(Protractor(f"phi_{c.of}", body.axis))
        rates = self.velocity if c.letter == "omega" else self.accelerations
        if body.root == FRAME:
            return self.bodies.draft.add_given(f"still_{c.of}", 0.0)
        return rates.spin(body.root)

    def _slider_coordinate_value(self, c: Coordinate) -> str:
        if c.letter != "s":
            return (self.velocity if c.letter == "v" else self.accelerations).slides[c.of].value
        pair = next(p for p in self.bodies.structure.pairs if p.link == c.of and p.kind == "P")
        start, along = self.bodies.guide_mark_and_direction(pair, pair.other)
        first = scheme_mark(self.bodies.mechanism.links[c.of].first_point)
        return self.bodies.draft.measure_segment(f"s_{c.of}", start, first, along)

    def _point_coordinate_value(self, c: Coordinate) -> str:
        d = self.bodies.draft
        name = f"|{c.letter}_{c.of}|"
        if c.letter in ("x", "y"):
            along = d.draw_direction_at_angle(
                f"→{c.letter}", 0.0 if c.letter == "x" else 90.0, Meaning("along", c.letter)
            )
            return d.measure_segment(name, d.draw_pole(SCHEME_PLAN), scheme_mark(c.of), along)
        rates = self.velocity if c.letter == "v" else self.accelerations
        return d.measure_segment(name, rates.plan.pole, rates.mark(c.of))
