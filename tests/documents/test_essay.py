"""The essay: ten small pages that answer a hand, say what their figures show, and please whoever looks or listens."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from planes.cli import main
from planes.lesson.essay import FIGURES_BY_PAGE, data_of_essay_pages
from planes.words import sentence_table
from tests.documents.test_lesson_for_everyone import complaints
from tests.helpers.browser import watched

NUMBERS = range(1, len(FIGURES_BY_PAGE) + 1)
LARGEST = 160_000  # bytes of a page


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    target = tmp_path_factory.mktemp("essay")
    assert main(["essay", "-o", str(target), "--lang", "en"]) == 0
    return target


def test_twelve_pages_are_written_and_are_small(folder: Path) -> None:
    assert sorted(f.name for f in folder.iterdir()) == sorted(f"{k}.html" for k in NUMBERS)
    assert len(FIGURES_BY_PAGE) == 12 and max(f.stat().st_size for f in folder.iterdir()) < LARGEST


@pytest.mark.parametrize("lang", ["ru", "en"])
def test_every_paragraph_has_words_and_a_figure(lang: str) -> None:
    told = [key for key in sentence_table(lang) if key.startswith("essay_") and key.count("_") == 2]
    assert told == [f"essay_{n}_{k}" for n in NUMBERS for k in range(1, len(FIGURES_BY_PAGE[n - 1]))]


@pytest.mark.few(2)
@pytest.mark.parametrize("number", NUMBERS)
def test_every_number_of_a_text_is_one_of_the_figures(number: int) -> None:
    from planes.lesson.formulas import slot_value_names

    data = data_of_essay_pages(number)
    for paragraph in data["paragraphs"]:
        for text in paragraph["said"].values():
            assert set(slot_value_names(text)) <= set(data["values"])
        known = {k["given"] for k in data["knobs"]} | {"phi"}
        assert set(paragraph["knobs"]) <= known


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("number", NUMBERS)
def test_a_page_answers_and_nothing_is_complained_of(browser: Any, folder: Path, number: int) -> None:
    page = browser.new_page()
    errors = watched(page)
    page.goto((folder / f"{number}.html").as_uri())
    drawn = "[...document.querySelectorAll('figure > svg')].map(s => s.innerHTML)"
    before = page.evaluate(drawn)
    assert len(before) == len(FIGURES_BY_PAGE[number - 1]) - 1 and all(before)
    page.evaluate(
        """() => { for (const i of document.querySelectorAll('.slid input')) {
        i.value = +i.value + (i.max - i.min) / 20; i.oninput(); } draw(); }"""
    )
    assert all(a != b for a, b in zip(before, page.evaluate(drawn), strict=True))
    page.click("#lang")
    assert page.evaluate("document.documentElement.lang") == "ru"
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        assert complaints(page) == []
    page.set_viewport_size({"width": 360, "height": 700})
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    page.close()
    assert errors == []


def test_the_end_of_a_vector_is_dragged_and_the_others_follow(browser: Any, folder: Path) -> None:
    page = browser.new_page()
    page.goto((folder / "1.html").as_uri())
    box = page.locator("figure > svg").nth(1).bounding_box()
    x, y = page.evaluate("paragraphs[1].figure.px(live.at('velocity:b'))")
    page.mouse.move(box["x"] + x, box["y"] + y)
    page.mouse.down()
    page.mouse.move(box["x"] + x + 30, box["y"] + y - 25, steps=4)
    goal = page.evaluate(f"paragraphs[1].figure.mm([{x + 30}, {y - 25}])")
    found = page.evaluate("live.at('velocity:b')")
    assert abs(complex(*found) - complex(*goal)) < 0.5 and "∠" in page.inner_text(".follow >> nth=1")
    page.mouse.up()
    page.close()
