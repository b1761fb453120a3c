"""The studio in a browser: from the gallery to a changed dimension to a link opened elsewhere; drawn from nothing."""

from __future__ import annotations

import math
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from planes.documents.studio import engine_archive, write_studio
from planes.scene import load, loads
from planes.solving.of_scene import solve
from tests.helpers import ROOT
from tests.helpers.browser import until, watched
from tests.helpers.studios import INNER, SEEN, Hand, behind_files, served

DESK, PHONE = {"width": 1400, "height": 900}, {"width": 390, "height": 844}
SIX = ROOT / "samples" / "six-link.yaml"


@pytest.fixture(scope="module")
def address(browser: Any) -> Iterator[str]:
    pytest.importorskip("uvicorn", reason="install the test extra: pip install -e '.[test]'")
    with served("--scenes", "samples/class-three") as found:
        browser.new_page().goto(found)  # the token is in the cookie now
        yield found.split("?")[0]


def opened(browser: Any, address: str, size: dict[str, int] = DESK) -> Any:
    page = browser.new_page(viewport=size)
    page.complaints = watched(page)
    page.goto(address)
    until(page, "document.querySelectorAll('[data-scene]').length > 5")
    return page


def test_from_the_gallery_to_a_changed_dimension_to_a_link_opened_elsewhere(browser: Any, address: str) -> None:
    page = opened(browser, address)
    page.locator("[data-scene=four-bar]").click()
    until(page, SEEN)
    before = page.evaluate(f"{INNER}.live.given.l_AB")
    page.evaluate(f"(() => {{ {INNER}.live.set({{ l_AB: 0.38 }}); {INNER}.rested(); }})()")
    until(page, "/l_AB: 0.38/.test(bench.text)")
    until(page, "document.querySelectorAll('#lines .touched').length === 1")
    assert before == 0.35
    page.locator("#share").click()
    until(page, "/#s=/.test(location.href)")
    link = page.evaluate("location.href")
    other = browser.new_context().new_page(viewport=DESK)
    other.goto(link)  # a clean profile has no token for a server of somebody else's
    assert "token" in other.evaluate("document.body.textContent")
    again = browser.new_page(viewport=DESK)
    again.goto(link)
    until(again, SEEN)
    assert again.evaluate(f"{INNER}.live.given.l_AB") == 0.38
    assert not [c for c in page.complaints if not c.startswith(("http://127.0.0.1", "data:", "blob:"))]


def test_a_mechanism_is_drawn_from_nothing_by_mouse(browser: Any, address: str) -> None:
    """Its text is a scene of the mechanism that was drawn, and what it says is what the engine solves."""
    page = opened(browser, address)
    drawn_slider_crank(page)
    scene = loads(page.evaluate("bench.text"))
    found = solve(scene)
    mechanism = scene.mechanism
    assert mechanism and {*mechanism.links} == {"1", "2", "3"} and mechanism.links["3"].slides
    points = Hand(page).points()
    crank = math.dist(points["A"], points["B"])
    assert crank == pytest.approx(0.1, abs=1e-4) and abs(found.v["B"]) == pytest.approx(crank * 10, rel=1e-3)
    until(page, SEEN)
    assert page.evaluate(f"{INNER}.live.value('omega_2')") == pytest.approx(found.omega["2"], rel=1e-9)


def drawn_slider_crank(page: Any) -> None:
    page.locator("#fresh").click()
    hand = Hand(page)
    hand.tool("fix")
    hand.press(-0.2, 0.0)
    hand.tool("guide")
    hand.drag((-0.05, 0.0), (0.2, 0.0))
    hand.tool("link")
    hand.drag((-0.2, 0.0), (-0.15, 0.0866))
    start = hand.points()["B"]
    hand.drag((start[0], start[1]), (0.1, 0.0))
    end = hand.points()["C"]
    hand.tool("slide")
    hand.press(end[0], end[1])
    until(page, "/assembly/.test(bench.text)")
    hand.rest()


@pytest.mark.slow
def test_a_hinge_dragged_on_the_canvas_changes_the_line_that_places_it(browser: Any, address: str) -> None:
    page = opened(browser, address)
    page.evaluate(f"bench.open({SIX.read_text('utf-8')!r}, 'own')")
    until(page, SEEN)
    page.locator("[data-view=draw]").click()
    hand = Hand(page)
    hand.rest()
    hand.tool("move")
    x, y = hand.points()["D"]
    hand.drag((x, y), (x, y + 0.02))
    until(page, "/c_1: 0.25/.test(bench.text)")
    assert page.evaluate("bench.text.match(/#/g).length") == SIX.read_text("utf-8").count("#")
    page.locator("#undo").click()
    until(page, "/c_1: 0.27/.test(bench.text)")


@pytest.mark.slow
def test_an_open_assembly_is_chosen_by_its_picture(browser: Any, address: str) -> None:
    page = opened(browser, address)
    text = SIX.read_text("utf-8").replace("assembly: {C: right}", "assembly: {}")
    page.evaluate(f"bench.open({text!r}, 'own')")
    until(page, "document.querySelectorAll('#problems .card svg').length === 2")
    page.locator("[data-help='1']").click()
    until(page, SEEN)
    assert "right" in page.evaluate("bench.text.split('assembly')[1].slice(0, 20)")


def test_an_error_has_its_line_and_its_remedy(browser: Any, address: str) -> None:
    page = opened(browser, address)
    text = SIX.read_text("utf-8").replace("slides: CL", "slides: CLL")
    page.evaluate(f"bench.open({text!r}, 'own')")
    until(page, "document.querySelectorAll('#lines .wrong').length === 1")
    page.locator("#problems button").first.click()
    until(page, SEEN)
    assert page.evaluate("bench.text") == SIX.read_text("utf-8")


@pytest.mark.slow
def test_the_studio_on_a_telephone(browser: Any, address: str) -> None:
    """Nothing is wider than the screen in any view, and a mechanism is drawn there."""
    page = opened(browser, address, PHONE)
    drawn_slider_crank(page)
    until(page, SEEN)
    for view in ("gallery", "see", "draw", "text"):
        page.locator(f"[data-view={view}]").click()
        page.wait_for_timeout(120)
        assert page.evaluate("document.documentElement.scrollWidth - innerWidth") <= 0, view


@pytest.mark.few(1)
@pytest.mark.parametrize("lang", ["en", "ru"])
@pytest.mark.parametrize(("width", "height"), [(390, 844), (360, 740)])
def test_the_tools_of_a_telephone_are_two_rows(browser: Any, address: str, lang: str, width: int, height: int) -> None:
    """Each is brought into view by a finger or by Tab, and the canvas has a third of the screen at least."""
    page = opened(browser, address, {"width": width, "height": height})
    page.select_option("#lang", lang)
    page.locator("#fresh").click()
    tops = "[...new Set([...document.querySelectorAll('#tools button')].map(b => b.getBoundingClientRect().top))]"
    assert len(page.evaluate(tops)) == 2
    shown = "(b => b.left >= 0 && b.right <= innerWidth)(document.activeElement.getBoundingClientRect())"
    tools = page.evaluate("[...document.querySelectorAll('#tools button')].map(b => b.dataset.tool)")
    page.focus(f"[data-tool={tools[0]}]")
    for name in tools:
        assert page.evaluate("document.activeElement.dataset.tool") == name
        until(page, shown)
        page.keyboard.press("Tab")
    for name in tools:
        page.locator(f"[data-tool={name}]").click()
        assert page.get_attribute(f"[data-tool={name}]", "aria-pressed") == "true"
    page.locator("[data-tool=fix]").click()
    until(page, "document.getElementById('canvas').getBoundingClientRect().height > innerHeight / 3")
    assert page.evaluate("document.documentElement.scrollWidth - innerWidth") <= 0
    until(page, "(d => d.scrollWidth <= d.clientWidth)(document.getElementById('draw'))")


def test_on_a_telephone_it_says_what_came_of_a_button(browser: Any, address: str) -> None:
    page = opened(browser, address, PHONE)
    page.locator("[data-scene=four-bar]").click()
    until(page, SEEN)
    page.locator("#share").click()
    until(page, "document.getElementById('state').getBoundingClientRect().height > 10")
    assert "copied" in page.inner_text("#state")


@pytest.mark.slow
@pytest.mark.parametrize("view", ["gallery", "see", "draw", "text"])
def test_nobody_is_shut_out(browser: Any, address: str, view: str) -> None:
    """What axe finds in every view, in the light and in the dark."""
    axe = pytest.importorskip("axe_core_python", reason="install the test extra: pip install -e '.[test]'")
    page = opened(browser, address)
    page.evaluate(f"bench.open({SIX.read_text('utf-8')!r}, 'own')")
    until(page, SEEN)
    page.locator(f"[data-view={view}]").click()
    page.evaluate("(() => { canvas.chosen = 'C'; canvas.seen(); return 1; })()")
    page.evaluate((Path(axe.__file__).parent / "axe.min.js").read_text("utf-8"))
    found = page.evaluate(
        "axe.run(document, { iframes: false }).then(r => r.violations.map(v => [v.id, v.nodes.length]))"
    )
    assert found == []


def test_the_archive_of_the_engine_is_enough(tmp_path: Path) -> None:
    """A worker has the standard library and this archive, nothing installed."""
    (tmp_path / "planes.zip").write_bytes(engine_archive())
    script = f"import sys; sys.path.insert(0, {str(tmp_path / 'planes')!r}); import render.page.studio_page"
    shutil.unpack_archive(tmp_path / "planes.zip", tmp_path / "planes")
    ran = subprocess.run([sys.executable, "-I", "-S", "-c", script], check=False, capture_output=True, text=True)
    assert not ran.returncode, ran.stderr


@pytest.fixture(scope="module")
def runtime(tmp_path_factory: Any) -> str:
    """The folder of Pyodide, from the usual registry."""
    npm = shutil.which("npm")
    if not npm:
        pytest.skip("no npm here: install node and npm; the studio's engine for the browser comes from there")
    folder = tmp_path_factory.mktemp("runtime")
    ran = subprocess.run(
        [npm, "install", "--silent", "pyodide"], cwd=folder, check=False, capture_output=True, text=True
    )
    if ran.returncode:
        pytest.skip(f"npm could not install pyodide: {ran.stderr[-200:]}")
    return str(folder / "node_modules" / "pyodide")


@pytest.mark.slow
def test_the_engine_runs_in_the_browser_as_it_is(browser: Any, runtime: str, tmp_path: Path) -> None:
    """The gallery is there at once and its lesson before the engine; then texts are answered as on this machine."""
    write_studio(str(tmp_path / "site"), "en", runtime)
    with behind_files(tmp_path / "site") as where:
        page = opened(browser, where)
        page.locator("[data-scene=four-bar]").click()
        until(page, SEEN)
        assert not page.evaluate("engine.ready")
        until(page, "engine.ready")
        for path in (SIX, ROOT / "samples" / "class-three" / "press.yaml", ROOT / "samples" / "friction-circles.yaml"):
            text = path.read_text("utf-8")
            page.evaluate(f"bench.open({text!r}, 'own')")
            page.wait_for_timeout(60)
            until(page, f"engine.idle() && {SEEN} && {INNER}.data.id === planes.lesson.data.id")
            here = solve(load(path))
            for link, omega in here.omega.items():
                if (told := page.evaluate(f"{INNER}.live.value('omega_{link}')")) is not None:
                    assert told == pytest.approx(omega, rel=1e-9, abs=1e-12), (path.stem, link)
        edited = page.evaluate("ask({ ask: 'numbers', text: bench.text, lang: 'en', numbers: { omega_1: 12 } })")
        assert edited["text"] and not edited["problems"]


@pytest.mark.slow
def test_without_an_engine_the_gallery_lives_and_a_text_says_what_it_needs(browser: Any, tmp_path: Path) -> None:
    write_studio(str(tmp_path / "site"), "en")
    with behind_files(tmp_path / "site") as where:
        page = opened(browser, where)
        page.locator("[data-scene=four-bar]").click()
        until(page, SEEN)
        page.evaluate(f"{INNER}.turn(200)")
        page.locator("[data-view=text]").click()
        page.evaluate("bench.take(bench.text + '# more')")
        until(page, "document.getElementById('state').textContent.length > 20")


@pytest.mark.slow
def test_another_browser_shows_the_same() -> None:
    """Firefox: from the gallery to a dimension changed on the canvas."""
    from tests.helpers.firefox import firefox

    with served() as own, firefox() as window:
        window.goto(own)
        until(window, "document.querySelectorAll('[data-scene]').length > 5")
        window.evaluate("document.querySelector('[data-scene=four-bar]').click()")
        until(window, SEEN)
        until(window, "engine.idle() && canvas.sketch.points.C ? true : false")
        changed = "canvas.sketch.points.C[0] += 0.02, canvas.changed('move', true)"
        window.evaluate(f"(async () => {{ {changed}; return 1; }})()")
        until(window, "/0.42/.test(bench.text)")
        until(window, f"Math.abs(({INNER}?.live?.given['place_C.x'] ?? 0) - 0.42) < 1e-9")
        assert not [e for e in window.errors if "127.0.0.1" not in e]


@pytest.mark.slow
def test_a_picture_beneath_is_sized_by_a_length_on_it(browser: Any, address: str) -> None:
    """A person drags along a length he knows and types it; its first point stays where it is."""
    page = opened(browser, address)
    page.locator("#fresh").click()
    picture = "{ href: 'data:image/png;base64,iVBORw0KGgo=', at: [-0.3, 0.2], width: 0.6, ratio: 0.5 }"
    page.evaluate(f"(() => {{ canvas.under = {picture}; return 1; }})()")
    hand = Hand(page)
    hand.tool("measure")
    hand.drag((-0.1, 0.0), (0.1, 0.0))
    (x, y), (u, v) = page.evaluate("canvas.ruled")
    assert abs(complex(u - x, v - y)) == pytest.approx(0.2, abs=2e-3)
    assert page.inner_text("[data-word=underlay_width]") == "this length, m"
    page.select_option("#lang", "ru")
    assert page.inner_text("[data-word=underlay_width]") == "эта длина, м"
    page.select_option("#lang", "en")
    page.fill("#width", "0,5")  # with either decimal sign
    page.evaluate("document.getElementById('width').dispatchEvent(new Event('change'))")
    under, ruled = page.evaluate("[canvas.under, canvas.ruled]")
    k = 0.5 / abs(complex(u - x, v - y))
    assert under["width"] == pytest.approx(0.6 * k) and ruled[0] == [x, y]
    assert under["at"] == pytest.approx([x + k * (-0.3 - x), y + k * (0.2 - y)])
    assert abs(complex(ruled[1][0] - x, ruled[1][1] - y)) == pytest.approx(0.5)
