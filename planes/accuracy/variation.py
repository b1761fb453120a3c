"""The same mechanism with a length, or the angle of a guide, made otherwise."""

from collections.abc import Iterable
from dataclasses import replace

from planes.plans import Plans, plans_of
from planes.plans.assembly import WORDS_OF_KIND
from planes.scene.mechanism import Assembly, Link


def altered(plans: Plans, name: str, value: float) -> Plans:
    """The plans with a given altered: a length, and all of its link with it, or a guide's angle; sides stay."""
    m, link = replace(plans.mechanism, assembly=_sides(plans)), _link(plans, name, value)
    of_frame = link.name == m.frame.name
    return plans_of(replace(m, frame=link) if of_frame else replace(m, links={**m.links, link.name: link}))


def changed(one: Plans, two: Plans) -> list[str]:
    """The givens in which two mechanisms of the same structure differ."""
    old = one.given
    return [n for n, v in two.given.items() if n not in old or abs(v - old[n]) > 1e-12 * max(1.0, abs(v))]


def alterable(plans: Plans, names: Iterable[str]) -> list[str]:
    """Those of the names that can be altered, with nothing but other lengths of links and angles of guides following:
    the givens whose makers say what they mean."""
    found = []
    means = {n: m for n, m in plans.means.items() if m.quantity in ("length", "angle")}
    for name in (n for n in names if n in means):
        value = float(plans.given[name])
        follow = changed(plans, altered(plans, name, value * 1.01 if means[name].quantity == "length" else value + 1.0))
        if name in follow and all(n in means for n in follow):
            found.append(name)
    return found


def _link(plans: Plans, name: str, value: float) -> Link:
    """The link it is a part of, altered; as it is where a length ends at no point of it but beside a guide."""
    means = plans.means[name]
    link = plans.mechanism.link(means.link)
    if means.quantity == "angle":
        return replace(link, guides={**link.guides, means.of: replace(link.guides[means.of], angle_deg=value)})
    if means.about not in link.points:
        return link
    start, times = link.points[means.of], value / plans.given[name]
    points = {p: start + (z - start) * times for p, z in link.points.items()}
    guides = {n: replace(g, through=points.get(g.through_point or "", g.through)) for n, g in link.guides.items()}
    return replace(link, points=points, guides=guides)


def _sides(plans: Plans) -> dict[str, Assembly]:
    """The assemblies in words, also those told by places."""
    found = {}
    for group in plans.structure.dyads:
        words = WORDS_OF_KIND.get(group.kind)
        key = group.inner.guide if group.kind == 3 else group.inner.point
        if words:
            found[key] = Assembly(order=words[0 if plans.given[f"side_{key}"] > 0 else 1])  # type: ignore[arg-type]
    return found
