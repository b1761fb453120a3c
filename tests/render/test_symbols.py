"""Signs of schemes: where their lines are, and what is left of lines under hinges."""

from __future__ import annotations

import math

import pytest

from render.paper.ink import cut_out_shapes, visible_marks
from render.paper.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text
from render.paper.symbols import (
    bar,
    block,
    dot,
    fixed_hinge,
    hatched_base,
    hatching,
    hinge,
    plate,
    rail,
    rigid_joint_gusset,
    turn_arrow,
    unit_vector,
)


def lines(marks: tuple[Mark, ...]) -> list[Line]:
    return [mark for mark in marks if isinstance(mark, Line)]


@pytest.mark.parametrize("angle", [0, 90, 137, -90, 400])
def test_unit_is_a_direction(angle: float) -> None:
    assert abs(unit_vector(angle)) == pytest.approx(1)
    assert math.degrees(math.atan2(unit_vector(angle).imag, unit_vector(angle).real)) % 360 == pytest.approx(
        angle % 360
    )
    assert unit_vector(90) == 1j and unit_vector(-90) == -1j and unit_vector(180) == -1


@pytest.mark.parametrize("angle", [0, 30, 180])
def test_hatching_lies_on_its_side(angle: float) -> None:
    for side in (-1, 1):
        for stroke in hatching(5 + 5j, angle, 10, side):
            assert isinstance(stroke, Line) and stroke.style == "thin" and stroke.layer == "hatch"
            start, end = ((z - 5 - 5j) / unit_vector(angle) for z in stroke.points)
            assert start.imag == pytest.approx(0) and end.imag * side > 1
            assert abs(start.real) <= 5 + 1e-9


def test_a_fixed_hinge_starts_at_its_circle() -> None:
    *rest, circle = fixed_hinge(10 + 10j)
    assert isinstance(circle, Arc) and circle.fill == "paper" and circle.centre == 10 + 10j
    legs = [mark for mark in lines(tuple(rest)) if mark.layer == "scheme"][1:]
    assert all(abs(leg.points[0] - circle.centre) == pytest.approx(circle.radius) for leg in legs)
    assert all(leg.points[1].imag < 5 for leg in legs)


def test_a_slider_lies_along_its_guide() -> None:
    shape, outline = block(10 + 0j, 30, size=(12, 6))
    assert isinstance(shape, Shape) and shape.fill == "paper"
    assert isinstance(outline, Line) and outline.closed
    local = [(z - 10) / unit_vector(30) for z in outline.points]
    assert {(round(z.real, 9), round(z.imag, 9)) for z in local} == {(-6, -3), (6, -3), (6, 3), (-6, 3)}


@pytest.mark.parametrize("side", [-1, 1])
def test_guides_of_the_frame(side: int) -> None:
    marks = rail(0j, 40, 25, side, across=6)
    (along,) = [mark for mark in lines(marks) if mark.style == "thick"]
    assert [z / unit_vector(40) for z in along.points] == pytest.approx([-25 + 3j * side, 25 + 3j * side])
    strokes = [mark for mark in lines(marks) if mark.layer == "hatch"]
    assert len(strokes) >= 8
    assert all((z / unit_vector(40)).imag * side >= 3 - 1e-9 for stroke in strokes for z in stroke.points)


@pytest.mark.parametrize("sweep", [130, -200])
def test_a_turn_arrow_points_the_way_it_turns(sweep: float) -> None:
    arc, head = turn_arrow(5j, 9, 20, sweep)
    assert isinstance(arc, Arc) and isinstance(head, Shape) and arc.start_deg < arc.end_deg
    tip, *corners = head.points
    assert tip == pytest.approx(5j + 9 * unit_vector(20 + sweep))
    back = (sum(corners) / 2 - 5j) / (tip - 5j)
    assert math.copysign(1, -back.imag) == math.copysign(1, sweep)
    assert abs(abs(back) - 1) < 0.01


def test_small_signs() -> None:
    assert bar(0j, 1j) == (Line((0j, 1j)),)
    hatch, outline = plate((0j, 10 + 0j, 5j))
    assert isinstance(hatch, Hatch) and isinstance(outline, Line) and outline.closed
    assert hatch.angle_deg == 45 and plate((0j, 10 + 10j, 10j))[0].angle_deg == 135  # type: ignore[union-attr]
    (gusset,) = rigid_joint_gusset(0j, 20 + 0j, 30j)
    assert isinstance(gusset, Shape) and gusset.fill == "ink" and rigid_joint_gusset(0j, 20 + 0j, -30 + 1j) == ()
    assert dot(0j)[0].fill == "ink"  # type: ignore[union-attr]
    assert len(hatched_base(0j)) > 4


def test_a_bar_is_cut_between_its_hinges() -> None:
    hinges = [Arc(0j, 1.5), Arc(30 + 0j, 2), Arc(10 + 40j, 1)]
    (left,) = cut_out_shapes(bar(0j, 30 + 0j), hinges)
    assert isinstance(left, Line) and left.style == "thick"
    assert left.points == (pytest.approx(1.5, abs=1e-3), pytest.approx(28, abs=1e-3))
    first, second = cut_out_shapes(bar(-10 + 0j, 10 + 0j), hinges)
    assert isinstance(first, Line) and first.points[0] == -10 and isinstance(second, Line)
    assert cut_out_shapes(bar(5 + 5j, 9 + 9j), hinges) == bar(5 + 5j, 9 + 9j)
    assert cut_out_shapes([Line((0j, 1 + 0j))], hinges) == ()


def test_closed_lines_and_circles_keep_their_far_side() -> None:
    square = Line((0j, 10 + 0j, 10 + 10j, 10j), closed=True)
    (left,) = cut_out_shapes([square], [Arc(10 + 10j, 2)])
    assert isinstance(left, Line) and not left.closed and {0j, 10 + 0j, 10j} <= set(left.points)
    (corner,) = cut_out_shapes([square], [Arc(0j, 2)])
    assert isinstance(corner, Line) and len(corner.points) == 5
    (arc,) = cut_out_shapes([Arc(0j, 10)], [Arc(10 + 0j, 1)])
    half = math.degrees(2 * math.asin(0.05))
    assert isinstance(arc, Arc) and arc.radius == 10
    assert (arc.start_deg % 360, arc.end_deg % 360) == pytest.approx((half, 360 - half), abs=0.02)
    (open_arc,) = cut_out_shapes([Arc(0j, 10, 0, 90)], [Arc(10j, 1)])
    assert isinstance(open_arc, Arc)
    assert (open_arc.start_deg, open_arc.end_deg) == pytest.approx((0, 90 - half), abs=0.02)


def test_arrows_and_hatching_are_cut() -> None:
    (arrow,) = cut_out_shapes([Arrow(0j, 20 + 0j, name="P")], [Arc(0j, 2)])
    assert isinstance(arrow, Arrow) and arrow.name == "P" and arrow.start.real == pytest.approx(2, abs=1e-3)
    whole = Arrow(0j, 20 + 0j)
    assert cut_out_shapes([whole], [Arc(20 + 0j, 2)]) == (whole,)
    strokes = lines(cut_out_shapes([Hatch((0j, 20 + 0j, 20 + 20j, 20j), 0, 2)], [Arc(10 + 10j, 3)]))
    assert len(strokes) == 9 + 3
    assert all(abs(z - 10 - 10j) > 3 - 1e-3 for stroke in strokes for z in stroke.points)


def test_what_lies_under_paper_is_gone() -> None:
    marks: tuple[Mark, ...] = (*bar(-20 + 0j, 20 + 0j), *block(0j), *bar(0j, 30j), *hinge(0j), Text("C", 5j))
    seen = visible_marks(marks)
    assert not [mark for mark in seen if getattr(mark, "fill", "") == "paper"]
    thick = [mark for mark in lines(seen) if mark.style == "thick" and not mark.closed]
    ends = sorted(min(abs(z) for z in mark.points) for mark in thick)
    assert ends == pytest.approx([1.5, 5.5, 5.5], abs=1e-3)
    assert visible_marks(seen) == seen
