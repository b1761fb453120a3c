"""The instantaneous centre of a link: the intersection of the perpendiculars to the velocities of its points."""

from itertools import combinations

from planes.solving import Position
from planes.words.naming import Naming
from render.labels import Label
from render.paper.marks import Arrow, Line, Mark
from render.paper.symbols import dot
from render.views import View, make_view
from render.views.plotted import Places
from render.views.scheme import Scheme

LONGEST_VELOCITY_MM = 20.0  # length of the velocity arrows
MOST_CENTRE_DISTANCE_MM = 130.0  # a centre farther from its link is not shown
LEAST_CROSSING_SINE = 0.05  # sine of the angle between lines that meet too far off


def instant_centre_scheme(position: Position, link: str, naming: Naming) -> View | None:
    """The scheme with the instantaneous centre P of a link and the velocities of its points; None if it is too far
    off."""
    places = Places(position)
    v = position.v
    own = position.plans.mechanism.links[link].points
    points = {p: places.point_place(p) for p in own if places.is_drawn(p) and p in v}
    centre = _intersection_of_normals([(z, v[p]) for p, z in points.items()])
    if centre is None or min(abs(centre - z) for z in points.values()) > MOST_CENTRE_DISTANCE_MM:
        return None
    fastest = max(abs(v[p]) for p in points)
    marks: list[Mark] = [Line((z, centre), "thin", "construction") for z in points.values()]
    named = [Label(f"P_{{{naming.link_number(link)}}}", centre, clear=1.0, name="P")]
    for p, z in points.items():
        tip = z + LONGEST_VELOCITY_MM * v[p] / fastest
        name = f"v_{p}"
        marks.append(Arrow(z, tip, name=name))
        named.append(Label(naming.lettered_vector(name), (z, tip), 3.5, name=name))
    marks += dot(centre)
    return make_view("centre", "", Scheme(position, naming).drawn_marks(True, marks, named))


def _intersection_of_normals(moving: list[tuple[complex, complex]]) -> complex | None:
    """The intersection of lines through places perpendicular to their velocities; of the two least parallel ones."""
    best = LEAST_CROSSING_SINE
    centre = None
    for (a, v), (b, w) in combinations(moving, 2):
        if not v or not w:
            continue
        across = (v.conjugate() * w).imag
        if abs(across) > best * abs(v) * abs(w):
            best = abs(across) / (abs(v) * abs(w))
            centre = a + 1j * v * ((b - a) * w.conjugate()).real / across
    return centre
