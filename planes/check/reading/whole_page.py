"""The plan among all that stands on a page: of the parts that hang together the one that is best read as it.

Its scale may be written in the title over it: "План скоростей, μv = 50 мм/(м·с⁻¹)".
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace

from planes.check.grading.grading import grade
from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.reading.chains import true_vectors
from planes.check.reading.matching import paper_of
from planes.check.reading.parts import parts
from planes.check.reading.strokes import ReadDrawing, Words
from planes.words.errors import PlanesError
from planes.words.names import kind_of
from planes.words.units import UnitError, read_mu

MOST = 6  # parts that are read
OPEN = 2.0  # what it costs a force polygon not to close, in marks
NAMED = 0.1  # what a name of the plan beside a part is worth, in marks drawn rightly
FAR_MM = 40.0  # a title farther over a plan is that of something else
GAP = 2.0  # how far a piece of a title may be from the piece before it, in heights
_MU = re.compile(r"[μµ]\s*_?\w*\s*=\s*(\d.*)")


def paper_on(sketch: ReadDrawing, bench: PreparedPlan) -> ReadPaper:
    """The marks of the plan on a page that may show other things too."""
    found = parts(sketch)
    force = kind_of(bench.asked.plan) == "force"
    known = bench.written(true_vectors(bench)) if force else bench.names

    def named(part: ReadDrawing) -> int:
        return len({known.exactly(one.text) for w in part.words for one in w.listed()} - {None})

    likely = sorted(found, key=named, reverse=True)[:MOST]
    likely = [p for p in likely if 2 * named(p) >= named(likely[0])]
    papers = [(_paper_of(replace(part), bench, sketch), named(part)) for part in likely or [sketch]]
    return max(papers, key=lambda p: worth(bench, p[0]) + NAMED * p[1])[0] if len(papers) > 1 else papers[0][0]


def _paper_of(part: ReadDrawing, bench: PreparedPlan, page: ReadDrawing) -> ReadPaper:
    """The marks of a plan on a part of a page, at the scale its title says."""
    mu = None if bench.asked.mu else mu_over(page.words, part, kind_of(bench.asked.plan))
    paper = paper_of(part, bench.at(mu, told=True) if mu else bench)
    paper.mu = mu
    return paper


def worth(bench: PreparedPlan, paper: ReadPaper) -> float:
    """How many marks of a paper are where their steps lead, less those that are not."""
    bench = bench.at(paper.mu, told=True) if paper.mu else bench
    found = None
    with suppress(PlanesError):
        found = grade(bench, paper) if paper.spots else None
    if found is None:
        return -len(bench.marks)
    return len(found.judgement.misses) - 2.0 * len(found.judgement.wrong) - OPEN * bool(found.gap_wrong)


def mu_over(words: Sequence[Words], part: ReadDrawing, kind: str) -> float | None:
    """μ in the nearest title over a part of a page, if it is that of such a plan."""
    ends = [z for stroke in part.strokes for z in stroke]
    if not ends:
        return None
    left, right = min(z.real for z in ends), max(z.real for z in ends)
    low, high = min(z.imag for z in ends), max(z.imag for z in ends)
    found = []
    for title in _titles(words):
        aside, up = max(left - title.place.real - title.width, title.place.real - right, 0.0), title.place.imag - high
        mu = _read(title.text, kind)
        if mu and title.middle.imag > (low + high) / 2 and max(aside, up) < FAR_MM:
            found.append((math.hypot(aside, max(up, 0.0)), mu))
    return min(found)[1] if found else None


def _titles(words: Sequence[Words]) -> Iterator[Words]:
    """Texts with a μ, each with what goes on from it in its line."""
    for word in (w for w in words if set("μµ") & set(w.text)):
        end = word.place + word.width
        goes_on = (
            w
            for w in words
            if w.text.startswith("=")
            and abs(w.place.imag - end.imag) < word.height / 2
            and abs(w.place.real - end.real) < GAP * word.height
        )
        more = None if "=" in word.text else next(goes_on, None)
        if more is not None:
            word = replace(word, text=word.text + more.text, width=more.width + (more.place - word.place).real)
        yield word


def _read(text: str, kind: str) -> float | None:
    """μ of a kind of plans, as a title has it."""
    said = _MU.search(text)
    try:
        return read_mu(said[1].replace(",", "."), kind) if said else None
    except UnitError:
        return None
