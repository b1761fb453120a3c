"""Which of two assemblies is meant: the words of the scene, or the root nearer to a place, as ±1 of each group."""

from planes.drafting.drawing import draw_program
from planes.drafting.program import Program
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.contours import Contour
from planes.plans.assur.groups import Group
from planes.plans.position.bodies import AssemblyChoice, Bodies, TrackChoice
from planes.plans.position.tracks import (
    MOST_CLEAR_DISTANCE_RATIO,
    choose_triad_assembly,
    nearest_place_meant,
    require_consistent_choice,
    words_choosing_place,
)
from planes.scene.mechanism import Assembly, Mechanism
from planes.words import Phrase
from planes.words.errors import PlanFailure, SceneError
from planes.words.names import scheme_mark

ASSEMBLY_WORDS_BY_KIND = {1: ("left", "right"), 2: ("ahead", "behind"), 3: ("ahead", "behind")}

OFFERED_PLACE_DECIMALS = 12  # of a place offered to the user, m: the rest is rounding


def choose_assembly_sides(b: Bodies) -> None:
    """Set every side in the draft's givens; :class:`SceneError` where the scene does not settle which is meant."""
    draft = b.draft
    mechanism = b.mechanism
    program = Program(tuple(draft.steps.values()))
    for choice in b.choices:
        if isinstance(choice, TrackChoice):
            choose_triad_assembly(b, program, choice)
            program = Program(tuple(draft.steps.values()))
            continue
        said = _scene_assembly_entries(choice, mechanism)
        if not said or any(one.near is not None and not choice.placed for _, one in said):
            line = mechanism.where.get(("assembly",), mechanism.where.get(("links",)))
            raise SceneError(_missing_choice_question(b, program, choice), b.file, line)
        chosen = {key: _side_selected(b, program, choice, key, one) for key, one in said}
        sides = (
            _point_places_by_side(b, program, choice, _deciding_point(b, choice, said[0][0])) if len(said) > 1 else []
        )
        offers: dict[object, Phrase] = {side: words_choosing_place(said[0][0], z) for side, z in sides}
        require_consistent_choice(b, choice, chosen, offers)
        draft.given[choice.side] = chosen[said[0][0]]


def _side_selected(b: Bodies, program: Program, choice: AssemblyChoice, key: str, said: Assembly) -> float:
    """The side that a word or a place of the scene selects."""
    words = ASSEMBLY_WORDS_BY_KIND[choice.group.kind]
    if said.near is not None:
        return _side_nearer_to_place(b, program, choice, key, said.near)
    if said.order in words:
        return 1.0 if said.order == words[0] else -1.0
    details = {"name": choice.group.pair_letters, "links": choice.group.links, "one": words[0], "two": words[1]}
    why = Phrase("order_misfit", key=key, order=said.order, **details)
    raise SceneError(why, b.file, b.mechanism.where.get(("assembly", key)))


def _scene_assembly_entries(choice: AssemblyChoice, mechanism: Mechanism) -> list[tuple[str, Assembly]]:
    """The entry of this group in the scene: under its own key, or ``near`` under any point of it."""
    points = _points_moving_with_choice(choice.group, mechanism)
    hinges = {pair.point for pair in choice.group.inner_pairs}
    return [
        (key, said)
        for key, said in mechanism.assembly.items()
        if key == choice.key or (key in points and (said.near is not None or key in hinges))
    ]


def _points_moving_with_choice(group: Group | Triad | Contour, mechanism: Mechanism) -> list[str]:
    """Points that move with the choice: those of the group's links, without its outer hinges."""
    outer = {pair.point for pair in group.pairs if pair not in group.inner_pairs}
    points = [p for link in group.output_link_candidates + group.links for p in mechanism.links[link].points]
    return [p for p in dict.fromkeys(points) if p not in outer]


def _point_places_by_side(
    b: Bodies, program: Program, choice: AssemblyChoice, point: str
) -> list[tuple[float, complex]]:
    """The places of the point for either side, in m; empty where it cannot be drawn."""
    mark = scheme_mark(point)
    sliced = program.cut_to_names([mark])
    places = []
    for side in (1.0, -1.0):
        try:
            drawing = draw_program(sliced, {**b.draft.given, choice.side: side, "mu_position": 1.0})
        except PlanFailure:
            continue
        places.append((side, drawing[mark]))
    return places


def _side_nearer_to_place(b: Bodies, program: Program, choice: AssemblyChoice, key: str, near: complex) -> float:
    point = _deciding_point(b, choice, key)
    line = b.mechanism.where.get(("assembly", key))
    places = _point_places_by_side(b, program, choice, point)
    if not places:
        try:
            draw_program(program.cut_to_names([scheme_mark(point)]), {**b.draft.given, "mu_position": 1000.0})
        except PlanFailure as failure:
            raise SceneError(Phrase("near_not_drawn", key=key, failure=failure.phrase), b.file, line) from None
    if len(places) == 2 and places[0][1] == places[1][1]:
        raise SceneError(Phrase("near_same", key=key, point=point), b.file, line)
    there = nearest_place_meant(b, choice, key, near, [place for _, place in places], MOST_CLEAR_DISTANCE_RATIO)
    return next(side for side, place in places if place == there)


def _deciding_point(b: Bodies, choice: AssemblyChoice, key: str) -> str:
    """The point that decides: for the key of a guide, one that moves with the choice."""
    placed = scheme_mark(key) in b.draft.steps
    if placed:
        return key
    return next(iter(_points_moving_with_choice(choice.group, b.mechanism)), key)


def _missing_choice_question(b: Bodies, program: Program, choice: AssemblyChoice) -> Phrase:
    """The missing choice, and the words that make it, to be added to an existing assembly."""
    more = bool(b.mechanism.assembly)
    g = choice.group
    words = ASSEMBLY_WORDS_BY_KIND[choice.group.kind]
    own, placed = ("assembly_more", "assembly_more_at") if more else ("assembly_offer", "assembly_offer_at")
    offers = [Phrase(own, key=choice.key, word=word) for word in words]
    if g.kind != 3 and choice.placed:
        for side, place in _point_places_by_side(b, program, choice, choice.key):
            index = 0 if side > 0 else 1
            x, y = (round(part, OFFERED_PLACE_DECIMALS) + 0.0 for part in (place.real, place.imag))
            offers[index] = Phrase(placed, key=choice.key, word=words[index], x=x, y=y)
    key = "two_more_assemblies" if more else "two_assemblies"
    return Phrase(key, links=g.links, name=g.pair_letters, offers=tuple(offers))
