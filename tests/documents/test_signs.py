"""The signs of the pages are those of the paper: a page has no shapes, sizes or line widths of its own."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest

from planes.lesson.data import lesson_data
from planes.scene import load, loads
from render.page.lesson_page import lesson_lettering
from render.page.signs import page_signs
from render.paper import symbols
from render.paper.marks import Arc, Line, Mark
from render.paper.style import (
    INNER_BLOCK_SIZE_MM,
    OUTER_BLOCK_SIZE_MM,
    PEN_BY_STYLE,
    ROUND_HATCHING_DEPTH_MM,
    arrowhead_corners,
    arrowhead_size,
)
from tests.helpers import ROOT
from tests.helpers.lessons import lesson_opened, lesson_written

SAMPLES = ROOT / "samples"
PX = 96 / 25.4  # to a mm
NARROW = {"width": 390, "height": 800}
ARC = """\
planes: 1
frame: {points: {O: [0, 0]}, guides: {arc: {centre: [0.3, 0], radius: 0.2}}}
links:
  1: {points: {O: 0, A: 0.1}}
  2: {points: {A: 0, B: 0.3}}
  3: {points: {B: 0}, slides: arc}
assembly: {B: left}
drive: {link: 1, phi: 40, omega: 10}
"""
DRAWN = """(() => {
  const figure = scheme, unit = figure.unit, at = {}, turned = {};
  for (const n in data.marks) at[n] = figure.spot(n);
  for (const n in data.turned) turned[n] = live.angle(n);
  const shapes = [...figure.node.querySelectorAll('.thick, .thin')].filter(e => !e.classList.contains('rail'));
  const kept = e => ['d', 'cx', 'cy', 'r'].map(k => e.getAttribute(k));
  return JSON.stringify({ unit, at, turned, shapes: shapes.map(e => [e.classList[0], ...kept(e)]) });
})()"""
ARROWS = """JSON.stringify([...document.querySelectorAll('#plan .arrow')].map(g => ({
  cls: g.getAttribute('class'), tip: g.querySelector('polygon')?.getAttribute('points'),
  start: ['x1', 'y1'].map(k => +g.firstChild.getAttribute(k)), width: getComputedStyle(g.firstChild).strokeWidth })))"""

Stroke = tuple[str, tuple[complex, ...], float]


def shown(page: Any) -> tuple[Any, list[Stroke]]:
    """The figure, and what is drawn on it with the pens of signs, y up, px: lines, and circles with a radius."""
    figure = json.loads(page.evaluate(DRAWN))
    strokes: list[Stroke] = []
    for pen, path, x, y, r in figure["shapes"]:
        if path is None:
            strokes.append((pen, (complex(float(x), -float(y)),), float(r)))
        for line in re.findall(r"M([^MZ]+)", path or ""):
            strokes.append(
                (pen, tuple(complex(float(x), -float(y)) for x, y in re.findall(r"([-\d.]+),([-\d.]+)", line)), 0)
            )
    return figure, strokes


def placed(marks: Iterable[Mark], at: list[float], unit: float) -> Iterator[Stroke]:
    """Marks about zero, of paper, at a place of a figure."""
    z = complex(at[0], -at[1])
    for m in marks:
        if isinstance(m, Line):
            yield m.style, tuple(z + unit * p for p in m.points), 0.0
        elif isinstance(m, Arc):
            yield m.style, (z + unit * m.centre,), unit * m.radius


def alike(one: Stroke, other: Stroke) -> bool:
    close = len(one[1]) == len(other[1]) and max(abs(a - b) for a, b in zip(one[1], other[1], strict=True)) < 0.16
    return one[0] == other[0] and close and abs(one[2] - other[2]) < 0.02


def same(drawn: list[Stroke], wanted: list[Stroke]) -> None:
    """All that is wanted is drawn, and nothing else."""
    assert wanted and not [w for w in wanted if not any(alike(w, d) for d in drawn)]
    assert not [d for d in drawn if not any(alike(w, d) for w in wanted)]


def scheme_of(name: str) -> Any:
    return lesson_data(loads((SAMPLES / name).read_text("utf-8")))["scheme"]


def hinges_and_points(scheme: Any, more: tuple[str, ...] = ()) -> dict[str, symbols.Marks]:
    """Points of two links, and fixed ones, are hinges."""
    points = [p for x in scheme["links"] for p in x["points"]]
    hinges = {*(p for p in points if points.count(p) > 1), *scheme["pivots"], *more}
    return {p: symbols.hinge(0j) if p in hinges else symbols.dot(0j) for p in points}


@pytest.mark.parametrize("wide", [True, False])
def test_a_mechanism_has_the_signs_of_its_sheet(browser: Any, tmp_path: Path, wide: bool) -> None:
    scheme = scheme_of("six-link.yaml")
    with lesson_opened(browser, lesson_written(tmp_path, SAMPLES / "six-link.yaml")) as page:
        if not wide:
            page.set_viewport_size(NARROW)
        page.evaluate("(scheme.measure(), go(data.frames.length - 1))")
        figure, drawn = shown(page)
    assert figure["unit"] == pytest.approx(PX if wide else 0.75 * PX)
    wanted = [(p, marks) for p, marks in hinges_and_points(scheme).items()]
    wanted += [(p, symbols.fixed_hinge(0j)) for p in scheme["pivots"]]
    wanted += [
        (
            x["points"][0],
            symbols.block(
                0j, figure["turned"][f"∥{x['slides']}"], {"4": INNER_BLOCK_SIZE_MM, "5": OUTER_BLOCK_SIZE_MM}[x["name"]]
            ),
        )
        for x in scheme["links"]
        if x["slides"]
    ]
    same(drawn, [s for mark, marks in wanted for s in placed(marks, figure["at"][mark], figure["unit"])])


@pytest.mark.parametrize("name", ["six-link", "class-four/tray", "statics/portal"])
def test_a_mark_is_lettered_without_its_plan(name: str) -> None:
    """A point reads B, not position:B."""
    data = lesson_data(load(SAMPLES / f"{name}.yaml"), practice=False)
    for table in lesson_lettering(data).values():
        read = {name: "".join(text for text, _ in pieces) for name, pieces in table.items()}
        assert not [text for text in read.values() if ":" in text]


def test_the_letters_on_a_scheme_are_those_of_its_points(browser: Any, tmp_path: Path) -> None:
    with lesson_opened(browser, lesson_written(tmp_path, SAMPLES / "six-link.yaml")) as page:
        page.evaluate("go(data.frames.findLastIndex(f => f.plan === 'position'))")
        shown = page.evaluate("[...document.querySelectorAll('#scheme .label')].map(e => e.textContent).join(', ')")
    assert {"A", "B", "C", "D", "H", "L", "S2"} <= set(shown.split(", "))


@pytest.mark.parametrize(("name", "clamped"), [("portal", False), ("cantilever", True)])
def test_supports_are_those_of_the_sheet(browser: Any, tmp_path: Path, name: str, clamped: bool) -> None:
    """A roller has a hinge on its wheels; a wall stands across the body that it clamps."""
    scheme = scheme_of(f"statics/{name}.yaml")
    with lesson_opened(browser, lesson_written(tmp_path, SAMPLES / f"statics/{name}.yaml")) as page:
        page.evaluate("go(data.frames.length - 1)")
        figure, drawn = shown(page)
    held = {s["mark"]: s for s in scheme["signs"] if s["sign"] in ("roller", "clamp")}
    rollers = tuple(mark for mark, s in held.items() if s["sign"] == "roller")
    wanted = [(p, marks) for p, marks in hinges_and_points(scheme, rollers).items()]
    wanted += [(p, symbols.fixed_hinge(0j)) for p in scheme["pivots"]]
    wanted += [(mark, symbols.clamp_wall(0j) if clamped else symbols.roller(0j)) for mark in held]
    same(drawn, [s for mark, marks in wanted for s in placed(marks, figure["at"][mark], figure["unit"])])


def test_an_arc_of_the_frame_is_hatched_as_on_the_sheet(browser: Any, tmp_path: Path) -> None:
    (tmp_path / "arc.yaml").write_text(ARC, encoding="utf-8")
    with lesson_opened(browser, lesson_written(tmp_path, tmp_path / "arc.yaml")) as page:
        page.evaluate("go(data.frames.length - 1)")
        _, drawn = shown(page)
        arc = page.evaluate("document.querySelector('#scheme .rail.arc, #scheme .rail').getAttribute('d')")
    ways = [b - a for pen, (a, *rest), _ in drawn for b in rest if pen == "thin" and len(rest) == 1]
    assert arc.count("A") == 1 and sum(abs(abs(way) / PX - ROUND_HATCHING_DEPTH_MM) < 0.05 for way in ways) > 15


def test_arrows_of_a_plan_have_the_heads_and_pens_of_the_sheet(browser: Any, tmp_path: Path) -> None:
    with lesson_opened(browser, lesson_written(tmp_path, SAMPLES / "six-link.yaml")) as page:
        page.evaluate("go(data.frames.findLastIndex(f => f.plan === 'acceleration'))")
        arrows = json.loads(page.evaluate(ARROWS))
    assert len(arrows) > 4
    for arrow in arrows:
        corners = [complex(*map(float, q.split(","))) for q in (arrow["tip"] or "").split()]
        start = complex(*arrow["start"])
        lit = "lit" in arrow["cls"]
        pen = "vector" if "part" in arrow["cls"] and not lit else "thick"
        long, wide = arrowhead_size(abs(corners[0] - start) / PX, PEN_BY_STYLE[pen].width)
        wanted = arrowhead_corners(corners[0], corners[0] - start, long * PX, wide * PX)
        assert all(min(abs(a - b) for b in corners) < 0.3 for a in wanted), arrow
        assert lit or float(arrow["width"].removesuffix("px")) == pytest.approx(PEN_BY_STYLE[pen].width * PX, abs=0.01)


def test_no_script_draws_a_sign_itself() -> None:
    """Whatever has the class of a sign comes from the table; rectangles and closed triangles are nobody's."""
    room = ROOT / "render" / "page"
    names = "|".join(page_signs()["signs"])
    for file in sorted(room.glob("*.js")):
        own = [line for line in file.read_text("utf-8").split("\n") if re.search(r'svg\("(path|rect|circle)"', line)]
        assert not [line for line in own if re.search(rf'"({names}|hatch)[" ]|"rect"', line)], file.name


def test_a_slotted_lever_is_drawn_once_its_slider_is(browser: Any, tmp_path: Path) -> None:
    """Before that, nothing constructed tells where it lies; at the end it is there."""
    with lesson_opened(browser, lesson_written(tmp_path, SAMPLES / "kind-3-rpr.yaml")) as page:
        levers = "document.querySelectorAll('#scheme .rail').length"
        page.evaluate("go(0)")
        assert page.evaluate(levers) == 0
        page.evaluate("go(data.frames.length - 1)")
        assert page.evaluate(levers) == 1
