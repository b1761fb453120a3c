"""The scheme of a group of class IV: the contour drawn aside with its base level, then turned to where it hangs.

With the base held still, what the group hangs on is a rod from the base's outer hinge to the basic link's: the basic
link stands on three leads, as one of class III does, and its hinge is found by a track. The figure is turned about the
base's outer hinge until the other outer hinge is where it hangs.
"""

from planes.drafting.steps import Image
from planes.drafting.steps.tracks import CutTrack, Hold
from planes.plans.bodies import SCHEME, Bodies
from planes.plans.contours import Contour
from planes.plans.groups import Lead
from planes.plans.positions import rigid_body
from planes.plans.reckoned import OwnPlace, angle_deg
from planes.plans.triads import cut_of, local_of
from planes.words.names import Meaning, at


def place_contour(b: Bodies, g: Contour) -> None:
    """Draw the contour aside, turn it to its outer hinges, and the links from that."""
    pivot, hinge = (pair.point for pair in g.outer)
    one, two = (_held_aside(b, g, pivot, lead) for lead in g.leads)
    apart = b.draft.measure(f"l_{pivot}{hinge}", at(SCHEME, pivot), at(SCHEME, hinge))
    link = b.mechanism.links[g.basic]
    rest = Hold("arc", local_of(b, link, hinge), at(SCHEME, pivot), apart)
    inner = [lead.inner.point for lead in g.leads]
    cut = cut_of(b, g, inner[0], (one, two, rest))
    for p in (inner[0], hinge):
        b.draft.step(CutTrack(_aside(p, pivot), local_of(b, link, p), *cut, means=Meaning("guide", p)))
    _turned(b, g, g.leads[0].outer.point)
    _turned(b, g, inner[0])
    for name, start, end in (
        (g.base, pivot, g.leads[0].outer.point),
        (g.basic, hinge, inner[0]),
        *((lead.link, lead.outer.point, lead.inner.point) for lead in g.leads),
    ):
        b.place_points(rigid_body(b, name, start, end))


def _aside(point: str, pivot: str) -> str:
    """The mark of a point on the figure aside."""
    return at(SCHEME, f"{point}°{pivot}")


def _held_aside(b: Bodies, g: Contour, pivot: str, lead: Lead) -> Hold:
    """A rod from the base, which is drawn level about its outer hinge."""
    d, base, p = b.draft, b.mechanism.links[g.base], lead.outer.point
    level = d.aim("→", 0.0, Meaning("given", g.base))
    angle = angle_deg(b.shape, OwnPlace(g.base, pivot), OwnPlace(g.base, p))
    along = d.turn(f"→{pivot}{p}", level, angle, Meaning("given", p))
    length = b.length(base, pivot, p)
    place = d.lay_off(SCHEME, f"{p}°{pivot}", at(SCHEME, pivot), along, length, Meaning("guide", p))
    reach = b.length(b.mechanism.links[lead.link], p, lead.inner.point)
    return Hold("arc", local_of(b, b.mechanism.links[g.basic], lead.inner.point), place, reach)


def _turned(b: Bodies, g: Contour, point: str) -> None:
    """A point of the figure aside where it is, by similarity."""
    pivot, hinge = (pair.point for pair in g.outer)
    start, end = at(SCHEME, pivot), at(SCHEME, hinge)
    of, like = (start, _aside(point, pivot)), (start, _aside(hinge, pivot))
    b.draft.step(Image(at(SCHEME, point), start, of, like, (start, end)))
