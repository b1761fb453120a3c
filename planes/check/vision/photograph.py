"""From a picture of a plan to a person's marks: rectified, its lines found, matched to the plan."""

import math
from collections.abc import Iterator
from dataclasses import replace

from planes.check.fiducials import SHEET_MM
from planes.check.grading.paper import Known, MarkPlaces, ReadPaper, with_pointed_marks
from planes.check.grading.prepared_plan import PreparedPlan, drawn_mark_position, known_plans
from planes.check.grading.remedies import phrase_with_remedy
from planes.check.sheet_mark import SheetMark, read_mark_of_sheet
from planes.check.vision.from_aside import fitted_camera_tilt, log_deviation_from_plan
from planes.check.vision.image.decoding import DecodedPicture, load
from planes.check.vision.image.frame import rectify_by_frame
from planes.check.vision.image.lens import CameraTilt
from planes.check.vision.image.opencv import cv, reduce_to_longest_side, resize_by_factor
from planes.check.vision.image.picture import (
    LARGEST_SIDE_PX,
    Flat,
    find_marks,
    flatten,
    is_plausible_scale,
    rectify_by_scale,
)
from planes.check.vision.image.two_points import rectify_by_two_points
from planes.check.vision.looking import Look, best_examination
from planes.check.vision.print_scale import print_scale_of_scan
from planes.geometry.arrays import Greys
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.lettering import plan_phrase
from planes.words.names import POLE_LABEL, PlanId

NO_HINTS = Known()


def read_picture(file: str, bench: PreparedPlan, known: Known = NO_HINTS) -> ReadPaper:
    """The plan in a picture, rectified by corner marks, otherwise by two named points, otherwise by the sheet's frame.

    :class:`PlanesError` if it is no picture or has no reference for its scale.
    """
    picture = load(file, known.page)
    best = None
    by = None
    pole = known.pole
    code = None
    for flat, named in _possible_rectifications(bench, picture, known):
        code = read_mark_of_sheet(flat) if flat.by == "marks" else None
        bench = _plan_at_printed_scale(bench, flat, code)
        held = _mark_setting_scale(bench, flat, known)
        look = best_examination(
            bench, flat, 0j if named else None if pole is None else flat.sheet_point_of_pixel(pole), held
        )
        if best is None or (look.has_plan, look.cover) > (best.has_plan, best.cover):
            best = look
            by = None if flat.by_file else named
        if best.flat.by in ("scale", "part") and best.has_plan:
            break
    best = best and _correct_camera_tilt(bench, picture, known, best)
    has_scale = best and (best.flat.by not in ("scale", "part") or pole is not None)
    if best is None or not (has_scale or best.has_plan):
        raise _missing_reference_error(picture.grey)
    paper = replace(
        best.paper, file=file, whole=False, look=picture.pixel_hash, scale_mark=by, notes=list(best.flat.notes)
    )
    paper.pole_told = pole is not None or best.flat.by == "marks"
    mu = best.paper.mu
    paper.mu = mu or bench.asked.mu
    paper.picture, paper.box = picture_for_page(best.flat), best.picture_box(bench)
    if code and code.plan != bench.plan and code.plan in known_plans(bench.plans):
        paper.notes.append(
            Phrase("check_code_says", other=plan_phrase(PlanId.read(code.plan)), plan=plan_phrase(bench.plan))
        )
    if best.bare:
        paper.reason = Phrase("check_no_lines")
    elif not best.has_plan:
        share, own = (f"{100 * part:.0f}" for part in (best.cover, best.explained))
        paper.reason = phrase_with_remedy("check_no_plan_seen", share=share, own=own)
    else:
        pointed = bench.pointed_positions(known.marks, best.flat.sheet_point_of_pixel)
        paper.spots = with_pointed_marks(paper.spots, pointed)
        if mu and mu != bench.said_mu:
            paper.notes.append(Phrase("check_mu_found", mu=bench.written_scale(mu)))
        paper.untold = [n for n in paper.untold if n not in pointed]
    return paper


def _mark_setting_scale(bench: PreparedPlan, flat: Flat, known: Known) -> tuple[str, complex] | None:
    """The mark pointed to that sets a picture's scale, and its position; none if the file gives the scale."""
    if flat.told is None or flat.by_file:
        return None
    name = flat.told[0]
    place = bench.marks_by_label(known.marks).get(name)
    return None if place is None else (name, flat.sheet_point_of_pixel(place))


def _correct_camera_tilt(bench: PreparedPlan, picture: DecodedPicture, known: Known, best: Look) -> Look:
    """The findings in a photograph scaled by two points, after correcting the camera tilt shown by its marks.

    The first findings are kept if they explain the marks better.
    """
    lens = best.flat.lens
    true = bench.true_marks
    tilt = fitted_camera_tilt(lens, best.pole, best.paper.spots, true) if lens and best.has_plan else None
    if tilt is None or lens is None or known.pole is None:
        return best
    held = replace(lens.held, slopes=lens.held.slopes + tilt)
    flat, _ = _rectify_by_pole_and_mark(bench, picture, known.pole, known.marks, held)
    other = best_examination(bench, flat, 0j, _mark_setting_scale(bench, flat, known))
    likelier = log_deviation_from_plan(best.pole, best.paper.spots, true) - log_deviation_from_plan(
        other.pole, other.paper.spots, true
    )
    return other if other.has_plan and likelier > 0 else best


def _plan_at_printed_scale(bench: PreparedPlan, flat: Flat, code: SheetMark | None) -> PreparedPlan:
    """The plan at the scale its blank was printed for (from its ``code``, otherwise the scene), unless given.

    The pole is the one in the code.
    """
    if code is None or code.plan != bench.plan:
        return bench
    flat.pole = code.pole
    if bench.asked.mu:
        return bench
    return bench.at_scale(code.mu or bench.said_mu)


def _missing_reference_error(grey: Greys) -> PlanesError:
    """An error, by the number of a blank's corner marks seen."""
    count = len(find_marks(reduce_to_longest_side(grey, LARGEST_SIDE_PX)[0]))
    return PlanesError(Phrase("check_few_marks", count=count) if count else Phrase("check_no_marks"))


def _possible_rectifications(
    bench: PreparedPlan, picture: DecodedPicture, known: Known
) -> Iterator[tuple[Flat, str | None]]:
    """Possible rectifications of the picture; with the vector that sets its scale, if any."""
    grey = picture.grey
    scale = picture.scale
    if known.pole is not None and known.marks:
        yield _rectify_by_pole_and_mark(bench, picture, known.pole, known.marks)
    elif flat := None if known.format else flatten(grey):
        flat.printed = print_scale_of_scan(flat, grey, scale)
        yield flat, None
    else:
        if scale is not None and known.format is None and is_plausible_scale(grey, scale):
            yield rectify_by_scale(grey, scale), None
        yield from ((flat, None) for flat in rectify_by_frame(grey, known.format))


def picture_for_page(flat: Flat) -> bytes:
    """The rectified picture, small enough for a page."""
    return bytes(cv().imencode(".jpg", resize_by_factor(flat.grey, 0.5), [cv().IMWRITE_JPEG_QUALITY, 75])[1])


def _rectify_by_pole_and_mark(
    bench: PreparedPlan, picture: DecodedPicture, pole: complex, marks: MarkPlaces, held: CameraTilt | None = None
) -> tuple[Flat, str]:
    """Scale from a named pole and vector."""
    named = [one for one in bench.marks_by_label(marks).items() if one[0] != POLE_LABEL]
    if not named:
        raise PlanesError(Phrase("check_no_marks"))
    name, where = named[0]
    vector = _vector_of_likely_size(bench, picture, abs(where - pole), name)
    return rectify_by_two_points(picture.grey, pole, where, vector, name, picture.scale, held, picture.focal), name


def _vector_of_likely_size(bench: PreparedPlan, picture: DecodedPicture, length: float, name: str) -> complex:
    """The vector to a mark with this length in pixels: the right one, or a mistake's.

    If the right one would make the sheet too large, it is that of the mistake that makes it most like A4.
    """
    ways = (drawn_mark_position(bench, v, name) for v in bench.mistakes)
    true = bench.true_marks[name]
    if length < 1 or not true or is_plausible_scale(picture.grey, length / abs(true)):
        return true
    likely = [z for z in ways if z and is_plausible_scale(picture.grey, length / abs(z))]
    area = picture.grey.size / length**2
    return min(likely, key=lambda z: abs(math.log(area * abs(z) ** 2 / math.prod(SHEET_MM))), default=true)
