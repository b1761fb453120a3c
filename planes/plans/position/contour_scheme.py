"""The scheme of a group of class IV: the contour drawn aside with its base level, then turned into place.

With the base held still, the support of the group is one more lead from the base's outer hinge to the basic link: a rod
to the basic link's outer hinge, or a block in which its guide slides. So the basic link has three leads, as one of
class III, and its hinge is found by a track. The figure is turned about the base's outer hinge until the other outer
hinge is in its place, or the guide in its direction.
"""

from planes.drafting.steps import Image
from planes.drafting.steps.reckoning import Drop
from planes.drafting.steps.tracks import CutTrack, CutTurn, Hold
from planes.geometry.plane import greatest_distance
from planes.plans.assur.basic_links import Lead
from planes.plans.assur.contours import Contour
from planes.plans.position.bodies import Bodies, Body, BodyPoint
from planes.plans.position.positions import body_by_two_points, line_of_point_in_pair, place_slider
from planes.plans.position.reckoned import OwnPlace, dimension_difference, direction_between_points
from planes.plans.position.triads import (
    Cut,
    cut_of_basic_link_tracks,
    first_point_of_basic_link,
    place_lead,
    point_place_on_link,
    tie_of_lead,
)
from planes.words.names import NO_MARK, SCHEME_PLAN, Mark, Meaning, scheme_mark


def place_contour(b: Bodies, g: Contour) -> None:
    """Draw the contour aside, turn it into place, and draw the links from it."""
    aside = _Aside(b, g)
    one, two = map(aside.lead_tie_from_base, g.leads)
    key = first_point_of_basic_link(b, g)
    cut = cut_of_basic_link_tracks(b, g, key, (one, two, aside.support_tie_on_base()))
    aside.draw_basic_link_by_cut(key, cut)
    aside.draw_base_in_place()
    aside.draw_basic_link_in_place(key, cut)
    for lead in g.leads:
        place_lead(b, g.basic, lead)


def largest_link_size(b: Bodies, g: Contour) -> float:
    """The size of the largest of the group's links, m."""
    return max(greatest_distance(b.mechanism.links[x].points.values()) for x in g.links)


class _Aside:
    """The auxiliary figure: its base level, about the base's outer hinge."""

    def __init__(self, b: Bodies, g: Contour) -> None:
        self.bodies = b
        self.group = g
        self.draft = b.draft
        self.base = b.mechanism.links[g.base]
        self.basic = b.mechanism.links[g.basic]
        self.pivot = g.outer[0].point
        self.outer = g.outer[1]
        self.level = self.draft.draw_direction_at_angle("→", 0.0, Meaning("given", g.base))
        self.like = NO_MARK, NO_MARK  # marks of the figure and their places, each from the pivot

    def mark(self, point: str) -> Mark:
        """The mark of a point on the auxiliary figure."""
        return scheme_mark(f"{point}°{self.pivot}")

    def transfer_length_name(self) -> str:
        """A length by which directions are transferred: the largest of the group's links."""
        size = largest_link_size(self.bodies, self.group)
        return self.draft.add_given(f"l_{self.pivot}°", size, means=Meaning("guide", self.pivot))

    def lead_tie_from_base(self, lead: Lead) -> Hold:
        """The tie of a lead from the base, which is drawn level about its outer hinge, on the basic link."""
        b = self.bodies
        d = self.draft
        outer = lead.outer
        inner = lead.inner
        if outer.kind == "P":
            across = dimension_difference(
                b.point_offset_from_guide(outer, lead.link, inner.point),
                b.point_offset_from_guide(outer, self.base.name, self.pivot),
            )
            beside = Meaning("offset", inner.point, self.pivot)
            offset = "" if across is None else d.add_computed_given(f"e_{inner.point}{self.pivot}", across, beside)
            given = Meaning("angle", outer.guide, link=self.base.name)
            name = f"∥{outer.guide}°"
            angle = b.guide_angle_in_link(outer, self.base.name)
            along = d.draw_turned_direction(name, self.level, angle, Meaning("along", outer.guide), given)
            return Hold("line", point_place_on_link(b, self.basic, inner.point), scheme_mark(self.pivot), offset, along)
        p = outer.point
        turned = direction_between_points(
            b.link_dimensions, OwnPlace(self.base.name, self.pivot), OwnPlace(self.base.name, p)
        )
        way = d.draw_turned_direction(f"→{self.pivot}{p}", self.level, turned, Meaning("given", p))
        length = b.given_distance(self.base, self.pivot, p)
        place = d.lay_off(SCHEME_PLAN, f"{p}°{self.pivot}", scheme_mark(self.pivot), way, length, Meaning("guide", p))
        return tie_of_lead(b, self.basic.name, lead, place)

    def support_tie_on_base(self) -> Hold:
        """The tie of the group's support on the basic link, relative to the base."""
        b = self.bodies
        d = self.draft
        name = self.basic.name
        pivot = scheme_mark(self.pivot)
        if self.outer.kind == "R":
            apart = d.measure_segment(f"l_{self.pivot}{self.outer.point}", pivot, scheme_mark(self.outer.point))
            return Hold("arc", point_place_on_link(b, self.basic, self.outer.point), pivot, apart)
        first = self.basic.first_point
        guide = self.outer.guide
        start, self.along = line_of_point_in_pair(b, self.outer, name, first)
        means = Meaning("offset", self.pivot, first)
        off = d.add_step(
            Drop(f"e_{self.pivot}{guide}", scheme_mark(start), self.along, pivot, SCHEME_PLAN.mu_name, means=means)
        )
        turn = d.add_computed_given(f"guide_{guide}_{name}", b.guide_angle_in_link(self.outer, name))
        return Hold("guide", point_place_on_link(b, self.basic, first), pivot, off, turn)

    def draw_basic_link_by_cut(self, key: str, cut: Cut) -> None:
        """The basic link of the auxiliary figure, and the rotation of the figure."""
        d = self.draft
        b = self.bodies
        ends = (key, self.outer.point) if self.outer.kind == "R" else (key,)
        for p in ends:
            d.add_step(CutTrack(self.mark(p), point_place_on_link(b, self.basic, p), *cut, means=Meaning("guide", p)))
        if self.outer.kind == "R":
            self.like = self.mark(self.outer.point), scheme_mark(self.outer.point)
            return
        axis = self.basic_link_axis(key, cut)
        guide = self.outer.guide
        turned = b.guide_angle_in_link(self.outer, self.basic.name)
        aside = d.draw_turned_direction(f"∥{guide}°", axis, turned, Meaning("along", guide))
        helper = Meaning("guide", guide)
        start = scheme_mark(self.pivot)
        marks = ((f"{guide}°{self.pivot}", aside), (f"{guide}′{self.pivot}", self.along))
        one, two = (
            d.lay_off(SCHEME_PLAN, label, start, way, self.transfer_length_name(), helper) for label, way in marks
        )
        self.like = one, two

    def basic_link_axis(self, key: str, cut: Cut) -> str:
        """The basic link's axis in the auxiliary figure."""
        own = Meaning("own", self.basic.name)
        name = f"x_{self.basic.name}°"
        return self.draft.add_step(CutTurn(name, point_place_on_link(self.bodies, self.basic, key), *cut, means=own))

    def transfer_mark_to_true_place(self, label: str, aside: Mark, means: Meaning | None = None) -> Mark:
        """A mark of the figure in its true place, by similarity."""
        start = scheme_mark(self.pivot)
        shape = (start, aside), (start, self.like[0]), (start, self.like[1])
        return self.draft.draw_mark(Image(scheme_mark(label), start, *shape, means=means))

    def link_axis_in_true_direction(self, link: str, start: Mark, aside: Mark, along: str) -> str:
        """A link's axis in its true direction, with its start mark there."""
        helper = Meaning("guide", link)
        end = self.draft.lay_off(
            SCHEME_PLAN, f"x{link}°{self.pivot}", aside, along, self.transfer_length_name(), helper
        )
        return self.draft.draw_direction_through_marks(
            f"x_{link}", start, self.transfer_mark_to_true_place(f"x{link}′", end, helper), Meaning("own", link)
        )

    def draw_base_in_place(self) -> None:
        """The base, by a hinge with a lead, or by its own axis."""
        hinges = [lead.outer.point for lead in self.group.leads if lead.outer.kind == "R"]
        if hinges:
            self.transfer_mark_to_true_place(hinges[0], self.mark(hinges[0]))
            self.bodies.draw_missing_points(body_by_two_points(self.bodies, self.base.name, self.pivot, hinges[0]))
            return
        start = scheme_mark(self.pivot)
        axis = self.link_axis_in_true_direction(self.base.name, start, start, self.level)
        self.bodies.draw_missing_points(Body(self.base, BodyPoint(self.pivot, self.pivot), axis, self.base.name))

    def draw_basic_link_in_place(self, key: str, cut: Cut) -> None:
        """The basic link, by its outer hinge and another point, by its axis, or on its guide."""
        b = self.bodies
        name = self.basic.name
        hinge = self.outer.point
        if key != hinge:
            self.transfer_mark_to_true_place(key, self.mark(key))
        if self.outer.kind == "P":
            place_slider(b, self.outer, name, key, self.along)
        elif key != hinge:
            b.draw_missing_points(body_by_two_points(b, name, hinge, key))
        else:
            axis = self.link_axis_in_true_direction(
                name, scheme_mark(hinge), self.mark(hinge), self.basic_link_axis(key, cut)
            )
            b.draw_missing_points(Body(self.basic, BodyPoint(hinge, hinge), axis, name))
