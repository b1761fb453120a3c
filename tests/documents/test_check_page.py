"""The report of a checked drawing in a real browser: what is moved is judged anew, as the program would judge it."""

from __future__ import annotations

import json
import random
import re
from pathlib import Path
from typing import Any

import pytest

from planes.batch.tape import LEAF_OPERATIONS, TEST_OPERATIONS
from planes.check.grading.grading import Grading, grading_without_marks
from planes.check.grading.paper import ReadMark, ReadPaper, read_table
from planes.check.grading.prepared_plan import Asked, mistake_variants, prepare
from planes.check.outcome import Outcome, check
from planes.check.report import Checked, phrases_for_reader, places
from planes.check.report.places import wrong_places
from planes.check.report.regrading import SCREEN_MARK_ERROR_MM, grading_tape
from planes.documents.check import write_report
from planes.documents.class_work import ClassWork
from planes.drafting.drawing import draw_program
from planes.scene import load
from planes.words.errors import PlanesError
from tests import confusion
from tests.helpers import ROOT
from tests.helpers.browser import watched
from tests.helpers.drawings import Care, Mistake

SAMPLES = ROOT / "samples"
CASES = [
    ("six-link", "velocity", Mistake("relative_from_pole", "c")),
    ("six-link", "acceleration", Mistake("coriolis_reversed", "k_HL")),
    ("six-link", "force:2-3", Mistake("inertia_along_acceleration", "I_2")),
    ("kind-3-rpr", "acceleration", Mistake("normal_missing", "n_B")),
    ("kind-5-rpp", "force:2-3", None),
]


def handed_in(sample: str, plan: str, mistake: Mistake | None, without: tuple[str, ...] = ()) -> Outcome:
    easel = confusion.easel(sample, plan)
    paper = confusion.hand_in(easel, mistake, Care(), random.Random(4))
    paper.spots = [s for s in paper.spots if s.name not in without]
    return check(Asked(load(SAMPLES / f"{sample}.yaml"), plan, mu=easel.mu), paper)


def opened(browser: Any, found: Outcome, tmp_path: Path, lang: str = "en") -> tuple[Any, list[str]]:
    target = tmp_path / "report.html"
    write_report(found, str(target), "ru" if lang == "ru" else "en")
    page = browser.new_page()
    errors = watched(page)
    page.goto(target.as_uri())
    return page, errors


def graded(found: Outcome) -> Grading:
    assert found.grading is not None
    return found.grading


def judged(page: Any) -> dict[str, Any]:
    """What the page finds: verdict, sentence and every mark's numbers."""
    return dict(
        page.evaluate("""() => ({ verdict: found.verdict, first: found.first, sentence: found.sentence,
        mistake: found.named ? found.named.mistake : null,
        marks: Object.fromEntries(marks.filter(m => m.read).map(m => { const f = found.marks[m.name];
            const sizes = [f.own, f.free].map(miss => miss.reach(found.limit));
            return [m.key, [f.verdict, f.own.x, f.own.y, ...sizes]]; })) })""")
    )


def same(page: Any, found: Outcome) -> None:
    """The page and the program find the same."""
    shown, grading = judged(page), graded(found)
    assert (shown["verdict"], shown["sentence"]) == (found.verdict, phrases_for_reader(found, "here")[0].told("en"))
    assert found.verdict == "unreadable" or (shown["first"], shown["mistake"]) == (found.first_wrong, found.mistake)
    assert set(shown["marks"]) == set(grading.judgement.misses)
    for mark, miss in grading.judgement.misses.items():
        verdict, x, y, own, free = shown["marks"][mark]
        assert verdict == grading.verdicts[mark], mark
        reach = miss.tolerance_mm(grading.judgement.limit)
        assert abs(complex(x, y) - miss.off) < 1e-6 + 0.01 * reach  # errors by slopes here, by differences there
        assert own == pytest.approx(reach, rel=0.05)
        assert free == pytest.approx(grading.free[mark].tolerance_mm(grading.judgement.limit), rel=0.05)


@pytest.mark.few(1)
@pytest.mark.parametrize(("sample", "plan", "mistake"), CASES)
def test_the_page_judges_as_the_program_does(
    browser: Any, tmp_path: Path, sample: str, plan: str, mistake: Mistake | None
) -> None:
    found = handed_in(sample, plan, mistake)
    assert found.mistake == (mistake.name if mistake else None)
    page, errors = opened(browser, found, tmp_path)
    same(page, found)
    page.close()
    assert errors == []


@pytest.mark.few(1)
@pytest.mark.parametrize(("sample", "plan", "mistake"), CASES)
def test_moved_marks_are_judged_anew_and_their_table_is_judged_alike(
    browser: Any, tmp_path: Path, sample: str, plan: str, mistake: Mistake | None
) -> None:
    found = handed_in(sample, plan, mistake)
    page, errors = opened(browser, found, tmp_path)
    rng = random.Random(2)
    for mark in graded(found).marks[:3]:
        name = mark.rpartition(":")[2]
        page.evaluate(f"move({name!r}, marks.find(m => m.name === {name!r}).x + {rng.uniform(5, 9)}, 3)")
        saved = tmp_path / "marks.csv"
        saved.write_text(page.evaluate("csv()"), encoding="utf-8")
        again = check(found.bench.asked, read_table(saved))
        shown = judged(page)
        assert (shown["verdict"], shown["first"]) == (again.verdict, again.first_wrong)
        assert shown["mistake"] == again.mistake
    page.close()
    assert errors == []


@pytest.mark.slow
def test_a_misread_mark_is_dragged_right(browser: Any, tmp_path: Path) -> None:
    found = handed_in("six-link", "velocity", None)
    place = next(s for s in found.paper.spots if s.name == "c").place
    pole = next(s for s in found.paper.spots if s.name == "p").place
    found.paper.spots = [ReadMark(s.name, s.place + 20, s.error_mm) if s.name == "c" else s for s in found.paper.spots]
    wrong = check(found.bench.asked, found.paper)
    assert wrong.first_wrong == "c"
    page, errors = opened(browser, wrong, tmp_path)
    assert "c" in page.inner_text("#sentence") and "wrong" in page.get_attribute("body", "class")
    start = page.evaluate("(() => { const m = marks.find(m => m.name === 'c'); return sheet.px([m.x, m.y]); })()")
    goal = page.evaluate(f"sheet.px([{(place - pole).real}, {(place - pole).imag}])")
    box = page.locator("#sheet").bounding_box()
    page.mouse.move(box["x"] + start[0], box["y"] + start[1])
    page.mouse.down()
    page.mouse.move(box["x"] + goal[0], box["y"] + goal[1], steps=5)
    page.mouse.up()
    assert page.inner_text("#sentence").startswith("The drawing is right")
    assert page.get_attribute("body", "class") == "right" and page.is_visible("#moved")
    assert page.locator("#marks tr.wrong").count() == 0
    page.click("#reset")
    assert "wrong" in page.get_attribute("body", "class") and not page.is_visible("#moved")
    page.close()
    assert errors == []


@pytest.mark.slow
def test_a_polygon_is_shown_and_dragged_in_the_order_it_was_laid(browser: Any, tmp_path: Path) -> None:
    """A corner takes with it the two sides that meet there, whatever the program's own order is."""
    found = handed_in("six-link", "force:2-3", None)
    rows = [s.name for s in found.paper.spots[1:]]
    page, errors = opened(browser, found, tmp_path)
    pole = found.paper.spots[0].place
    sides = "sheet.own.vectors.map(([a, b, name]) => [name, b[0] - a[0], b[1] - a[1]])"
    before = page.evaluate(sides)
    assert [name for name, _, _ in before] == rows and rows != [m.rpartition(":")[2] for m in graded(found).marks]
    for spot in found.paper.spots[1:-1]:
        if any(m.endswith(f":{spot.name}") for m in graded(found).marks):
            assert complex(*page.evaluate(f"sheet.own.at({spot.name!r})")) == pytest.approx(spot.place - pole, abs=0.02)
    for k in (1, 3):
        page.evaluate(f"(() => {{ const [x, y] = sheet.own.at({rows[k]!r}); drag({rows[k]!r}, x + 4, y - 3); }})()")
        now = page.evaluate(sides)
        change = [complex(b[1] - a[1], b[2] - a[2]) for a, b in zip(before, now, strict=True)]
        assert change == pytest.approx([(4 - 3j) * ((j == k) - (j == k + 1)) for j in range(len(rows))], abs=1e-6)
        before = now
        saved = tmp_path / "marks.csv"
        saved.write_text(page.evaluate("csv()"), encoding="utf-8")
        again, shown = check(found.bench.asked, read_table(saved)), judged(page)
        assert (shown["verdict"], shown["first"]) == (again.verdict, again.first_wrong)
    page.close()
    assert errors == []


def test_marks_move_by_the_keys_and_are_saved(browser: Any, tmp_path: Path) -> None:
    page, errors = opened(browser, handed_in("six-link", "velocity", None), tmp_path, "ru")
    page.focus('[data-mark="b"]')
    before = page.evaluate("marks[0].x")
    for key in ("ArrowRight", "Shift+ArrowRight", "Alt+ArrowRight"):
        page.keyboard.press(key)
    assert page.evaluate("marks[0].x") == pytest.approx(before + 5.6)
    assert page.evaluate("document.activeElement.dataset.mark") == "b"
    assert page.get_attribute('[data-mark="b"]', "aria-label").startswith("b: неверно")
    with page.expect_download() as saving:
        page.click("#save")
    saving.value.save_as(str(tmp_path / "marks.csv"))
    spots = read_table(tmp_path / "marks.csv").spots
    assert (tmp_path / "marks.csv").read_text("utf-8").startswith(f"# {page.inner_text('code')}\nmark,")
    assert [s.name for s in spots] == ["p", "b", "c", "s2", "l", "h"]
    assert spots[1].place.real == pytest.approx(before + 5.6, abs=1e-3)
    assert page.inner_text("code").startswith("planes check") and "--plan velocity" in page.inner_text("code")
    page.close()
    assert errors == []


def test_marks_nobody_read_are_put_in_place(browser: Any, tmp_path: Path) -> None:
    whole = handed_in("six-link", "velocity", None)
    found = handed_in("six-link", "velocity", None, ("c", "h"))
    assert found.verdict == "unreadable"
    assert found.sentence.told().startswith("Too little could be read (marks: 3 of 5): without c, h the plan")
    page, errors = opened(browser, found, tmp_path)
    same(page, found)
    lettered = "[...document.querySelectorAll('#sentence i')].map(e => e.textContent)"
    unbroken = "[...document.querySelectorAll('#sentence .command')].map(e => e.textContent)"
    for _ in ("as printed", "as judged anew"):
        assert (page.evaluate(lettered), page.evaluate(unbroken)) == (["c", "h"], [])
        assert "in the drawing below" in page.inner_text("#sentence")
        page.evaluate("move('l', marks.find(m => m.name === 'l').x, marks.find(m => m.name === 'l').y)")
    for name in ("c", "h"):
        place = next(s for s in whole.paper.spots if s.name == name).place - whole.paper.spots[0].place
        page.evaluate(f"move({name!r}, {place.real}, {place.imag})")
    shown = judged(page)
    assert shown["verdict"] == "right" and len(shown["marks"]) == 5
    spots = [ReadMark(s.name, s.place, SCREEN_MARK_ERROR_MM) if s.name in ("c", "h") else s for s in whole.paper.spots]
    again = check(whole.bench.asked, ReadPaper("t", spots))
    for mark, miss in graded(again).judgement.misses.items():
        assert abs(complex(*shown["marks"][mark][1:3]) - miss.off) < 1e-6 + 0.01 * miss.tolerance_mm(1.0)
    page.close()
    assert errors == []


@pytest.mark.slow
def test_a_printed_report_is_a_sheet_and_says_what_to_draw_anew(browser: Any, tmp_path: Path) -> None:
    pdfium = pytest.importorskip("pypdfium2")
    page, errors = opened(browser, handed_in("six-link", "velocity", Mistake("relative_from_pole", "c")), tmp_path)
    assert "Redraw this step" in page.inner_text("#chance")
    sheets = pdfium.PdfDocument(page.pdf(prefer_css_page_size=True))
    assert [round(side) for side in sheets[0].get_size()] == [595, 842]
    assert len(sheets) == 1 and "Steps" in sheets[0].get_textpage().get_text_range()
    page.close()
    assert errors == []
    page, errors = opened(browser, handed_in("six-link", "velocity", None), tmp_path)
    assert page.inner_text("#chance") == "(Sure.)"
    page.close()


def test_a_window_shows_a_force_and_where_it_should_end() -> None:
    """Its order is free, so the right end is where the construction leads from what was laid before."""
    found = handed_in("six-link", "force:2-3", Mistake("inertia_along_acceleration", "I_2"))
    place = wrong_places(found)[0]
    miss = graded(found).judgement.misses["force:2-3:I_2"].off
    left, low, right, high = place["box"]
    goal = complex(*place["at"]) - miss
    assert place["name"] == "I_2" and abs(miss) > 8
    assert left < goal.real < right and low < goal.imag < high
    assert abs((left + right) / 2 - goal.real) == pytest.approx(abs(miss.real) / 2, abs=0.02)


def test_a_window_is_made_once_for_a_row_and_its_report(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[str] = []
    kept = places._place_windows
    monkeypatch.setattr(
        places, "_place_windows", lambda found, grading: made.append(found.verdict) or kept(found, grading)
    )
    group = ClassWork("11", "en", str(tmp_path / "class"))
    group.add_checked_drawing(Checked("boris.jpg", handed_in("six-link", "velocity", CASES[0][2])))
    group.write_results()
    assert made == ["wrong"]
    assert all('class="place"' in (tmp_path / "class" / name).read_text() for name in ("index.html", "boris.jpg.html"))


UNSEEN = [("six-link", "velocity", ("s2",)), ("six-link", "acceleration", ("s2'",)), ("kind-1-rrr", "velocity", ("e",))]


@pytest.mark.few(1)
@pytest.mark.parametrize(("sample", "plan", "without"), UNSEEN)
def test_the_page_names_what_nobody_has_seen(
    browser: Any, tmp_path: Path, sample: str, plan: str, without: tuple[str, ...]
) -> None:
    whole, found = handed_in(sample, plan, None), handed_in(sample, plan, None, without)
    assert found.verdict == "right_as_seen" and found.unseen == list(without)
    page, errors = opened(browser, found, tmp_path)
    same(page, found)
    assert f"not judged: {', '.join(without)}" in page.evaluate("found.sentence")
    pole = whole.paper.spots[0].place
    for k, name in enumerate(without):
        place = next(s for s in whole.paper.spots if s.name == name).place - pole
        page.evaluate(f"move({json.dumps(name)}, {place.real}, {place.imag})")
        left = ", ".join(without[k + 1 :])
        assert (f"not judged: {left}" if left else "The drawing is right") in page.inner_text("#sentence")
    page.close()
    assert errors == []


@pytest.mark.slow
def test_the_page_says_where_too_little_is_seen_to_judge_by(browser: Any, tmp_path: Path) -> None:
    """A mark near the pole, one by itself at the stated scale, one at a scale of its own, one that tells something."""
    bench = prepare(Asked(load(SAMPLES / "kind-1-rrr.yaml"), "velocity"))
    c = complex(draw_program(bench.program, bench.given)["velocity:c"])
    keys = []
    for size, mu in (
        (0.06, bench.said_mu * 0.06),
        (0.12, bench.said_mu * 0.12),
        (0.25, None),
        (0.25, bench.said_mu * 0.25),
    ):
        spots = [ReadMark("p", 0j), ReadMark("c", c * size)]
        found = check(Asked(bench.asked.scene, "velocity", mu=mu), ReadPaper("t", spots))
        page, errors = opened(browser, found, tmp_path)
        same(page, found)
        page.close()
        assert errors == []
        keys.append(found.sentence.key)
    assert keys == ["check_nothing_drawn", "check_by_chance", "check_by_chance", "check_right_as_seen"]


def test_layers_and_a_telephone(browser: Any, tmp_path: Path) -> None:
    page, errors = opened(browser, handed_in("six-link", "velocity", CASES[0][2]), tmp_path)
    for layer, drawn in (("own", ".arrow.own"), ("truth", ".arrow.truth"), ("next", "#sheet line.next")):
        assert page.locator(drawn).count() > 0
        page.uncheck(f'input[data-layer="{layer}"]')
        assert page.locator(drawn).count() == 0
    page.set_viewport_size({"width": 390, "height": 800})
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    page.close()
    assert errors == []


def test_a_table_of_numbers_has_nothing_to_move(browser: Any, tmp_path: Path) -> None:
    paper = ReadPaper("t", results=[("v_C", 72.1, "m/s")])
    page, errors = opened(browser, check(Asked(load(SAMPLES / "six-link.yaml"), "velocity"), paper), tmp_path)
    assert page.locator("svg").count() == 0 and "millimetres" in page.inner_text("#sentence")
    page.close()
    assert errors == []


def test_the_page_reads_every_operation_of_a_tape() -> None:
    """What the page is given to reckon with, it knows how to reckon and how to differentiate."""
    text = (ROOT / "render" / "page" / "tape.js").read_text(encoding="utf-8")
    values, slopes = text.split("const SLOPES")
    for sample, plan, mistake in [*CASES, ("kind-1-rrr", "position", None)]:
        found = handed_in(sample, plan, mistake) if plan != "position" else None
        grading = (
            graded(found) if found else grading_without_marks(prepare(Asked(load(SAMPLES / f"{sample}.yaml"), plan)))
        )
        bench = found.bench if found else prepare(Asked(load(SAMPLES / f"{sample}.yaml"), plan))
        tape, _ = grading_tape(grading, mistake_variants(bench, grading.hand.taken, grading.mu))
        names = set(tape["names"]) - LEAF_OPERATIONS
        assert names and all(f'"{n}"' in values for n in names), names
        assert all(re.search(rf"\b{n}:", slopes) for n in names - TEST_OPERATIONS)


def test_a_teacher_decides_on_the_page_of_a_class(browser: Any, tmp_path: Path) -> None:
    """A decision marks its row, is taken back, stands when the page is opened again, and goes into the table."""
    group = ClassWork("11", "en", str(tmp_path / "class"))
    for name, mistake in (("anna", None), ("boris", CASES[0][2])):
        group.add_checked_drawing(Checked(f"{name}.jpg", handed_in("six-link", "velocity", mistake)))
    group.write_results()
    page = browser.new_page()
    errors = watched(page)
    page.goto((tmp_path / "class" / "index.html").as_uri())
    assert not page.is_visible("#decided")
    rows = "[...document.querySelector('tbody').rows]"
    own = f"Object.fromEntries({rows}.map(r => [r.cells[0].textContent, r.dataset.own]))"
    page.click("tr.wrong .decide button >> text=Accept")
    page.click("tr.right .decide button >> text=Accept")
    page.click("tr.right .decide button >> text=Reject")
    both, said = {"boris.jpg": "accepted", "anna.jpg": "rejected"}, "Decided by you: 1 accepted, 1 rejected."
    assert (page.evaluate(own), page.inner_text("#decided output")) == (both, said)
    kept = "JSON.stringify(localStorage).includes('rejected')"
    page.wait_for_function(kept)
    first, page = page, browser.new_page()
    errors += watched(page)
    page.goto((tmp_path / "class" / "index.html").as_uri())
    page.wait_for_function(kept)
    assert (page.evaluate(own), page.inner_text("#decided output")) == (both, said)
    first.close()
    page.click("tr.right .decide button >> text=Reject")
    assert page.evaluate(own)["anna.jpg"] == ""
    with page.expect_download() as kept:
        page.click("#decided button")
    kept.value.save_as(tmp_path / "decided.csv")
    lines = (tmp_path / "decided.csv").read_text("utf-8-sig").splitlines()
    assert lines[0].endswith(',"decision"')
    assert sorted(line.split(",")[0] + line[-9:] for line in lines[1:])[1] == '"boris.jpg","Accept"'
    page.close()
    assert errors == []


def test_the_page_of_a_class_tells_whose_mistakes_and_is_sorted_at_will(browser: Any, tmp_path: Path) -> None:
    group = ClassWork("11", "en", str(tmp_path / "class"))
    for name, mistake in (("anna", None), ("boris", CASES[0][2]), ("gleb", CASES[0][2])):
        group.add_checked_drawing(Checked(f"{name}.jpg", handed_in("six-link", "velocity", mistake)))
    group.add_checked_drawing(Checked("vera.jpg", refused=PlanesError("vera.jpg: no picture"), report="../vera.jpg"))
    group.write_results()
    page = browser.new_page()
    errors = watched(page)
    page.goto((tmp_path / "class" / "index.html").as_uri())
    often = page.locator("li")
    assert often.count() == 1 and often.inner_text().endswith("— 2: boris, gleb")
    names = "[...document.querySelectorAll('tbody th')].map(e => e.textContent.split('.')[0])"
    assert page.evaluate(names) == ["vera", "boris", "gleb", "anna"]  # what needs a look comes first
    assert page.get_attribute("th a >> text=vera", "href") == "../vera.jpg"
    cells = "[...document.querySelectorAll('tbody tr')].map(r => getComputedStyle(r.lastChild, '::before').content)"
    assert set(page.evaluate(cells)) == {"none"}  # the sign of the verdict stands once
    page.click("thead th:nth-child(2) button")
    assert page.evaluate(names) == ["anna", "vera", "boris", "gleb"]
    page.click("thead th:nth-child(4) button")
    page.click("thead th:nth-child(4) button")
    assert page.evaluate(names)[-1] == "anna"
    assert page.get_attribute("thead th:nth-child(4)", "aria-sort") == "descending"
    page.emulate_media(media="print")
    assert [page.is_visible(f"tr >> text={name} >> .place") for name in ("boris", "gleb")] == [True, True]
    page.emulate_media(media="screen")
    page.set_viewport_size({"width": 390, "height": 800})  # rows have no head there
    assert not page.is_visible("thead")
    page.select_option(".sort select", "1")
    assert page.evaluate(names) == ["anna", "vera", "boris", "gleb"]
    page.click("li a >> text=gleb")
    assert "c" in page.inner_text("#sentence")
    page.emulate_media(media="print")
    assert not page.is_visible(".place")  # a report is one sheet
    page.emulate_media(media="screen")
    assert page.locator(".place").count() == 1 and page.is_visible(".place")  # the same window as in the table
    page.evaluate("move('c', marks[0].x, marks[0].y)")
    assert not page.is_visible(".place")  # it shows what was read
    page.close()
    assert errors == []
