"""Which of two assemblies is meant: the words of the scene, or the root nearer to a place, as ±1 of each group."""

from planes.drafting.drawing import run
from planes.drafting.program import Program
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.contours import Contour
from planes.plans.assur.groups import Group
from planes.plans.position.bodies import AssemblyChoice, Bodies, TrackChoice
from planes.plans.position.tracks import resolve_track
from planes.scene.mechanism import Assembly, Mechanism
from planes.words import Phrase
from planes.words.errors import PlanFailure, SceneError
from planes.words.names import at

WORDS_OF_KIND = {1: ("left", "right"), 2: ("ahead", "behind"), 3: ("ahead", "behind")}


def resolve(b: Bodies) -> None:
    """Set every side in the draft's givens; :class:`SceneError` where the scene does not say which is meant."""
    draft, mechanism = b.draft, b.mechanism
    program = Program(tuple(draft.steps.values()))
    for choice in b.choices:
        if isinstance(choice, TrackChoice):
            resolve_track(b, program, choice)
            program = Program(tuple(draft.steps.values()))
            continue
        key, said = _said(choice, mechanism)
        words = WORDS_OF_KIND[choice.group.kind]
        if said is None or (said.near is not None and not choice.placed):
            line = mechanism.where.get(("assembly",), mechanism.where.get(("links",)))
            raise SceneError(_question(b, program, choice), b.file, line)
        if said.near is not None:
            draft.given[choice.side] = _nearer(b, program, choice, key, said.near)
        elif said.order in words:
            draft.given[choice.side] = 1.0 if said.order == words[0] else -1.0
        else:
            named = {"name": choice.group.name, "links": choice.group.links, "one": words[0], "two": words[1]}
            why = Phrase("order_misfit", key=key, order=said.order, **named)
            raise SceneError(why, b.file, mechanism.where.get(("assembly", key)))


def _said(choice: AssemblyChoice, mechanism: Mechanism) -> tuple[str, Assembly | None]:
    """What the scene says of this group: under its own key, or ``near`` under any point of it."""
    if choice.key in mechanism.assembly:
        return choice.key, mechanism.assembly[choice.key]
    points = _new_points(choice.group, mechanism)
    for key, said in mechanism.assembly.items():
        if key in points and (said.near is not None or any(pair.point == key for pair in choice.group.inner_pairs)):
            return key, said
    return choice.key, None


def _new_points(group: Group | Triad | Contour, mechanism: Mechanism) -> list[str]:
    """Points that move with the choice: those of the group's links but the hinges it hangs on."""
    outer = {pair.point for pair in group.pairs if pair not in group.inner_pairs}
    points = [p for link in (*group.ends, *group.links) for p in mechanism.links[link].points]
    return [p for p in dict.fromkeys(points) if p not in outer]


def _places(b: Bodies, program: Program, choice: AssemblyChoice, point: str) -> list[tuple[float, complex]]:
    """Where the point would be on either side, in m; empty where it cannot be drawn."""
    mark = at("position", point)
    sliced = program.sliced([mark])
    found = []
    for side in (1.0, -1.0):
        try:
            drawing = run(sliced, {**b.draft.given, choice.side: side, "mu_position": 1.0})
        except PlanFailure:
            continue
        found.append((side, drawing[mark]))
    return found


def _nearer(b: Bodies, program: Program, choice: AssemblyChoice, key: str, near: complex) -> float:
    point, line = key, b.mechanism.where.get(("assembly", key))
    if at("position", point) not in b.draft.steps:  # keyed by the guide: judge by a point that moves with the choice
        point = next(iter(_new_points(choice.group, b.mechanism)), key)
    places = _places(b, program, choice, point)
    if not places:
        try:
            run(program.sliced([at("position", point)]), {**b.draft.given, "mu_position": 1000.0})
        except PlanFailure as failure:
            raise SceneError(Phrase("near_not_drawn", key=key, failure=failure.phrase), b.file, line) from None
    if len(places) == 2 and places[0][1] == places[1][1]:
        raise SceneError(Phrase("near_same", key=key, point=point), b.file, line)
    return min(places, key=lambda found: abs(found[1] - near))[0]


def _question(b: Bodies, program: Program, choice: AssemblyChoice) -> Phrase:
    """What the scene does not say, and the words that say it, to be added to an assembly if there is one."""
    more, g, words = bool(b.mechanism.assembly), choice.group, WORDS_OF_KIND[choice.group.kind]
    own, placed = ("assembly_more", "assembly_more_at") if more else ("assembly_offer", "assembly_offer_at")
    offers = [Phrase(own, key=choice.key, word=word) for word in words]
    if g.kind != 3 and choice.placed:
        for side, place in _places(b, program, choice, choice.key):
            index = 0 if side > 0 else 1
            offers[index] = Phrase(placed, key=choice.key, word=words[index], x=place.real, y=place.imag)
    key = "two_more_assemblies" if more else "two_assemblies"
    return Phrase(key, links=g.links, name=g.name, offers=tuple(offers))
