"""Reactions of bodies and forces in members by linear equations only, without importing planes."""

from __future__ import annotations

from typing import Any

import numpy as np
import yaml


def unit(angle_deg: float) -> complex:
    return complex(np.exp(1j * np.deg2rad(angle_deg)))


def forces_of(scene: dict[str, Any]) -> list[tuple[str, complex, complex]]:
    """Loads as (body, point, force); distributed ones by their resultants, summed exactly over a fine mesh."""
    points, bodies = places(scene), scene.get("bodies") or {"1": list(scene["points"])}
    found = []
    for load in scene.get("loads", []):
        if "moment" in load:
            continue
        way = unit(load.get("direction", -90))
        if "force" in load:
            body = next(n for n, own in bodies.items() if load["point"] in own)
            found.append((str(body), points[load["point"]], load["force"] * way))
            continue
        start, end = points[load["from"]], points[load["to"]]
        body = next(n for n, own in bodies.items() if load["from"] in own and load["to"] in own)
        q = load["intensity"] if isinstance(load["intensity"], list) else [load["intensity"]] * 2
        length = abs(end - start)
        for part in (0.5 - 0.5 / 3**0.5, 0.5 + 0.5 / 3**0.5):  # Gauss: exact for moments of a linear load
            found.append((str(body), start + part * (end - start), (q[0] + part * (q[1] - q[0])) * length / 2 * way))
    return found


def places(scene: dict[str, Any]) -> dict[str, complex]:
    return {name: complex(*xy) for name, xy in scene["points"].items()}


def columns_of(scene: dict[str, Any]) -> list[tuple[str, str, complex, complex]]:
    """Unknown numbers as (name, point, place, direction): two for hinges, one for lines, three for clamps."""
    points, found = places(scene), []
    for point, said in scene.get("supports", {}).items():
        count: dict[str, int] = {}
        for one in said if isinstance(said, list) else [said]:
            kind, value = (one, "") if isinstance(one, str) else next(iter(one.items()))
            name = f"S_{point}{value}" if kind in ("rod", "rope") else f"R_{point}"
            count[name] = count.get(name, 0) + 1
            name += f"_{count[name]}" if count[name] > 1 else ""
            if kind in ("hinge", "clamp"):
                found += [(name, point, points[point], 1 + 0j), (name, point, points[point], 1j)]
            if kind == "clamp":
                found.append((f"M_{point}", point, points[point], 0j))
            if kind == "roller":
                found.append((name, point, points[point], unit(90.0 if value == "" else float(value))))
            if kind in ("rod", "rope"):
                way = points[value] - points[point]
                found.append((name, point, points[point], way / abs(way)))
    return found


def reactions(text: str) -> dict[str, complex]:
    """Every reaction of bodies in equilibrium: forces as x + iy in N, couples as real numbers in N·m."""
    scene = yaml.safe_load(text)
    bodies = {str(n): own for n, own in (scene.get("bodies") or {"1": list(scene["points"])}).items()}
    points, names = places(scene), list(bodies)
    unknown: list[tuple[str, dict[int, complex], complex]] = []
    for name, point, place, way in columns_of(scene):
        body = next(k for k, n in enumerate(names) if point in bodies[n])
        unknown.append((name, {body: way}, place))
    for point in points:
        own = [k for k, n in enumerate(names) if point in bodies[n]]
        if len(own) == 2:
            for way in (1 + 0j, 1j):
                unknown.append((f"R_{point}", {own[1]: way, own[0]: -way}, points[point]))  # on the later one
    matrix, right = np.zeros((3 * len(names), len(unknown))), np.zeros(3 * len(names))
    for j, (name, ways, place) in enumerate(unknown):
        for k, way in ways.items():
            couple = 1.0 if name.startswith("M_") else (place.conjugate() * way).imag
            matrix[3 * k : 3 * k + 3, j] = way.real, way.imag, couple
    for on, place, force in forces_of(scene):
        k = names.index(on)
        right[3 * k : 3 * k + 3] -= force.real, force.imag, (place.conjugate() * force).imag
    for load in scene.get("loads", []):
        if "moment" in load:
            right[3 * names.index(str(load.get("body", names[0]))) + 2] -= load["moment"]
    solved, found = np.linalg.solve(matrix, right), dict[str, complex]()
    for (name, ways, _), value in zip(unknown, solved, strict=True):
        found[name] = found.get(name, 0j) + value * (1.0 if name.startswith("M_") else next(iter(ways.values())))
    return found


def members(text: str) -> dict[str, float]:
    """Forces in the members of a truss, tension positive, from the equilibrium of all joints at once."""
    scene = yaml.safe_load(text)
    points = places(scene)
    joints = [p for p in points if any(p in m for m in scene["members"])]
    columns: list[dict[str, complex]] = []
    for a, b in scene["members"]:
        way = (points[b] - points[a]) / abs(points[b] - points[a])
        columns.append({a: way, b: -way})
    columns += [{point: way} for _, point, _, way in columns_of(scene)]
    matrix, right = np.zeros((2 * len(joints), len(columns))), np.zeros(2 * len(joints))
    for j, column in enumerate(columns):
        for joint, way in column.items():
            k = joints.index(joint)
            matrix[2 * k : 2 * k + 2, j] = way.real, way.imag
    for load in scene["loads"]:
        force, k = load["force"] * unit(load["direction"]), joints.index(load["point"])
        right[2 * k : 2 * k + 2] -= force.real, force.imag
    solved = np.linalg.solve(matrix, right)
    return {f"S_{a}{b}": float(x) for (a, b), x in zip(scene["members"], solved, strict=False)}


def expected(text: str) -> dict[str, Any]:
    """All results in the samples' format: vectors as [x, y], couples and members as numbers; for loads, their sum."""
    scene = yaml.safe_load(text)
    if "supports" not in scene:
        total = sum(force for _, _, force in forces_of(scene))
        return {"vectors": {"R": [total.real, total.imag]}, "values": {}}
    found = reactions(text)
    vectors = {n: [z.real, z.imag] for n, z in found.items() if not n.startswith("M_")}
    values = {n: z.real for n, z in found.items() if n.startswith("M_")}
    return {"vectors": vectors, "values": values | (members(text) if "members" in scene else {})}
