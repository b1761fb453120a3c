"""The scenes of `samples/` read and solved without the package: their expected results come from here.

`numeric` is a reader of its own for scene files (PyYAML's base loader and Python's own arithmetic), `truth` the
independent solver started from a pose estimated by hand, `save` rewrites samples/expected/*.json of the scenes
that no publication gives results for:  python -m tests.sample_oracle
"""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterator, Mapping
from functools import partial
from typing import Any

import yaml

from tests.helpers import ROOT
from tests.helpers.equilibrium import expected
from tests.helpers.higher_poses import POSES
from tests.helpers.oracle import Pose, Solution, follow, reaction_key, solve

SAMPLES = ROOT / "samples"
EXPECTED = SAMPLES / "expected"

# Place of the origin (m) and turn (degrees) of every link, read off a sketch.
SKETCHES: dict[str, dict[str, Pose]] = {
    "six-link": {
        "1": (0, 0, 150),
        "2": (-0.09, 0.05, -145),
        "3": (-0.35, -0.27, 83),
        "4": (-0.42, 0, 125),
        "5": (-0.42, 0, 90),
    },
    "assignment-12": {
        "1": (0, 0, 245),
        "2": (-0.04, -0.09, -3),
        "3": (0.15, -0.1, -3),
        "4": (0.4, -0.11, 0),
        "5": (0.35, -0.11, 90),
    },
    "bntu-1": {"1": (0, 0, 75), "2": (0.02, 0.08, -15), "3": (0.31, 0, 0)},
    "bntu-2": {"1": (0, 0, 90), "2": (0, 0.07, -13), "3": (0.29, 0, 0)},
    "bntu-3": {"1": (0, 0, 0), "2": (0.2, 0, 60), "3": (0, -0.35, 60)},
    "bntu-4": {"1": (0, 0, 90), "2": (0, 0.1, -19), "3": (0.28, 0, 0)},
    "bntu-5": {"1": (0, 0, -8), "2": (0.1, -0.014, -8), "3": (0.5, -0.07, 0)},
    "kind-1-rrr": {"1": (0, 0, 310), "2": (0.08, -0.09, 93), "3": (-0.24, 0.3, -10)},
    "kind-2-rrp": {"1": (0, 0, 15), "2": (0.06, 0.015, 68), "3": (0.13, 0.2, 60)},
    "kind-3-rpr": {"1": (0, 0, 20), "2": (0.11, 0.04, 71), "3": (0, -0.28, 71)},
    "kind-4-prp": {"1": (0, 0, -5), "2": (0.31, 0.05, 15), "3": (0.31, 0.05, 80)},
    "kind-5-rpp": {"1": (0, 0, 50), "2": (0.06, 0.08, 75), "3": (0.04, 0, 0)},
    "shaper": {"1": (0, 0, 60), "2": (0.06, 0.1, 83), "3": (0, -0.4, 83), "4": (0.09, 0.34, -2), "5": (0.39, 0.33, 0)},
    "lift": {"1": (0.9, -0.5, 82), "2": (1.05, 0.6, 82), "3": (0, 0, 29)},
    "hinge-motor": {"1": (0, 0, -10), "2": (0.3, -0.05, 85), "3": (0.6, 0.1, 132)},
    "carriage": {"1": (0.13, 0, 0), "2": (0.13, 0, 55), "3": (0.9, 0.05, 143)},
    "folding-boom": {
        "1": (-0.05, 0.2, 35),
        "2": (0.32, 0.46, 35),
        "3": (0, 0, 90),
        "4": (0, 0.5, 12),
        "5": (1, 0.1, 111),
    },
    "excavator": {
        "1": (0, 0, 38),
        "2": (0.6, -0.3, 72),
        "3": (0.53, 0.94, 40),
        "4": (1.52, 1.78, 40),
        "5": (2.04, 1.62, 4),
    },
    "friction-circles": {"1": (0, 0, 65), "2": (0.04, 0.09, -13), "3": (0.43, 0, 0)},
    "sliding-driver": {"1": (0.15, 0, 0), "2": (0.15, 0, 65), "3": (0.45, 0.12, 128)},
    **POSES,
}
KINDS = ("kind-1-rrr", "kind-2-rrp", "kind-3-rpr", "kind-4-prp", "kind-5-rpp")
INSIDE = ("lift", "hinge-motor", "carriage", "folding-boom", "excavator")
HIGHER = tuple(POSES)
UNPUBLISHED = (*KINDS, "shaper", "sliding-driver", *INSIDE, "friction-circles")
WORDS = ("title", "note", "plans", "assembly", "parameters", "variants", "planes", "find", "sheet")


def degrees(f: Any) -> Any:
    """A function of an angle in degrees."""
    return lambda x: f(math.radians(x))


FUNCTIONS: dict[str, Any] = {
    "__builtins__": {},
    "pi": math.pi,
    "sqrt": math.sqrt,
    "sin": degrees(math.sin),
    "cos": degrees(math.cos),
    "tan": degrees(math.tan),
    "asin": lambda x: math.degrees(math.asin(x)),
    "atan2": lambda y, x: math.degrees(math.atan2(y, x)),
}


def numeric(name: str, variant: str | None = None) -> dict[str, Any]:
    """A sample's mechanism with every expression worked out, as the independent solver wants it."""
    text = (SAMPLES / f"{name}.yaml").read_text(encoding="utf-8")
    scene: dict[str, Any] = yaml.load(text, Loader=yaml.BaseLoader)
    given = dict(scene.get("parameters", {})) | dict(scene.get("variants", {}).get(variant, {}))
    known = dict(FUNCTIONS)
    for key, value in given.items():
        known[key] = eval(value.replace("^", "**"), known)
    return {key: worked_out(value, known) for key, value in scene.items() if key not in WORDS}


def worked_out(node: Any, known: dict[str, Any]) -> Any:
    """Expressions of known parameters as numbers; all other texts (names) as they are."""
    if isinstance(node, dict):
        named = ("link", "on", "point", "centre", "slides", "guide", "through", "mark", "against", "along", "stroke")
        return {k: v if k in named and isinstance(v, str) else worked_out(v, known) for k, v in node.items()}
    if isinstance(node, list):
        return [worked_out(v, known) for v in node]
    text = re.sub(r"[^\W\d]\w*", lambda m: repr(known.get(m[0], m[0])) if m[0] not in FUNCTIONS else m[0], node)
    moving = set(re.findall(r"'(\w+)'", text))  # what only the position tells
    return text.replace("'", "") if moving else float(eval(node, known))


def sketch(name: str) -> dict[str, Pose]:
    """The estimated pose with turns in radians."""
    return {link: (x, y, math.radians(turn)) for link, (x, y, turn) in SKETCHES[name].items()}


def truth(name: str) -> Solution:
    """The sample in its own position."""
    return solve(numeric(name), sketch(name))


def turned(name: str, values: list[float]) -> Iterator[tuple[float, Solution]]:
    """The sample at other values of its drive, by continuation from its own."""
    scene, start = numeric(name), truth(name).pose
    for value in values:
        yield value, follow(scene, start, value, 90)


def results(sol: Solution, key: str = "balancing_moment") -> dict[str, Any]:
    """A solution under the names `planes solve --json` uses."""
    reactions: dict[str, Any] = {}
    for (i, j), r in sol.reactions.items():
        reactions[reaction_key(i, j)] = (
            {"force": pair(r[0]), "arm": r[1], "moment": r[2]} if isinstance(r, tuple) else pair(r)
        )
    return {
        "points": {p: dict(zip("rva", map(pair, rva), strict=True)) for p, rva in sol.points.items()},
        "links": {n: dict(zip(("angle_deg", "omega", "epsilon"), w, strict=True)) for n, w in sol.links.items()},
        "slides": {n: {"v": v, "a": a, "coriolis": pair(c)} for n, (v, a, c) in sol.slides.items()},
        "reactions": reactions,
        key: sol.balancing,
    }


def pair(z: complex) -> list[float]:
    """A vector as [x, y]."""
    return [z.real, z.imag]


SORTS = {
    "r": "r",
    "v": "v",
    "a": "a",
    "coriolis": "a",
    "angle_deg": "angle",
    "omega": "omega",
    "epsilon": "epsilon",
    "force": "force",
    "arm": "arm",
    "moment": "moment",
    "balancing_moment": "moment",
    "balancing_force": "force",
    "zhukovsky_moment": "moment",
    "zhukovsky_force": "force",
}


def flat(found: Mapping[str, Any]) -> dict[tuple[str, ...], tuple[str, complex | None]]:
    """Every number of results by its path, with its sort; vectors are complex."""
    out: dict[tuple[str, ...], tuple[str, complex | None]] = {}

    def walk(node: Any, path: tuple[str, ...]) -> None:
        if isinstance(node, Mapping):
            for key, value in node.items():
                walk(value, (*path, key))
        elif not isinstance(node, str):
            sort = SORTS.get(path[-1], "force")
            out[path] = sort, complex(*node) if isinstance(node, list) else node

    for part in ("points", "links", "slides", "reactions", *SORTS):
        if part in found:
            walk(found[part], (part,))
    return out


def scales(numbers: Mapping[tuple[str, ...], tuple[str, complex | None]]) -> dict[str, float]:
    """The largest number of every sort, at least what the others make of it."""
    most = dict.fromkeys(SORTS.values(), 0.0)
    for sort, value in numbers.values():
        most[sort] = max(most[sort], abs(value or 0.0))
    size = most["r"]
    most |= {
        "angle": 180.0,
        "arm": size,
        "omega": max(most["omega"], most["v"] / size),
        "epsilon": max(most["epsilon"], most["a"] / size),
        "moment": max(most["moment"], most["force"] * size),
    }
    return {sort: value or 1.0 for sort, value in most.items()}


def printed(node: Any, unit: Mapping[str, float], sort: str = "force") -> Any:
    """Numbers to 12 significant digits, rounding noise as zero."""
    if isinstance(node, Mapping):
        return {k: printed(v, unit, SORTS.get(k, "force")) for k, v in node.items()}
    if isinstance(node, list):
        return [printed(v, unit, sort) for v in node]
    return node if node is None else float(f"{node:.12g}") if abs(node) > 1e-13 * unit[sort] else 0.0


def save() -> None:
    """Write the expected results of the samples nobody published."""
    EXPECTED.mkdir(exist_ok=True)
    for name in (*UNPUBLISHED, *HIGHER):
        drive = numeric(name)["drive"]
        turning = "phi" in drive
        found = results(truth(name), "balancing_moment" if turning else "balancing_force")
        unit = scales(flat(found))
        position = {"phi_deg" if turning else "s": drive["phi" if turning else "s"]}
        told = {
            "scene": f"{name}.yaml",
            "by": "equilibrium and constraints of all links at once, no plans",
            "positions": [position | printed(found, unit)],
        }
        text = json.dumps(told, ensure_ascii=False, indent=1)
        (EXPECTED / f"{name}.json").parent.mkdir(parents=True, exist_ok=True)
        (EXPECTED / f"{name}.json").write_text(text + "\n", encoding="utf-8")
    save_statics()


def save_statics() -> None:
    """The same of bodies and trusses in equilibrium."""
    (EXPECTED / "statics").mkdir(exist_ok=True)
    for scene in sorted((SAMPLES / "statics").glob("*.yaml")):
        found = expected(scene.read_text("utf-8"))
        most = max(
            abs(x) for part in (*found["vectors"].values(), *([v] for v in found["values"].values())) for x in part
        )
        shown = json.loads(json.dumps(found), parse_float=partial(_rounded, most=most))
        told = {
            "scene": f"statics/{scene.name}",
            "by": "equilibrium of all bodies and joints at once, no plans",
            **shown,
        }
        text = json.dumps(told, ensure_ascii=False, indent=1)
        (EXPECTED / "statics" / f"{scene.stem}.json").write_text(text + "\n", encoding="utf-8")


def _rounded(text: str, most: float) -> float:
    """Twelve digits; nothing where a number is nothing beside the largest."""
    x = float(text)
    return 0.0 if abs(x) < 1e-12 * most else float(f"{x:.12g}")


if __name__ == "__main__":
    save()
