"""The instantaneous centre of a link: the intersection of the perpendiculars to the velocities of its points."""

from itertools import combinations

from planes.solving import Position
from planes.words.naming import Naming
from render.labels import Label
from render.paper import symbols
from render.paper.marks import Arrow, Line, Mark
from render.views import View, view
from render.views.plotted import Places
from render.views.scheme import Scheme

LONGEST_MM = 20.0  # length of the velocity arrows
FAR_MM = 130.0  # a centre farther from its link is not shown
PARALLEL = 0.05  # sine of the angle between lines that meet too far off


def instant_centre(position: Position, link: str, naming: Naming) -> View | None:
    """The scheme with the instantaneous centre P of a link and the velocities of its points; None if it is too far
    off."""
    places, v = Places(position), position.v
    points = [p for p in position.plans.mechanism.links[link].points if places.has(p) and p in v]
    centre = _centre([(places.at(p), v[p]) for p in points])
    if centre is None or min(abs(centre - places.at(p)) for p in points) > FAR_MM:
        return None
    fastest = max(abs(v[p]) for p in points)
    marks: list[Mark] = [Line((places.at(p), centre), "thin", "construction") for p in points]
    named = [Label(f"P_{{{naming.link(link)}}}", centre, clear=1.0, name="P")]
    for p in points:
        tip = places.at(p) + LONGEST_MM * v[p] / fastest
        marks.append(Arrow(places.at(p), tip, name=f"v_{p}"))
        named.append(Label(naming.vector(f"v_{p}"), (places.at(p), tip), 3.5, name=f"v_{p}"))
    marks += symbols.dot(centre)
    return view("centre", "", Scheme(position, naming).drawn(True, marks, named))


def _centre(moving: list[tuple[complex, complex]]) -> complex | None:
    """The intersection of lines through places perpendicular to their velocities; of the two least parallel ones."""
    best, centre = PARALLEL, None
    for (a, v), (b, w) in combinations(moving, 2):
        if not v or not w:
            continue
        across = (v.conjugate() * w).imag
        if abs(across) > best * abs(v) * abs(w):
            best = abs(across) / (abs(v) * abs(w))
            centre = a + 1j * v * ((b - a) * w.conjugate()).real / across
    return centre
