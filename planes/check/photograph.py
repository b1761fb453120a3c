"""From a picture of a plan to the marks of a person: made flat, its lines found, matched to the plan."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import pairwise

from planes.check.bench import Bench
from planes.check.chains import true_vectors
from planes.check.fiducials import pole_place
from planes.check.matching import paper_of
from planes.check.paper import Paper, Spot
from planes.check.motion_seen import marks_on
from planes.check.pencil_lines import sheet_of
from planes.check.picture import Flat, by_points, cv, flatten, load
from planes.check.strokes import Sketch, Words
from planes.drawing import run
from planes.mark_names import Names
from planes.naming import at, label_of
from planes.scales import kind_of
from planes.wording import PlanesError
from planes.words import Phrase

LEAST_MM = 3.0  # smaller vectors are lost on a picture
UNLIKE = 0.15  # a vector of a polygon that differs by more from the plan's own is not surely it


def paper_of_picture(
    file: str, bench: Bench, pole: complex | None = None, marks: Mapping[str, complex] | None = None
) -> Paper:
    """What a picture shows of a plan. :class:`PlanesError` where it is no picture or has nothing to measure by."""
    marks = marks or {}
    grey = load(file)
    flat = None if pole is not None and marks else flatten(grey)
    named = None
    if flat is None:
        flat, named = _by_hand(bench, grey, pole, marks)
    seen = sheet_of(flat)
    paper = Paper(file, whole=False, notes=list(flat.notes))
    if seen is None:
        paper.notes.append(Phrase("check_crowd", count="> 1500"))
        return paper
    pole_mm = 0j if named else blank_pole(bench)
    paper.scale_mark = named
    paper.picture = b"" if named else shown(flat)
    if named:
        paper.notes.append(Phrase("check_scale_vector", mark=named))
    paper.spots, explained = marks_on(bench, seen, pole_mm)
    return paper


def _only_sure(bench: Bench, found: Paper) -> None:
    """Vectors of a polygon have no names on a picture: keep them only if all but a few are like the plan's own."""
    truth = true_vectors(bench)
    unlike = 0
    for before, spot in pairwise(found.spots):
        true = truth.get(spot.name)
        unlike += true is None or abs(spot.place - before.place - true) > UNLIKE * abs(true) + 2
    seen = {s.name for s in found.spots}
    missed = [n for n, v in truth.items() if n not in seen and abs(v) > LEAST_MM and not n.startswith("F_")]
    closed = bool(found.spots) and abs(found.spots[-1].place - found.spots[0].place) < LEAST_MM
    if not closed or unlike > 1 + len(truth) // 3 or len(missed) > 1 or len(found.spots) < 3:
        found.spots = []
        found.notes.append(Phrase("check_force_unsure"))


def shown(flat: Flat) -> bytes:
    """The flat picture, small enough for a page."""
    cv2 = cv()
    small = cv2.resize(flat.grey, None, fx=0.5, fy=0.5, interpolation=cv2.INTER_AREA)
    return bytes(cv2.imencode(".jpg", small, [cv2.IMWRITE_JPEG_QUALITY, 75])[1])


def _by_hand(bench: Bench, grey: object, pole: complex | None, marks: Mapping[str, complex]) -> tuple[Flat, str]:
    """Scale by a named pole and vector."""
    labels = [label_of(m) for m in bench.marks]
    name = next((n for n in (Names(labels).find(k) for k in marks) if n and n != "p"), None)
    if pole is None or name is None:
        raise PlanesError(Phrase("check_no_marks"))
    where = next(z for k, z in marks.items() if Names(labels).find(k) == name)
    length = abs(run(bench.program, bench.given)[at(bench.asked.plan, name)])
    return by_points(grey, pole, where, float(length)), name


def _words(
    bench: Bench, flat: Flat, pole: complex | None, marks: Mapping[str, complex], height: int
) -> list[Words]:
    """The pole's place: printed on a blank, or as it was named."""
    if pole is not None:
        factor = 1 / flat.scale * (flat.grey.shape[0] / height)
        found = [Words("p", -0.05 - 0.05j, 0.1, 0.1)]
        for name, z in marks.items():
            found.append(Words(name, ((z - pole) * factor).conjugate() - 0.05 - 0.05j, 0.1, 0.1))
        return found
    return [Words("p", blank_pole(bench) - 0.05 - 0.05j, 0.1, 0.1)]


def blank_pole(bench: Bench) -> complex:
    """Where the blank of this plan has its pole."""
    truth = run(bench.program, bench.given)
    return pole_place([complex(truth[m]) for m in bench.marks])


def _surely(sketch: Sketch, spot: Spot) -> bool:
    """Whether a mark is at the end of some stroke."""
    return any(min(abs(spot.place - a), abs(spot.place - b)) < 1.5 for a, b in sketch.strokes)
