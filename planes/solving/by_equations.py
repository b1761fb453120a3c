"""The user's own equations of a mechanism as a scene of vectors: it is drawn in their order, taught, practised and
checked as any other. Of each vector it gives what the program's own equations know before they are drawn."""

from collections.abc import Mapping
from itertools import permutations

from planes.geometry.arithmetic import Arithmetic
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene, loads
from planes.scene.writing import written
from planes.solving import Position
from planes.solving.own_equations import kind_shown, own_equations, vectors_of
from planes.words import Phrase, Written, langs, say
from planes.words.errors import SceneError
from planes.words.names import kind_of, mu_of
from planes.words.records import Json
from planes.words.units import mu_text

DIGITS = 12  # of the numbers handed over: more than equations are held to, fewer than rounding has spoilt


def by_equations(scene: Scene, position: Position) -> str:
    """The text of that scene, for one position of the mechanism.

    Where equations would have more than two unknowns, vectors of the mechanism's plans are given whole, in the order in
    which they are named; the result of an equation (alone on its side) comes last. Raises :class:`SceneError` where the
    scene has no equations, and at the line of the first that does not close.
    """
    if not scene.equations:
        raise SceneError(Phrase("own_none"), scene.file)
    for one in own_equations(position.plans, position.drawing, position.scales, scene.equations, scene.file):
        if not one.closes:
            why = Phrase("about", what=one.equation.text, why=Written(one.fault))
            raise SceneError(why, scene.file, one.equation.line)
    vectors = dict(vectors_of(position.plans, position.drawing, position.scales))
    known = {name: _known(position, name, vectors) for e in scene.equations for name in e.names}
    alone = {side[0].name for e in scene.equations for side in e.sides if len(side) == 1}
    more = sorted((n for n in known if n in vectors and len(known[n]) < 2), key=lambda n: n in alone)
    given = known
    fault = _fault(scene, position, known)
    while fault and more:
        name = more.pop(0)
        given = {**given, name: _whole(vectors[name])}
        fault = _fault(scene, position, given)
    if fault:
        raise fault
    for name in (n for n in known if given[n] != known[n]):  # it was given whole for another equation's sake
        less = {**given, name: known[name]}
        given = given if _fault(scene, position, less) else less
    return _text(scene, position, given)


def _fault(scene: Scene, position: Position, given: Mapping[str, Json]) -> SceneError | None:
    """Why the equations cannot be drawn with these data, at the line of the user's equation."""
    text = _text(scene, position, given)
    try:
        scene_plans(loads(text, scene.file))
    except SceneError as error:
        from_the_end = text.count("\n") - (error.line or 0)  # the equations are its last lines
        own = scene.equations[-1 - from_the_end] if from_the_end < len(scene.equations) else scene.equations[0]
        return SceneError(error.phrase, scene.file, own.line)
    return None


def _text(scene: Scene, position: Position, given: Mapping[str, Json]) -> str:
    """The scene with these data of its vectors, at the scales of the mechanism's plans; last an equation a line."""
    title = {lang: say("own_title", lang, title=scene.title.get(lang, scene.file)) for lang in langs()}
    own = {kind_shown(e.names[0]) for e in scene.equations}
    mus = position.scales
    scales = {k: {"mu": mu_text(mus[mu_of(p)], k)} for p in position.plans.segments_of if (k := kind_of(p)) in own}
    vectors = {**_lines(position, given), **given}
    head = written({"planes": 1, "title": title, "vectors": vectors, "plans": scales})
    return f"{head}equations:\n" + "".join(f'  - "{e.text}"\n' for e in scene.equations)


def _known(position: Position, name: str, vectors: Mapping[str, complex]) -> Json:
    """What the program knows of a vector before it draws the equation that gives it; nothing of a new one."""
    equations = position.plans.equations
    things = position.drawing
    term = next((t for e in equations for t in e.terms if t.name == name and not t.drawn), None)
    if term and term.known < 2:
        if not term.direction:
            return {}
        return _line(position, term.direction) or {"direction": _angle(things[term.direction])}
    sought = not term and name in [e.total for e in equations]
    return {} if sought or name not in vectors else _whole(vectors[name])


def _line(position: Position, direction: str) -> Json:
    """A line of action along or across that of two points of the scheme, by their vector r_BC; empty for any other."""
    means = position.plans.means.get(direction)
    key = {"along": "direction", "across": "perpendicular_to"}.get(means.quantity if means else "")
    known = position.plans.points
    return {key: f"r_{means.line}"} if key and means and {means.of, means.about} <= known.keys() else {}


def _lines(position: Position, given: Mapping[str, Json]) -> Json:
    """Those vectors, each with its direction."""
    names = {str(way) for one in given.values() for way in one.values() if isinstance(way, str)}
    lines = {}
    for one, two in permutations(position.plans.points, 2):
        if (name := f"r_{one}{two}") in names:
            start, end = (position.drawing[position.plans.points[n].position] for n in (one, two))
            lines[name] = {"direction": _angle(end - start)}
    return lines


def _whole(value: complex) -> Json:
    """A vector of which everything is known."""
    return {"value": _rounded(abs(value)), "direction": _angle(value)}


def _angle(value: complex) -> float:
    return _rounded(Arithmetic().angle_deg(complex(value)))


def _rounded(number: float) -> float:
    return float(f"{number:.{DIGITS}g}")
