"""Which place of a picture is which mark of a motion plan: every way the plan may have been drawn is tried on the ink.

Drawn rightly, or with one mistake of the catalogue, or with one mark anywhere: each time the program is drawn once
more, every mark snapped to the place where the person has it before the next is drawn from it. The way that leaves
the least ink unexplained, with the fewest marks missing, tells the names of the places. It only names them: whether
the drawing is right is judged afterwards, from the places.
"""

import math
from collections.abc import Sequence
from dataclasses import replace

from planes.check.grading.judging import LEFT_OUT
from planes.check.grading.paper import ReadMark
from planes.check.grading.prepared_plan import PreparedPlan, variants_of
from planes.check.vision.marks.places import Seen, pole_on
from planes.check.vision.marks.print_scale import by_ruler, measured_by, shares_of
from planes.check.vision.search.costs import ANYWHERE, slip
from planes.check.vision.search.ink_cover import InkCover
from planes.check.vision.search.laid_plan import LaidPlan
from planes.check.vision.search.named_marks import by_names, named, traceless
from planes.check.vision.search.plan_search import CLOSE, Search
from planes.check.vision.search.signs_seen import Found, in_doubt, signs_seen
from planes.words import Phrase
from planes.words.names import POLE, label_of

MANY = 3  # strange vectors to one of the plan's


def best_way(searches: Sequence[Search]) -> tuple[Search, LaidPlan] | None:
    """The way that explains the picture best, of a sheet that may have been printed at several sizes."""
    bench = searches[0].bench
    ways = [(s, w) for s in searches if 0 in s.drawn for w in (s.settled(None),) if w]
    best, count = min(ways, key=_cost, default=None), len(variants_of(bench, {}, bench.said_mu))
    if best is None or len(best[1].found) < len(bench.marks) or best[1].cost > slip(count):
        for search in _likely(searches, best):
            variants = variants_of(search.bench, {}, search.bench.said_mu)
            for variant in (v for k, v in enumerate(variants) if k + 1 in search.drawn):
                most = min((w.cost for _, w in ways), default=math.inf)
                ways += [(search, w) for w in (search.settled(variant, slip(len(variants)), most),) if w]
        best = min(ways, key=_cost, default=None)
        if best and best[1].cost > fair(bench.marks):
            ways += [(best[0], w) for w in best[0].free_ways(best[1])]
    best = min(ways, key=_cost, default=None)
    if best is None or best[1].variant is not None or len(best[1].found) < len(bench.marks):
        return best
    return best[0], by_names(*best)


def _likely(searches: Sequence[Search], best: tuple[Search, LaidPlan] | None) -> Sequence[Search]:
    """The sizes a sheet may have been printed at; where the right plan fits well at one, not those at which it is out
    of the question."""
    marks = searches[0].bench.marks
    if best is None or len(best[1].found) < len(marks) or best[1].cost > fair(marks):
        return searches
    return [s for s in searches if s.plain is None or s.plain.cost < best[1].cost + CLOSE]


def fair(marks: Sequence[str]) -> float:
    """What a plan may cost that explains a picture."""
    return ANYWHERE + 4.0 + len(marks)


def _cost(found: tuple[Search, LaidPlan]) -> float:
    return found[1].cost


def marks_on(bench: PreparedPlan, seen: Seen, near: complex) -> Found:
    """The marks of a motion plan with its pole near a place, the share of the ink they explain, which others have
    but their names where they should be, which letters are exchanged, and which vectors are in doubt."""
    pole, ends = pole_on(seen, near), [*bench.vectors]
    shares = shares_of(bench, seen, pole.z)
    ink = InkCover(seen, pole.z, [*bench.true_marks.values()])
    searches = [replace(Search.of(bench, ink, pole, ends, k), drawn=drawn) for k, drawn in shares.items()]
    search, way = best_way(searches) or (None, None)
    if search is None or way is None or not way.found:
        return [], 0.0, (), [], []
    spots = [ReadMark(POLE, search.pole.z, min(search.pole.sigma, 0.3))]
    left_out = way.variant.blames if way.variant and way.variant.mistake.endswith(LEFT_OUT) else None
    shown, bare = (m for m in bench.marks if m in way.found and not search.blind(m, way)), traceless(search, way)
    found = {n: m for m in shown if (n := label_of(m)) not in bare}
    spots += [ReadMark(n, way.found[m].z, search.error_mm(m, way)) for n, m in found.items() if n != left_out]
    routes = search.routes(way)
    explained, strange = ink.explained(routes), ink.strangers(routes)
    if strange and len(way.found) == len(bench.marks):
        seen.ink.flat.notes.append(Phrase("check_strangers", count=len(strange)))
    if seen.ink.flat.told and len(strange) > MANY * len(bench.marks):
        explained = 0.0  # at the scale of a vector far too short or long nearly all of a drawing is strange
    spots = measured_by(seen.ink.flat, near, spots, search.own)
    right = named(search, way, {label_of(m) for m in bench.marks} - found.keys()) if way.variant is None else ()
    spots = by_ruler(seen.ink.flat, near, search.share, spots, explained, bench.true_marks)
    return spots, explained, right, signs_seen(search, way), in_doubt(search, way)
