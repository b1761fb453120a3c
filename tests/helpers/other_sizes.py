"""A mechanism with other dimensions, by their names on a page, without the page's calculation."""

import cmath
from collections.abc import Mapping
from dataclasses import replace
from itertools import permutations

from planes.drafting.drawing import Drawing, draw_program
from planes.drafting.tools import Thing
from planes.plans import plans_of
from planes.scene.mechanism import Link, Mechanism

CHOSEN = ("track_", "turning_", "middle_", "half_", "size_", "sense_", "side_", "place_")


def drawn_anew(mechanism: Mechanism, numbers: Mapping[str, float], file: str, near: Mapping[str, complex]) -> Drawing:
    """The mechanism restated with other dimensions and drawn; errors as those of :func:`plans_of` and ``run``.

    If given, ``near`` holds the approximate positions of its points, which select the assembly.
    """
    told = {n: replace(a, near=near[n]) if n in near else a for n, a in mechanism.assembly.items()}
    plans = plans_of(replace(resized(mechanism, numbers), assembly=told), file)
    given: dict[str, Thing] = {**plans.given}
    for name, value in numbers.items():
        if name in given and name not in plans.reckoned and not name.startswith(CHOSEN):
            given[name] = value
    return draw_program(plans.program, {**given, **{n: z for n, z in numbers.items() if n.startswith("mu_")}})


def resized(mechanism: Mechanism, numbers: Mapping[str, float]) -> Mechanism:
    """The mechanism with the given dimensions, the others unchanged."""
    links = {name: _link(link, numbers) for name, link in mechanism.links.items()}
    frame = _turned(mechanism.frame, numbers)
    places = {p: _place(p, z, numbers) for p, z in frame.points.items()}
    guides = {
        n: replace(g, through=places[g.through_point] if g.through_point else _place(f"°{n}", g.through, numbers))
        for n, g in frame.guides.items()
    }
    return replace(mechanism, links=links, frame=replace(frame, points=places, guides=guides))


def _place(name: str, z: complex, numbers: Mapping[str, float]) -> complex:
    return complex(numbers.get(f"place_{name}.x", z.real), numbers.get(f"place_{name}.y", z.imag))


def _link(link: Link, numbers: Mapping[str, float]) -> Link:
    link = _turned(link, numbers)
    points = {**link.points}
    for base, p in permutations(link.points, 2):
        if f"l_{base}{p}" in numbers:
            way = link.points[p] - link.points[base]
            for start in link.points:
                if (name := f"angle_∠{start}{base}{p}") in numbers and start not in (base, p):
                    way = (link.points[start] - link.points[base]) * cmath.rect(1, cmath.pi / 180 * numbers[name])
            if f"angle_∠{base}{p}" in numbers and link.slides:
                way = cmath.rect(1, cmath.pi / 180 * numbers[f"angle_∠{base}{p}"])
            points[p] = link.points[base] + way / abs(way) * numbers[f"l_{base}{p}"]
    guides = {n: replace(g, through=points[g.through_point]) if g.through_point else g for n, g in link.guides.items()}
    return replace(link, points=points, guides=guides)


def _turned(link: Link, numbers: Mapping[str, float]) -> Link:
    """With its guides in other directions, and the offset of its slider."""
    guides = {n: replace(g, angle_deg=numbers.get(f"angle_∠{n}", g.angle_deg)) for n, g in link.guides.items()}
    slides = link.slides
    if slides and f"e_{link.name}" in numbers:
        slides = replace(slides, offset=numbers[f"e_{link.name}"])
    return replace(link, guides=guides, slides=slides)
