"""Other content of sheets: title blocks, tables, second plans, names, stamps."""

from __future__ import annotations

from dataclasses import replace

from tests import confusion, picture_corpus
from tests.confusion import Easel
from tests.physical.layout import Page, extent

BLOCK_MM = (185.0, 55.0)  # of a title block
NAMES = ("Иванов А. П.", "Ковалёва М. С.", "Дмитриев Н.", "Ли Юй", "Smith J.", "Гр. 10305121")


def add(page: Page, easel: Easel) -> None:
    """Adds other content to a sheet."""
    s = page.paper.setting
    if s.title_block:
        _title_block(page)
    if s.second_plan:
        _second(page, easel)
    if s.table:
        _table(page)
    if s.name:
        for text in page.rng.sample(NAMES, 2):
            corner = page.free(complex(3.4 * len(text), 5))
            if corner is not None:
                page.taken.append((corner, corner + complex(3.4 * len(text), 5)))
                page.writer.word(text, corner, 5.0)
    if s.stamp:
        _stamp(page)


def _title_block(page: Page) -> None:
    """The title block of a drawing, its lines by ruler and its words by hand."""
    right, left = 292.0, 292 - BLOCK_MM[0]
    rows = [
        (complex(left, 5 + y), complex(left + 65 if 0 < y < 55 and y % 15 else right, 5 + y)) for y in range(5, 60, 5)
    ]
    columns = [(complex(left + x, 5), complex(left + x, 60)) for x in (0, 7, 17, 40, 55, 65)]
    page.lines([*rows, *columns, (complex(right - 50, 20), complex(right - 50, 45))], 0.9)
    words = (("Разраб.", 1, 36), ("Пров.", 1, 31), (page.rng.choice(NAMES), 18, 36), ("План скоростей", 75, 28))
    for text, x, y in words:
        page.writer.word(text, complex(left + x, y), 3.0 if x < 70 else 6.0)


def _table(page: Page) -> None:
    """A table of values: quantities, millimetres."""
    rows, columns, wide, high = page.rng.randint(3, 6), page.rng.randint(2, 4), 17.0, 8.0
    size = complex(columns * wide, rows * high)
    corner = page.free(size)
    if corner is None:
        return
    page.taken.append((corner, corner + size))
    page.lines((corner + 1j * high * k, corner + size.real + 1j * high * k) for k in range(rows + 1))
    page.lines((corner + wide * k, corner + wide * k + 1j * size.imag) for k in range(columns + 1))
    for r in range(rows):
        for c in range(columns):
            text = page.rng.choice(("v_B", "a_C", "ω", "мм")) if r == rows - 1 else f"{page.rng.uniform(1, 90):.1f}"
            page.writer.word(text, corner + complex(2 + c * wide, 2 + r * high), 3.5)


def _second(page: Page, easel: Easel) -> None:
    """Another plan of the same mechanism, at any scale that fits."""
    others = [e for e in confusion.easels() if e.sample == easel.sample and e.plan != easel.plan]
    for other in others:
        one = picture_corpus.drawn(other, None, page.rng)
        for scale in (1.0, 0.7, 0.5, 0.35) if one else ():
            assert one is not None
            small = replace(
                one,
                strokes=[(a * scale, b * scale) for a, b in one.strokes if abs(b - a) * scale > 1],
                words=[(text, z * scale) for text, z in one.words],
            )
            low, high = extent(small)
            corner = page.free(high - low)
            if corner is not None:
                page.taken.append((corner, corner + high - low))
                for a, b in small.strokes:
                    page.hand.vector(a + corner - low, b + corner - low)
                for text, z in small.words:
                    page.writer.word(text, z + corner - low)
                return


def _stamp(page: Page) -> None:
    """A round stamp in a random free place."""
    corner = page.free(28 + 28j)
    if corner is None:
        return
    page.taken.append((corner, corner + 28 + 28j))
    for radius in (13, 9):
        ring = [corner + 14 + 14j + radius * 1j ** (k / 8) for k in range(33)]
        for k in range(0, 32, 8):
            page.paper.printed(ring[k : k + 9], (150, 70, 60), 0.7, 0.6)
