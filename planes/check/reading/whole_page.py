"""The plan among the contents of a page: the connected part that reads best as the plan.

Its scale may be written in the title over it: "План скоростей, μv = 50 мм/(м·с⁻¹)".
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from planes.check.grading.paper import ReadPaper
from planes.check.grading.polygons import polygon_sides
from planes.check.grading.prepared_plan import PreparedPlan, known_plans
from planes.check.reading.matching import read_plan_marks
from planes.check.reading.parts import connected_parts
from planes.check.reading.strokes import ReadDrawing
from planes.check.reading.weighed import agreement_score
from planes.check.reading.written import Words
from planes.words.names import PlanId
from planes.words.units import UnitError, read_mu

MOST_PARTS_READ = 6  # parts that are read
NAME_WEIGHT = 0.1  # weight of a name of the plan beside a part, in marks drawn correctly
MOST_TITLE_DISTANCE_MM = 40.0  # a title farther above a plan belongs elsewhere
SIDEWAYS_TITLE_WEIGHT = 2.0  # a title is above its plan rather than beside it: weight of a sideways millimetre
MOST_TITLE_GAP_RATIO = 2.0  # maximum gap between pieces of a title, in heights
MOST_DETAIL_SIGN_HEIGHT_MM = 25.0  # maximum height of a detail's sign above the content of its circle
_DETAIL_SIGN = re.compile(r"\((\d+):1\)$")
_SCALE_IN_TITLE = re.compile(r"[μµ]\s*_?\w*\s*=\s*(\d.*)")


def read_page(sketch: ReadDrawing, bench: PreparedPlan) -> ReadPaper:
    """The marks of the plan on a page that may show other contents, too."""
    sides = [side.name for side in polygon_sides(bench.plans, bench.plan)]
    known = bench.naming.name_finder(sides) if bench.plan.is_force else bench.written_mark_names

    def named(part: ReadDrawing) -> int:
        return len({known.find_exact_name(one.text) for w in part.words for one in w.split_names()} - {None})

    def own(pieces: list[ReadDrawing]) -> list[ReadDrawing]:
        """Those under the plan's title that name parts of it, unlike a diagram of the same quantity."""
        return [p for p in pieces if named(p) and scale_in_title(sketch.words, p, bench.plan, plans)[1]]

    plans = known_plans(bench.plans)
    if shows_other_plans_only(sketch.words, bench.plan, plans):
        return ReadPaper(sketch.file, whole=False)
    pieces = connected_parts(sketch)
    titled = own(pieces)
    plain = [p for p in titled if detail_enlargement(sketch.words, p) == 1.0]
    likely = plain or titled or own(connected_parts(sketch, 0.0)) or pieces
    likely = sorted(likely, key=named, reverse=True)[:MOST_PARTS_READ]
    likely = [p for p in likely if 2 * named(p) >= named(likely[0])]
    papers = [(_read_part(replace(part), bench, sketch.words), named(part)) for part in likely or [sketch]]
    if len(papers) > 1:
        return max(papers, key=lambda p: agreement_score(bench, p[0]) + NAME_WEIGHT * p[1])[0]
    return papers[0][0]


def _read_part(part: ReadDrawing, bench: PreparedPlan, words: Sequence[Words]) -> ReadPaper:
    """The marks of a plan on a part of a page, at the scale in its title."""
    said = None if bench.asked.mu else scale_in_title(words, part, bench.plan, known_plans(bench.plans))[0]
    mu = said and said * detail_enlargement(words, part)
    paper = read_plan_marks(part, bench.at_scale(mu))
    paper.mu = mu
    return paper


def detail_enlargement(words: Sequence[Words], part: ReadDrawing) -> float:
    """The enlargement of a detail of a plan, from the sign over its circle: "А (10:1)"; 1 for no detail."""
    low, high = part.box
    signs = ((w.middle, float(said[1])) for w in words if (said := _DETAIL_SIGN.search(w.text)))
    over = [(abs(z - (low + high) / 2), times) for z, times in signs if z.imag > high.imag]
    near, times = min(over, default=(MOST_DETAIL_SIGN_HEIGHT_MM, 1.0))
    return times if near < MOST_DETAIL_SIGN_HEIGHT_MM else 1.0


def scale_in_title(
    words: Sequence[Words], part: ReadDrawing, plan: PlanId, plans: Sequence[str]
) -> tuple[float | None, bool]:
    """μ in the nearest title of this plan of ``plans`` over a part of a page, and whether none is nearer."""
    if not part.strokes:
        return None, False
    low, high = part.box
    titles = []
    for title in _scale_titles(words):
        aside = max(low.real - title.place.real - title.width, title.place.real - high.real, 0.0)
        up = title.place.imag - high.imag
        if title.middle.imag > (low + high).imag / 2 and max(aside, up) < MOST_TITLE_DISTANCE_MM:
            titles.append(
                (
                    abs(complex(SIDEWAYS_TITLE_WEIGHT * aside, max(up, 0.0))),
                    _scale_from_title(title.text, plan, plans) or 0.0,
                )
            )
    own = min((one for one in titles if one[1]), default=None)
    return (own[1], own == min(titles)) if own else (None, False)


def _scale_titles(words: Sequence[Words]) -> Iterator[Words]:
    """Texts with a μ, each with its continuation in the same line."""
    for word in words:
        if not set("μµ") & set(word.text):
            continue
        end = word.place + word.width
        goes_on = (
            w
            for w in words
            if w.text.startswith("=")
            and abs(w.place.imag - end.imag) < word.height / 2
            and abs(w.place.real - end.real) < MOST_TITLE_GAP_RATIO * word.height
        )
        more = None if "=" in word.text else next(goes_on, None)
        if more is not None:
            word = replace(word, text=word.text + more.text, width=more.width + (more.place - word.place).real)
        yield word


def shows_other_plans_only(words: Sequence[Words], plan: PlanId, plans: Sequence[PlanId]) -> bool:
    """Whether titles on a page are of other plans of its kind, and none of this one."""
    alike = [p for p in plans if p.kind == plan.kind]
    shown = {p for title in _scale_titles(words) for p in alike if _scale_from_title(title.text, p, plans)}
    return bool(shown) and plan not in shown


def _scale_from_title(text: str, plan: PlanId, plans: Sequence[str]) -> float | None:
    """μ of a plan from its title; None if the title names the links of another one."""
    said = _SCALE_IN_TITLE.search(text)
    links = re.findall(r"\d+", text[: said.start()] if said else "")
    named = [p for p in plans if (own := re.findall(r"\d+", p)) and links[-len(own) :] == own]
    if named and plan not in named:
        return None
    try:
        if said:
            return read_mu(said[1].replace(",", "."), plan.kind)
        return None
    except UnitError:
        return None
