"""The data of a scene of statics on its plans: points, forces at them, couples."""

import cmath
import math
from itertools import combinations

from planes.drafting.draft import Draft
from planes.drafting.steps import Aim
from planes.drafting.steps.laws import Follow
from planes.drafting.tools import Tool
from planes.geometry.arithmetic import Arithmetic
from planes.plans.force.loads import Couple, Force
from planes.plans.position.bodies import BodyPoint
from planes.plans.statements.turning import value_name_of_law
from planes.plans.structures.figure import StaticsFigure
from planes.scene import Scene
from planes.scene.expressions import names_in_expression
from planes.scene.mechanism import LoadLaw
from planes.scene.structures import Framework, StaticLoad
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import SCHEME_PLAN, MarkPair, Meaning, NamesByName, scheme_mark


class StatedLoads:
    """The draft with points and loads, to which bodies, members and reactions are added."""

    def __init__(self, scene: Scene, framework: Framework) -> None:
        self.scene = scene
        self.framework = framework
        self.draft = Draft()
        self.figure = StaticsFigure.undrawn_figure(framework)
        self.forces: dict[str, list[Force]] = {name: [] for name in framework.bodies}
        self.couples: dict[str, list[Couple]] = {name: [] for name in framework.bodies}
        self.left = list(framework.bodies)
        self.spans: dict[str, MarkPair] = {}
        self.values: NamesByName = {}
        self.sizes: dict[str, complex] = {}  # of known forces in N, for the choice of a method and a pole

    def error(self, phrase: Phrase, *path: str) -> SceneError:
        """An error at the line of its subject."""
        where = self.scene.where
        return SceneError(phrase, self.scene.file, where.get(path, where.get(("points",))))

    def check_points(self) -> None:
        """Check that points are apart, and that supported points belong to a body."""
        f = self.framework
        for one, other in combinations(f.points, 2):
            if f.points[one] == f.points[other]:
                raise self.error(Phrase("points_same", one=one, other=other), "points", other)
        held_points = {p for points in f.bodies.values() for p in points}
        if loose := next((s.point for s in f.supports if s.point not in held_points), None):
            raise self.error(
                Phrase("point_loose", what=Phrase("support_of", name=loose), name=loose), "supports", loose
            )

    def state_points_and_loads(self) -> None:
        """Points of the scheme, and loads at them."""
        d = self.draft
        f = self.framework
        d.draw_pole(SCHEME_PLAN)
        for name, z in f.points.items():
            d.draw_given_mark(SCHEME_PLAN, name, z)
        for load in f.loads:
            if load.direction_deg is None:
                value = self.name_of_number(f"|{load.name}|", load.size, Meaning("couple", load.name, link=load.body))
                self.couples[load.body].append(Couple(load.name, load.body, value))
            else:
                self.state_force(load, load.direction_deg)

    @property
    def turning(self) -> bool:
        """Whether any load follows a law: what suits the drive's position in the file need not suit others."""
        numbers = (x for load in self.framework.loads for x in (load.size, load.direction_deg))
        return any(isinstance(x, LoadLaw) for x in numbers)

    def name_of_number(self, name: str, value: float | LoadLaw, means: Meaning) -> str:
        """A given number, or the value of a law."""
        if isinstance(value, LoadLaw):
            return value_name_of_law(self.draft, self.scene.drive, name, value, means)
        return self.draft.add_given(name, value, means)

    def number_at_file_position(self, value: float | LoadLaw) -> float:
        """A number at the drive's position in the file."""
        if not isinstance(value, LoadLaw):
            return value
        assert self.scene.drive
        law = Follow("", value, tuple((n, "x") for n in names_in_expression(value.text)))
        return float(law.draw({"x": self.scene.drive.position}, Tool(Arithmetic())))

    def state_force(self, load: StaticLoad, angle: float | LoadLaw) -> None:
        """A force at its point, or at a new one: the centre of the load whose resultant it is."""
        d = self.draft
        size = self.name_of_number(f"|{load.name}|", load.size, Meaning("load", load.name, link=load.body))
        turned = self.name_of_number(f"angle_∠{load.name}", angle, Meaning("angle", load.name))
        along = d.add_step(Aim(f"∠{load.name}", turned, means=Meaning("given", load.name)))
        mark = (
            scheme_mark(load.point)
            if load.point
            else d.draw_given_mark(SCHEME_PLAN, f"_{load.name}", load.place, Meaning("moved"))
        )
        spot = BodyPoint(mark.label, load.point)
        self.forces[load.body].append(Force(load.name, load.body, size, along, mark, "load", spot))
        now = self.number_at_file_position(load.size) or float(
            isinstance(load.size, LoadLaw)
        )  # zero now, it has a direction all the same
        self.sizes[load.name] = now * cmath.rect(1.0, math.radians(self.number_at_file_position(angle)))
