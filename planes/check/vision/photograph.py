"""From a picture of a plan to the marks of a person: made flat, its lines found, matched to the plan."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from planes.check.fiducials import OTHER_MM, SHEET_MM, has_room, pole_place
from planes.check.grading.paper import MISREAD, Box, Known, ReadMark, ReadPaper, with_told
from planes.check.grading.prepared_plan import PreparedPlan, drawn_at, known_plans, variants_of
from planes.check.reading.as_planned import worth
from planes.check.sheet_mark import mark_of
from planes.check.vision.image.decoding import DecodedPicture, load
from planes.check.vision.image.frame import by_frame
from planes.check.vision.image.picture import (
    LARGEST_PX,
    Flat,
    by_points,
    by_scale,
    cv,
    find_marks,
    fits,
    flatten,
    smaller,
)
from planes.check.vision.marks.page_parts import A2_MM2, parts_of
from planes.check.vision.marks.places import Seen, pole_on, sheet_of
from planes.check.vision.marks.pole_guess import likely_poles, pole_found
from planes.check.vision.marks.print_scale import printed_share
from planes.check.vision.match.match_force import start_of, vectors_on
from planes.check.vision.match.match_motion import marks_on
from planes.check.vision.match.match_printed import PrintedSheet
from planes.check.vision.match.match_scheme import origin_found, points_on
from planes.geometry.arrays import Greys
from planes.plans.scales import fitting
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.lettering import plan_phrase
from planes.words.names import POLE, Names, kind_of, label_of

SMALLER = 0.99  # of a scale: the next one of the standard is smaller
ASIDE_MM = 12.0  # how far from a blank's middle its pole tells nobody where the plan goes
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


def paper_of_picture(file: str, bench: PreparedPlan, known: Known | None = None) -> ReadPaper:
    """What a picture shows of a plan: made flat by corner marks, else by two named points, else by the sheet's frame.

    :class:`PlanesError` where it is no picture or has nothing to measure by.
    """
    known = known or Known()
    picture = load(file, known.page or 0)
    paper, best, pole = ReadPaper(file, whole=False), None, known.pole
    for flat, named in _flats(bench, picture, known):
        bench = _as_printed(bench, flat)
        look = _best(bench, flat, 0j if named else None if pole is None else flat.place(pole))
        if best is None or look.explained > best.explained:
            best, paper.scale_mark = look, None if flat.by_file else named
        if best.flat.by in ("scale", "part") and best.explained >= EXPLAINED:
            break
    told = best and (best.flat.by not in ("scale", "part") or pole is not None)
    if best is None or not (told or (best.spots and best.explained >= EXPLAINED)):
        raise _nothing_to_measure_by(picture.grey)
    paper.notes, paper.pole_told = list(best.flat.notes), pole is not None or best.flat.by == "marks"
    paper.picture, paper.box = shown(best.flat), best.box(bench)
    code = mark_of(best.flat) if best.flat.by == "marks" else None
    if code and code.plan != bench.asked.plan and code.plan in known_plans(bench.plans):
        plans = {"other": plan_phrase(code.plan), "plan": plan_phrase(bench.asked.plan)}
        paper.notes.append(Phrase("check_code_says", **plans))
    if best.crowd:
        paper.notes.append(Phrase("check_crowd", count=f"> {2 * MOST_LINES}"))
    elif best.bare:
        paper.notes.append(Phrase("check_no_lines"))
    elif best.explained < EXPLAINED:
        paper.notes.append(Phrase("check_no_plan_seen", share=f"{100 * max(best.explained, 0.0):.0f}"))
    else:
        pointed = bench.pointed(known.marks, best.flat.place) if best.spots else {}
        paper.spots, paper.whole = with_told(best.spots, pointed, MISREAD), best.whole
        paper.mu = best.mu or bench.asked.mu
        if best.mu and best.mu != bench.said_mu:
            paper.notes.append(Phrase("check_mu_found", mu=bench.mu_said(best.mu)))
        if not best.spots:
            paper.notes.append(Phrase("check_force_unsure"))
        paper.untold, paper.apart = [n for n in best.untold if n not in pointed], best.apart
        paper.named = [*best.named]
        if best.named:
            paper.notes.append(Phrase("check_by_name", names=", ".join(best.named)))
        if best.hidden:
            paper.notes.append(Phrase("check_hidden", names=", ".join(best.hidden)))
    return paper


def _as_printed(bench: PreparedPlan, flat: Flat) -> PreparedPlan:
    """The plan at the scale that the code of its blank tells, where nobody told another."""
    code = mark_of(flat) if flat.by == "marks" and not bench.asked.mu else None
    return bench.at(code.mu, told=True) if code and code.mu and code.plan == bench.asked.plan else bench


def _nothing_to_measure_by(grey: Greys) -> PlanesError:
    """A refusal, by how many of a blank's corner marks are seen."""
    count = len(find_marks(smaller(grey, LARGEST_PX)[0]))
    return PlanesError(Phrase("check_few_marks", count=count) if count else Phrase("check_no_marks"))


def _flats(bench: PreparedPlan, picture: DecodedPicture, known: Known) -> Iterator[tuple[Flat, str | None]]:
    """Ways the picture may be made flat; with the vector its scale is taken from, if it is."""
    grey, scale = picture.grey, picture.scale
    if known.pole is not None and known.marks:
        yield _by_hand(bench, picture, known.pole, known.marks)
    elif flat := None if known.format else flatten(grey):
        flat.printed = printed_share(flat, grey, scale)
        yield flat, None
    else:
        if scale is not None and known.format is None and fits(grey, scale):
            yield by_scale(grey, scale), None
        yield from ((flat, None) for flat in by_frame(grey, known.format))


def _best(bench: PreparedPlan, flat: Flat, pole: complex | None) -> Look:
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
        spots, explained, named = find(bench, seen, start)
        known = not guessed or explained >= EXPLAINED  # a guess that explains nothing tells no pole
        if start != near:
            explained = min(explained, EXPLAINED)  # on a sheet of another size a plan may tell its pole
        look = Look(flat, start if known else 0j, spots, False, explained, named=named)
        best = max(best, look, key=lambda look: look.explained)
        if known:
            break
    return best


def shown(flat: Flat) -> bytes:
    """The flat picture, small enough for a page."""
    cv2 = cv()
    small = cv2.resize(flat.grey, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)
    return bytes(cv2.imencode(".jpg", small, [cv2.IMWRITE_JPEG_QUALITY, 75])[1])


def _by_hand(
    bench: PreparedPlan, picture: DecodedPicture, pole: complex, marks: Mapping[str, complex]
) -> tuple[Flat, str]:
    """Scale by a named pole and vector."""
    names = Names([label_of(m) for m in bench.marks])
    name, where = next(((n, z) for k, z in marks.items() if (n := names.find(k)) and n != POLE), (None, 0j))
    if name is None:
        raise PlanesError(Phrase("check_no_marks"))
    return by_points(
        picture.grey, pole, where, _vector(bench, picture, abs(where - pole), name), name, picture.scale
    ), name


def _vector(bench: PreparedPlan, picture: DecodedPicture, length: float, name: str) -> complex:
    """The vector to a mark, so many pixels long: as it should be, or, if no sheet is as large as that would make it, as
    the mistake has it that makes it most like A4."""
    ways = (drawn_at(bench, v, name) for v in variants_of(bench, {}, bench.said_mu))
    true = bench.true_marks[name]
    if length < 1 or not true or fits(picture.grey, length / abs(true)):
        return true
    likely = [z for z in ways if z and fits(picture.grey, length / abs(z))]
    area = picture.grey.size / length**2
    return min(likely, key=lambda z: abs(math.log(area * abs(z) ** 2 / math.prod(SHEET_MM))), default=true)


def roomy(bench: PreparedPlan) -> PreparedPlan:
    """A plan as a blank has it: at the largest standard scale, no larger than the scene's, that has room for it there;
    if of motion, with its pole in the middle of the sheet, for any plan of that size, whichever way it goes."""
    plan = bench.asked.plan
    if bench.asked.mu:
        return bench
    if kind_of(plan) not in ("position", "force"):
        aside = abs(blank_pole(bench) - pole_place([])) > ASIDE_MM
        reach = max(abs(z) for z in bench.true_marks.values()) / bench.said_mu
        return bench.at(fitting(plan, reach, SHEET_MM[1] / 2 - OTHER_MM), told=True) if aside else bench
    while not has_room([*bench.true_marks.values()]):
        bench = bench.at(fitting(plan, 1.0, SMALLER * bench.said_mu), told=True)
    return bench


def blank_pole(bench: PreparedPlan) -> complex:
    """Where the blank of this plan has its pole."""
    return pole_place([*bench.true_marks.values()])
