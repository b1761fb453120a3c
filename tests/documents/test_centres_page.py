"""The chapter of instantaneous centres on a page: by choice, live as the crank turns, in every language."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from planes import cli
from planes.lesson.data import lesson_data
from planes.lesson.formulas import LESSON_LANGS
from planes.lesson.told import SceneLesson
from planes.scene import load
from tests.documents.test_lesson_for_everyone import complaints
from tests.helpers import ROOT
from tests.helpers.lessons import lesson_opened, lesson_written

SLIDER = ROOT / "samples" / "kind-2-rrp.yaml"
SAMPLES = sorted([*ROOT.glob("samples/*.yaml"), *ROOT.glob("samples/class-*/*.yaml")])
TURNED = """() => { const said = new Set(), own = data.frames.map((f, k) => k).filter(
        k => data.frames[k].chapter === "centres");
    for (let at = 0; at < 24; at++) for (const k of own) { turn(data.drive.from + at *
        (data.drive.to - data.drive.from) / 24); go(k); said.add($("sentence").innerText); }
    handout();
    return [own.length, [...said].filter(t => /undefined|NaN|[{}]/.test(t))]; }"""


def with_centres(folder: Path, scene: Path, lang: str) -> str:
    return lesson_written(folder, scene, lang, lesson_data(load(str(scene)), centres=True))


def test_the_chapter_is_there_by_choice_alone(tmp_path: Path, capsys: Any) -> None:
    plain, more = SceneLesson.of(load(str(SLIDER))), SceneLesson.of(load(str(SLIDER)), True)
    chapter = [f for f in more.frames if f.chapter == "centres"]
    assert not any(f.chapter == "centres" for f in plain.frames)
    assert [f.words_with_rows for f in more.frames if f not in chapter] == [f.words_with_rows for f in plain.frames]
    assert more.practice.practice_id == plain.practice.practice_id
    for f in chapter:
        assert {*f.words_with_rows} == {*f.why} == {*LESSON_LANGS} and len({*f.why.values()}) == len(LESSON_LANGS), (
            f.key
        )
    sizes = []
    for options in ([], ["--centres"]):
        target = tmp_path / "lesson.html"
        assert cli.main(["lesson", str(SLIDER), *options, "-o", str(target), "--lang", "en"]) == 0
        sizes.append(target.stat().st_size)
    assert sizes[0] < sizes[1] < 1.1 * sizes[0]


@pytest.mark.slow
def test_a_centre_that_is_not_to_be_seen_is_told_of(browser: Any, tmp_path: Path) -> None:
    with lesson_opened(browser, with_centres(tmp_path, SLIDER, "en")) as page:
        page.evaluate("go(data.frames.findIndex(f => f.makes[0] === 'position:P_20'))")
        for angle, told in ((150, "the lines are parallel: P20 is at infinity"), (149.9, "P20 lies off the sheet")):
            page.evaluate(f"turn({angle}); draw()")
            assert told in page.inner_text("#sentence").replace("\n", "")
        page.evaluate("turn(50); draw()")
        shown = page.inner_text("#sentence").replace("\n", "")
        assert "sheet" not in shown and "infinity" not in shown
        assert page.locator("#scheme .centre-line").count() == 2
        near = """(() => { const p = live.at('position:P_20'), q = live.at('position:C'), r = live.at('position:B');
            return [live.value('omega_2') * Math.hypot(p[0] - q[0], p[1] - q[1]) / live.given.mu_position,
                    live.value('omega_2') * Math.hypot(p[0] - r[0], p[1] - r[1]) / live.given.mu_position,
                    Math.hypot(...live.at('velocity:c')), Math.hypot(...live.at('velocity:b')), live.given.mu_velocity];
            })()"""
        c, b, vc, vb, mu = page.evaluate(near)
        assert abs(c) == pytest.approx(vc / mu, rel=1e-9) and abs(b) == pytest.approx(vb / mu, rel=1e-9)
        assert page.evaluate("[...$('chapter').options].map(o => o.text)")[2].endswith("Instantaneous centres")
        assert complaints(page) == []
        printed = "[...document.querySelectorAll('#handout article')].filter(a => a.querySelector('circle.centre'))"
        page.evaluate("handout()")
        assert page.evaluate(f"{printed}.map(a => a.querySelector('h2').textContent.slice(0, 21))") == [
            "Instantaneous centres"
        ]
        page.evaluate("draw(); go(data.frames.findIndex(f => f.key === 'centres_first'))")
        assert "P30 ⊥q-q" in page.inner_text("#sentence").replace("\n", "")


@pytest.mark.few(0, slow=7)
@pytest.mark.parametrize("path", SAMPLES, ids=[p.stem for p in SAMPLES])
def test_every_sample_shows_its_centres_at_every_place(browser: Any, tmp_path: Path, path: Path) -> None:
    with lesson_opened(browser, with_centres(tmp_path, path, "ru")) as page:
        frames, wrong = page.evaluate(TURNED)
        assert wrong == [] and (frames > 2 or path.stem.startswith(("bntu", "vectors")))  # these stand still


def test_what_three_centres_do_not_give_is_told() -> None:
    told = SceneLesson.of(load(str(ROOT / "samples" / "excavator.yaml")), True)
    last = [f for f in told.frames if f.chapter == "centres"][-1]
    assert (
        last.key == "centres_left" and "⟨P_50⟩" in last.words_with_rows["en"] and "⟨P_23⟩" in last.words_with_rows["en"]
    )
