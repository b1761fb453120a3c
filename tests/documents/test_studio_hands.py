"""What a hand does on the studio's canvas beyond drawing: names, copies, typed sizes, a picture beneath."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import pytest

from planes.scene import loads
from tests.helpers import ROOT
from tests.helpers.browser import chromium, until
from tests.helpers.studios import SEEN, Hand, served

SIX = (ROOT / "samples" / "six-link.yaml").read_text("utf-8")


@pytest.fixture(scope="module")
def page() -> Iterator[Any]:
    pytest.importorskip("uvicorn", reason="install the test extra: pip install -e '.[test]'")
    with chromium() as browser, served() as address:
        opened = browser.new_page(viewport={"width": 1400, "height": 900})
        opened.goto(address)
        until(opened, "document.querySelectorAll('[data-scene]').length > 5")
        yield opened


def opened(page: Any, text: str) -> Hand:
    page.evaluate(f"bench.open({text!r}, 'own')")
    until(page, f"engine.idle() && {SEEN}")
    page.locator("#views [data-view=draw]").click()
    hand = Hand(page)
    hand.rest()
    hand.tool("move")
    return hand


def typed(page: Any, field: str, text: str) -> None:
    page.fill(field, text)
    page.evaluate(f"document.querySelector('{field}').dispatchEvent(new Event('change'))")
    page.wait_for_timeout(60)
    until(page, "engine.idle()")


def test_a_point_and_a_link_are_renamed_on_the_canvas(page: Any) -> None:
    """By a click and a field, or by keys; the text follows everywhere, and undo takes it back."""
    hand = opened(page, SIX)
    hand.press(*hand.points()["C"])
    typed(page, "#name", "K")
    until(page, "/D: 0, K: l_CD/.test(bench.text)")
    assert "C" not in hand.points() and page.evaluate("bench.text").count("#") == SIX.count("#")
    typed(page, "#name", "B")
    assert "taken" in page.inner_text("#problems") and page.get_attribute("#name", "aria-invalid") == "true"
    page.focus("#canvas")
    page.evaluate("(() => { canvas.chosen = '5'; return 1; })()")
    page.keyboard.press("F2")
    assert page.evaluate("document.activeElement.id") == "name"
    typed(page, "#name", "8")
    until(page, "/link: 8, point: H, force: 6000/.test(bench.text)")
    page.locator("#undo").click()
    page.locator("#undo").click()
    until(page, "canvas.sketch.points.C ? true : false")
    assert page.evaluate("bench.text") == SIX


def test_a_link_is_duplicated_and_its_copy_is_hung_up(page: Any) -> None:
    """The copy has points of its own beside the link; dropped on other points, they become hinges."""
    hand = opened(page, (ROOT / "planes" / "templates" / "four-bar.yaml").read_text("utf-8"))
    links = page.evaluate("Object.keys(canvas.sketch.links)")
    before = page.evaluate("bench.text")
    page.evaluate("(() => { canvas.chosen = '3'; canvas.seen(); return 1; })()")
    page.locator("#copy").click()
    until(page, f"Object.keys(canvas.sketch.links).length === {len(links) + 1}")
    hand.rest()
    copy = page.evaluate("canvas.chosen")
    ends = page.evaluate(
        f"canvas.sketch.links['{copy}'].points.filter(p => p !== canvas.sketch.links['{copy}'].centre)"
    )
    assert len(ends) > 1 and not {*ends} & {*page.evaluate("canvas.sketch.links['3'].points")}
    hand.drag(tuple(hand.points()[ends[0]]), tuple(hand.points()["B"]))  # type: ignore[arg-type]
    assert "B" in page.evaluate(f"canvas.sketch.links['{copy}'].points")
    page.locator("#undo").click()
    page.locator("#undo").click()
    until(page, f"Object.keys(canvas.sketch.links).length === {len(links)}")
    assert page.evaluate("bench.text") == before


def test_sizes_are_typed_for_what_is_chosen(page: Any) -> None:
    """A place and a length, in the units of the hand; a length goes to its parameter."""
    hand = opened(page, SIX)
    hand.press(*hand.points()["D"])
    typed(page, "#x", "-36 cm")
    until(page, "/b_1: 0.36/.test(bench.text)")
    page.evaluate("(() => { canvas.chosen = '2'; canvas.seen(); return 1; })()")
    typed(page, "#long", "310 mm")
    until(page, "bench.text.includes('l_BC: 310*0.001,')")
    assert loads(page.evaluate("bench.text")).mechanism


def test_a_picture_is_sized_by_two_clicks(page: Any) -> None:
    """Two points of it are clicked and their distance is typed in any unit; both ends are marked."""
    page.locator("#views [data-view=gallery]").click()
    page.locator("#fresh").click()
    picture = "{ href: 'data:image/png;base64,iVBORw0KGgo=', at: [-0.3, 0.2], width: 0.6, ratio: 0.5 }"
    page.evaluate(f"(() => {{ canvas.under = {picture}; return 1; }})()")
    hand = Hand(page)
    hand.tool("measure")
    hand.press(-0.1, 0.0)
    hand.press(0.1, 0.05)
    (x, y), (u, v) = page.evaluate("canvas.ruled")
    assert page.evaluate("document.activeElement.id") == "width"
    long = math.hypot(u - x, v - y)
    typed(page, "#width", "500 mm")
    assert page.evaluate("canvas.under.width") == pytest.approx(0.6 * 0.5 / long)
    (x, y), (u, v) = page.evaluate("canvas.ruled")
    assert math.hypot(u - x, v - y) == pytest.approx(0.5)
    assert page.evaluate("document.querySelector('#canvas .ruled').getAttribute('d').split('M').length") == 4
    page.evaluate("(() => { canvas.under = canvas.ruled = null; return 1; })()")


def test_a_number_typed_in_a_unit_is_in_the_text_as_it_was_typed(page: Any) -> None:
    """In a field of the lesson, and of what is chosen on the canvas."""
    opened(page, SIX)
    inner = "document.getElementById('lesson').contentWindow"
    for name, text, line in (
        ("l_AB", "120 mm", "l_AB: 120*0.001,"),
        ("omega_1", "-180 rpm", "omega: -180*pi/30,"),
        ("l_BC", "2*(0,1+0,06)", "l_BC: 2*(0.1+0.06),"),
    ):
        field = f"{inner}.document.querySelector('#knobs input[type=text][data-given={name}]')"
        page.evaluate(
            f"(() => {{ const f = {field}; f.value = '{text}'; f.dispatchEvent(new Event('input', "
            "{ bubbles: true })); f.dispatchEvent(new Event('change', { bubbles: true })); return 1; })()"
        )
        until(page, f"bench.text.includes('{line}')")
    hand = Hand(page)
    hand.rest()
    page.evaluate("(() => { canvas.chosen = '3'; canvas.seen(); return 1; })()")
    typed(page, "#long", "160 mm")
    until(page, "bench.text.includes('l_CD: 160*0.001,')")
