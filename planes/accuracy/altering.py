"""The same mechanism with a length, or the angle of a guide, made otherwise."""

from __future__ import annotations

from dataclasses import replace

from planes.plans import Plans, state
from planes.plans.assembly import WORDS_OF_KIND
from planes.scene.mechanism import Assembly, Link, Mechanism

LENGTH, ANGLE = "l_", "angle_∥"  # how the names of such givens begin


def altered(plans: Plans, name: str, value: float) -> Plans:
    """The plans with a given altered: a length, and all of its link with it, or a guide's angle; sides stay."""
    m = _with(plans.mechanism, _link(plans, name, value))
    return state(replace(m, assembly=_sides(plans)))


def changed(one: Plans, two: Plans) -> list[str]:
    """The givens in which two mechanisms of the same structure differ."""
    return [n for n, v in two.given.items() if abs(v - one.given[n]) > 1e-12 * max(1.0, abs(v))]


def alterable(plans: Plans, names: list[str]) -> list[str]:
    """Those of the names that can be altered, with nothing but other lengths and angles following."""
    found = []
    for name in names:
        value = float(plans.given[name])
        follow = changed(plans, altered(plans, name, value * 1.01 if name.startswith(LENGTH) else value + 1.0))
        if name in follow and all(n.startswith((LENGTH, ANGLE)) for n in follow):
            found.append(name)
    return found


def _link(plans: Plans, name: str, value: float) -> Link:
    """The link it is a part of, altered; the frame as it is, if none is known to be."""
    for link in (plans.mechanism.frame, *plans.mechanism.links.values()):
        guide = link.guides.get(name.removeprefix(ANGLE))
        if guide and name.startswith(ANGLE):
            return replace(link, guides={**link.guides, guide.name: replace(guide, angle_deg=value)})
        for one, start in link.points.items():
            for two, end in link.points.items():
                if name == f"{LENGTH}{one}{two}" and abs(end - start) == plans.given[name]:
                    return _stretched(link, start, value / abs(end - start))
    return plans.mechanism.frame


def _stretched(link: Link, start: complex, times: float) -> Link:
    points = {p: start + (z - start) * times for p, z in link.points.items()}
    guides = {n: replace(g, through=points.get(g.through_point or "", g.through)) for n, g in link.guides.items()}
    return replace(link, points=points, guides=guides)


def _with(m: Mechanism, link: Link) -> Mechanism:
    return replace(m, frame=link) if link.name == m.frame.name else replace(m, links={**m.links, link.name: link})


def _sides(plans: Plans) -> dict[str, Assembly]:
    """The assemblies in words, also those told by places."""
    found = {}
    for group in plans.structure.groups:
        words = WORDS_OF_KIND.get(group.kind)
        key = group.inner.guide if group.kind == 3 else group.inner.point
        if words:
            found[key] = Assembly(order=words[0 if plans.given[f"side_{key}"] > 0 else 1])  # type: ignore[arg-type]
    return found
