"""The quantities of a mechanism that can be asked for: names, numbers, and how each is taken from the drawing."""

from collections.abc import Iterable, Iterator
from itertools import permutations
from typing import NamedTuple

from planes.plans import Plans
from planes.plans.columns import Column
from planes.plans.force.derived import Derived, derived_values, values_given_by_laws
from planes.plans.force.reactions import Reaction
from planes.plans.transfers import transfer_functions
from planes.scene.mechanism import FRAME
from planes.words.errors import PlanesError, SceneError
from planes.words.names import NO_MARK, MarkPair, NameTuple, split_value_name
from planes.words.records import Json

MOTION_GROUPS = ("points", "links", "slides")
RESULT_GROUPS = (*MOTION_GROUPS, "reactions")


class Quantity(NamedTuple):
    """One quantity: the ``key`` ("v", "omega"; a segment's name) ``of`` a point, link, reaction or plan, and its
    columns: one for a number, two for a vector, four for a sliding pair's reaction."""

    name: str
    columns: tuple[Column, ...]
    group: str
    of: str = ""
    key: str = ""

    @property
    def json_path(self) -> NameTuple:
        """Its place in the JSON."""
        return tuple(x for x in (self.group, self.of, self.key) if x)

    @property
    def is_reversed(self) -> bool:
        """Whether it is named from the other link of its pair, F_12 for F_21: the force is opposite."""
        return self.group == "reactions" and self.name != self.of

    @property
    def needed_names(self) -> NameTuple:
        """The names of the program it depends on."""
        return tuple(dict.fromkeys(n for c in self.columns for n in c._replace(beside=c.beside[:1]).needed_names))

    @property
    def column_to_write(self) -> Column:
        """The single number to write down for it: of a vector, its magnitude."""
        first = self.columns[0]
        return first._replace(part="size") if first.part else first


Quantities = Iterator[Quantity]


class Measured(NamedTuple):
    """The value of a quantity: a number for each of its columns, None for the arm of a zero normal force."""

    quantity: Quantity
    numbers: tuple[float | None, ...]

    def __repr__(self) -> str:
        said = [f"{c.name} = {n} {c.unit}" for c, n in zip(self.quantity.columns, self.numbers, strict=True)]
        return f"<{', '.join(said)}>"

    @property
    def unit(self) -> str:
        """The key of its unit, of its first number."""
        return self.quantity.columns[0].unit

    @property
    def number(self) -> float:
        """A plain number; of a slider's reaction or another vector, its x component."""
        return self.numbers[0]  # type: ignore[return-value]  # only an arm may be empty

    @property
    def vector(self) -> complex:
        """A vector, or a reaction's force."""
        return complex(*self.numbers[:2])  # type: ignore[arg-type]

    @property
    def slides(self) -> bool:
        """Whether this is a sliding pair's reaction, with an arm and a couple beside its force."""
        return len(self.numbers) > 2

    @property
    def arm(self) -> float | None:
        """The arm of a sliding pair's force about the foot of the perpendicular from the slider's first point."""
        return self.numbers[2] if self.slides else None

    @property
    def moment(self) -> float:
        """The couple about that foot; a hinge has none."""
        return (self.numbers[3] or 0.0) if self.slides else 0.0

    def json(self) -> Json | list[float | None] | float | None:
        """A number, [x, y], or a sliding pair's force, arm and moment."""
        if self.slides:
            return {"force": list(self.numbers[:2]), "arm": self.numbers[2], "moment": self.numbers[3]}
        return list(self.numbers) if len(self.numbers) == 2 else self.numbers[0]


def nested_json(measured: Iterable[Measured], groups: Iterable[str] = ()) -> Json:
    """The results in the shape of the JSON, its ``groups`` included even if they are empty."""
    out: Json = {group: {} for group in groups}
    for one in measured:
        *outer, last = one.quantity.json_path
        within = out
        for key in outer:
            within = within.setdefault(key, {})
        within[last] = one.json()
    return out


def quantities_by_name(plans: Plans) -> dict[str, Quantity]:
    """Every quantity of a mechanism by the student's name for it: v_C, a_H, omega_2, F_21, M_1, v_CB…"""
    known = [*_results_and_intermediates(plans), *_segment_quantities(plans), *_lettered_quantities(plans)]
    known += _reversed_component_quantities(plans, known)
    first = {q.name: q for q in reversed(known)}
    return {q.name: first[q.name] for q in known}


def results_wanted(plans: Plans, wanted: Iterable[Quantity] | None = None) -> list[Quantity]:
    """The quantities wanted (None: all), each once, without bare segments of plans."""
    return distinct_quantities(_all_results(plans) if wanted is None else (q for q in wanted if q.group != "plans"))


def results_with_intermediates(plans: Plans, wanted: Iterable[Quantity] | None = None) -> list[Quantity]:
    """The same with the intermediate results."""
    return results_wanted(plans, _results_and_intermediates(plans) if wanted is None else wanted)


def distinct_quantities(quantities: Iterable[Quantity]) -> list[Quantity]:
    """Each of the quantities once, by the first of its names."""
    by_path = dict[NameTuple, Quantity]()
    return [by_path.setdefault(q.json_path, q) for q in quantities if q.json_path not in by_path]


def quantities_asked_for(plans: Plans, find: Iterable[str], file: str = "") -> list[Quantity]:
    """The quantities named in ``find:``. :class:`SceneError` lists the valid names."""
    known = quantities_by_name(plans)
    names = plans.default_naming.name_finder(known, poles=False)
    refusal = "find_no_quantity" if file else "no_quantity"
    try:
        return [known[names.require_name(name, refusal, lambda n: known[n].json_path)] for name in find]
    except PlanesError as error:
        raise SceneError(error.phrase, file, plans.mechanism.where.get(("find",))) from None


def _all_results(plans: Plans) -> Quantities:
    for name, ends in plans.vectors.items():
        yield Quantity(name, _vector_columns(name, ends[0].plan.unit, ends), "vectors", name)
    for part in (_point_quantities, _link_quantities, _slide_quantities, _reaction_quantities, _balancing_quantities):
        yield from part(plans)
    yield from _derived_quantities(values_given_by_laws(plans))


def _results_and_intermediates(plans: Plans) -> Quantities:
    yield from (
        *_all_results(plans),
        *_derived_quantities(derived_values(plans)),
        *_derived_quantities(transfer_functions(plans)),
    )


def _vector_columns(name: str, unit: str, ends: MarkPair | None) -> tuple[Column, ...]:
    """Both components of a segment; zeros where there is none."""
    start, end = ends or (NO_MARK, NO_MARK)
    return tuple(Column(f"{name}_{part}", unit, "", start, end, part if ends else "") for part in "xy")


def _point_quantities(plans: Plans) -> Quantities:
    for point, m in plans.points.items():
        for letter, unit, mark in (("r", "m", m.position), ("v", "m/s", m.velocity), ("a", "m/s²", m.acceleration)):
            name = f"{letter}_{point}"
            yield Quantity(name, _vector_columns(name, unit, (mark.plan.pole, mark)), "points", point, letter)


def _link_quantities(plans: Plans) -> Quantities:
    units = {"angle_deg": "°", "omega": "rad/s", "epsilon": "rad/s²"}
    for link, v in plans.links.items():
        for (key, unit), value in zip(units.items(), (v.angle, v.omega, v.epsilon), strict=True):
            name = f"{'phi' if key == 'angle_deg' else key}_{link}"
            if link != FRAME:
                yield Quantity(name, (Column(name, unit, value),), "links", link, key)


def _slide_quantities(plans: Plans) -> Quantities:
    for link, rate in plans.velocity_slides.items():
        quick = plans.acceleration_slides[link]
        for key, unit, value in (("v", "m/s", rate.value), ("a", "m/s²", quick.value)):
            name = f"{key}_slide_{link}"
            yield Quantity(name, (Column(name, unit, value),), "slides", link, key)
        name = f"coriolis_{link}"
        yield Quantity(name, _vector_columns(name, "m/s²", quick.coriolis), "slides", link, "coriolis")


def _reaction_quantities(plans: Plans) -> Quantities:
    for key, r in plans.reactions.items():
        columns = _reaction_columns(plans, r)
        for name in r.both_reaction_names:
            yield Quantity(name, columns, "reactions", key)


def _reaction_columns(plans: Plans, r: Reaction) -> tuple[Column, ...]:
    force = _vector_columns(r.key, "N", (r.start, r.end))
    if r.pair.kind == "R":
        return force
    marks = tuple(s.makes for s in plans.program.mark_steps_on(r.plan))
    arm = Column(f"{r.key}_arm", "m", r.arm, beside=(r.normal, *marks))
    return (*force, arm, Column(f"{r.key}_moment", "N·m", r.moment))


def _balancing_quantities(plans: Plans) -> Quantities:
    drive = plans.drive
    what, letter, unit = ("moment", "M", "N·m") if drive.rotates else ("force", "Fb", "N")
    for by, sign, value in (("balancing", "", plans.balancing), ("zhukovsky", "Z", plans.zhukovsky)):
        for name in (f"{letter}{sign}_{drive.link}", f"{by}_{what}") if value else ():
            yield Quantity(name, (Column(name, unit, value),), f"{by}_{what}")
    if plans.beside_force:
        key, *ends = plans.beside_force
        own = plans.balancing_force
        yield from (Quantity(n, (Column(n, "N", own),), "balancing_force") for n in (own, "balancing_force"))
        yield Quantity(key, _vector_columns(key, "N", (ends[0], ends[1])), "reactions", key)


def _derived_quantities(values: Iterable[Derived]) -> Quantities:
    for d in values:
        part = "size" if d.ends[0] else ""
        columns = {n: Column(n, d.unit, d.value, *d.ends, part, per=d.per) for n in d.names}
        yield from (Quantity(n, (c,), d.group, d.names[0]) for n, c in columns.items())


def _segment_quantities(plans: Plans) -> Quantities:
    for s in plans.segments:
        if s.plan != "motion" and s.start != s.end and not {"°", "⊥"} & set(s.name):
            size = Column(s.name, s.plan.unit, "", *s.ends, "size")
            yield Quantity(s.name, (size,), "plans", s.plan, s.name)


def _lettered_quantities(plans: Plans) -> Quantities:
    """Values that sheets letter beside their results: given couples, the rates of a drive between moving links, and
    components of reactions that are plain values."""
    for couple in (c for couples in plans.acting.couples.values() for c in couples if not (c.inertia or c.handed)):
        yield Quantity(couple.name, (Column(couple.name, "N·m", couple.value),), "loads", couple.name)
    for rate, unit in zip(plans.drive.rate_names, ("rad/s", "rad/s²"), strict=True):
        if plans.drive.on != FRAME and rate in plans.given:
            yield Quantity(rate, (Column(rate, unit, rate),), "drive", rate)
    for name in plans.program.result_names:
        letter, _, part = split_value_name(name)
        if letter == "F" and part:
            yield Quantity(name, (Column(name, "N", name),), "reactions", name)
    for rate in (f"omega_{key}" for key in plans.reactions):  # of a hinge with friction
        if rate in plans.program.result_names:
            yield Quantity(rate, (Column(rate, "rad/s", rate),), "friction", rate)


def _reversed_component_quantities(plans: Plans, known: Iterable[Quantity]) -> list[Quantity]:
    """Components of reactions named from the other link of their pair, F_12^t for F_21^t."""
    turned = {one: two for r in plans.reactions.values() for one, two in permutations(r.both_reaction_names, 2)}
    parts = ((q, *split_value_name(q.name)) for q in known)
    own = ((q, turned.get(f"{letter}_{index}"), part) for q, letter, index, part in parts if part)
    return [q._replace(name=f"{name}^{part}") for q, name, part in own if name]
