"""The plan among all that stands on a page: of the parts that hang together the one that is best read as it.

Its scale may be written in the title over it: "План скоростей, μv = 50 мм/(м·с⁻¹)".
"""

from __future__ import annotations

from dataclasses import replace

from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan, known_plans
from planes.check.reading.as_planned import worth
from planes.check.reading.chains import true_vectors
from planes.check.reading.matching import paper_of
from planes.check.reading.parts import parts
from planes.check.reading.strokes import ReadDrawing
from planes.check.reading.titles import elsewhere, mu_over
from planes.words.names import kind_of

MOST = 6  # parts that are read
NAMED = 0.1  # what a name of the plan beside a part is worth, in marks drawn rightly


def paper_on(sketch: ReadDrawing, bench: PreparedPlan) -> ReadPaper:
    """The marks of the plan on a page that may show other things too."""
    found = parts(sketch)
    force = kind_of(bench.asked.plan) == "force"
    known = bench.written(true_vectors(bench)) if force else bench.names

    def named(part: ReadDrawing) -> int:
        return len({known.exactly(one.text) for w in part.words for one in w.listed()} - {None})

    plans = known_plans(bench.plans)
    if elsewhere(sketch.words, bench.asked.plan, plans):
        return ReadPaper(sketch.file, whole=False)
    likely = [p for p in found if mu_over(sketch.words, p, bench.asked.plan, plans)[1]]  # under the plan's own title
    likely = sorted(likely or found, key=named, reverse=True)[:MOST]
    likely = [p for p in likely if 2 * named(p) >= named(likely[0])]
    papers = [(_paper_of(replace(part), bench, sketch), named(part)) for part in likely or [sketch]]
    return max(papers, key=lambda p: worth(bench, p[0]) + NAMED * p[1])[0] if len(papers) > 1 else papers[0][0]


def _paper_of(part: ReadDrawing, bench: PreparedPlan, page: ReadDrawing) -> ReadPaper:
    """The marks of a plan on a part of a page, at the scale its title says."""
    mu = None if bench.asked.mu else mu_over(page.words, part, bench.asked.plan, known_plans(bench.plans))[0]
    paper = paper_of(part, bench.at(mu, told=True) if mu else bench)
    paper.mu = mu
    return paper
