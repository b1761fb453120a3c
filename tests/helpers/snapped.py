"""Scenes with one exact coincidence: random numbers practically never have one, and teachers try them first.

``snapped`` makes one of a family; ``faults`` lists the faults of the program's result: a traceback, a NaN, a number
that differs from the independent solver's, a direction of a zero vector, a rejection of a solvable scene.
"""

from __future__ import annotations

import contextlib
import csv
import io
import json
import math
import random
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from planes.batch.cycle import Cycle
from planes.cli import main
from planes.plans import plans_of
from planes.scene import loads
from planes.solving import Position, Solved, solve
from planes.words.errors import PlanesError
from tests.helpers.comparing import differences, draw, expected, plain, pose, standing
from tests.helpers.mechanisms import KINDS, Case, make, to_yaml
from tests.helpers.oracle import NoSolution, Solution
from tests.helpers.oracle import solve as solved_apart

NEAR = 1e-9  # of the largest number of its kind, times the sharpness
SINGULAR = 1e7  # a condition number above which the independent solver is unreliable, and an answer needs a warning
NOTHING = 1e-12  # of the largest of its kind: it has no direction
LEAST_FAULT = 1e-6  # of a value: a smaller error need not be detected


@dataclass(frozen=True)
class Snapped:
    """The text of a scene, its family, and whether it always has an answer."""

    family: str
    text: str
    answered: bool = True


def _two(rng: random.Random, low: float, high: float) -> float:
    return round(rng.uniform(low, high), 2)


def _four_bar(crank: float, rod: float, rocker: float, base: float, phi: float, side: str, more: str = "") -> str:
    return (
        f"planes: 1\nframe: {{points: {{O: [0, 0], D: [{base!r}, 0]}}}}\nlinks:\n"
        f"  1: {{points: {{O: 0, A: {crank!r}}}, mass: 1, inertia: 0.1}}\n"
        f"  2: {{points: {{A: 0, B: {rod!r}, E: [{rod / 2!r}, 0.1]}}, centre: E, mass: 2, inertia: 0.2}}\n"
        f"  3: {{points: {{D: 0, B: {rocker!r}}}, mass: 1.5, inertia: 0.1}}\n"
        f"assembly: {{B: {side}}}\ndrive: {{link: 1, phi: {phi!r}, omega: 7, epsilon: 3}}\ngravity: 9.81\n{more}"
    )


def _crank_slider(crank: float, rod: float, guide: str, phi: float, more: str = "", mass: str = ", mass: 2") -> str:
    return (
        f"planes: 1\nframe: {{points: {{O: [0, 0]}}, guides: {{x-x: {guide}}}}}\nlinks:\n"
        f"  1: {{points: {{O: 0, A: {crank!r}}}{mass}}}\n"
        f"  2: {{points: {{A: 0, B: {rod!r}}}{mass}}}\n  3: {{points: {{B: 0}}, slides: x-x{mass}}}\n"
        f"assembly: {{B: ahead}}\ndrive: {{link: 1, phi: {phi!r}, omega: 7, epsilon: 3}}\n{more}"
    )


def _rhombus(rng: random.Random) -> Snapped:
    a = _two(rng, 0.2, 1)
    phi = rng.choice((0.0, 60.0, 90.0, 180.0, _two(rng, 10, 170)))
    return Snapped("rhombus", _four_bar(a, a, a, a, phi, rng.choice(("left", "right"))), False)


def _parallelogram(rng: random.Random) -> Snapped:
    a, b = _two(rng, 0.1, 0.4), _two(rng, 0.5, 1)
    phi = rng.choice((0.0, 180.0, 90.0, _two(rng, 20, 160)))
    return Snapped("parallelogram", _four_bar(a, b, a, b, phi, "left"), phi % 180 != 0)


def _touching(rng: random.Random) -> Snapped:
    a, b, c = (_two(rng, 0.1, 1) for _ in range(3))
    phi = rng.choice((0.0, 180.0))
    reach = b + c if rng.random() < 0.5 else abs(b - c)
    text = _four_bar(a, b, c, reach + (a if phi == 0 else -a), phi, rng.choice(("left", "right")))
    return Snapped("arcs touch", text + rng.choice(("", "find: [r_B]\n", "find: [r_E, phi_2]\n")), False)


def _shared_guide(rng: random.Random) -> Snapped:
    a, b, phi = _two(rng, 0.1, 0.3), _two(rng, 0.6, 1), rng.choice((30.0, 90.0, _two(rng, 0, 360)))
    text = (
        f"planes: 1\nframe: {{points: {{O: [0, 0]}}, guides: {{x-x: {{y: 0}}}}}}\nlinks:\n"
        f"  1: {{points: {{O: 0, A: {a!r}, C: {-a!r}}}}}\n  2: {{points: {{A: 0, B: {b!r}}}, mass: 1}}\n"
        f"  3: {{points: {{B: 0}}, slides: x-x, mass: 2}}\n  4: {{points: {{C: 0, D: {b!r}}}, mass: 1}}\n"
        f"  5: {{points: {{D: 0}}, slides: x-x, mass: 2}}\nassembly: {{B: ahead, D: ahead}}\n"
        f"drive: {{link: 1, phi: {phi!r}, omega: 7}}\ngravity: 9.81\n"
        f"loads: [{{link: 3, point: B, force: 50, direction: 180}}, {{link: 5, point: D, force: 50, direction: 180}}]\n"
    )
    return Snapped("shared guide", text)


def _parallel_guides(rng: random.Random) -> Snapped:
    """A plate on two parallel guides and a rod, posed first."""
    turn, way = rng.choice((0.0, math.pi / 2, rng.uniform(-3, 3))), rng.choice((0, 90, 30, round(rng.uniform(0, 180))))
    z, u = complex(np.exp(1j * turn)), complex(np.exp(1j * math.radians(way)))
    b, c, d = (0.5 + 0.4j + z * w for w in (0, complex(0.1, 0.25), complex(_two(rng, 0.3, 0.5), -0.05)))
    a = complex(np.exp(1j * math.radians(70))) * 0.1
    one, two = (f"{{through: [{p.real!r}, {p.imag!r}], angle: {way}}}" for p in (c - 0.3 * u, d + 0.2 * u))
    offset = (u.conjugate() * (d - c)).imag
    shared = rng.random() < 0.4
    slide = f"{{guide: a-a, offset: {offset!r}}}" if shared else "b-b"
    text = (
        f"planes: 1\nframe: {{points: {{O: [0, 0]}}, guides: {{a-a: {one}, b-b: {two}}}}}\nlinks:\n"
        f"  1: {{points: {{O: 0, A: 0.1}}}}\n  2: {{points: {{A: 0, B: {abs(b - a)!r}}}, mass: 1}}\n"
        f"  3: {{points: {{B: 0, C: [0.1, 0.25], D: [{((d - b) / z).real!r}, {((d - b) / z).imag!r}]}}, mass: 3}}\n"
        f"  4: {{points: {{C: 0}}, slides: a-a}}\n  5: {{points: {{D: 0}}, slides: {slide}}}\n"
        f"assembly: {{B: {{near: [{b.real!r}, {b.imag!r}]}}}}\ndrive: {{link: 1, phi: 70, omega: 5}}\ngravity: 9.81\n"
    )
    return Snapped("parallel guides", text.replace(f", b-b: {two}", "") if shared else text, False)


def _through_pivot(rng: random.Random) -> Snapped:
    a, phi = _two(rng, 0.1, 0.4), rng.choice((0.0, 90.0, 45.0, 180.0, _two(rng, 0, 360)))
    if rng.random() < 0.5:  # a rod as long as the crank: at a right angle the slider is on the pivot
        return Snapped("guide through the pivot", _crank_slider(a, a, "{through: O, angle: 0}", phi), False)
    base = rng.choice((0.0, a))  # the rocker's pivot on the crank's, or on the circle of its pin
    text = (
        f"planes: 1\nframe: {{points: {{O: [0, 0], D: [{base!r}, 0]}}}}\nlinks:\n"
        f"  1: {{points: {{O: 0, A: {a!r}}}, mass: 1}}\n  2: {{points: {{A: 0}}, slides: DE, mass: 1}}\n"
        f"  3: {{points: {{D: 0, E: 0.7}}, guides: {{DE: {{through: D, angle: 0}}}}, mass: 2, centre: E}}\n"
        f"assembly: {{DE: ahead}}\ndrive: {{link: 1, phi: {phi!r}, omega: 7}}\ngravity: 9.81\n"
    )
    return Snapped("guide through the pivot", text, False)


def _zero_sum(rng: random.Random) -> Snapped:
    force, way = _two(rng, 10, 500), rng.choice((0, 30, 90, 217))
    more = "loads:\n" + "".join(
        f"  - {{link: 3, point: B, force: {force!r}, direction: {turn}}}\n" for turn in (way, way + 180)
    )
    text = _crank_slider(0.1, 0.4, "{y: 0.05}", _two(rng, 0, 360), more, rng.choice(("", ", mass: 2")))
    return Snapped("zero sums", text.replace("omega: 7, epsilon: 3", rng.choice(("omega: 7, epsilon: 3", "omega: 7"))))


def _static(rng: random.Random) -> Snapped:
    """A dyad or a triad connected only to the frame, beside a crank-slider."""
    moving = _crank_slider(0.1, 0.4, "{y: 0}", rng.choice((0.0, 90.0, _two(rng, 0, 360))), "gravity: 9.81\n")
    if rng.random() < 0.6:
        points = "O: [0, 0], P: [0.5, 0.3], Q: [0.9, 0.3]"
        links = "  6: {points: {P: 0, R: 0.3}, mass: 1}\n  7: {points: {Q: 0, R: 0.3}, mass: 1}\n"
        side = f"R: {rng.choice(('left', 'right'))}"
    else:
        points = "O: [0, 0], V: [0.06, -0.39], Y: [0.49, -0.563], W: [0.073, 0.156]"
        links = (
            "  6: {points: {Y: 0, L: 0.75}}\n  7: {points: {X: 0, G: [0.6, 0.3], L: [0.2, -0.4]}, mass: 3, centre: X}\n"
            "  8: {points: {V: 0, G: 0.64}}\n  9: {points: {X: 0}, slides: k}\n"
        )
        side, moving = (
            "X: {near: [0.05, 0.17]}",
            moving.replace("x-x: {y: 0}", "k: {through: W, angle: -32}, x-x: {y: 0}"),
        )
    text = (
        moving.replace("O: [0, 0]", points)
        .replace("assembly:", f"{links}assembly:")
        .replace("B: ahead", f"B: ahead, {side}")
    )
    return Snapped("a static group", text)


def _on_its_guide(rng: random.Random) -> Snapped:
    """A slider's hinge at the defining point of its guide."""
    a, b, phi = _two(rng, 0.1, 0.3), _two(rng, 0.5, 1), rng.choice((0.0, 180.0))
    at = (a if phi == 0 else -a) + b
    guide = rng.choice((f"{{through: [{at!r}, 0], angle: 0}}", "{y: 0}", "{through: O, angle: 0}"))
    more = rng.choice(("", "friction: {x-x: 0.1}\n", "loads: [{link: 3, point: B, force: 40, against: motion}]\n"))
    return Snapped("a hinge on its guide", _crank_slider(a, b, guide, phi, "gravity: 9.81\n" + more))


def _at_rest(rng: random.Random) -> Snapped:
    case = make(rng, rng.choices(KINDS, k=rng.choice((1, 2))), rest=True, sliding=False)
    if rng.random() < 0.5:
        case.scene["drive"]["epsilon"] = 0.0
    return Snapped("at rest", to_yaml(case.scene), False)


def _rounded(value: Any, grid: float, key: str = "") -> Any:
    """The numbers of a scene on a coarse grid; angles at multiples of 15°."""
    if isinstance(value, dict):
        return {k: v if k in ("assembly", "planes") else _rounded(v, grid, k) for k, v in value.items()}
    if isinstance(value, list):
        return [_rounded(v, grid, key) for v in value]
    if not isinstance(value, float):
        return value
    step = 15.0 if key in ("angle", "phi", "direction") else 1.0 if key in ("omega", "epsilon", "force") else grid
    return round(value / step) * step


def _repeated(rng: random.Random) -> Snapped:
    """A random scene on a coarse grid: lengths, positions, angles and offsets that are equal or zero."""
    while True:
        case = make(rng, rng.choices(KINDS, k=rng.choice((1, 1, 2))), sliding=False, assembly="near")
        scene = _rounded(case.scene, rng.choice((0.1, 0.25)))
        try:
            sol = solved_apart(scene, case.guess)
        except (NoSolution, np.linalg.LinAlgError, ZeroDivisionError):
            continue
        near = {k: z for k in scene["assembly"] if k in sol.points for z in [sol.points[k][0]]}
        if len(near) == len(scene["assembly"]):
            scene["assembly"] = {k: {"near": [z.real, z.imag]} for k, z in near.items()}
            return Snapped("repeated numbers", to_yaml(scene), False)


def _vectors(rng: random.Random) -> Snapped:
    """Stated vectors that add up to zero, have equal lengths, or whose arcs touch."""
    p, way = _two(rng, 1, 9), rng.choice((0, 30, 90, _two(rng, -180, 180)))
    rows = [f"P_1: {{value: {p!r}, direction: {way!r}}}"]
    style = rng.randrange(4)
    if style == 0:
        rows += [
            f"P_2: {{value: {p!r}, direction: {way + 180!r}}}",
            "P_3: {}",
            "P_4: {value: 2, direction: P_3}",
            "P_5: {}",
        ]
        equations = ["P_3 = P_1 + P_2", "P_5 = P_4 + P_1"]
    elif style == 1:
        rows += [f"P_2: {{value: {p / 2!r}, near: {way!r}}}", f"P_3: {{value: {p / 2!r}}}"]
        equations = ["P_1 + P_2 + P_3 = 0"]
    elif style == 2:
        rows += [f"P_2: {{value: {p!r}, near: {way + rng.choice((180, 120, 60, 0))!r}}}", f"P_3: {{value: {p!r}}}"]
        equations = ["P_1 + P_2 + P_3 = 0"]
    else:
        rows += [
            f"P_2: {{value: {p!r}, direction: {way + 180!r}}}",
            f"P_3: {{direction: {way + 90!r}}}",
            "P_4: {direction: 77}",
        ]
        equations = ["P_1 + P_2 + P_3 + P_4 = 0"]
    listed = "".join(f"  {row}\n" for row in rows)
    return Snapped("stated vectors", f"planes: 1\nvectors:\n{listed}equations: {json.dumps(equations)}\n", False)


FAMILIES: tuple[Callable[[random.Random], Snapped], ...] = (
    _rhombus,
    _parallelogram,
    _touching,
    _shared_guide,
    _parallel_guides,
    _through_pivot,
    _zero_sum,
    _static,
    _on_its_guide,
    _at_rest,
    _repeated,
    _vectors,
)


def snapped(seed: int) -> Snapped:
    """A scene of the next family."""
    return FAMILIES[seed % len(FAMILIES)](random.Random(f"snapped {seed}"))


# faults


def faults(one: Snapped) -> Iterator[str]:
    """The faults of a position, and of a run of them."""
    try:
        found = solve(loads(one.text, "s.yaml"))
    except PlanesError as refused:
        yield from _sentence(str(refused), one.answered)
        return
    for failure in found.failed:
        yield from _sentence(failure["error"], one.answered)
    for position in found.positions:
        yield from _numbers(found, position)
        if found.plans.has_mechanism:
            yield from _against(one.text, position)
    if found.plans.has_mechanism:
        yield from _run(re.sub(r"(?m)^find:.*\n", "", one.text))


def _sentence(text: str, answered: bool) -> Iterator[str]:
    if answered:
        yield f"refused: {text}"
    if "\n" in text or re.search(r"\b(nan|inf|None)\b", text):
        yield f"no sentence: {text}"


def _numbers(found: Solved, position: Position) -> Iterator[str]:
    try:
        json.dumps(found.json(), allow_nan=False)
    except ValueError as error:
        yield f"{error} in {position.results}"


def _truth(text: str) -> Solution | None:
    """The independent solution at the drawn pose; None if that is singular."""
    try:
        sol = solved_apart(plain(text), pose(draw(text)))
    except (NoSolution, np.linalg.LinAlgError, ZeroDivisionError):
        return None
    return sol if sol.condition < SINGULAR else None


def _against(text: str, position: Position) -> Iterator[str]:
    warned, scene = position.results["warnings"], plain(text)
    if scene.get("find"):  # parts of the plans are not compared
        return
    sol = _truth(text)
    if sol is None:
        if not warned:
            yield "an answer at a singular place without a warning"
        return
    case = Case(scene, {}, [], sol)
    if standing(case) or any("speed is zero" in said for said in warned):
        return
    d = draw(text)
    truth = {n.name: n for n in expected(sol, "phi" in scene["drive"])}
    loads_ = max([abs(row["force"]) for row in scene.get("loads") or () if "force" in row], default=0.0)
    idle = max(abs(n.value) for n in truth.values() if n.sort == "force") < NEAR * loads_  # what cancels, and rounding
    for name, error in differences(d, truth).items():
        if error * d.sharpest > NEAR and not (idle and truth[name].sort in ("force", "moment", "arm")):
            yield f"{name} is {error:.2g} off at sharpness {d.sharpest:.2g}"
    said = " ".join(warned)
    for letter, rate in (("v", 1), ("a", 2)):
        largest = max((abs(p[rate]) for p in sol.points.values()), default=0.0)
        for name, vector in (position.v if rate == 1 else position.a).items():
            faint = abs(sol.points[name][rate]) <= 1e-3 * NOTHING * largest < abs(vector) <= NOTHING * largest
            if faint and f"{letter}_{name}" not in said:
                yield f"{letter}_{name} is nothing and has a direction"


def _run(text: str) -> Iterator[str]:
    """Whether a run of positions has the numbers of each of them."""
    scene = loads(text, "s.yaml")
    assert scene.mechanism
    drive = scene.mechanism.drive
    values = [drive.position, drive.position + (37.0 if drive.kind == "phi" else 0.01), drive.position + 180.0]
    cycle = Cycle(plans_of(scene.mechanism))
    (block,) = cycle.blocks(np.array(values), fast=False, bare=True)
    there = {p.at: p for p in solve(scene, values).positions}
    for k, value in enumerate(values):
        if value not in there or block.codes[k]:
            continue
        many = dict(zip((c.name for c in cycle.columns), block.table[:, k], strict=True))
        told = [m for m in there[value].found if m.quantity.group in ("points", "links", "slides")]
        alone = {c.name: x for m in told for c, x in zip(m.quantity.columns, m.numbers, strict=True)}
        units = {c.name: c.unit for c in cycle.columns}
        sharp = min([1.0, *there[value].drawing.crossing_sharpness.values()])
        for name, x in alone.items():
            size = max([1.0, *(abs(y or 0.0) for n, y in alone.items() if units.get(n) == units.get(name))])
            if x is not None and name in many and not abs(_apart(x, many[name], units[name])) * sharp <= NEAR * size:
                yield f"at {value}: {name} is {x} alone and {many[name]} in a run"


def _apart(x: float, y: float, unit: str) -> float:
    return math.remainder(x - y, 360) if unit == "°" else x - y


# documents


def typed(*line: str) -> tuple[int, str, str]:
    """A command as typed: its exit status and its output."""
    out, err = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = main(line)
        except SystemExit as end:
            status = int(end.code or 0)
    return status, out.getvalue(), err.getvalue()


DOCUMENTS = ("sheet", "lesson", "note", "cycle", "check")


def document_faults(one: Snapped, command: str, folder: Path) -> Iterator[str]:
    """The faults of a document of a scene: ``sheet``, ``lesson``, ``note``, ``cycle`` or ``check``."""
    scene = folder / "s.yaml"
    scene.write_text(one.text, "utf-8")
    if command == "check":
        yield from _check_faults(scene)
        return
    written = {"sheet": "o.svg", "lesson": "o.html", "note": "o.html"}
    more = ["-o", str(folder / written[command])] if command in written else []
    status, out, err = typed(command, str(scene), "--lang", "en", *more)
    if status not in (0, 2) or (status == 2 and not err.strip()):
        yield f"{command}: ends with {status} and says {err!r}"
    text = out + (Path(more[1]).read_text("utf-8") if more and status == 0 and command == "sheet" else "")
    if bad := re.search(r".{0,40}(?<![\w.])(nan|inf|NaN|Infinity)(?![\w-]).{0,40}", text):
        yield f"{command}: {bad[0]}"
    if status == 2 and more and (folder / written[command]).exists():
        yield f"{command}: refused, and left a file"


def _check_faults(scene: Path) -> Iterator[str]:
    """A table of the true results is right, and one with a value three times as large is not."""
    try:
        found = solve(loads(scene.read_text("utf-8"), "s.yaml"))
    except PlanesError:
        return
    rows = [
        (m.quantity.name, m.number) for p in found.positions for m in p.found if m.quantity.key in ("omega", "epsilon")
    ]
    table = scene.with_name("t.csv")
    for factor, right in ((1.0, True), (3.0, False)):
        most = max((abs(x) for _, x in rows), default=0.0)
        changed = next((n for n, x in rows if abs(x) > 0.1 * most > LEAST_FAULT), None)
        if changed is None:
            return
        with table.open("w", encoding="utf-8", newline="") as file:
            out = csv.writer(file)
            out.writerow(("result", "value", "unit"))
            for name, x in rows:
                unit = "rad/s" if name.startswith("omega") else "rad/s²"
                out.writerow((name, repr(x * (factor if name == changed else 1.0)), unit))
        status, _, err = typed("check", str(scene), str(table), "--lang", "en")
        if status not in ((0, 3, 2) if right else (1, 3, 2)):
            yield f"check: {changed} times {factor} ends with {status} {err}"
        if status == 2 and not err.strip():
            yield "check: says nothing"
