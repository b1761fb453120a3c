"""The drawing lettering: complete alphabets, ink inside its box, exact widths, shear and curves."""

from __future__ import annotations

import math
import unicodedata
from itertools import pairwise

import pytest

from render.paper import lettering
from render.paper.boxes import box_around_lines
from render.paper.lettering import SAME_SHAPED_CHARACTERS, SHIFTED_CHARACTERS
from tests.helpers.glyphs import missing

RUSSIAN = "АБВГДЕЁЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯ"
BELARUSIAN = "АБВГДЕЁЖЗІЙКЛМНОПРСТУЎФХЦЧШЫЬЭЮЯ"
UKRAINIAN = "АБВГҐДЕЄЖЗИІЇЙКЛМНОПРСТУФХЦЧШЩЬЮЯ"
LATIN = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
GREEK = "αβγδεζηθικλμνξπρστυφχψωΓΔΘΛΠΣΦΨΩ"
SIGNS = "0123456789.,:;!?()[]{}/\\|+−-–—=≈≤≥<>±×·•%№°′″‴'\"«»“”„_^~@#&*$§⊥∥∠√→←↑↓∞∅⌀∑∫∂⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ⁻₀₁₂₃₄₅₆₇₈₉"
LETTERS = RUSSIAN + BELARUSIAN + UKRAINIAN + LATIN
EVERY = sorted(
    {*LETTERS, *LETTERS.lower(), *GREEK, *SIGNS, *lettering.GLYPH_PATHS, *SAME_SHAPED_CHARACTERS, *SHIFTED_CHARACTERS}
)
WORDS = [
    "План скоростей, μ_v = 30 мм/(м·с⁻¹)",
    "Кривошипно-ползунный механизм",
    "Ў і ґ є ї",
    "v_CB ⊥ BC, a_CB^n",
    "ГА ТА AV 1:2 φ₁",
]
HEIGHTS = [1.8, 2.5, 3.5, 5.0, 7.0, 10.0, 40.0]


def box(text: str, height: float, slant: bool = False) -> tuple[float, float, float, float]:
    """Bounds of the ink in mm, half the pen width included."""
    drawn = zip(lettering.stroke_pen_widths(text, height), lettering.letter_strokes(text, height, slant), strict=True)
    return box_around_lines((line, pen / 2) for pen, line in drawn)


@pytest.mark.parametrize("alphabet", [RUSSIAN, BELARUSIAN, UKRAINIAN, LATIN])
def test_alphabets_are_complete(alphabet: str) -> None:
    assert missing(alphabet + alphabet.lower()) == ""


def test_signs_are_complete_and_unknown_ones_are_named() -> None:
    assert missing(GREEK + SIGNS) == ""
    assert missing("Ж漢 a☃漢\u00a0") == "漢☃"


@pytest.mark.parametrize("char", EVERY)
def test_a_character_has_ink_inside_its_box(char: str) -> None:
    lines = lettering.letter_strokes(char, 10.0)
    x0, y0, x1, y1 = box(char, 10.0)
    assert lines and all(len(line) >= 2 for line in lines)
    assert x0 == pytest.approx(0, abs=1e-9)
    assert x1 == pytest.approx(lettering.line_ink_width(char, 10.0), abs=1e-9)
    assert x1 > 0 and -4.2 < y0 < y1 < 13.2
    assert len(lettering.stroke_pen_widths(char, 10.0)) == len(lines)
    half = lettering.stroke_pen_widths(char, 10.0)[0] / 2
    assert half == pytest.approx(0.35 if char in SHIFTED_CHARACTERS else 0.5)
    for z in (z for line in lines for z in line):
        assert x0 + half - 1e-9 <= z.real <= x1 - half + 1e-9
        assert y0 + half - 1e-9 <= z.imag <= y1 - half + 1e-9


def test_letters_fill_the_rows_of_the_standard() -> None:
    for char in "АБВГЕЖЗИКЛМНОПРСТХЧШЭЮЯHNS0123456789":
        assert box(char, 10.0)[1::2] == pytest.approx((0.0, 10.0))
    for char in "авгежзиклмнопстхчшэюяnsuxz":
        assert box(char, 10.0)[1::2] == pytest.approx((0.0, 7.0))
    for char in "pqgyру":
        assert box(char, 10.0)[1::2] == pytest.approx((-3.0, 7.0))


def test_only_the_stated_look_alikes_are_identical() -> None:
    seen: dict[object, str] = {}
    for char in EVERY:
        twin = seen.setdefault(lettering.letter_strokes(char, 10.0), char)
        assert SAME_SHAPED_CHARACTERS.get(twin, twin) == SAME_SHAPED_CHARACTERS.get(char, char), (
            f"{twin!r} looks like {char!r}"
        )
    for char, model in SAME_SHAPED_CHARACTERS.items():
        assert lettering.letter_strokes(char, 5.0) == lettering.letter_strokes(model, 5.0)


@pytest.mark.parametrize("composed", ["й", "Й", "ў", "Ў", "ї", "Ї", "ё", "Ё"])
def test_combining_marks_equal_composed_letters(composed: str) -> None:
    apart = unicodedata.normalize("NFD", composed)
    assert len(apart) == 2
    assert lettering.letter_strokes(apart, 5.0) == lettering.letter_strokes(composed, 5.0)
    assert missing(apart) == ""


@pytest.mark.parametrize("height", HEIGHTS)
@pytest.mark.parametrize("text", WORDS)
def test_width_is_the_ink_and_the_drawing_scales(text: str, height: float) -> None:
    x0, y0, x1, y1 = box(text, height)
    assert (x0, x1) == pytest.approx((0.0, lettering.line_ink_width(text, height)), abs=1e-9)
    assert lettering.line_ink_width(text, height) == pytest.approx(height * lettering.line_ink_width(text, 1.0))
    reference = box(text, 1.0)
    assert (y0, y1) == pytest.approx((height * reference[1], height * reference[3]), abs=1e-9)


@pytest.mark.parametrize("height", HEIGHTS)
def test_curves_are_flat_to_two_hundredths_of_a_millimetre(height: float) -> None:
    def distance(z: complex, line: tuple[complex, ...]) -> float:
        best = math.inf
        for a, b in pairwise(line):
            t = 0.0 if a == b else ((z - a) / (b - a)).real
            best = min(best, abs(z - a - (b - a) * min(1.0, max(0.0, t))))
        return best

    for char in "OSg&9бЗд":
        fine = lettering.letter_strokes(char, 4000.0)
        for coarse, exact in zip(lettering.letter_strokes(char, height), fine, strict=True):
            step = max(1, len(exact) // 60)
            assert max(distance(z * height / 4000, coarse) for z in exact[::step]) < 0.02


@pytest.mark.parametrize("text", WORDS)
def test_slant_is_a_shear_to_75_degrees(text: str) -> None:
    upright, slanted = lettering.letter_strokes(text, 5.0), lettering.letter_strokes(text, 5.0, slant=True)
    for a, b in zip(upright, slanted, strict=True):
        for z, w in zip(a, b, strict=True):
            assert w.imag == z.imag
            assert w.real - z.real == pytest.approx(z.imag / math.tan(math.radians(75)), abs=1e-12)
    stem = lettering.letter_strokes("I", 5.0, slant=True)[0]
    turn = stem[-1] - stem[0]
    assert math.degrees(math.atan2(turn.imag, turn.real)) == pytest.approx(75)
    x0, y0, x1, y1 = box(text, 5.0, slant=True)
    for line, pen in zip(slanted, lettering.stroke_pen_widths(text, 5.0), strict=True):
        for z in line:
            assert x0 + pen / 2 - 1e-9 <= z.real <= x1 - pen / 2 + 1e-9
            assert y0 + pen / 2 - 1e-9 <= z.imag <= y1 - pen / 2 + 1e-9


def test_gaps_of_letters_and_words() -> None:
    def gap(pair: str) -> float:
        return lettering.line_ink_width(pair, 10.0) - sum(lettering.line_ink_width(c, 10.0) for c in pair if c != " ")

    assert [gap(pair) for pair in ("НН", "ол", "11", "17")] == pytest.approx([2.0] * 4)
    assert [gap(pair) for pair in ("ГА", "ТА", "AV", "LT", "м²")] == pytest.approx([1.0] * 5)
    assert [gap(pair) for pair in ("Н Н", "Г А")] == pytest.approx([6.0] * 2)
    assert lettering.line_ink_width("Н\u00a0Н", 10.0) == lettering.line_ink_width("Н Н", 10.0)
    assert gap(" Н ") == pytest.approx(0.0)


def test_a_missing_character_is_an_open_box_and_nothing_is_no_ink() -> None:
    (frame,) = lettering.letter_strokes("漢", 5.0)
    assert frame[0] == frame[-1] and len(set(frame)) == 4
    assert lettering.letter_strokes(" ", 5.0) == lettering.letter_strokes("", 5.0) == ()
    assert lettering.line_ink_width("", 5.0) == 0.0
    assert box("", 5.0) == (0.0, 0.0, 0.0, 0.0)
    assert missing("a\n\t b") == ""


@pytest.mark.parametrize("height", [0.0, -1.0, math.nan, math.inf])
def test_a_height_must_be_positive(height: float) -> None:
    with pytest.raises(ValueError, match="letter height"):
        lettering.letter_strokes("A", height)
