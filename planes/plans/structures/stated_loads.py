"""What a scene of statics gives, on its plans: points, forces at them, couples."""

import cmath
import math

from planes.drafting.draft import Draft
from planes.plans.force.loads import Couple, Force
from planes.plans.position.bodies import SCHEME, BodyPoint
from planes.plans.structures.cremona import CremonaPlan
from planes.plans.structures.figure import FigureDraft
from planes.scene import Scene
from planes.scene.structures import Framework, StaticLoad
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import Meaning, at, label_of


class StatedLoads:
    """The draft with points and loads; what bodies, members and reactions are found on it."""

    def __init__(self, scene: Scene, framework: Framework) -> None:
        self.scene, self.framework = scene, framework
        self.draft, self.figure = Draft(), FigureDraft()
        self.forces: dict[str, list[Force]] = {name: [] for name in framework.bodies}
        self.couples: dict[str, list[Couple]] = {name: [] for name in framework.bodies}
        self.left = list(framework.bodies)
        self.cremona: CremonaPlan | None = None
        self.spans: dict[str, tuple[str, str]] = {}
        self.values: dict[str, str] = {}
        self.sizes: dict[str, complex] = {}  # of known forces in N, by which a way and a pole are chosen

    def error(self, phrase: Phrase, *path: str) -> SceneError:
        """A refusal that points at the line of what it speaks of."""
        where = self.scene.where
        return SceneError(phrase, self.scene.file, where.get(path, where.get(("points",))))

    def place(self) -> None:
        """Points of the scheme, and loads at them."""
        d, f = self.draft, self.framework
        d.pole(SCHEME)
        for name, z in f.points.items():
            d.put(SCHEME, name, z)
        for load in f.loads:
            if load.direction_deg is None:
                value = d.give(f"|{load.name}|", load.size, Meaning("couple", load.name, link=load.body))
                self.couples[load.body].append(Couple(load.name, load.body, value))
            else:
                self.force(load, load.direction_deg)

    def force(self, load: StaticLoad, angle: float) -> None:
        """A force at its point, or at one of its own: the middle of what it is the resultant of."""
        d = self.draft
        size = d.give(f"|{load.name}|", load.size, Meaning("load", load.name, link=load.body))
        along = d.aim(f"∠{load.name}", angle, Meaning("given", load.name))
        mark = at(SCHEME, load.point) if load.point else d.put(SCHEME, f"_{load.name}", load.place, Meaning("moved"))
        spot = BodyPoint(label_of(mark), load.point)
        self.forces[load.body].append(Force(load.name, load.body, size, along, mark, "load", spot))
        self.sizes[load.name] = load.size * cmath.rect(1.0, math.radians(angle))
