"""A mechanism as drawn on a canvas: points in their places, links by their points.

A sketch is plain data. ``points`` are places, m; ``fixed`` those of the frame; ``guides`` have a place ``at``, an
``angle`` and their ``link`` ("0": the frame); ``links`` have ``points`` and the guide they slide on; ``drive`` is a
link with its speed. The other parts of a scene (masses, loads, friction, scales) stay in its text.
"""

import cmath
import math

from planes.drafting.drawing import draw_program
from planes.drafting.program import Program
from planes.plans import Plans
from planes.scene import Scene
from planes.scene.mechanism import FRAME, Guide, Link, Mechanism
from planes.solving import plans_and_requested_results
from planes.words import Phrase, text_in
from planes.words.errors import PlanesError
from planes.words.names import Mark, scheme_mark
from planes.words.records import Json

SAME_PLACE_M = 1e-7  # places this close are one


def sketch_of(scene: Scene) -> Json:
    """The sketch of a scene in its given position; :class:`PlanesError` where it cannot be drawn."""
    m = scene.mechanism
    if m is None:
        raise PlanesError(Phrase("no_structure", file=scene.file))
    plans, _ = plans_and_requested_results(scene, shown=True)
    marks, program = marks_and_their_steps(plans)
    drawn = draw_program(
        program, {**plans.given, **plans.drive_givens_at(m.drive.position, program), "mu_position": 1.0}
    )
    places = {p: complex(drawn[mark]) for p, mark in marks.items()} | dict(m.frame.points)
    guides = {
        g.name: _guide_data(g, x, _link_axis_direction(x, m, places), places)
        for x in m.bodies
        for g in x.guides.values()
    }
    return {
        "title": text_in("en", scene.title),
        "points": {p: [z.real, z.imag] for p, z in places.items()},
        "fixed": [*m.frame.points],
        "guides": guides,
        "links": {n: _link_data(x) for n, x in m.links.items()},
        "drive": _drive_data(m),
        "loads": [{"link": x.link, "point": x.point} for x in m.loads if x.point],
    }


def marks_and_their_steps(plans: Plans) -> tuple[dict[str, Mark], Program]:
    """The mark of each drawn point, and the steps for them."""
    marks = {p: mark for p in plans.mechanism.point_names if (mark := scheme_mark(p)) in plans.program.result_names}
    return marks, plans.program.cut_to_names([*marks.values()])


def _drive_data(m: Mechanism) -> Json:
    """The drive; a motor between moving links names the link it is ``on``."""
    own: Json = {"link": m.drive.link, "kind": m.drive.kind, "rate": m.drive.velocity}
    return own | ({"on": m.drive.on} if m.drive.rotates and m.drive.on != FRAME else {})


def _link_data(x: Link) -> Json:
    slides = x.slides.guide if x.slides else None
    return {"points": [*x.points], "slides": slides, "centre": x.centre, "heavy": bool(x.mass)}


def _guide_data(g: Guide, x: Link, axis: complex, places: dict[str, complex]) -> Json:
    first = x.first_point if x.points else ""
    start = places.get(first, 0j) - x.points[first] * axis if x.name != FRAME and first else 0j
    z = start + g.through * axis
    return {"at": [z.real, z.imag], "angle": g.angle_deg + math.degrees(cmath.phase(axis)), "link": x.name}


def _link_axis_direction(x: Link, m: Mechanism, places: dict[str, complex]) -> complex:
    """The direction of a link's x axis."""
    if x.name == FRAME:
        return 1 + 0j
    if x.slides:
        body = m.link(m.owner_of_guide(x.slides.guide))
        guide = m.guide(x.slides.guide)
        turn = math.radians(guide.angle_deg + (x.slides.angle_deg or 0.0))
        return _link_axis_direction(body, m, places) * cmath.rect(1.0, turn)
    base = x.first_point
    for p, z in x.points.items():
        if abs(z - x.points[base]) > SAME_PLACE_M and p in places:
            turned = (places[p] - places[base]) / (z - x.points[base])
            return turned / abs(turned)
    for other in m.links.values():  # a lever visible only by its slider
        if other.slides and other.slides.guide in x.guides and other.first_point in places:
            guide = x.guides[other.slides.guide]
            way = places[other.first_point] - places[base]
            if abs(way) > SAME_PLACE_M:
                return way / abs(way) * cmath.rect(1.0, -math.radians(guide.angle_deg))
    return 1 + 0j
