"""Which of two assemblies is meant: the words of the scene, or the root nearer to a place, as ±1 of each group."""

from planes.drafting.drawing import run
from planes.drafting.program import Program
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.contours import Contour
from planes.plans.assur.groups import Group
from planes.plans.position.bodies import AssemblyChoice, Bodies, TrackChoice
from planes.plans.position.tracks import MIDWAY, nearest, one_chosen, resolve_track, track_offer
from planes.scene.mechanism import Assembly, Mechanism
from planes.words import Phrase
from planes.words.errors import PlanFailure, SceneError
from planes.words.names import at

WORDS_OF_KIND = {1: ("left", "right"), 2: ("ahead", "behind"), 3: ("ahead", "behind")}

DECIMALS = 12  # of a place offered to the user, m: the rest is rounding


def resolve(b: Bodies) -> None:
    """Set every side in the draft's givens; :class:`SceneError` where the scene does not settle which is meant."""
    draft, mechanism = b.draft, b.mechanism
    program = Program(tuple(draft.steps.values()))
    for choice in b.choices:
        if isinstance(choice, TrackChoice):
            resolve_track(b, program, choice)
            program = Program(tuple(draft.steps.values()))
            continue
        said = _said(choice, mechanism)
        if not said or any(one.near is not None and not choice.placed for _, one in said):
            line = mechanism.where.get(("assembly",), mechanism.where.get(("links",)))
            raise SceneError(_question(b, program, choice), b.file, line)
        chosen = {key: _side(b, program, choice, key, one) for key, one in said}
        sides = _places(b, program, choice, _judged(b, choice, said[0][0])) if len(said) > 1 else []
        offers: dict[object, Phrase] = {side: track_offer(said[0][0], z) for side, z in sides}
        one_chosen(b, choice, chosen, offers)
        draft.given[choice.side] = chosen[said[0][0]]


def _side(b: Bodies, program: Program, choice: AssemblyChoice, key: str, said: Assembly) -> float:
    """The side that a word or a place of the scene selects."""
    words = WORDS_OF_KIND[choice.group.kind]
    if said.near is not None:
        return _nearer(b, program, choice, key, said.near)
    if said.order in words:
        return 1.0 if said.order == words[0] else -1.0
    details = {"name": choice.group.name, "links": choice.group.links, "one": words[0], "two": words[1]}
    why = Phrase("order_misfit", key=key, order=said.order, **details)
    raise SceneError(why, b.file, b.mechanism.where.get(("assembly", key)))


def _said(choice: AssemblyChoice, mechanism: Mechanism) -> list[tuple[str, Assembly]]:
    """The entry of this group in the scene: under its own key, or ``near`` under any point of it."""
    points, hinges = _new_points(choice.group, mechanism), {pair.point for pair in choice.group.inner_pairs}
    return [
        (key, said)
        for key, said in mechanism.assembly.items()
        if key == choice.key or (key in points and (said.near is not None or key in hinges))
    ]


def _new_points(group: Group | Triad | Contour, mechanism: Mechanism) -> list[str]:
    """Points that move with the choice: those of the group's links, without its outer hinges."""
    outer = {pair.point for pair in group.pairs if pair not in group.inner_pairs}
    points = [p for link in (*group.ends, *group.links) for p in mechanism.links[link].points]
    return [p for p in dict.fromkeys(points) if p not in outer]


def _places(b: Bodies, program: Program, choice: AssemblyChoice, point: str) -> list[tuple[float, complex]]:
    """The places of the point for either side, in m; empty where it cannot be drawn."""
    mark = at("position", point)
    sliced = program.sliced([mark])
    places = []
    for side in (1.0, -1.0):
        try:
            drawing = run(sliced, {**b.draft.given, choice.side: side, "mu_position": 1.0})
        except PlanFailure:
            continue
        places.append((side, drawing[mark]))
    return places


def _nearer(b: Bodies, program: Program, choice: AssemblyChoice, key: str, near: complex) -> float:
    point, line = _judged(b, choice, key), b.mechanism.where.get(("assembly", key))
    places = _places(b, program, choice, point)
    if not places:
        try:
            run(program.sliced([at("position", point)]), {**b.draft.given, "mu_position": 1000.0})
        except PlanFailure as failure:
            raise SceneError(Phrase("near_not_drawn", key=key, failure=failure.phrase), b.file, line) from None
    if len(places) == 2 and places[0][1] == places[1][1]:
        raise SceneError(Phrase("near_same", key=key, point=point), b.file, line)
    there = nearest(b, choice, key, near, [place for _, place in places], MIDWAY)
    return next(side for side, place in places if place == there)


def _judged(b: Bodies, choice: AssemblyChoice, key: str) -> str:
    """The point that decides: for the key of a guide, one that moves with the choice."""
    placed = at("position", key) in b.draft.steps
    return key if placed else next(iter(_new_points(choice.group, b.mechanism)), key)


def _question(b: Bodies, program: Program, choice: AssemblyChoice) -> Phrase:
    """The missing choice, and the words that make it, to be added to an existing assembly."""
    more, g, words = bool(b.mechanism.assembly), choice.group, WORDS_OF_KIND[choice.group.kind]
    own, placed = ("assembly_more", "assembly_more_at") if more else ("assembly_offer", "assembly_offer_at")
    offers = [Phrase(own, key=choice.key, word=word) for word in words]
    if g.kind != 3 and choice.placed:
        for side, place in _places(b, program, choice, choice.key):
            index = 0 if side > 0 else 1
            x, y = (round(part, DECIMALS) + 0.0 for part in (place.real, place.imag))
            offers[index] = Phrase(placed, key=choice.key, word=words[index], x=x, y=y)
    key = "two_more_assemblies" if more else "two_assemblies"
    return Phrase(key, links=g.links, name=g.name, offers=tuple(offers))
