"""The parts of the lesson's scheme: links, guides, sliders, forces with their arms, and the owners of names."""

from collections.abc import Iterator
from itertools import chain, permutations

from planes.drafting.drawing import Drawing
from planes.drafting.equations import Moments
from planes.drafting.steps import LayOff
from planes.drafting.steps.reckoning import Calculate, Drop
from planes.geometry.arrays import Points
from planes.plans import Plans
from planes.plans.structures.figure import StaticsFigure
from planes.scene.mechanism import Mechanism
from planes.words.names import LEVER_PLAN, SCHEME_PLAN, Mark, NamesByName, label_of, scheme_mark, split_value_name
from planes.words.records import Json


def scheme_data(plans: Plans, drawing: Drawing) -> Json:
    """Links by their points, guides by a mark and a direction, and the signs on them."""
    m = plans.mechanism
    links = []
    for x in m.links.values():
        guide, owner = m.round_guide_of_link(x) or (None, "")
        links.append(
            {
                "name": x.name,
                "points": [scheme_mark(p) for p in m.points_without_guide_centre(x)],
                "round": {"centre": scheme_mark(guide.centre), "link": owner} if guide else None,
                "slides": x.slides.guide if x.slides else None,
            }
        )
    marks = {name: scheme_mark(x.guides[name].through_point or f"°{name}") for name, x in m.owners.items()}
    return {
        "links": links,
        "guides": [
            {"name": n, "link": m.owner_of_guide(n), "mark": mark} for n, mark in marks.items() if mark in drawing
        ],
        "signs": [*_supports(plans), *_sliders(m), *_hinges(plans)],
        "pivots": [scheme_mark(p) for p in frame_hinges(m)],
        "driver": m.drive.link,
        "drawn": statics_figure_data(plans.figure, plans) if plans.figure else None,
    }


def _supports(plans: Plans) -> Iterator[Json]:
    """Rollers turned from their base, and clamps across the body towards the next of its points."""
    spots = plans.figure.points if plans.figure else {}
    for s in plans.figure.supports if plans.figure else ():
        body = next((x for x in plans.mechanism.links.values() if s.point in x.points), None)
        others = [p for p in body.points if p != s.point] if body and s.kind == "clamp" else []
        towards = min(others, key=lambda p: abs(spots[p] - spots[s.point]), default=None)
        if s.kind in ("roller", "clamp"):
            sign = {"sign": s.kind, "mark": scheme_mark(s.point), "turn": s.normal_deg - 90}
            yield {**sign, "towards": scheme_mark(towards)} if towards else sign


def _sliders(m: Mechanism) -> list[Json]:
    """Blocks along their guides; of two at one point the larger is drawn first."""
    signs = []
    for x in m.links.values():
        if x.slides:
            point = x.first_point
            guide = x.slides.guide
            other = next((y for y in m.links.values() if y.slides and y != x and y.first_point == point), None)
            size = "block" if other is None else "large" if m.slider_rank(x) > m.slider_rank(other) else "small"
            signs.append({"sign": size, "mark": scheme_mark(point), "along": f"∥{guide}", "shows": f"link:{x.name}"})
    return sorted(signs, key=lambda sign: ("large", "block", "small").index(sign["sign"]))


def _hinges(plans: Plans) -> Iterator[Json]:
    """Fixed hinges, hinges between links, and points of one link, of Assur or of a circular guide."""
    m = plans.mechanism
    moving = [p for x in m.links.values() for p in x.points]
    rollers = [s.point for s in plans.figure.supports if s.kind == "roller"] if plans.figure else []
    centres = [guides[0].centre for x in m.links.values() if (guides := m.round_guide_of_link(x))]
    yield from ({"sign": "ground", "mark": scheme_mark(p)} for p in frame_hinges(m))
    joined = dict.fromkeys(p for x in m.links.values() for p in m.points_without_guide_centre(x))
    for p in dict.fromkeys([*joined, *centres, *special_points(plans)]):
        hinged = p in rollers or (p in joined and (moving.count(p) > 1 or p in m.frame.points))
        mark = scheme_mark(p)
        yield {"sign": "hinge" if hinged else "point", "mark": mark, "shows": mark}


def statics_figure_data(figure: StaticsFigure, plans: Plans) -> Json:
    """The parts of statics beside links: lines, loads at their points, rollers and walls, and the plan with the letters
    of regions, with the members as its lines."""
    return {
        "strokes": [{"plan": s.plan, "kind": s.kind, "name": s.name, "ends": [s.start, s.end]} for s in figure.strokes],
        "loads": [f.shown for f in plans.acting.every if f.spot],
        "members": [name for name, _, _ in figure.members],
        "numbered": sorted(figure.numbered),
    }


def frame_hinges(m: Mechanism) -> list[str]:
    """The fixed points that are hinges of a moving link, without mere centres of a slider's arc."""
    hinged = {p for x in m.links.values() for p in m.points_without_guide_centre(x)}
    return [p for p in m.frame.points if p in hinged]


def moment_arms(plans: Plans) -> list[Json]:
    """For each moment equation its forces: the point, the direction and the foot of the arm of each."""
    return [
        {
            "about": plan.mark(m.about),
            "plan": plan,
            "links": list(m.links),
            "forces": [*_forces_with_arms(plans, m)],
            "couples": [*_couples_on_links(plans, m)],
        }
        for m in plans.moments
        for plan in [LEVER_PLAN if m.links == ("lever",) else SCHEME_PLAN]
    ]


def _forces_with_arms(plans: Plans, m: Moments) -> Iterator[Json]:
    """The forces of an equation with their arms; then the tangential reaction found from it."""
    steps = plans.program.steps_by_result
    equation = steps.get(m.unknown)
    terms = equation.terms if isinstance(equation, Calculate) else ()
    for (name, arm), term in zip(m.terms, terms, strict=False):
        drop = steps.get(arm)
        if isinstance(drop, Drop):
            own = {"name": name, "mark": drop.point, "along": drop.along, "size": term.factors[0][0]}
            yield {**own, "arm": arm, "foot": arm_foot_mark(drop)}
    laid = next((s for s in steps.values() if isinstance(s, LayOff) and s.length == m.unknown), None)
    letter, index, _ = split_value_name(m.unknown)
    reaction = plans.reactions.get(f"{letter}_{index}")
    if laid and reaction:
        mark = scheme_mark(reaction.pair.point)
        yield {"name": m.unknown, "mark": mark, "along": laid.along, "size": m.unknown, "foot": None}


def _couples_on_links(plans: Plans, m: Moments) -> Iterator[Json]:
    """The couples of an equation of links, each at the middle of its link."""
    for link in m.links:
        for c in plans.acting.couples.get(link, ()):
            if (c.name, "") in m.terms:
                yield c.shown


def arm_foot_mark(drop: Drop) -> str:
    """The mark of an arm's foot."""
    return drop.point.plan.mark(f"⊥{drop.makes}")


def arm_foot_marks(plans: Plans, cycle: Drawing) -> dict[str, Points]:
    """The feet of the arms as marks."""
    foot_places = {}
    for step in plans.program.steps:
        if isinstance(step, Drop) and step.makes in cycle and step.point.plan != "motion":
            way = ((cycle[step.about] - cycle[step.point]) * cycle[step.along].conjugate()).real
            foot_places[arm_foot_mark(step)] = cycle[step.point] + way * cycle[step.along]
    return foot_places


def points_of_application(plans: Plans) -> dict[str, Mark]:
    """The mark of the scheme at which each force acts; for a slider's reaction its point, whatever its arm."""
    marks = {f.name: f.point for f in plans.acting.every}
    for r in plans.reactions.values():
        point = scheme_mark(r.pair.point or plans.mechanism.links[r.pair.link].first_point)
        marks |= {f"{name}{part}": point for name in r.both_reaction_names for part in ("", "^t", "^n")}
    return marks


def owners_by_name(plans: Plans, under: NamesByName) -> dict[str, list[str]]:
    """Links and points of the scheme by the names of their vectors and values; ``under`` are the links of points under
    sliders."""
    names = {s.name for s in plans.segments} | {t.name for e in plans.equations for t in e.all_terms}
    names |= {*plans.links, *plans.program.result_names}
    acted_on = {name: link for r in plans.reactions.values() for name, link in r.both_reaction_names.items()}
    own = {**under, **special_points(plans)}
    return {name: [owner] for name in sorted(names) if (owner := _owner_of_name(plans, name, acted_on, own))}


def special_points(plans: Plans) -> NamesByName:
    """Assur's special points, each with its basic link."""
    return {label_of(n): m.of for n, m in plans.means.items() if m.quantity == "special"}


def _owner_of_name(plans: Plans, name: str, acted_on: NamesByName, under: NamesByName) -> str:
    """The owner of a vector or value, a point or a link; "" where there is none."""
    links = plans.mechanism.links
    letter, index, _ = split_value_name(name)
    if letter in ("v", "a", "r") and any(index in link.points for link in links.values()):
        return scheme_mark(index)
    if letter in ("v", "a"):
        if index in under:
            return f"link:{under[index]}"
        return _link_of_pair(plans, index, under)
    if letter == "F":
        link = acted_on.get(f"F_{index}", "")
    else:
        link = split_value_name(index)[0] if letter in ("omega", "epsilon", "G", "I", "MI", "P", "M") else ""
    return f"link:{link}" if link in links else ""


def _link_of_pair(plans: Plans, symbol: str, more: NamesByName) -> str:
    """The link that carries both points of "CB", or the slider of a relative motion "HL"."""
    links = plans.mechanism.links.values()
    points = ((x, [*x.points, *(p for p, link in more.items() if link == x.name)]) for x in links)
    both = (x for x, own in points for one, two in permutations(own, 2) if one + two == symbol)
    slider = (x for x in links for p in x.points if x.slides and (symbol.startswith(p) or symbol.endswith(p)))
    return next((f"link:{link.name}" for link in chain(both, slider)), "")
