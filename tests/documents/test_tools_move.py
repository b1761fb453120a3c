"""The tools of a lesson: each lies where its step is drawn, comes from where it is taken, and moves in time."""

from __future__ import annotations

from typing import Any

import pytest

from planes.lesson.data import lesson_data
from planes.scene import load
from tests.helpers import ROOT

SIX = ROOT / "samples" / "six-link.yaml"
ACTS = """() => data.frames.flatMap((f, k) => {
    go(k);
    const gap = (p, a, u) => Math.abs((p[0] - a[0]) * u[1] - (p[1] - a[1]) * u[0]);
    const far = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1]);
    return f.tools.map(t => {
        const act = KITS[t.tool](t);
        if (!act) return null;
        const [a, b] = t.to.map(m => kit.spot(m)), [c, d] = (t.from || []).map(m => kit.spot(m));
        const on = act.tool === "square" ? Math.max(gap(a, act.corner, act.u), gap(b, act.corner, act.u))
            : act.tool === "dividers" ? (b ? Math.max(far(a, act.goal[0]), far(b, act.goal[1])) : 0) : far(a, act.at);
        const slid = act.tool === "square" && c && d && far(c, d) > 5;
        const off = w => Math.max(gap(c, act.first, w), gap(d, act.first, w));
        return { frame: k, tool: act.tool, on, laid: slid ? Math.min(off(act.u), off(act.v)) : 0 };
    }).filter(Boolean); })"""


@pytest.mark.slow
def test_each_tool_lies_on_what_it_draws_and_comes_off_what_it_is_laid_to(page: Any) -> None:
    found = page.evaluate(ACTS)
    assert {"square", "compass", "dividers", "protractor"} == {f["tool"] for f in found}
    assert max(f["on"] for f in found) < 0.01  # px
    assert max(f["laid"] for f in found) < 0.01


@pytest.mark.slow
def test_while_a_tool_travels_neither_the_vector_nor_its_letter_is_there(page: Any) -> None:
    there = """() => { const k = data.frames.findIndex(f => f.makes[0] === 'velocity:c'); go(k - 1); go(k);
        kit.move();
        const seen = e => getComputedStyle(e).visibility !== 'hidden';
        const all = [...document.querySelectorAll('#plan .arrow.lit, #plan .label')];
        const during = all.filter(seen).length; kit.rest();
        return [during, all.filter(seen).length, document.querySelectorAll('#plan .awaited').length]; }"""
    during, after, awaited = page.evaluate(there)
    assert awaited > 0 and during < after


@pytest.mark.slow
def test_a_step_of_a_tool_takes_six_tenths_of_a_second_and_none_where_motion_is_not_wanted(page: Any) -> None:
    cross = "data.frames.findIndex(f => f.makes[0] === 'velocity:c')"
    seen = """k => { go(k - 1); go(k); return new Promise(done => {
        const told = [], begun = performance.now();
        const tool = () => document.querySelector('#kit .tool')?.getAttribute('d');
        const moving = () => document.querySelector('.panels').classList.contains('moving');
        const look = () => {
            told.push([performance.now() - begun, tool() || '', moving()]);
            told.at(-1)[0] < 1500 ? requestAnimationFrame(look) : done(told);
        };
        look(); }); }"""
    told = page.evaluate(f"({seen})({cross})")
    moving = [t for t, _, on in told if on]
    assert len({d for _, d, on in told if on}) > 3
    assert max(moving) < 1500 > told[-1][0] - 100
    assert not told[-1][2] and page.evaluate("ACT_MS") == 600
    page.emulate_media(reduced_motion="reduce")
    told = page.evaluate(f"({seen})({cross})")
    assert len({d for _, d, _ in told}) == 1 and told[0][1] and not any(on for *_, on in told)


@pytest.mark.slow
def test_what_is_measured_is_seen_while_it_is_measured(page: Any) -> None:
    """A vector that is just being drawn is not there yet; one that dividers are laid to is."""
    seen = """k => { go(k - 1); go(k); return new Promise(done => setTimeout(() => done(
        [...document.querySelectorAll('.arrow.lit')].map(a => getComputedStyle(a).visibility)), 300)); }"""
    measured, drawn = (
        page.evaluate(
            f"({seen})(data.frames.findIndex((f, k) => f.key === 'measured' && data.frames[k - 1].makes[0]) + {back})"
        )
        for back in (0, -1)
    )
    assert measured and set(measured) == {"visible"}
    assert set(drawn) <= {"hidden"}


@pytest.mark.slow
def test_a_tool_leaves_while_the_crank_spins_and_while_practising(page: Any) -> None:
    page.evaluate("go(8); kit.rest(); spin(true); draw()")
    assert page.evaluate("kit.over.childElementCount") == 0
    page.evaluate("spin(false); draw()")
    assert page.evaluate("kit.over.childElementCount") > 0
    page.evaluate("practice.toggle()")
    assert page.evaluate("kit.over.childElementCount") == 0


def test_tools_follow_from_the_kind_of_construction() -> None:
    frames = lesson_data(load(str(SIX)))["frames"]
    tools = {(f["key"], f["makes"][0]): [t["tool"] for t in f["tools"]] for f in frames if f["makes"]}
    assert tools["arcs", "position:C"] == ["compass", "compass"]
    assert tools["cross", "velocity:c"] == ["square", "square"]
    assert tools["lay_off", "acceleration:n_CB"] == ["square", "dividers"]
    assert tools["image", "velocity:l"] == ["protractor", "protractor"]
    drawn = {
        "arcs",
        "arc",
        "cross",
        "lay_off",
        "given",
        "found",
        "load",
        "carried",
        "image",
        "similar",
        "driver",
        "carry",
    }
    assert all(f["tools"] for f in frames if f["key"] in drawn)
