"""Random mechanisms that mix features of the format: laws of loads, friction, arcs, cylinders, classes II and III."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from tests.helpers.comparing import standing
from tests.helpers.mechanisms import KINDS, Case, make
from tests.helpers.oracle import NoSolution, Solution, solve
from tests.helpers.oracle_pins import circle_of

LEADS = ("RR", "PR", "RP")
FEATURES = (
    "an expression",
    "a table",
    "strokes",
    "friction in hinges",
    "friction on straight guides",
    "friction on arcs",
    "arcs",
    "a cylinder",
    "class III",
    "an arc in class III",
    "friction beside class III",
    *KINDS,
)


def motion(rng: random.Random, scene: dict[str, Any], sol: Solution) -> str:
    """A quantity of about 1, from a name of the motion, in many forms."""
    sizes = {f"{x}_{n}": v for n, (v, a, _) in sol.slides.items() for x, v in (("v", v), ("a", a), ("s", sol.slid[n]))}
    for n, (_, omega, epsilon) in sol.links.items():
        sizes |= {f"omega_{n}": omega, f"epsilon_{n}": epsilon}
    for p, (r, v, a) in sol.points.items():
        if any(p in link["points"] for link in scene["links"].values()):
            sizes |= {f"x_{p}": r.real, f"y_{p}": r.imag, f"v_{p}": abs(v), f"a_{p}": abs(a)}
    sizes = {n: v if abs(v) > 1e-9 else 0.0 for n, v in sizes.items()}  # values of rounding only are zero
    largest = {x: max(abs(v) for n, v in sizes.items() if n[0] == x) for x in {n[0] for n in sizes}}
    name = rng.choice(sorted(sizes))
    ratio = f"({name}/{largest[name[0]] or 1.0!r})"
    root = "" if abs(sizes[name]) > 1e-9 * largest[name[0]] else " + 0.1"  # a root of rounding has no effect
    angle = rng.choice([f"phi_{n}" for n in sol.links])
    ways = [ratio, f"{ratio}^2", f"(1 + {ratio}^2)^-1.5", f"sqrt(abs{ratio}{root})", f"hypot({ratio}, 0.5)"]
    ways += [f"max({ratio}, 0.25)", f"min(1/(2 + {ratio}), 0.4)", f"(sin({angle}) - cos(2*{angle})/3)"]
    return rng.choice(ways)


def law(rng: random.Random, scene: dict[str, Any], sol: Solution, link: str, most: float) -> Any:
    """A number of a load as a law of any form."""
    text = f"{most * rng.uniform(-1, 1)!r} + {most!r}*{motion(rng, scene, sol)}*{motion(rng, scene, sol)}"
    if (way := rng.random()) < 0.5:
        return text
    if way < 0.75:
        xs = [-5.0, -0.7, rng.uniform(-0.5, 0.5), 0.8, 5.0]
        return {"over": motion(rng, scene, sol), "table": [[x, most * rng.uniform(-1, 1)] for x in xs]}
    moving = [n for n, v in sol.speeds.items() if abs(v) > 1e-6 * max(map(abs, sol.speeds.values()))]
    if not moving:
        return text
    slider = rng.choice(moving)
    return {"working": text, "idle": most / 10, "slider": slider, "stroke": rng.choice(("ahead", "behind"))}


def lawful(seed: int, kinds: Sequence[str], **options: Any) -> Case:
    """A random mechanism with laws for its loads."""
    rng = random.Random(seed)
    return with_laws(rng, make(rng, kinds, **options))


def with_laws(rng: random.Random, case: Case) -> Case:
    """The mechanism with laws for its loads."""
    scene = {**case.scene, "loads": [dict(load) for load in case.scene["loads"]]}
    for load in scene["loads"]:
        key = "force" if "force" in load else "moment"
        load[key] = law(rng, scene, case.solution, load["link"], abs(load[key]))
        if isinstance(load.get("direction"), float) and rng.random() < 0.5:
            load["direction"] = f"90 + 40*{motion(rng, scene, case.solution)}"
    return replace(case, scene=scene, solution=solve(scene, case.guess))


def mixed(seed: int) -> Case:
    """A mechanism with any mixture of laws, friction, arcs, a cylinder and groups of classes II and III."""
    rng = random.Random(f"mixed {seed}")
    for _ in range(50):
        kinds = rng.choices(KINDS, k=rng.choice((0, 1, 2, 2, 3)))
        if rng.random() < 0.3:
            kinds.insert(rng.randint(0, len(kinds)), "-".join(rng.choices(LEADS, k=3)))
        how: dict[str, Any] = {"inner": rng.random() < 0.35, "arcs": rng.random() < 0.8, "rest": rng.random() < 0.1}
        rubs: dict[str, Any] = {"pins": rng.random() < 0.6, "friction": rng.random() < 0.5}
        try:
            case = with_laws(rng, make(rng, kinds, **how, **rubs, limit=1e6))
        except NoSolution:  # friction locks under the loads of these laws
            continue
        if case.solution.consistent == 1 and not standing(case):
            return case
    raise NoSolution(f"no mixture was drawn from {seed}")


def features_of(case: Case) -> set[str]:
    """The ``FEATURES`` mixed in a scene."""
    scene, said = case.scene, case.scene.get("friction", {})
    laws = [load[k] for load in scene["loads"] for k in ("force", "moment", "direction") if k in load]
    arcs = {n: c for n in scene["links"] if (c := circle_of(scene, n))}
    dyads, triads = {kind for kind, _, _ in case.groups}, [g for g in case.solution.groups if len(g) == 4]
    in_triads = {n for g in triads for n in g}
    found = (
        any(isinstance(x, str) for x in laws),
        any(isinstance(x, dict) and "table" in x for x in laws),
        any(isinstance(x, dict) and "working" in x for x in laws),
        any(isinstance(x, dict) for x in said.values()),
        bool(said.keys() & {g for g, _, _ in case.solution.guides.values()}),
        bool(said.keys() & {name for name, _, _ in arcs.values()}),
        bool(arcs),
        "s" in scene["drive"] and case.solution.guides[scene["drive"]["link"]][1] != "0",
        bool(triads),
        bool(arcs.keys() & in_triads),
        bool(triads and said),
        *(kind in dyads for kind in KINDS),
    )
    return {name for name, true in zip(FEATURES, found, strict=True) if true}
