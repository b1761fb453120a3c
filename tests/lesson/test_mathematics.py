"""Lines of calculation as mathematics: each is set in a page, a PDF and a Word file, with the numbers of its words."""

import re

import pytest

from planes.lesson.formulas import fill_slots
from planes.lesson.mathematics import Typesetter, split_at_signs
from planes.lesson.note import Note
from planes.scene import load
from planes.solving import solve
from render.report.math_line import break_formula, math_line
from render.report.mathml import formula_as_mathml
from tests.helpers import ROOT

PATHS = sorted(p for p in (ROOT / "samples").glob("**/*.yaml") if "course" not in (p.stem, p.parent.name))
NUMBER = re.compile(r"\d+(?:[.,]\d+)?")


@pytest.mark.few(6, slow=40)
@pytest.mark.parametrize("path", PATHS, ids=lambda p: p.stem)
@pytest.mark.parametrize("lang", ["en", "ru"])
def test_a_line_as_mathematics_has_the_numbers_of_its_words(path, lang) -> None:
    scene = load(path)
    note = Note(scene, solve(scene).positions[0], lang)
    for frame in note.frames:
        for row in frame.rows:
            parts = Typesetter(note.value_by_name, note.naming, frame.plan).typeset_row(row)
            words = fill_slots(row.text_in_words(lang), note.value_by_name, lang)
            said = NUMBER.findall(re.sub(r"⟨[^⟩]*⟩|[²³]|·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+", "", words))
            powers = r"\\cdot ?10\^\{[^{}]*\}|[_^]\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}|\^\d"
            tex = re.sub(powers, "", "".join(parts).replace("{,}", ","))
            assert NUMBER.findall(tex) == said, row
            assert math_line("".join(parts), 10).width > 0
            assert all(formula_as_mathml(part).startswith("<math ") for part in parts)


def test_a_long_line_is_broken_at_its_signs_and_repeats_them() -> None:
    parts = ("a", "=b", *["+c"] * 40)
    lines = break_formula(parts, 10, 200)
    assert len(lines) > 2 and all(line.width <= 200 + math_line("+c", 10).width for line in lines)
    assert [line.letters[-1][2] for line in lines[:-1]] == ["+"] * (len(lines) - 1)
    assert [line.letters[0][2] for line in lines[1:]] == ["+"] * (len(lines) - 1)


def test_signs_in_brackets_do_not_part() -> None:
    assert split_at_signs("a + b / (c + d) − e", "+−") == ["a", "+", "b / (c + d)", "−", "e"]
