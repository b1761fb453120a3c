"""Stamps of the studio: each is drawn onto a crank, and is the group that its name says."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from planes.plans import structure_of
from planes.scene import loads
from planes.solving import plans_and_requested_results
from planes.solving.of_scene import solve
from tests.helpers.browser import chromium, until
from tests.helpers.studios import Hand, served

DESK = {"width": 1400, "height": 900}
KINDS = ("RRR", "RRP", "RPR", "PRP", "RPP")


@pytest.fixture(scope="module")
def page() -> Iterator[Any]:
    pytest.importorskip("uvicorn", reason="install the test extra: pip install -e '.[test]'")
    with chromium() as browser, served() as address:
        opened = browser.new_page(viewport=DESK)
        opened.goto(address)
        until(opened, "document.querySelectorAll('[data-scene]').length > 5")
        yield opened


def crank(page: Any) -> Hand:
    """A new mechanism with a crank and its motor, drawn by one stamp: A on the frame, B at the crank's end."""
    hand = Hand.on_fresh(page)
    hand.tool("motor")
    hand.drag((-0.2, 0.0), (-0.15, 0.0866))
    return hand


def text_of(page: Any) -> str:
    """The text, once the engine has seen it."""
    until(page, "engine.idle()")
    found: str = page.evaluate("bench.text")
    return found


@pytest.mark.few(1)
@pytest.mark.parametrize("stamp", KINDS)
def test_a_stamp_on_a_crank_is_a_group_of_its_kind(page: Any, stamp: str) -> None:
    """Joined to the crank's end at one side and to the frame at the other; what the text says is solved."""
    hand = crank(page)
    hand.tool(stamp)
    x, y = hand.points()["B"]
    if stamp == "PRP":  # its first slider runs on a rod of the crank
        hand.drag((x, y), (0.1, 0.2))
    else:
        hand.drag((x, y), (0.1, 0.0))
    text = text_of(page)
    scene = loads(text)
    assert scene.mechanism
    groups = structure_of(scene.mechanism, "s").groups
    assert [g.pair_letters for g in groups] == [stamp], text
    assert set(scene.mechanism.links) == {"1", "2", "3"}
    assert solve(scene).omega["1"] == 10
    assert len(text.splitlines()) < 16 and "offset" not in text


def test_a_cylinder_drives_a_rocker(page: Any) -> None:
    """Between a hinge of the frame and a point of the rocker; the length of the cylinder is the drive's."""
    hand = Hand.on_fresh(page)
    hand.tool("fix")
    hand.press(-0.2, 0.0)
    hand.tool("link")
    hand.drag((-0.2, 0.0), (0.0, 0.2))
    hand.tool("cylinder")
    x, y = hand.points()["B"]
    hand.drag((0.1, -0.1), (x, y))
    scene = loads(text_of(page))
    assert scene.mechanism and scene.mechanism.drive.kind == "s" and scene.mechanism.drive.link == "3"
    assert solve(scene).omega["1"] != 0


def test_a_motor_stands_in_a_hinge_of_two_moving_links(page: Any) -> None:
    hand = crank(page)
    hand.tool("RRR")
    hand.drag(tuple(hand.points()["B"]), (0.1, 0.0))  # type: ignore[arg-type]
    hand.tool("motor")
    hand.press(*hand.points()["B"])
    scene = loads(text_of(page))
    assert scene.mechanism and scene.mechanism.drive.on == "1" and scene.mechanism.drive.link == "2"
    assert plans_and_requested_results(scene)[0].structure.structural_formula.startswith("I(1;2)")


def test_a_stamp_is_placed_by_two_clicks_and_by_keys(page: Any) -> None:
    """A click at each end does what a drag does; so do Tab and Enter on the canvas."""
    hand = crank(page)
    hand.tool("RRR")
    hand.press(*hand.points()["B"])
    hand.press(0.1, 0.0)
    assert set(loads(text_of(page)).mechanism.links) == {"1", "2", "3"}  # type: ignore[union-attr]
    hand = crank(page)
    hand.tool("fix")
    hand.press(0.1, 0.0)
    hand.tool("RRR")
    page.focus("#canvas")
    page.evaluate("(() => { canvas.chosen = 'B'; return 1; })()")
    page.keyboard.press("Enter")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    assert set(loads(text_of(page)).mechanism.links) == {"1", "2", "3"}  # type: ignore[union-attr]


def test_marks_show_what_can_be_dragged_until_the_first_drag(page: Any) -> None:
    """Three marks on hinges; a drag takes them away for good, and no reader of the screen is told of them."""
    page.evaluate("localStorage.clear()")
    page.goto(page.evaluate("location.origin"))
    until(page, "document.querySelectorAll('[data-scene]').length > 5")
    page.locator("[data-scene=four-bar]").click()
    page.locator("#views [data-view=draw]").click()
    until(page, "document.querySelectorAll('#canvas .draggable').length === 3")
    assert page.evaluate("[...document.querySelectorAll('.draggable')].every(e => e.ariaHidden === 'true')")
    page.emulate_media(media="print")
    assert page.evaluate("[...document.querySelectorAll('.draggable')].every(e => !e.checkVisibility())")
    page.emulate_media(media="screen")
    hand = Hand(page)
    hand.rest()
    x, y = hand.points()["A"]
    hand.drag((x, y), (x + 0.02, y))
    assert page.evaluate("document.querySelectorAll('#canvas .draggable').length") == 0
    page.goto(page.evaluate("location.origin"))
    until(page, "document.querySelectorAll('[data-scene]').length > 5")
    page.locator("[data-scene=four-bar]").click()
    page.locator("#views [data-view=draw]").click()
    hand.rest()
    until(page, "document.querySelectorAll('#canvas .hinge').length > 3")
    assert page.evaluate("document.querySelectorAll('#canvas .draggable').length") == 0
