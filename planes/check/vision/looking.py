"""One flat picture looked at: the pole of a plan found on it, and its marks."""

import math
from dataclasses import dataclass, field

from planes.check.blank import blank_pole
from planes.check.fiducials import SHEET_MM
from planes.check.grading.paper import Box, ReadMark, ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.sign_faults import SignFault
from planes.check.reading.as_planned import worth
from planes.check.vision.image.picture import Flat
from planes.check.vision.marks.page_parts import A2_MM2, parts_of
from planes.check.vision.marks.places import Seen, pole_on, sheet_of
from planes.check.vision.marks.pole_guess import likely_poles, pole_found
from planes.check.vision.match.match_force import start_of, vectors_on
from planes.check.vision.match.match_motion import marks_on
from planes.check.vision.match.match_printed import PrintedSheet
from planes.check.vision.match.match_scheme import origin_found, points_on
from planes.words.names import kind_of

MOST_LINES = 120  # a plan has far fewer
EXPLAINED = 0.6  # the share of a picture's lines that must be the plan's


@dataclass
class Look:
    """One way of looking at a picture: made flat so, and what was found."""

    flat: Flat
    pole: complex
    spots: list[ReadMark] = field(default_factory=list)
    whole: bool = False
    explained: float = -1.0
    hidden: tuple[str, ...] = ()  # vectors whose ends are not seen
    untold: tuple[str, ...] = ()  # vectors that may as well be others, with a mistake
    named: tuple[str, ...] = ()  # marks that but their names tell, which stand where they should
    signs: list[SignFault] = field(default_factory=list)  # letters and arrows that are wrong
    in_doubt: list[str] = field(default_factory=list)  # vectors torn, or with their heads at the wrong end
    apart: bool = False  # whether a mistake explains it, and no right plan nearly as well
    bare: bool = False  # whether there are no lines at all
    crowd: bool = False  # whether there are too many to look at
    mu: float | None = None  # the scale it was found at, where that is not the stated one

    def box(self, bench: PreparedPlan) -> Box:
        """Where the flat picture lies."""
        printed = not self.spots and self.flat.by == "marks"
        low = self.flat.corner - (blank_pole(bench) if printed else self.pole)
        h, w = self.flat.grey.shape[:2]
        high = low + complex(w, h) / self.flat.scale
        return low.real, low.imag, high.real, high.imag


def seen_best(bench: PreparedPlan, flat: Flat, pole: complex | None) -> Look:
    """What a flat picture shows best: all of it, or of a page of known scale one of its parts."""
    if flat.by != "scale" or pole is not None:
        return looked(bench, flat, pole, sheet_of(flat, _printed(bench, flat)))
    page, looks = parts_of(flat), [(-math.inf, Look(flat, 0j, explained=0.0))]
    seen: dict[int, tuple[Flat, Seen | None]] = {}
    for k, mu in page.likely(bench):
        part, sheet = seen[k] = seen.get(k) or (one := page.cut(k), sheet_of(one))
        there = bench.at(mu, told=True) if mu else bench
        look = _on_part(there, part, sheet)
        look.mu = mu
        good = worth(there, ReadPaper("", look.spots, whole=look.whole)) if look.explained >= EXPLAINED else -math.inf
        looks.append((good, look))
        if good >= len(bench.marks):
            break
    if math.prod(flat.size_mm) <= A2_MM2 and all(good == -math.inf for good, _ in looks):
        looks.append((0.0, looked(bench, flat, None, sheet_of(flat))))
    return max(looks, key=lambda found: (found[0], found[1].explained))[1]


def _on_part(bench: PreparedPlan, flat: Flat, seen: Seen | None) -> Look:
    """What a part of a page shows: a plan printed rightly, told by its arrowheads, or one drawn by hand."""
    motion = kind_of(bench.asked.plan) not in ("position", "force")
    spots = PrintedSheet(bench, seen).right() if motion and seen and len(seen.lines) <= MOST_LINES else []
    return Look(flat, spots[0].place, spots, True, 1.0) if spots else looked(bench, flat, None, seen)


def _printed(bench: PreparedPlan, flat: Flat) -> complex | None:
    """Where a blank has its pole, if the picture is of its size."""
    return blank_pole(bench) if flat.size_mm == SHEET_MM else None


def looked(bench: PreparedPlan, flat: Flat, pole: complex | None, seen: Seen | None) -> Look:
    """What a flat picture shows; the pole may be named, is printed on a blank, or must be found."""
    printed = _printed(bench, flat)
    if seen is None or len(seen.lines) > MOST_LINES:
        return Look(flat, 0j, crowd=True)
    if not seen.lines:
        return Look(flat, 0j, explained=0.0, bare=True)
    kind = kind_of(bench.asked.plan)
    if flat.by in ("scale", "part") and kind == "force" and pole is None:
        return Look(flat, 0j, explained=0.0)
    near = pole if pole is not None else printed
    guessed = near is None or (flat.by == "frame" and pole is None and not pole_on(seen, near).ended)
    if guessed:
        find_pole = {"position": origin_found, "force": start_of}.get(kind)
        near = (find_pole(bench, seen) if find_pole else None) or pole_found(bench, seen)
    starts = [near] if near is not None else []
    if kind == "force" and near is not None:
        read = vectors_on(bench, seen, near)
        return Look(flat, near, read.spots, read.whole, read.explained, read.hidden, read.untold, apart=read.apart)
    if guessed and kind not in ("position", "force"):
        starts += likely_poles(seen)
    find, best = points_on if kind == "position" else marks_on, Look(flat, 0j, explained=0.0)
    for start in starts:
        spots, explained, named, signs, in_doubt = find(bench, seen, start)
        known = not guessed or explained >= EXPLAINED  # a guess that explains nothing tells no pole
        if start != near:
            explained = min(explained, EXPLAINED)  # on a sheet of another size a plan may tell its pole
        look = Look(flat, start if known else 0j, spots, False, explained, named=named, signs=signs, in_doubt=in_doubt)
        best = max(best, look, key=lambda look: look.explained)
        if known:
            break
    return best
