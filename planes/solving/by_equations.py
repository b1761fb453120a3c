"""The user's own equations of a mechanism as a scene of vectors: it is drawn in their order, taught, practised and
checked as any other. Of each vector it gives what the program's own equations know before they are drawn."""

from collections.abc import Mapping
from itertools import permutations

from planes.geometry.arithmetic import Arithmetic
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene, loads
from planes.scene.writing import scene_file_text
from planes.solving import Position
from planes.solving.own_equations import check_own_equations, mechanism_vectors, plan_kind_of_vector
from planes.words import Phrase, Written, available_languages, say
from planes.words.errors import SceneError
from planes.words.records import Json
from planes.words.units import mu_text

HANDED_OVER_DIGITS = 12  # of the numbers handed over: more than equations are held to, fewer than rounding has spoilt


def scene_text_by_equations(scene: Scene, position: Position) -> str:
    """The text of that scene, for one position of the mechanism.

    Where equations would have more than two unknowns, vectors of the mechanism's plans are given whole, in the order in
    which they are named; the result of an equation (alone on its side) comes last. Raises :class:`SceneError` where the
    scene has no equations, and at the line of the first that does not close.
    """
    if not scene.equations:
        raise SceneError(Phrase("own_none"), scene.file)
    for one in check_own_equations(position.plans, position.drawing, position.scales, scene.equations, scene.file):
        if not one.is_closed:
            why = Phrase("about", what=one.equation.text, why=Written(one.closing_fault_in_words))
            raise SceneError(why, scene.file, one.equation.line)
    vectors = dict(mechanism_vectors(position.plans, position.drawing, position.scales))
    known = {name: _known_vector_data(position, name, vectors) for e in scene.equations for name in e.vector_names}
    alone = {side[0].name for e in scene.equations for side in e.sides if len(side) == 1}
    more = sorted((n for n in known if n in vectors and len(known[n]) < 2), key=lambda n: n in alone)
    given = known
    fault = _undrawable_error(scene, position, known)
    while fault and more:
        name = more.pop(0)
        given = {**given, name: _fully_known_vector(vectors[name])}
        fault = _undrawable_error(scene, position, given)
    if fault:
        raise fault
    for name in (n for n in known if given[n] != known[n]):  # it was given whole for another equation's sake
        less = {**given, name: known[name]}
        given = given if _undrawable_error(scene, position, less) else less
    return _scene_text(scene, position, given)


def _undrawable_error(scene: Scene, position: Position, given: Mapping[str, Json]) -> SceneError | None:
    """Why the equations cannot be drawn with these data, at the line of the user's equation."""
    text = _scene_text(scene, position, given)
    try:
        scene_plans(loads(text, scene.file))
    except SceneError as error:
        from_the_end = text.count("\n") - (error.line or 0)  # the equations are its last lines
        own = scene.equations[-1 - from_the_end] if from_the_end < len(scene.equations) else scene.equations[0]
        return SceneError(error.phrase, scene.file, own.line)
    return None


def _scene_text(scene: Scene, position: Position, given: Mapping[str, Json]) -> str:
    """The scene with these data of its vectors, at the scales of the mechanism's plans; last an equation a line."""
    title = {lang: say("own_title", lang, title=scene.title.get(lang, scene.file)) for lang in available_languages()}
    own = {plan_kind_of_vector(e.vector_names[0]) for e in scene.equations}
    mus = position.scales
    scales = {
        k: {"mu": mu_text(mus[p.mu_name], k)}
        for p in dict.fromkeys(s.plan for s in position.plans.segments)
        if (k := p.kind) in own
    }
    vectors = {**_vectors_with_directions(position, given), **given}
    head = scene_file_text({"planes": 1, "title": title, "vectors": vectors, "plans": scales})
    return f"{head}equations:\n" + "".join(f'  - "{e.text}"\n' for e in scene.equations)


def _known_vector_data(position: Position, name: str, vectors: Mapping[str, complex]) -> Json:
    """What the program knows of a vector before it draws the equation that gives it; nothing of a new one."""
    equations = position.plans.equations
    things = position.drawing
    term = next((t for e in equations for t in e.all_terms if t.name == name and not t.drawn), None)
    if term and term.known_part_count < 2:
        if not term.direction:
            return {}
        return _line_of_action(position, term.direction) or {"direction": _rounded_angle_deg(things[term.direction])}
    sought = not term and name in [e.total for e in equations]
    if sought or name not in vectors:
        return {}
    return _fully_known_vector(vectors[name])


def _line_of_action(position: Position, direction: str) -> Json:
    """A line of action along or across that of two points of the scheme, by their vector r_BC; empty for any other."""
    means = position.plans.means.get(direction)
    key = {"along": "direction", "across": "perpendicular_to"}.get(means.quantity if means else "")
    known = position.plans.points
    if key and means and {means.of, means.about} <= known.keys():
        return {key: f"r_{means.line_name}"}
    return {}


def _vectors_with_directions(position: Position, given: Mapping[str, Json]) -> Json:
    """Those vectors, each with its direction."""
    names = {str(way) for one in given.values() for way in one.values() if isinstance(way, str)}
    lines = {}
    for one, two in permutations(position.plans.points, 2):
        if (name := f"r_{one}{two}") in names:
            start, end = (position.drawing[position.plans.points[n].position] for n in (one, two))
            lines[name] = {"direction": _rounded_angle_deg(end - start)}
    return lines


def _fully_known_vector(value: complex) -> Json:
    """A vector of which everything is known."""
    return {"value": _round_to_digits(abs(value)), "direction": _rounded_angle_deg(value)}


def _rounded_angle_deg(value: complex) -> float:
    return _round_to_digits(Arithmetic().angle_deg(complex(value)))


def _round_to_digits(number: float) -> float:
    return float(f"{number:.{HANDED_OVER_DIGITS}g}")
