"""Draws a scene at chosen scales and compares every number of it with the independent solution."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import yaml

from planes.drafting.drawing import Drawing, draw_program
from planes.plans import Plans, plans_of
from planes.plans.scales import plan_scales
from planes.scene import Scene, loads
from planes.words.names import Mark, scheme_mark
from tests.helpers.mechanisms import Case, to_yaml, unmoved
from tests.helpers.oracle import Solution, reaction_key, solve


@dataclass(frozen=True)
class Drawn:
    """A scene, its plans, their scales and the drawing."""

    scene: Scene
    plans: Plans
    mu: dict[str, float]
    drawing: Drawing

    def number(self, name: str) -> Any:
        return self.drawing[name] if name else 0.0

    def vector(self, start: Mark, end: Mark) -> Any:
        return (self.drawing[end] - self.drawing[start]) / self.mu[start.plan.mu_name]

    def place(self, mark: Mark) -> Any:
        return self.drawing[mark] / self.mu[mark.plan.mu_name]

    @property
    def sharpest(self) -> float:
        """The smallest sharpness of intersections in the drawing."""
        found = [s for name, s in self.drawing.crossing_sharpness.items() if not name.endswith(("+", "-"))]
        return float(min([1.0, *found]))


def draw(scene: Mapping[str, Any] | str, value: Any = None, mu: Mapping[str, float] | None = None) -> Drawn:
    """Draws a scene (its text or its numeric dict) at automatic scales, at one or more values of the drive."""
    read = loads(scene if isinstance(scene, str) else to_yaml(scene))
    assert read.mechanism
    plans = plans_of(read.mechanism)
    one = {plans.drive_given_name: value} if isinstance(value, (int, float)) else {}
    chosen = dict(mu or plan_scales(plans, read.mu, one))
    moved = {} if value is None else {plans.drive_given_name: value}
    return Drawn(read, plans, chosen, draw_program(plans.program, {**plans.given, **chosen, **moved}))


@dataclass(frozen=True)
class Number:
    """A quantity in SI: ``sort`` groups those of one unit (r, v, a, omega, epsilon, force, moment…)."""

    name: str
    sort: str
    value: complex


def numbers(d: Drawn) -> Iterator[Number]:
    """Every result of a drawing."""
    st = d.plans
    for name, marks in st.points.items():
        yield Number(f"r_{name}", "r", d.place(marks.position))
        yield Number(f"v_{name}", "v", d.place(marks.velocity))
        yield Number(f"a_{name}", "a", d.place(marks.acceleration))
    for name, values in st.links.items():
        if name != "0":
            yield Number(f"angle_{name}", "angle", d.number(values.angle))
            yield Number(f"omega_{name}", "omega", d.number(values.omega))
            yield Number(f"epsilon_{name}", "epsilon", d.number(values.epsilon))
    for name, reading in st.velocity_slides.items():
        quick = st.acceleration_slides[name]
        yield Number(f"slide_v_{name}", "v", d.number(reading.value))
        yield Number(f"slide_a_{name}", "a", d.number(quick.value))
        yield Number(f"coriolis_{name}", "a", d.vector(*quick.coriolis) if quick.coriolis else 0j)
    for key, r in st.reactions.items():
        yield Number(key, "force", d.vector(r.start, r.end))
        if r.pair.kind == "P":
            yield Number(f"moment_{key}", "moment", d.number(r.moment))
            yield Number(f"arm_{key}", "arm", d.number(r.arm))
    sort = "moment" if st.mechanism.drive.kind == "phi" else "force"
    yield Number("balancing", sort, d.number(st.balancing))
    yield Number("zhukovsky", sort, d.number(st.zhukovsky))


def expected(sol: Solution, revolving: bool) -> Iterator[Number]:
    """The same numbers from the independent solution."""
    for name, (r, v, a) in sol.points.items():
        yield Number(f"r_{name}", "r", r)
        yield Number(f"v_{name}", "v", v)
        yield Number(f"a_{name}", "a", a)
    for name, (angle, omega, epsilon) in sol.links.items():
        yield Number(f"angle_{name}", "angle", angle)
        yield Number(f"omega_{name}", "omega", omega)
        yield Number(f"epsilon_{name}", "epsilon", epsilon)
    for name, (v, a, coriolis) in sol.slides.items():
        yield Number(f"slide_v_{name}", "v", v)
        yield Number(f"slide_a_{name}", "a", a)
        yield Number(f"coriolis_{name}", "a", coriolis)
    for (i, j), reaction in sol.reactions.items():
        key = reaction_key(i, j)
        if not isinstance(reaction, tuple):
            yield Number(key, "force", reaction)
            continue
        yield Number(key, "force", reaction[0])
        yield Number(f"moment_{key}", "moment", reaction[2])
        yield Number(f"arm_{key}", "arm", math.nan if reaction[1] is None else reaction[1])
    for name in ("balancing", "zhukovsky"):
        yield Number(name, "moment" if revolving else "force", sol.balancing)


def sizes(found: Mapping[str, Number]) -> dict[str, float]:
    """The scale of every sort of number: the largest of its kind, but at least what follows from the others."""
    most = {
        sort: max([abs(n.value) for n in found.values() if n.sort == sort and n.value == n.value], default=0.0)
        for sort in ("r", "v", "a", "omega", "epsilon", "force", "moment")
    }
    places = [n.value for n in found.values() if n.sort == "r"]
    span = max(abs(p - q) for p in places for q in places)
    span = span if span > 1e-12 * most["r"] else most["r"] or 1.0  # all points coincide: scaled by their distance
    scale = {"r": max(most["r"], span), "angle": 180.0}
    turning, quick = most["omega"] * span, max(most["epsilon"], most["omega"] ** 2) * span
    scale["v"] = turning if most["v"] < 1e-12 * turning else most["v"]  # every point is on the pivot
    scale["a"] = quick if most["a"] < 1e-12 * quick else most["a"]
    scale["omega"] = max(most["omega"], most["v"] / scale["r"])
    scale["epsilon"] = max(most["epsilon"], most["a"] / scale["r"])
    scale["force"], scale["arm"] = most["force"], scale["r"]
    scale["moment"] = max(most["moment"], most["force"] * scale["r"])
    return scale


def differences(d: Drawn, truth: Mapping[str, Number]) -> dict[str, float]:
    """Relative differences by name: over the largest number of the same sort."""
    found = {n.name: n for n in numbers(d)}
    assert set(found) == set(truth), set(found) ^ set(truth)
    scale, out = sizes(truth), {}
    for name, want in truth.items():
        got, size = found[name].value, scale[want.sort] or 1.0
        error = abs(got - want.value) / size
        if want.sort == "angle":
            error = abs(math.remainder((got - want.value).real, 360)) / size
            assert -180 < got.real <= 180
        if want.sort == "arm":  # as accurate as the normal force in its denominator
            normal = abs(d.number(d.plans.reactions[name.removeprefix("arm_")].normal))
            if not normal > 1e-3 * scale["force"]:
                continue
            error *= normal / scale["force"] / max(1.0, abs(want.value) / size)
        out[name] = error
    return out


def against(case: Case, text: str | None = None) -> tuple[Drawn, dict[str, float]]:
    """A random mechanism drawn (from a text of its file), and its differences from the independent solution."""
    drive = case.scene["drive"]
    d = draw(text or case.scene)
    truth = {n.name: n for n in expected(case.solution, "phi" in drive)}
    return d, differences(d, truth)


def turned_about(d: Drawn, case: Case) -> dict[str, float]:
    """The same for an inner drive, where the two may state a reaction on either link of a pair."""
    keys, truth = {*d.plans.reactions}, {}
    for n in expected(case.solution, "phi" in case.scene["drive"]):
        head, _, key = n.name.rpartition("F_")
        other = "F_" + "_".join(key.split("_")[::-1]) if "_" in key else f"F_{key[::-1]}"
        if key and "F_" in n.name and f"F_{key}" not in keys and other in keys:
            n = Number(head + other, n.sort, n.value if n.sort == "arm" else -n.value)
        truth[n.name] = n
    return differences(d, truth)


def standing(case: Case) -> bool:
    """Whether a part whose sense of motion matters (a rubbing slider) is at rest except for rounding."""
    friction, sol = case.scene.get("friction", {}), case.solution
    quick = max([abs(v) for v in sol.speeds.values()], default=0.0)
    if any(sol.guides[i][0] in friction and abs(v) < 1e-9 * quick for i, v in sol.speeds.items()):
        return True
    omegas = {n: w for n, (_, w) in sol.motion.items()}
    span = max(abs(r) for r, _, _ in sol.points.values())
    most = max([*map(abs, omegas.values()), *(abs(v) / span for v, _ in sol.motion.values())])  # all may only slide
    straight = {guide for guide, _, _ in sol.guides.values()}
    pins = any(name not in straight for name in friction)
    return pins and any(abs(omegas[i] - omegas[j]) < 1e-9 * most for i, j in sol.hinges if not unmoved(sol, i, j))


def closing_mm(d: Drawn) -> float:
    """The largest closing error of all stated equations of a drawing, in mm: the sum of the vectors as read."""
    worst = 0.0
    for e in d.plans.equations:
        sums = []
        for chain in e.chains:
            parts = [d.drawing[f"{e.plan}:{t.end}"] - d.drawing[f"{e.plan}:{t.start}"] for t in chain]
            sums.append(sum(parts, 0j))
        if e.chains[0] and e.chains[1]:
            worst = max(worst, abs(sums[0] - sums[1]))
        elif not e.total and e.chains[0]:
            worst = max(worst, abs(sums[0]))
    return worst


def measured_closing_mm(d: Drawn) -> float:
    """The same from measured or given values: each vector as its length (SI) along its direction."""
    worst, st = 0.0, d.plans
    made = d.drawing.things
    for e in st.equations:
        if e.plan == "position":
            continue
        total, sign_of = 0j, (1, -1)
        for chain, sign in zip(e.chains, sign_of, strict=True):
            for t in chain:
                length = t.length or t.name
                if t.direction and length in made and not t.drawn:
                    total += sign * t.sign * d.mu["mu_" + e.plan] * made[length] * made[t.direction]
                else:
                    total += sign * (d.drawing[f"{e.plan}:{t.end}"] - d.drawing[f"{e.plan}:{t.start}"])
        if e.chains[1] or not e.total:
            worst = max(worst, abs(total))
    return worst


def power(d: Drawn) -> tuple[float, float]:
    """(sum, largest term) of F·v + M·ω over all external actions, friction and balancing, as measured."""
    st, terms = d.plans, []
    motion = st.acting.motion
    assert motion
    for forces in st.acting.forces.values():
        for f in forces:
            if f.spot:
                rate = d.place(motion.mark(f.spot.name))
                terms.append((rate.conjugate() * d.number(f.size) * d.number(f.along)).real)
    for couples in st.acting.couples.values():
        for c in couples:
            root = motion.bodies.known[c.link].root
            if root != "0" and not c.handed:
                terms.append(c.sign * d.number(c.value) * d.number(motion.spin(root)))
    drive = st.mechanism.drive
    rate = 1.0 if st.at_rest else drive.velocity
    for r in st.reactions.values():
        if r.pair.kind == "R" and r.friction:
            turning = [motion.spin(motion.bodies.known[x].root) for x in (r.pair.link, r.pair.other)]
            apart = [0.0 if name.endswith("_0") else d.number(name) for name in turning]
            terms.append(d.number(r.friction) * (apart[0] - apart[1]))
        if r.pair.kind == "P" and r.pair.guide in st.mechanism.friction:
            slide = motion.slides.get(r.pair.link)
            along = d.number(f"∥{r.pair.guide}")
            rub = (d.vector(r.start, r.end) * along.conjugate()).real
            terms.append(rub * (d.number(slide.value) if slide else rate))
    terms.append(d.number(st.balancing) * rate)
    return math.fsum(terms), max(abs(t) for t in terms)


def balanced(d: Drawn, case: object = "") -> None:
    """Asserts that the powers of a drawing add up to zero, and its polygons close, except for rounding."""
    total, largest = power(d)
    assert abs(total) * d.sharpest <= 1e-10 * largest, (case, total, largest)
    assert closing_mm(d) <= 1e-9, case


def pose(d: Drawn) -> dict[str, tuple[float, float, float]]:
    """The origin and rotation (rad) of every link, as drawn: the initial guess of the independent solution."""
    out, mechanism = {}, d.plans.mechanism
    for name, link in mechanism.links.items():
        turn = math.radians(d.number(d.plans.links[name].angle))
        point, local = next(iter(link.points.items()))
        origin = d.place(scheme_mark(point)) - local * cmath.rect(1.0, turn)
        out[name] = (origin.real, origin.imag, turn)
    return out


def plain(text: str) -> dict[str, Any]:
    """A scene file without expressions as the numeric dict of the independent solution."""

    def keyed(node: Any) -> Any:
        if isinstance(node, dict):
            return {str(k): keyed(v) for k, v in node.items()}
        return [keyed(v) for v in node] if isinstance(node, list) else node

    scene: dict[str, Any] = keyed(yaml.safe_load(text))
    for body in (scene["frame"], *scene["links"].values()):
        body["guides"] = {
            k: g if "through" not in g else {"angle": 0, **g} for k, g in (body.get("guides") or {}).items()
        }
    return scene


def checked(text: str, value: float | None = None) -> tuple[Drawn, dict[str, float]]:
    """A scene drawn, and its differences from the independent solution started at the drawn pose."""
    d, scene = draw(text, value), plain(text)
    kind = d.plans.mechanism.drive.kind
    if value is not None:
        scene["drive"][kind] = value
    guess = pose(d)
    sol = solve(scene, guess)
    size = max(abs(r) for r, _, _ in sol.points.values())
    for name, (x, y, turn) in guess.items():
        x2, y2, turn2 = sol.pose[name]
        assert abs(complex(x - x2, y - y2)) <= 1e-9 * size / d.sharpest and abs(turn - turn2) < 1e-9 / d.sharpest
    truth = {n.name: n for n in expected(sol, kind == "phi")}
    return d, differences(d, truth)
