"""External loads on the links: weights, inertia, and the scene's forces and couples."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from planes.drafting.steps import Aim, Turn
from planes.drafting.steps.reckoning import Sense, SenseOf
from planes.plans.force.following import LawValues
from planes.plans.motion.kinematics import Rates
from planes.plans.position.bodies import Bodies, BodyPoint
from planes.scene.mechanism import FRAME, LOAD_KINDS, Link, Load, LoadLaw, Mechanism, StrokeLoad
from planes.words.frozen import frozen
from planes.words.names import Mark, Meaning, NamePair, Quantity, scheme_mark
from planes.words.records import Json


@frozen
class Force:
    """A force on ``link`` at a mark of the scheme: names of its magnitude (N) and direction. ``spot`` is its point."""

    name: str
    link: str
    size: str
    along: str
    point: Mark
    quantity: Quantity
    spot: BodyPoint | None = None

    @property
    def shown(self) -> Json:
        """How a page draws it."""
        return {"name": self.name, "mark": self.point, "along": self.along, "size": self.size}

    @property
    def meaning_of_mark(self) -> Meaning:
        """The meaning of its mark on a force plan."""
        return Meaning(self.quantity, self.name, link=self.link)


@frozen
class Couple:
    """A couple on ``link``: the name of its value (N·m, counter-clockwise positive), times ``sign``; ``handed`` over by
    a sliding pair, or of ``inertia``, or external."""

    name: str
    link: str
    value: str
    sign: int = 1
    handed: bool = False
    inertia: bool = False

    @property
    def shown(self) -> Json:
        """How a page draws it."""
        return {"name": self.name, "link": self.link, "size": self.value, "sign": self.sign}


def names_of_loads(mechanism: Mechanism) -> list[str]:
    """The names of the loads, in order: P_5, a second force on that link P_5_2; couples M_3, on the driver MP_1."""
    names = []
    counts = Counter[NamePair]()
    for load in mechanism.loads:
        counts[key := (load.link, load.kind)] += 1
        letter = LOAD_KINDS[load.kind]
        letter = "MP" if letter == "M" and load.link == mechanism.drive.link else letter
        names.append(f"{letter}_{load.link}" + (f"_{counts[key]}" if counts[key] > 1 else ""))
    return names


def name_of_force(on: str, by: str) -> str:
    """F_21 acts on 2 from 1; longer names are separated: F_11_10."""
    return f"F_{force_pair_index(on, by)}"


def force_pair_index(on: str, by: str) -> str:
    """The index of a force on a link from another."""
    return on + by if len(on) == len(by) == 1 else f"{on}_{by}"


@frozen
class Loads:
    """All forces and couples by link, the loads given by laws by name, and the ``motion`` that gave their senses."""

    forces: Mapping[str, Sequence[Force]] = field(default_factory=dict)
    couples: Mapping[str, Sequence[Couple]] = field(default_factory=dict)
    laws: Mapping[str, LoadLaw | StrokeLoad] = field(default_factory=dict)
    motion: Rates | None = None

    @property
    def every(self) -> list[Force]:
        """The forces on all links."""
        return [f for forces in self.forces.values() for f in forces]


@dataclass
class Acting:
    """All forces and couples on each link; those of pairs are added as they are found."""

    bodies: Bodies
    motion: Rates  # the velocities that decide "along" or "against" motion
    accelerations: Rates
    laws: LawValues
    forces: dict[str, list[Force]] = field(default_factory=dict)
    couples: dict[str, list[Couple]] = field(default_factory=dict)

    def gather_all_loads(self) -> None:
        """Weights, inertia and loads of every link, in this order on each."""
        for link in self.bodies.mechanism.links.values():
            self.forces[link.name] = []
            self.couples[link.name] = []
            self._add_weight(link)
            self._add_inertia_loads(link)
        m = self.bodies.mechanism
        for number, (name, load) in enumerate(zip(names_of_loads(m), m.loads, strict=True)):
            name = self._add_given_force(load, name) if load.kind == "force" else self._add_given_couple(load, name)
            for path, law in self.bodies.mechanism.laws.items():
                if path[:2] == ("loads", str(number)):
                    self.bodies.draft.record_law(name, law)

    @property
    def all_loads(self) -> Loads:
        """All loads found."""
        return Loads(self.forces, self.couples, self.laws.said, self.motion)

    def _add_weight(self, link: Link) -> None:
        if link.mass is None or self.bodies.mechanism.gravity is None:
            return
        d = self.bodies.draft
        gravity = d.add_given("g", self.bodies.mechanism.gravity)
        mass = d.add_given(f"m_{link.name}", link.mass)
        size = d.add_product(f"G_{link.name}", **{mass: 1, gravity: 1})
        down = d.draw_direction_at_angle("↓", -90.0, Meaning("down"))
        self.forces[link.name].append(
            Force(f"G_{link.name}", link.name, size, down, *self._mass_centre_mark(link, "weight"))
        )

    def _mass_centre_mark(self, link: Link, quantity: Quantity) -> tuple[Mark, Quantity, BodyPoint]:
        return scheme_mark(link.mass_centre), quantity, BodyPoint(link.mass_centre, link.mass_centre)

    def _add_inertia_loads(self, link: Link) -> None:
        d = self.bodies.draft
        rates = self.accelerations
        root = self.bodies.known[link.name].root
        if link.inertia is not None and root != FRAME:
            moment = d.add_given(f"J_{link.name}", link.inertia)
            value = d.add_product(f"MI_{link.name}", -1.0, **{moment: 1, rates.spin(root): 1})
            self.couples[link.name].append(Couple(f"MI_{link.name}", link.name, value, inertia=True))
        mark = rates.mark(link.mass_centre)
        pole = rates.plan.pole
        if link.mass is None or mark == pole:
            return
        rate = d.measure_segment(f"a_{link.mass_centre}", pole, mark)
        size = d.add_product(f"I_{link.name}", **{d.add_given(f"m_{link.name}", link.mass): 1, rate: 1})
        back = d.draw_direction_through_marks(
            f"-a_{link.mass_centre}", mark, pole, Meaning("against", f"a_{link.mass_centre}")
        )
        self.forces[link.name].append(
            Force(f"I_{link.name}", link.name, size, back, *self._mass_centre_mark(link, "inertia"))
        )

    def _add_given_force(self, load: Load, name: str) -> str:
        d = self.bodies.draft
        point = load.point or ""
        size = self.laws.name_of_load_value(f"{name}_given", load, Meaning("load", name, link=load.link))
        if load.sense:
            ends = self.motion.plan.pole, self.motion.mark(point)
            moving = d.add_step(Sense(f"moves_{point}", *ends, None, tuple(self.motion.driven)))
            ends = ends if load.sense == "along" else (ends[1], ends[0])
            means = Meaning("with" if load.sense == "along" else "against", f"v_{point}")
            along = d.draw_direction_through_marks(
                f"{'+' if load.sense == 'along' else '-'}{self.motion.letter}{point}", *ends, means
            )
            size = d.add_product(name, **{size: 1, moving: 1})
        else:
            along = self._load_direction(name, load)
        if not load.sense:
            size = d.add_product(name, **{size: 1})
        acting = Force(name, load.link, size, along, scheme_mark(point), "load", BodyPoint(point, point))
        self.forces[load.link].append(acting)
        return size

    def _load_direction(self, name: str, load: Load) -> str:
        d = self.bodies.draft
        means = Meaning("given", name)
        angle = load.direction_deg or 0.0
        turned = bool(load.direction_link) and load.direction_link != FRAME
        axis = self.bodies.known[load.direction_link or FRAME].axis
        if isinstance(angle, LoadLaw):
            law = self.laws.name_of_amount(f"∠{name}_given", load, angle, Meaning("angle", name, link=load.link))
            return d.add_step(
                Turn(f"∠{name}", axis, 0, law, means=means) if turned else Aim(f"∠{name}", law, means=means)
            )
        if turned:
            return d.draw_turned_direction(f"∠{name}", axis, angle, means)
        return d.draw_direction_at_angle(f"∠{name}", angle, means)

    def _add_given_couple(self, load: Load, name: str) -> str:
        d = self.bodies.draft
        link = load.link
        value = self.laws.name_of_load_value(f"{name}_given", load, Meaning("couple", name, link=link))
        if not load.sense:
            self.couples[link].append(Couple(name, link, d.add_product(name, **{value: 1})))
            return name
        root = self.bodies.known[link].root
        if root == FRAME:
            return name  # a link that never turns gives a couple no sense of rotation
        sense = self.turning(root)
        sign = 1.0 if load.sense == "along" else -1.0
        self.couples[link].append(Couple(name, link, d.add_product(name, sign, **{value: 1, sense: 1})))
        return name

    def turning(self, root: str, warns: bool = True) -> str:
        """The sense of rotation of a link; ``warns`` at standstill."""
        if root in self.motion.turning:
            ends = (*self.motion.turning[root], tuple(self.motion.driven))
            return self.bodies.draft.add_step(Sense(f"turns_{root}" if warns else f"way_{root}", *ends, warns))
        return self.bodies.draft.add_step(SenseOf(f"turns_{root}", self.motion.spin(root)))
