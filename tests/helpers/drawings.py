"""Realistic drawings, with one mistake or none, for tests of the checker.

The true vectors come from the independent solver (`oracle`); the constructions, the drawing errors and every mistake
are implemented here again, from the textbook. Nothing of the package is used.
"""

from __future__ import annotations

import cmath
import math
import random
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from tests.helpers.oracle import Model, Pair, Solution, read

Lines = dict[str, tuple[complex, complex]]


@dataclass(frozen=True)
class Care:
    """The accuracy of a person: marks (mm, each way), transferred directions (degrees), readings (mm)."""

    point: float = 0.15
    ray: float = 0.15
    ruler: float = 0.25


NONE = Care(0.0, 0.0, 0.0)
SHAKY = Care(0.3, 0.35, 0.35)


@dataclass
class Hand:
    """A hand with random errors."""

    care: Care
    rng: random.Random

    def mark(self, z: complex) -> complex:
        return z + self.care.point * complex(self.rng.gauss(0, 1), self.rng.gauss(0, 1))

    def ray(self, u: complex) -> complex:
        return u / abs(u) * cmath.rect(1, math.radians(self.care.ray * self.rng.gauss(0, 1)))

    def read(self, mm: float) -> float:
        return mm + self.care.ruler * self.rng.gauss(0, 1)


def meet(p: complex, u: complex, q: complex, w: complex) -> complex:
    """The intersection of two lines."""
    return p + u * (((q - p).conjugate() * w).imag / (u.conjugate() * w).imag)


@dataclass(frozen=True)
class Mistake:
    """One mistake: its name in the catalogue and its mark ("" for any possible one)."""

    name: str
    where: str
    variant: int = 0


@dataclass
class Sheet:
    """A person's drawing: marks in order (mm from the pole), and where a mistake was really made."""

    marks: dict[str, complex] = field(default_factory=dict)
    made: list[tuple[str, str]] = field(default_factory=list)  # (mistake, mark) pairs possible in this drawing
    done: bool = False


@dataclass(frozen=True)
class Leg:
    """One path to a group's new point: from ``known`` (a name, "" for the pole) about a hinge or along a guide."""

    known: str
    carrier: str
    hinge: str = ""
    guide: str = ""


@dataclass(frozen=True)
class Task:
    """A group: the name and link of the new point, its position, and two legs."""

    new: str
    link: str
    place: str
    legs: tuple[Leg, Leg]


class Motion:
    """Velocity and acceleration plans of one scene, drawn by hand."""

    def __init__(self, scene: Mapping[str, Any], sol: Solution, letters: Mapping[str, str] | None = None) -> None:
        self.scene, self.sol, self.model = scene, sol, read(scene)
        self.letters = dict(letters or {})
        self.owner = {g: n for n, b in [("0", scene["frame"]), *self.links()] for g in b.get("guides") or {}}
        for _, b in [("0", scene["frame"]), *self.links()]:
            for g, spec in (b.get("guides") or {}).items():
                if spec.get("mark"):
                    self.letters[f"{g}"] = spec["mark"]
        self.frame = set(scene["frame"].get("points") or {})
        self.tasks = list(self._tasks())

    def links(self) -> list[tuple[str, Any]]:
        return [(str(k), v) for k, v in self.scene["links"].items()]

    def _tasks(self) -> Iterator[Task]:
        solved = ["0", self.model.driver]
        for i, j in self.model.groups:
            yield self._task(self.model, i, j, solved)
            solved += [i, j]

    def _task(self, m: Model, i: str, j: str, solved: list[str]) -> Task:
        inner_h = [h for h in m.hinges if {h.i, h.j} == {i, j}]
        outer = {n: self._outer(m, n, solved) for n in (i, j)}
        if inner_h:
            new = inner_h[0].name
            return Task(new, i, new, (self._leg(outer[i], i, new), self._leg(outer[j], j, new)))
        slide = next(s for s in m.slides if {s.i, s.j} == {i, j})
        kinds = {n: outer[n].u is None for n in (i, j)}
        if all(kinds.values()):
            first, last = slide.i, slide.j
        else:
            first = i if kinds[i] else j
            last = j if first == i else i
        hinge = outer[first].name
        new = self.coincident(slide, hinge, last)
        inner = Leg(hinge, first, guide=slide.name)
        return Task(new, last, hinge, (inner, self._leg(outer[last], last, new)))

    def _outer(self, m: Model, link: str, solved: list[str]) -> Pair:
        found = [h for h in m.hinges if link in (h.i, h.j) and (h.j in solved or h.i in solved)]
        slides = [s for s in m.slides if link in (s.i, s.j) and (s.i in solved or s.j in solved)]
        return (found + slides)[0]

    def _leg(self, pair: Pair, link: str, new: str) -> Leg:
        if pair.u is None:
            return Leg(pair.name, link, hinge=pair.name)
        mate = pair.j if pair.i == link else pair.i
        if mate == "0":
            return Leg("", mate, guide=pair.name)
        return Leg(self.coincident(pair, new, mate), mate, guide=pair.name)

    def coincident(self, slide: Pair, point: str, link: str) -> str:
        """The name of a link's point below another point: its guide's letter, or the point's with its number."""
        letter = self.letters.get(slide.name)
        return letter if letter and self.owner[slide.name] == link else f"{point}{link}"

    def place(self, name: str) -> complex:
        """The position of a point on the scheme, m; a coincident one shares that of its counterpart."""
        if name in self.sol.points:
            return self.sol.points[name][0]
        for t in self.tasks:
            if name == t.new or name in (leg.known for leg in t.legs):
                return self.sol.points[t.place][0]
        raise KeyError(name)

    def direction(self, guide: str) -> complex:
        return next(u for g, _, u in self.sol.guides.values() if g == guide)

    def rate(self, guide: str) -> float:
        """ω of the link that carries the guide's direction."""
        link = next(link for g, link, _ in self.sol.guides.values() if g == guide)
        return 0.0 if link == "0" else self.sol.links[link][1]

    def turning(self, guide: str) -> bool:
        return abs(self.rate(guide)) > 0

    def label(self, name: str, quick: bool) -> str:
        return name.lower() + ("'" if quick else "")


Scheme = Mapping[str, complex]  # points of the mechanism as drawn by a person, mm


def draw_scheme(m: Motion, hand: Hand, scheme_mu: float) -> Scheme:
    """The mechanism to scale: one scheme, source of directions and arms for all plans."""
    return {n: hand.mark(z[0] * scheme_mu) for n, z in m.sol.points.items()}


class Plan:
    """A motion plan while it is drawn."""

    def __init__(self, m: Motion, hand: Hand, mu: float, scheme: Scheme, mistake: Mistake | None) -> None:
        self.m, self.hand, self.mu, self.mistake = m, hand, mu, mistake
        self.scheme = scheme
        self.sheet = Sheet()
        self.ends: dict[str, complex] = {"": 0j}  # point -> end of its vector
        for n in m.frame:
            self.ends[n] = 0j

    def at(self, name: str) -> complex:
        """A point on the drawn scheme."""
        if name in self.scheme:
            return self.scheme[name]
        t = next(t for t in self.m.tasks if name == t.new or name in (leg.known for leg in t.legs))
        return self.scheme[t.place]

    def is_now(self, name: str, where: str) -> bool:
        """Whether the mistake is made here; records every place where it is possible."""
        self.sheet.made.append((name, where))
        return self.mistake is not None and (self.mistake.name, self.mistake.where) == (name, where)

    def put(self, name: str, z: complex, quick: bool) -> None:
        """Marks the end of a point's vector."""
        self.ends[name] = self.hand.mark(z)
        self.sheet.marks[self.m.label(name, quick)] = self.ends[name]

    def likeness(self, link: str, quick: bool, bases: list[tuple[str, str]], tangential: Mapping[Any, complex]) -> None:
        """The other points of a link by similarity on the first base with both ends known."""
        scene_points = self.m.scene["links"][link]["points"]
        for name in [n for n in scene_points if n not in self.ends]:
            one, two = bases[0]
            label = self.m.label(name, quick)
            ratio = (self.m.place(name) - self.m.place(one)) / (self.m.place(two) - self.m.place(one))
            start, end = self.ends[one], self.ends[two]
            if abs(ratio.imag) > 1e-9 and self.is_now("similarity_mirrored", label):
                ratio = ratio.conjugate()
            if not quick and self.is_now("divided_from_wrong_end", label):
                start, end = end, start
            if not quick and abs(start) > 1 and self.is_now("similarity_on_pole_segments", label):
                start = 0j
            if quick and (one, two) in tangential and self.is_now("similarity_on_tangential", label):
                start = tangential[one, two]
            self.put(name, start + (end - start) * ratio, quick)


def similar_to(plan: Plan, task_link: str, name: str, base: str, one: str, two: str, quick: bool) -> None:
    """A point of a link that rotates like ``one``–``two``: its vector bypasses that of ``base``."""
    ratio = (plan.m.place(name) - plan.m.place(base)) / (plan.m.place(two) - plan.m.place(one))
    plan.put(name, plan.ends[base] + (plan.ends[two] - plan.ends[one]) * ratio, quick)


def driver_points(plan: Plan, quick: bool) -> tuple[str, str] | None:
    """The driver's vectors; its two points if it rotates."""
    m = plan.m
    drive, link = m.scene["drive"], m.model.driver
    points = list(m.scene["links"][link]["points"])
    if "phi" not in drive:
        u = next(u for n, (_, _, u) in m.sol.guides.items() if n == link)
        name = points[0]
        value = float(drive.get("acceleration" if quick else "velocity", 0))
        reversed_ = plan.is_now("epsilon1_reversed" if quick else "omega1_reversed", m.label(name, quick))
        if quick and plan.is_now("epsilon1_ignored", m.label(name, quick)):
            value = 0.0
        plan.put(name, plan.hand.ray(u) * value * plan.mu * (-1 if reversed_ else 1), quick)
        for other in points[1:]:
            plan.ends[other] = plan.ends[name]
            plan.sheet.marks[m.label(other, quick)] = plan.ends[name]
        return None
    pivot = next(p for p in points if p in m.frame)
    shared = [p for p in points if p != pivot and any(p in b["points"] for n, b in m.links() if n != link)]
    name = (shared + [p for p in points if p != pivot])[0]
    line = plan.hand.ray(m.place(name) - m.place(pivot))  # drawn by protractor
    length = abs(m.place(name) - m.place(pivot))
    omega, epsilon = float(drive.get("omega", 0)), float(drive.get("epsilon", 0))
    label = m.label(name, quick)
    if not quick:
        u = 1j * line
        if plan.is_now("omega1_reversed", label):
            u = -u
        if plan.is_now("along_link", label):
            u = u / 1j
        plan.put(name, plan.hand.ray(u) * omega * length * plan.mu, False)
        return pivot, name
    n = f"n_{name}"
    size = omega**2 * length * plan.mu
    size = -size if plan.is_now("normal_outward", n) else 0.0 if plan.is_now("normal_missing", n) else size
    missing = plan.mistake is not None and (plan.mistake.name, plan.mistake.where) == ("normal_missing", n)
    end = plan.hand.mark(-plan.hand.ray(line) * size) if not missing else 0j
    if not missing:
        plan.sheet.marks[n] = end
    u, rate = 1j * line, epsilon * length * plan.mu
    if epsilon:
        rate = -rate if plan.is_now("epsilon1_reversed", label) else rate
        rate = 0.0 if plan.is_now("epsilon1_ignored", label) else rate
        u = line if plan.is_now("tangential_along_link", label) else u
    plan.put(name, end + plan.hand.ray(u) * rate, True)
    return pivot, name


def leg_line(plan: Plan, task: Task, leg: Leg, other: Leg) -> complex:
    """The direction of a leg's relative vector on the drawing."""
    if leg.guide:
        return plan.m.direction(leg.guide) * drawn_turn(plan, leg)
    return 1j * (plan.at(task.place) - plan.at(leg.hinge))


def drawn_turn(plan: Plan, leg: Leg) -> complex:
    """The rotation of the drawn scheme's link from the true one: guides take their direction from the scheme."""
    link = next((link for g, link, _ in plan.m.sol.guides.values() if g == leg.guide), "0")
    held = [n for n in plan.m.scene["links"].get(link, {"points": {}})["points"] if n in plan.scheme]
    if link in ("0", plan.m.model.driver) or len(held) < 2:
        return 1 + 0j
    far = max(held, key=lambda n: abs(plan.m.place(n) - plan.m.place(held[0])))
    drawn, true = plan.scheme[far] - plan.scheme[held[0]], plan.m.place(far) - plan.m.place(held[0])
    return drawn / true / abs(drawn / true)


Velocities = Mapping[str, Any]


def draw_velocity(m: Motion, hand: Hand, mu: float, scheme: Scheme, mistake: Mistake | None = None) -> Sheet:
    """A velocity plan."""
    plan = Plan(m, hand, mu, scheme, mistake)
    base = driver_points(plan, False)
    bases: dict[str, tuple[str, str]] = {m.model.driver: base} if base else {}
    finish(plan, m.model.driver, bases, False, {})
    for task in m.tasks:
        for leg in task.legs:
            carried(plan, leg, task, bases, False)
        cross_velocity(plan, task)
        group_points(plan, task, bases, False, {})
    plan.sheet.done = True
    return plan.sheet


def finish(
    plan: Plan, link: str, bases: Mapping[str, tuple[str, str]], quick: bool, tangential: Mapping[Any, complex]
) -> None:
    if link in bases:
        plan.likeness(link, quick, [bases[link]], tangential)


def carried(plan: Plan, leg: Leg, task: Task, bases: Mapping[str, tuple[str, str]], quick: bool) -> None:
    """The known point of a leg, if it is a coincident point of a moving link not yet drawn."""
    if leg.known in plan.ends:
        return
    one, two = bases[turner(plan, leg.carrier, bases)]
    base = next(n for n in plan.m.scene["links"][leg.carrier]["points"] if n in plan.ends)
    similar_to(plan, leg.carrier, leg.known, base, one, two, quick)


def turner(plan: Plan, link: str, bases: Mapping[str, tuple[str, str]]) -> str:
    """The link whose rotation another one shares: itself, or the one on which it slides."""
    while link not in bases:
        mates = [s.j if s.i == link else s.i for s in plan.m.model.slides if link in (s.i, s.j)]
        link = next(n for n in mates if n in bases)
    return link


def group_points(
    plan: Plan, task: Task, bases: dict[str, tuple[str, str]], quick: bool, tangential: Mapping[Any, complex]
) -> None:
    """All other points of the two links of a group."""
    m = plan.m
    pair = next((i, j) for i, j in m.model.groups if task.link in (i, j))
    for leg in task.legs:
        if leg.hinge:
            link = next(n for n in pair if leg.hinge in m.scene["links"][n]["points"] and leg.carrier == n)
            bases[link] = leg.hinge, task.new
    for link in pair:
        finish(plan, link, bases, quick, tangential)
    for link in pair:
        for name in [n for n in m.scene["links"][link]["points"] if n not in plan.ends]:
            known = [n for n in (*m.scene["links"][link]["points"], task.new) if n in plan.ends]
            base = next(n for n in known if n in m.scene["links"][link]["points"] or task.link == link)
            try:
                one, two = bases[turner(plan, link, bases)]
                similar_to(plan, link, name, base, one, two, quick)
            except StopIteration:
                plan.ends[name] = plan.ends[base]
                plan.sheet.marks[m.label(name, quick)] = plan.ends[base]


def cross_velocity(plan: Plan, task: Task) -> None:
    """The new point at the intersection of the lines of its two legs."""
    label = plan.m.label(task.new, False)
    one, two = task.legs
    start, other = plan.ends[one.known], plan.ends[two.known]
    lines = [leg_line(plan, task, one, two), leg_line(plan, task, two, one)]
    for k, leg in enumerate(task.legs):
        lines[k] = wrong_line(plan, task, leg, lines, k, label)
    if (one.known in plan.m.frame or not one.known) != (two.known in plan.m.frame or not two.known) and plan.is_now(
        "relative_from_pole", label
    ):
        start, other = other, start
    place = meet(start, plan.hand.ray(lines[0]), other, plan.hand.ray(lines[1]))
    moving = [leg for leg in task.legs if abs(plan.ends[leg.known]) > 1]
    if moving and plan.is_now("relative_reversed", label):
        place = 2 * plan.ends[moving[0].known] - place
    plan.put(task.new, place, False)


def wrong_line(plan: Plan, task: Task, leg: Leg, lines: list[complex], k: int, label: str) -> complex:
    """A leg's line with mistakes of direction; the variant number gives the leg."""
    mine = plan.mistake is not None and plan.mistake.variant == k
    line = lines[k]
    if leg.hinge:
        if plan.is_now("along_link", label) and mine:
            return line / 1j
        if plan.is_now("wrong_link", label) and mine:
            first = next(iter(plan.m.scene["links"][plan.m.model.driver]["points"]))
            second = list(plan.m.scene["links"][plan.m.model.driver]["points"])[-1]
            return 1j * (plan.at(second) - plan.at(first))
    elif plan.is_now("across_guide", label) and mine:
        return 1j * line
    return line


def draw_acceleration(
    m: Motion, hand: Hand, mu: float, scheme: Scheme, velocity: Sheet, mu_v: float, mistake: Mistake | None = None
) -> Sheet:
    """An acceleration plan, with normal and Coriolis components computed from a measured velocity plan."""
    plan = Plan(m, hand, mu, scheme, mistake)
    base = driver_points(plan, True)
    bases: dict[str, tuple[str, str]] = {m.model.driver: base} if base else {}
    finish(plan, m.model.driver, bases, True, {})
    speeds = {"": 0j, **dict.fromkeys(m.frame, 0j)}
    names = [*m.sol.points, *(t.new for t in m.tasks), *(leg.known for t in m.tasks for leg in t.legs)]
    for name in names:
        speeds.setdefault(name, velocity.marks.get(m.label(name, False), 0j) / mu_v)
    tangential: dict[tuple[str, str], complex] = {}
    for task in m.tasks:
        for leg in task.legs:
            carried(plan, leg, task, bases, True)
        cross_acceleration(plan, task, speeds, mu_v, tangential)
        group_points(plan, task, bases, True, tangential)
    plan.sheet.done = True
    return plan.sheet


def cross_acceleration(
    plan: Plan, task: Task, speeds: Mapping[str, complex], mu_v: float, tangential: dict[tuple[str, str], complex]
) -> None:
    """The new point from the ends of the known components."""
    label = plan.m.label(task.new, True)
    starts, lines = [], []
    for k, leg in enumerate(task.legs):
        line = leg_line(plan, task, leg, task.legs[1 - k])
        start = plan.ends[leg.known]
        if leg.hinge:
            start = normal_part(plan, task, leg, speeds, mu_v, start)
            tangential[leg.hinge, task.new] = start
            mine = plan.mistake is not None and plan.mistake.variant == k
            if plan.is_now("tangential_along_link", label) and mine:
                line = line / 1j
        else:
            if leg.known and plan.m.turning(leg.guide):
                start = coriolis_part(plan, task, leg, speeds, mu_v, start)
            mine = plan.mistake is not None and plan.mistake.variant == k
            if plan.is_now("across_guide", label) and mine:
                line = 1j * line
        starts.append(start)
        lines.append(line)
    plan.put(task.new, meet(starts[0], plan.hand.ray(lines[0]), starts[1], plan.hand.ray(lines[1])), True)


def measured(plan: Plan, one: complex, two: complex, mu_v: float) -> float:
    """A speed measured on the velocity plan."""
    return plan.hand.read(abs(two - one) * mu_v) / mu_v


def normal_part(
    plan: Plan, task: Task, leg: Leg, speeds: Mapping[str, complex], mu_v: float, start: complex
) -> complex:
    """Lays off a^n = v²/l towards the hinge."""
    name = f"n_{task.new}{leg.hinge}"
    inward = plan.at(leg.hinge) - plan.at(task.place)
    speed = measured(plan, speeds[leg.known], speeds[task.new], mu_v)
    if plan.is_now("normal_wrong_velocity", name):
        wrong = [abs(speeds[t]) for t in speeds if abs(speeds[t]) > 0 and abs(abs(speeds[t]) - speed) > 0.05 * speed]
        speed = wrong[0] if wrong else 0.0
    size = speed**2 / abs(plan.m.place(leg.hinge) - plan.m.place(task.place)) * plan.mu
    if plan.is_now("normal_outward", name):
        size = -size
    if start != 0 and plan.is_now("normal_from_pole", name):
        start = 0j
    if plan.is_now("normal_missing", name):
        return start
    end = plan.hand.mark(start + plan.hand.ray(inward) * size)
    plan.sheet.marks[name] = end
    return end


def coriolis_part(
    plan: Plan, task: Task, leg: Leg, speeds: Mapping[str, complex], mu_v: float, start: complex
) -> complex:
    """Lays off a^k = 2ωv, the relative velocity rotated by 90° in the sense of ω."""
    name = f"k_{task.new}{leg.known}"
    along = plan.m.direction(leg.guide) * drawn_turn(plan, leg)
    relative = speeds[task.new] - speeds[leg.known]
    sliding = plan.hand.read((relative * along.conjugate()).real * mu_v) / mu_v
    omega = plan.m.rate(leg.guide) * (1 + plan.hand.care.ruler / 60 * plan.hand.rng.gauss(0, 1))
    if plan.is_now("coriolis_wrong_omega", name):
        omega = float(plan.m.scene["drive"].get("omega", 0.0))
    size, u = 2 * omega * sliding * plan.mu, 1j * along
    if plan.is_now("coriolis_reversed", name):
        size = -size
    if plan.is_now("coriolis_half", name):
        size = size / 2
    if plan.is_now("coriolis_along_guide", name):
        u = along
    if plan.is_now("coriolis_missing", name):
        return start
    end = plan.hand.mark(start + plan.hand.ray(u) * size)
    plan.sheet.marks[name] = end
    return end


Draw = Callable[[Mistake | None, Hand], Sheet]
