"""Position plans drawn by hand on a blank: links, hinges, guides and sliders in pencil, right or wrong.

The positions come from the independent solver (`oracle`); only the scene and the printed blank are shared with the
checker.
"""

from __future__ import annotations

import cmath
import copy
import math
import random
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import cv2

from tests import sample_oracle
from tests.helpers import line_drawings, photographs
from tests.helpers.oracle import Solution, follow, solve
from tests.helpers.oracle_pins import place
from tests.helpers.photographs import Camera, Page, Stroke

HINGE_MM, DOT_MM, BLOCK_MM, BEYOND_MM = 1.3, 0.7, (9.0, 5.0), 14.0
Change = Callable[[dict[str, Any]], None]


@dataclass
class Scheme:
    """The drawing, mm from the scene's origin."""

    places: dict[str, complex] = field(default_factory=dict)
    strokes: list[Stroke] = field(default_factory=list)
    thin: list[Stroke] = field(default_factory=list)  # guides
    hinges: list[complex] = field(default_factory=list)
    fixed: list[complex] = field(default_factory=list)
    dots: list[complex] = field(default_factory=list)
    blocks: list[tuple[complex, complex]] = field(default_factory=list)  # centre, direction of the guide


@cache
def solved(sample: str) -> Solution:
    return sample_oracle.truth(sample)


def mistaken(sample: str, change: Change | None, phi: float | None = None, mirrored: str = "") -> Solution:
    """The scene solved after a change; ``mirrored`` names the hinge on the other side."""
    scene, sol = copy.deepcopy(sample_oracle.numeric(sample)), solved(sample)
    if change:
        change(scene)
    pose = dict(sol.pose)
    if mirrored:
        pose |= other_side(scene, sol, mirrored)
    if phi is not None:
        return follow(scene, pose, phi, 180)
    return solve(scene, pose)


def other_side(scene: dict[str, Any], sol: Solution, hinge: str) -> dict[str, tuple[float, float, float]]:
    """Poses of the links at a hinge, mirrored about the line of their outer points."""
    links = {n: b for n, b in scene["links"].items() if hinge in b["points"]}
    outer = {n: next(p for p in b["points"] if p != hinge and shared(scene, p)) for n, b in links.items()}
    a, b = (sol.points[p][0] for p in outer.values())
    out = {}
    for n, body in links.items():
        at = sol.points[outer[n]][0]
        z = sol.points[hinge][0]
        mirror = a + ((z - a) / (b - a)).conjugate() * (b - a)
        local = place(body["points"][hinge]) - place(body["points"][outer[n]])
        turn = cmath.phase((mirror - at) / local)
        origin = at - place(body["points"][outer[n]]) * cmath.rect(1, turn)
        out[n] = (origin.real, origin.imag, turn)
    return out


def shared(scene: dict[str, Any], point: str) -> bool:
    bodies = [scene["frame"], *scene["links"].values()]
    return sum(point in (b.get("points") or {}) for b in bodies) > 1


def scheme(sample: str, sol: Solution, mu: float) -> Scheme:
    """The drawing of a solution at mu mm/m."""
    scene, out = sample_oracle.numeric(sample), Scheme()
    out.places = {n: rva[0] * mu for n, rva in sol.points.items()}
    at = out.places
    out.fixed = [z * mu for z in map(place, (scene["frame"].get("points") or {}).values())]
    for n, z in zip(scene["frame"].get("points") or {}, out.fixed, strict=True):
        at[n] = z
    for body in scene["links"].values():
        joints = [p for p in body["points"] if shared(scene, p)]
        loose = [p for p in body["points"] if p not in joints]
        out.strokes += bars([at[p] for p in [*joints, *(p for p in loose if not p.startswith("S"))]])
        out.dots += [at[p] for p in loose]
    out.hinges = [at[p] for p in at if shared(scene, p)]
    for link, (_, home, u) in sol.guides.items():
        first = next(iter(scene["links"][link]["points"]))
        foot = sol.feet[link] * mu
        if abs(at[first] - foot) < 1e-6:
            foot = at[first]
        out.blocks.append((foot, u))
        if home == "0":
            out.thin.append((foot - BEYOND_MM * 1.5 * u, foot + BEYOND_MM * 1.5 * u))
        else:
            base = min((at[p] for p in scene["links"][home]["points"]), key=lambda z: abs(((z - foot) / u).imag))
            way = (foot - base) / abs(foot - base) if abs(foot - base) > 1 else u
            out.strokes.append((base, foot + BEYOND_MM * way))
    return out


def bars(points: list[complex]) -> Iterator[Stroke]:
    """Lines between a link's points: one through all if collinear, otherwise from the first to the others."""
    if len(points) < 2:
        return
    u = points[1] - points[0]
    if all(abs(((z - points[0]) / u).imag) < 1e-6 for z in points):
        row = sorted(points, key=lambda z: (z / u).real)
        yield row[0], row[-1]
        return
    for z in points[1:]:
        yield points[0], z


def picture(one: Scheme, pole: complex, camera: Camera, rng: random.Random, symbols: int = 2) -> Any:
    """A picture of it on its blank: bare lines, with hinges and dots (1), with sliders and supports, too (2)."""
    page = Page(camera.dpi)
    if camera.grid:
        page.grid(camera.grid)
    page.print_blank(pole, camera.corners)
    lines = [(a + pole, b + pole) for a, b in one.strokes if abs(b - a) > 0.3]
    for _ in range(camera.erased):
        page.rubbed(lines, rng)
    for a, b in lines:
        pencil(page, a, b, camera.wobble_mm, rng, rng.uniform(0.4, 0.6))
    for a, b in one.thin:
        pencil(page, a + pole, b + pole, camera.wobble_mm, rng, 0.25)
    if symbols > 1:
        for z, u in one.blocks:
            block(page, z + pole, u)
        for z in one.fixed:
            support(page, z + pole)
    if symbols:
        for z in one.dots:
            disc(page, z + pole, DOT_MM, 60)
        for z in [*one.hinges, *one.fixed]:
            disc(page, z + pole, HINGE_MM, photographs.PAPER)
    words = line_drawings.beside_lines(line_drawings.labels(one.places, rng), [*one.strokes, *one.thin])
    for text, z in words if camera.letters else ():
        page.word(text, z + pole)
    return photographs.shot(page.grey, camera, rng)


def pencil(page: Page, a: complex, b: complex, wobble: float, rng: random.Random, width: float) -> None:
    """A line drawn along a ruler, hardly bent."""
    bend, count = wobble * rng.gauss(0, 1) * 1j * (b - a) / abs(b - a), 12
    points = [a + (b - a) * t / count + bend * math.sin(math.pi * t / count) for t in range(count + 1)]
    page.line(points, rng.randint(50, 90), width)


def disc(page: Page, z: complex, radius: float, fill: int) -> None:
    middle, r = page.px(z), round(radius * page.k * 16)
    cv2.circle(page.grey, middle, r, fill, -1, cv2.LINE_AA, 4)
    cv2.circle(page.grey, middle, r, 70, max(1, round(0.35 * page.k)), cv2.LINE_AA, 4)


def block(page: Page, z: complex, u: complex) -> None:
    """A slider on its guide."""
    along, across = BLOCK_MM[0] / 2 * u, 1j * BLOCK_MM[1] / 2 * u
    corners = [z + along + across, z - along + across, z - along - across, z + along - across]
    page.line([*corners, corners[0]], 70, 0.4)


def support(page: Page, z: complex) -> None:
    """The two legs of a fixed hinge, the ground and its hatching."""
    page.line([z, z - 3 - 6j], 70, 0.4)
    page.line([z, z + 3 - 6j], 70, 0.4)
    page.line([z - 5 - 6j, z + 5 - 6j], 70, 0.4)
    for k in range(4):
        page.line([z - 3.5 + 2.5 * k - 6j, z - 5 + 2.5 * k - 8j], 80, 0.25)
