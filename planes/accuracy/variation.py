"""The same mechanism with a length, or the angle of a guide, made otherwise."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from planes.drafting.draft import Draft
from planes.drafting.tools import Thing
from planes.plans import Plans, plans_of
from planes.plans.assur.groups import Group
from planes.plans.position.assembly import WORDS_OF_KIND
from planes.plans.position.bodies import Bodies
from planes.plans.position.scheme import place_all
from planes.plans.scales import drawn_in_si
from planes.scene.mechanism import Assembly, Link, Mechanism
from planes.words.names import at


def altered(plans: Plans, name: str, value: float) -> Plans:
    """The plans with a given altered: a length, and all of its link with it, or a guide's angle; sides stay."""
    return plans_of(replace(_mechanism(plans, name, value), assembly=_sides(plans)))


def _mechanism(plans: Plans, name: str, value: float) -> Mechanism:
    """The mechanism with a given altered."""
    m, link = plans.mechanism, _link(plans, name, value)
    return replace(m, frame=link) if link.name == m.frame.name else replace(m, links={**m.links, link.name: link})


def changed(one: Plans, two: Plans) -> list[str]:
    """The givens in which two mechanisms of the same structure differ."""
    return _differing(one.given, two.given)


def _differing(old: Mapping[str, Thing], new: Mapping[str, Thing]) -> list[str]:
    return [n for n, v in new.items() if n not in old or abs(v - old[n]) > 1e-12 * max(1.0, abs(v))]


def scheme_given(plans: Plans, mechanism: Mechanism) -> Mapping[str, Thing]:
    """What is given of the scheme of a mechanism of the same structure, its assembly not chosen."""
    bodies = Bodies(mechanism, plans.structure, Draft())
    place_all(bodies)
    return bodies.draft.given


def lengthened(plans: Plans, name: str) -> dict[str, Thing]:
    """How givens of the scheme grow while a length becomes twice as long: they do so evenly."""
    once, twice = (scheme_given(plans, _mechanism(plans, name, plans.given[name] * k)) for k in (1.0, 2.0))
    return {n: twice[n] - once[n] for n in _differing(once, twice)}


def alterable(plans: Plans, names: Iterable[str]) -> list[str]:
    """Those of the names that can be altered, with nothing but other lengths of links and angles of guides following:
    the givens whose makers say what they mean."""
    free, own = [], scheme_given(plans, plans.mechanism)
    means = {n: m for n, m in plans.means.items() if m.quantity in ("length", "angle")}
    for name in (n for n in names if n in means):
        value = float(plans.given[name])
        other = _mechanism(plans, name, value * 1.01 if means[name].quantity == "length" else value + 1.0)
        follow = _differing(own, scheme_given(plans, other))
        if name in follow and all(n in means for n in follow):
            free.append(name)
    return free


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
    assemblies = {}
    for group in plans.structure.dyads:
        words = WORDS_OF_KIND.get(group.kind)
        key = group.inner.guide if group.kind == 3 else group.inner.point
        if words:
            assemblies[key] = Assembly(order=words[0 if plans.given[f"side_{key}"] > 0 else 1])  # type: ignore[arg-type]
    tracked = [g for g in plans.structure.groups if not isinstance(g, Group)]
    things = drawn_in_si(plans, plans.mechanism.drive.position).things if tracked else {}
    for higher in tracked:
        outer = {pair.point for pair in higher.pairs if pair not in higher.inner_pairs}
        key = next(p for link in higher.links for p in plans.mechanism.links[link].points if p not in outer)
        assemblies[key] = Assembly(near=complex(things[at("position", key)]))
    return assemblies
