"""The same mechanism with a length, or the angle of a guide, changed."""

from collections.abc import Iterable
from dataclasses import replace

from planes.drafting.draft import Draft
from planes.drafting.tools import Env, Things
from planes.plans import Plans, plans_of
from planes.plans.assur.groups import Group
from planes.plans.position.assembly import ASSEMBLY_WORDS_BY_KIND
from planes.plans.position.bodies import Bodies
from planes.plans.position.scheme import draw_scheme
from planes.plans.scales import drawn_in_si
from planes.scene.mechanism import Assembly, Link, Mechanism
from planes.words.names import scheme_mark


def plans_with_changed_given(plans: Plans, name: str, value: float) -> Plans:
    """The plans with a changed given: a length, with all of its link, or a guide's angle; the assembly choices stay."""
    return plans_of(replace(_mechanism_with_changed_given(plans, name, value), assembly=_assemblies_in_words(plans)))


def _mechanism_with_changed_given(plans: Plans, name: str, value: float) -> Mechanism:
    """The mechanism with a changed given."""
    m = plans.mechanism
    link = _changed_link(plans, name, value)
    if link.name == m.frame.name:
        return replace(m, frame=link)
    return replace(m, links={**m.links, link.name: link})


def names_of_changed_givens(old: Things, new: Things) -> list[str]:
    """The givens that differ between two mechanisms of the same structure."""
    return [n for n, v in new.items() if n not in old or abs(v - old[n]) > 1e-12 * max(1.0, abs(v))]


def givens_of_scheme(plans: Plans, mechanism: Mechanism) -> Things:
    """The givens of the scheme of a mechanism of the same structure, its assembly not chosen."""
    bodies = Bodies(mechanism, plans.structure, Draft())
    draw_scheme(bodies)
    return bodies.draft.given


def growth_of_givens(plans: Plans, name: str) -> Env:
    """The growth of the scheme's givens while a length doubles: they are linear in it."""
    once, twice = (
        givens_of_scheme(plans, _mechanism_with_changed_given(plans, name, plans.given[name] * k)) for k in (1.0, 2.0)
    )
    return {n: twice[n] - once[n] for n in names_of_changed_givens(once, twice)}


def alterable_given_names(plans: Plans, names: Iterable[str]) -> list[str]:
    """Those of the names that can be changed while only other lengths of links and angles of guides follow: the givens
    whose makers state their meaning."""
    free = []
    own = givens_of_scheme(plans, plans.mechanism)
    means = {n: m for n, m in plans.means.items() if m.quantity in ("length", "angle")}
    for name in (n for n in names if n in means):
        value = float(plans.given[name])
        other = _mechanism_with_changed_given(
            plans, name, value * 1.01 if means[name].quantity == "length" else value + 1.0
        )
        follow = names_of_changed_givens(own, givens_of_scheme(plans, other))
        if name in follow and all(n in means for n in follow):
            free.append(name)
    return free


def _changed_link(plans: Plans, name: str, value: float) -> Link:
    """The link that it belongs to, changed; unchanged where a length ends not at a point of the link but beside a
    guide."""
    means = plans.means[name]
    link = plans.mechanism.link(means.link)
    if means.quantity == "angle":
        return replace(link, guides={**link.guides, means.of: replace(link.guides[means.of], angle_deg=value)})
    if means.about not in link.points:
        return link
    start = link.points[means.of]
    times = value / plans.given[name]
    points = {p: start + (z - start) * times for p, z in link.points.items()}
    guides = {n: replace(g, through=points.get(g.through_point or "", g.through)) for n, g in link.guides.items()}
    return replace(link, points=points, guides=guides)


def _assemblies_in_words(plans: Plans) -> dict[str, Assembly]:
    """The assemblies in words, including those given by places."""
    assemblies = {}
    for group in plans.structure.class_two_groups:
        words = ASSEMBLY_WORDS_BY_KIND.get(group.kind)
        key = group.inner.guide if group.kind == 3 else group.inner.point
        if words:
            assemblies[key] = Assembly(order=words[0 if plans.given[f"side_{key}"] > 0 else 1])  # type: ignore[arg-type]
    tracked = [g for g in plans.structure.groups if not isinstance(g, Group)]
    things = drawn_in_si(plans, plans.drive.position).things if tracked else {}
    for higher in tracked:
        outer = {pair.point for pair in higher.pairs if pair not in higher.inner_pairs}
        key = next(p for link in higher.links for p in plans.mechanism.links[link].points if p not in outer)
        assemblies[key] = Assembly(near=complex(things[scheme_mark(key)]))
    return assemblies
