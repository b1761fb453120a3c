"""What a hand does on the studio's canvas beyond drawing: names, copies, typed sizes, a picture beneath."""

from __future__ import annotations

import math
import zipfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from planes.scene import loads
from planes.solving.of_scene import solve
from tests.helpers import ROOT
from tests.helpers.browser import chromium, until
from tests.helpers.studios import INNER, SEEN, Hand, served

KEPT = "JSON.parse(localStorage.getItem('planes.scenes') ?? '[]')"
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


def chosen(page: Any, name: str) -> None:
    page.evaluate(f"(() => {{ canvas.chosen = '{name}'; canvas.seen(); return 1; }})()")


def place(hand: Hand, name: str) -> tuple[float, float]:
    x, y = hand.points()[name]
    return x, y


def along(rail: Any, way: complex, far: float) -> tuple[float, float]:
    """A place on a guide, so far from where it begins."""
    z = complex(*rail[1]) + way * far
    return z.real, z.imag


def typed_in_the_lesson(page: Any, numbers: dict[str, str]) -> None:
    """Numbers typed in the fields of the lesson, until the text has them."""
    inner = "document.getElementById('lesson').contentWindow"
    for name, text in numbers.items():
        until(page, f"engine.idle() && {SEEN}")
        before = page.evaluate("bench.text")
        field = f"{inner}.document.querySelector('#knobs input[type=text][data-given={name}]')"
        until(page, f"!!{field}")
        page.evaluate(
            f"(() => {{ const f = {field}; f.value = '{text}'; f.dispatchEvent(new Event('input', "
            "{ bubbles: true })); f.dispatchEvent(new Event('change', { bubbles: true })); return 1; })()"
        )
        until(page, f"bench.text !== {before!r}")
        Hand(page).rest()


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
    chosen(page, "3")
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
    chosen(page, "2")
    typed(page, "#long", "310 mm")
    until(page, "bench.text.includes('l_BC: 310*0.001,')")
    assert loads(page.evaluate("bench.text")).mechanism


def test_a_picture_is_sized_by_two_clicks(page: Any) -> None:
    """Two points of it are clicked and their distance is typed in any unit; both ends are marked."""
    hand = Hand.on_fresh(page)
    picture = "{ href: 'data:image/png;base64,iVBORw0KGgo=', at: [-0.3, 0.2], width: 0.6, ratio: 0.5 }"
    page.evaluate(f"(() => {{ canvas.under = {picture}; return 1; }})()")
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
    typed_in_the_lesson(page, {"l_AB": "120 mm", "omega_1": "-180 rpm", "l_BC": "2*(0,1+0,06)"})
    for line in ("l_AB: 120*0.001,", "omega: -180*pi/30,", "l_BC: 2*(0.1+0.06),"):
        assert line in page.evaluate("bench.text")
    hand = Hand(page)
    hand.rest()
    chosen(page, "3")
    typed(page, "#long", "160 mm")
    until(page, "bench.text.includes('l_CD: 160*0.001,')")


@pytest.mark.slow
def test_the_six_link_is_drawn_from_nothing_by_mouse(page: Any) -> None:
    """Snapping places hinges and guides, typed sizes do the rest: every number is that of the sample."""
    hand = Hand.on_fresh(page)
    page.evaluate("(() => { canvas.chosen = ''; return 1; })()")
    hand.tool("fix")
    hand.press(0.0, 0.0)
    hand.press(-0.3, -0.2)
    hand.tool("move")
    hand.press(*hand.points()["B"])
    for field, text in (("#x", "-350 mm"), ("#y", "-270 mm")):
        typed(page, field, text)
    hand.tool("link")
    hand.drag((0.0, 0.0), (-0.0866, 0.05))  # AC, 0.1 m at 150°
    hand.drag(place(hand, "C"), (-0.3, -0.1))
    hand.drag(place(hand, "B"), place(hand, "D"))
    for link, text in (("2", "300 mm"), ("3", "150 mm")):
        chosen(page, link)
        typed(page, "#long", text)
    renamed = {"D": "T", "B": "D", "C": "B", "T": "C"}
    for was, now in renamed.items():
        chosen(page, was)
        typed(page, "#name", now)
    hand.tool("guide")
    hand.drag((-0.42, -0.2), (-0.42, 0.1))
    x, y = place(hand, "C")
    hand.drag((x, y), (x - 0.057, y + 0.082))  # nearly across BC
    hand.tool("PRP")
    text = page.evaluate("bench.text")
    rails = page.evaluate("Object.entries(canvas.sketch.guides).map(([n, g]) => [n, g.at, g.angle])")
    ways = [complex(math.cos(math.radians(a)), math.sin(math.radians(a))) for _, _, a in rails]
    upright, across = (next(k for k, w in enumerate(ways) if (abs(w.real) < 1e-6) is there) for there in (True, False))
    hand.drag(along(rails[across], ways[across], 0.06), along(rails[upright], ways[upright], 0.05))
    hand.rest()
    typed_in_the_lesson(page, {"omega_1": "-20", "epsilon_1": "80"})
    hand.tool("plate")
    start, end = complex(*place(hand, "B")), complex(*place(hand, "C"))
    at = start + (end - start) / 0.3 * 0.2
    hand.press(at.real, at.imag)
    hand.tool("mass")
    hand.press(*place(hand, "F"))
    for link in ("1", "3"):
        middle = page.evaluate(f"canvas.sketch.links['{link}'].points.map(p => canvas.sketch.points[p])")
        hand.press(*(sum(p[k] for p in middle[:2]) / 2 for k in (0, 1)))
    hand.press(*place(hand, "E"))
    hand.tool("load")
    hand.press(*place(hand, "E"))
    masses = {
        "m_1": "60",
        "J_1": "5",
        "m_2": "40",
        "J_2": "2",
        "m_3": "70",
        "J_3": "0.5",
        "m_5": "50",
        "P_5_given": "6 kN",
    }
    typed_in_the_lesson(page, masses)
    text = page.evaluate("bench.text")
    own, sample = loads(text), loads(SIX)
    assert own.mechanism and sample.mechanism

    ours, theirs = solve(own), solve(sample)
    for p in "ABCD":
        assert ours.r[p] == pytest.approx(theirs.r[p], abs=2e-5) and ours.v[p] == pytest.approx(theirs.v[p], abs=2e-3)
    for link, omega in theirs.omega.items():
        assert ours.omega[link] == pytest.approx(omega, rel=2e-4, abs=1e-3), link
        assert ours.epsilon[link] == pytest.approx(theirs.epsilon[link], rel=2e-4, abs=1e-2), link
    for name in ("F_50", "F_32", "M_1"):
        assert abs(ours.value(name)) == pytest.approx(abs(theirs.value(name)), rel=1e-3), name


def test_the_practice_is_asked_for_apart(page: Any) -> None:
    """Frames and tape come first; then the mistakes, with the tape that has their places. A late answer is dropped."""
    page.evaluate(f"bench.open({SIX!r}, 'own')")
    ready = f"({SEEN}) && {INNER}.data.pending === false && {INNER}.data.practice.length > 50"
    until(page, f"engine.idle() && {ready} && Math.abs({INNER}.live.value('omega_2') - 8.122472) < 1e-5")
    places = page.evaluate(f"{INNER}.data.slips.map(s => {INNER}.live.pair(s.place)).flat().every(Number.isFinite)")
    assert places
    page.evaluate(f"{INNER}.practice.toggle()")
    assert page.evaluate(f"{INNER}.practice.on && {INNER}.practice.items.length > 50")
    other = SIX.replace("phi_1: 150", "phi_1: 152").replace("C: right", "C: left")
    page.evaluate(f"(() => {{ bench.open({SIX!r}, 'own'); bench.open({other!r}, 'own'); return 1; }})()")
    until(page, f"engine.idle() && ({SEEN}) && {INNER}.data.home.angle_x_1 === 152 && {INNER}.data.pending === false")


def test_scenes_leave_and_come_back_as_an_archive(page: Any, tmp_path: Path) -> None:
    """Python's own archive of a folder is read, packed or stored; what is saved, Python reads; the last scenes stay."""
    page.evaluate("localStorage.removeItem('planes.scenes')")
    page.evaluate(f"bench.open({SIX!r}, 'own')")
    until(page, f"{KEPT}.length === 1")
    names = ["four-bar", "crank-slider"]
    texts = {f"курс/{n}.yaml": (ROOT / "planes" / "templates" / f"{n}.yaml").read_text("utf-8") for n in names}
    with zipfile.ZipFile(tmp_path / "mine.zip", "w", zipfile.ZIP_DEFLATED) as made:
        for name, text in texts.items():
            made.writestr(name, text)
        made.writestr("курс/notes.txt", "no scene")
    page.locator("#views [data-view=gallery]").click()
    page.set_input_files("#files-in", str(tmp_path / "mine.zip"))
    until(page, f"engine.idle() && {KEPT}.length >= 3")
    assert page.evaluate(f"{KEPT}.map(k => k.text)").count(SIX) == 1
    page.locator("#views [data-view=gallery]").click()
    with page.expect_download() as saving:
        page.locator("#files-out").click()
    saving.value.save_as(str(tmp_path / "out.zip"))
    with zipfile.ZipFile(tmp_path / "out.zip") as saved:
        assert saved.testzip() is None
        out = {saved.read(name).decode() for name in saved.namelist()}
        assert all(name.startswith("scenes/") and name.endswith(".yaml") for name in saved.namelist())
    assert out == {SIX, *texts.values()}
    (tmp_path / "broken.zip").write_bytes(b"PK\5\6" + b"\xff" * 40)
    before = page.evaluate(f"{KEPT}.length")
    page.set_input_files("#files-in", str(tmp_path / "broken.zip"))
    until(page, "document.getElementById('state').textContent.length > 10")
    assert page.evaluate(f"{KEPT}.length") == before


def test_a_new_mechanism_has_a_title_and_a_link_says_where_it_opens(page: Any) -> None:
    """Two new mechanisms are two in the history; a link of this computer is not taken for one to be sent."""
    page.evaluate("localStorage.removeItem('planes.scenes')")
    for _ in range(2):
        hand = Hand.on_fresh(page)
        hand.tool("motor")
        hand.drag((-0.2, 0.0), (-0.15, 0.0866))
    until(page, f"{KEPT}.length === 2")
    page.evaluate("(() => { canvas.chosen = ''; canvas.seen(); return 1; })()")
    typed(page, "#called", 'My "own" four-bar')
    until(page, "document.getElementById('title').textContent === 'My \"own\" four-bar'")
    page.locator("#share").click()
    until(page, "/this computer only/.test(document.getElementById('state').textContent)")
    page.evaluate("bench.take(bench.text + 'sheet: {studio: https://planes.example/studio/}\\n')")
    page.locator("#share").click()
    until(page, "/holds the whole/.test(document.getElementById('state').textContent)")
