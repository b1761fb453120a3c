"""The scheme of a group of class IV: the contour drawn aside with its base level, then turned into place.

With the base held still, the support of the group is one more lead from the base's outer hinge to the basic link: a rod
to the basic link's outer hinge, or a block in which its guide slides. So the basic link has three leads, as one of
class III, and its hinge is found by a track. The figure is turned about the base's outer hinge until the other outer
hinge is in its place, or the guide in its direction.
"""

from planes.drafting.steps import Image
from planes.drafting.steps.reckoning import Drop
from planes.drafting.steps.tracks import CutTrack, CutTurn, Hold
from planes.geometry.plane import spread
from planes.plans.assur.basic_links import Lead
from planes.plans.assur.contours import Contour
from planes.plans.position.bodies import SCHEME, Bodies, Body, BodyPoint, on_scheme
from planes.plans.position.positions import on_line, place_slider, rigid_body
from planes.plans.position.reckoned import OwnPlace, angle_deg, difference
from planes.plans.position.triads import Cut, cut_of, first_reached, hold_of, local_of, place_lead
from planes.words.names import Meaning, mu_of


def place_contour(b: Bodies, g: Contour) -> None:
    """Draw the contour aside, turn it into place, and draw the links from it."""
    aside = _Aside(b, g)
    one, two = map(aside.held, g.leads)
    key = first_reached(b, g)
    cut = cut_of(b, g, key, (one, two, aside.hung()))
    aside.cut(key, cut)
    aside.place_base()
    aside.place_basic(key, cut)
    for lead in g.leads:
        place_lead(b, g.basic, lead)


def largest(b: Bodies, g: Contour) -> float:
    """The size of the largest of the group's links, m."""
    return max(spread(b.mechanism.links[x].points.values()) for x in g.links)


class _Aside:
    """The auxiliary figure: its base level, about the base's outer hinge."""

    def __init__(self, b: Bodies, g: Contour) -> None:
        self.bodies, self.group, self.draft = b, g, b.draft
        self.base, self.basic = b.mechanism.links[g.base], b.mechanism.links[g.basic]
        self.pivot, self.outer = g.outer[0].point, g.outer[1]
        self.level = self.draft.aim("→", 0.0, Meaning("given", g.base))
        self.like: tuple[str, str] = ("", "")  # marks of the figure and their places, each from the pivot

    def mark(self, point: str) -> str:
        """The mark of a point on the auxiliary figure."""
        return on_scheme(f"{point}°{self.pivot}")

    def reach(self) -> str:
        """A length by which directions are transferred: the largest of the group's links."""
        size = largest(self.bodies, self.group)
        return self.draft.give(f"l_{self.pivot}°", size, means=Meaning("guide", self.pivot))

    def held(self, lead: Lead) -> Hold:
        """The tie of a lead from the base, which is drawn level about its outer hinge, on the basic link."""
        b, d, outer, inner = self.bodies, self.draft, lead.outer, lead.inner
        if outer.kind == "P":
            across = difference(b.offset(outer, lead.link, inner.point), b.offset(outer, self.base.name, self.pivot))
            beside = Meaning("offset", inner.point, self.pivot)
            offset = "" if across is None else d.reckon(f"e_{inner.point}{self.pivot}", across, beside)
            given = Meaning("angle", outer.guide, link=self.base.name)
            name, angle = f"∥{outer.guide}°", b.own_angle(outer, self.base.name)
            along = d.turn(name, self.level, angle, Meaning("along", outer.guide), given)
            return Hold("line", local_of(b, self.basic, inner.point), on_scheme(self.pivot), offset, along)
        p = outer.point
        turned = angle_deg(b.shape, OwnPlace(self.base.name, self.pivot), OwnPlace(self.base.name, p))
        way = d.turn(f"→{self.pivot}{p}", self.level, turned, Meaning("given", p))
        length = b.length(self.base, self.pivot, p)
        place = d.lay_off(SCHEME, f"{p}°{self.pivot}", on_scheme(self.pivot), way, length, Meaning("guide", p))
        return hold_of(b, self.basic.name, lead, place)

    def hung(self) -> Hold:
        """The tie of the group's support on the basic link, relative to the base."""
        b, d, name, pivot = self.bodies, self.draft, self.basic.name, on_scheme(self.pivot)
        if self.outer.kind == "R":
            apart = d.measure(f"l_{self.pivot}{self.outer.point}", pivot, on_scheme(self.outer.point))
            return Hold("arc", local_of(b, self.basic, self.outer.point), pivot, apart)
        first, guide = self.basic.first_point, self.outer.guide
        start, self.along = on_line(b, self.outer, name, first)
        means = Meaning("offset", self.pivot, first)
        off = d.step(Drop(f"e_{self.pivot}{guide}", on_scheme(start), self.along, pivot, mu_of(SCHEME), means=means))
        turn = d.reckon(f"guide_{guide}_{name}", b.own_angle(self.outer, name))
        return Hold("guide", local_of(b, self.basic, first), pivot, off, turn)

    def cut(self, key: str, cut: Cut) -> None:
        """The basic link of the auxiliary figure, and the rotation of the figure."""
        d, b = self.draft, self.bodies
        ends = (key, self.outer.point) if self.outer.kind == "R" else (key,)
        for p in ends:
            d.step(CutTrack(self.mark(p), local_of(b, self.basic, p), *cut, means=Meaning("guide", p)))
        if self.outer.kind == "R":
            self.like = self.mark(self.outer.point), on_scheme(self.outer.point)
            return
        axis, guide = self.axis(key, cut), self.outer.guide
        turned = b.own_angle(self.outer, self.basic.name)
        aside = d.turn(f"∥{guide}°", axis, turned, Meaning("along", guide))
        helper, start = Meaning("guide", guide), on_scheme(self.pivot)
        marks = ((f"{guide}°{self.pivot}", aside), (f"{guide}′{self.pivot}", self.along))
        one, two = (d.lay_off(SCHEME, label, start, way, self.reach(), helper) for label, way in marks)
        self.like = one, two

    def axis(self, key: str, cut: Cut) -> str:
        """The basic link's axis in the auxiliary figure."""
        own, name = Meaning("own", self.basic.name), f"x_{self.basic.name}°"
        return self.draft.step(CutTurn(name, local_of(self.bodies, self.basic, key), *cut, means=own))

    def turned(self, label: str, aside: str, means: Meaning | None = None) -> str:
        """A mark of the figure in its true place, by similarity."""
        start = on_scheme(self.pivot)
        shape = (start, aside), (start, self.like[0]), (start, self.like[1])
        return self.draft.step(Image(on_scheme(label), start, *shape, means=means))

    def axis_turned(self, link: str, start: str, aside: str, along: str) -> str:
        """A link's axis in its true direction, with its start mark there."""
        helper = Meaning("guide", link)
        end = self.draft.lay_off(SCHEME, f"x{link}°{self.pivot}", aside, along, self.reach(), helper)
        return self.draft.through(f"x_{link}", start, self.turned(f"x{link}′", end, helper), Meaning("own", link))

    def place_base(self) -> None:
        """The base, by a hinge with a lead, or by its own axis."""
        hinges = [lead.outer.point for lead in self.group.leads if lead.outer.kind == "R"]
        if hinges:
            self.turned(hinges[0], self.mark(hinges[0]))
            self.bodies.place_points(rigid_body(self.bodies, self.base.name, self.pivot, hinges[0]))
            return
        start = on_scheme(self.pivot)
        axis = self.axis_turned(self.base.name, start, start, self.level)
        self.bodies.place_points(Body(self.base, BodyPoint(self.pivot, self.pivot), axis, self.base.name))

    def place_basic(self, key: str, cut: Cut) -> None:
        """The basic link, by its outer hinge and another point, by its axis, or on its guide."""
        b, name, hinge = self.bodies, self.basic.name, self.outer.point
        if key != hinge:
            self.turned(key, self.mark(key))
        if self.outer.kind == "P":
            place_slider(b, self.outer, name, key, self.along)
        elif key != hinge:
            b.place_points(rigid_body(b, name, hinge, key))
        else:
            axis = self.axis_turned(name, on_scheme(hinge), self.mark(hinge), self.axis(key, cut))
            b.place_points(Body(self.basic, BodyPoint(hinge, hinge), axis, name))
