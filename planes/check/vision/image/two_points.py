"""A picture made flat by the two ends of a vector, pointed to; and by its paper, where that tells how it is seen."""

import cmath
import math
from dataclasses import replace

import numpy

from planes.check.vision.image.bend import Bend
from planes.check.vision.image.lens import FOCAL, UNTOLD, CameraTilt, Lens
from planes.check.vision.image.picture import MOST_FLAT, PX_PER_MM, Flat, by_scale, remapped
from planes.check.vision.image.sheet_view import SheetView, by_tilt, sheet_view, similar
from planes.geometry.arrays import Greys
from planes.words import Phrase, Written
from planes.words.errors import PlanesError

LEAST_ASKEW_DEG, MOST_ASKEW_DEG = 0.5, 4.0  # less is a hand's own error, more is no sheet's that was laid straight
SHORT_MM = 3.0  # a vector that tells neither scale nor direction
ANOTHER = 0.06  # by more than this share squares, lines or sheets are of another size than the usual ones
DRAWN_MM = 1.5  # no more is a vector longer or shorter for a hand's error
BY_PAPER = {"squares": 0.003, "lines": 0.006, "edges": 0.006}  # the same of a sheet seen straight by its own print
LAID = ("squares", "lines")  # along which people draw
TOLD_TILT_DEG = 1.5  # less is not worth a sentence
FARTHEST_MM = 420.0  # no drawing is farther from its pole


def by_points(
    grey: Greys,
    pole: complex,
    mark: complex,
    vector: complex,
    name: str = "",
    file_scale: float | None = None,
    held: CameraTilt | None = None,
    focal: float | None = None,
) -> Flat:
    """The picture by the two ends of a true vector, of the pole and a named mark, in pixels (x right, y down). Straight
    and to scale by its paper, where that has squares, lines or edges, or straight by text on it, else turned straight
    if it is as little askew as a sheet lies. To the scale its paper or file (``file_scale``) has, if a hand's error is
    all they differ by, or the vector is too short to tell any; else to the vector's. A photograph that nothing tells
    the tilt of may be taken for one of a camera tilted by so much (``held``). The lens may be told (``focal``, in the
    picture's longer sides). The pole becomes the origin."""
    short = abs(vector) < SHORT_MM
    if not (short and file_scale) and (abs(mark - pole) < 10 or not vector):
        raise PlanesError(Phrase("check_points"))
    focal = focal or FOCAL
    view = by_tilt(grey, held.mirrored(), focal) if held else None
    if not held and not short:
        view = sheet_view(grey, file_scale or abs(mark - pole) / abs(vector), file_scale is not None, focal)
    drawn = view.bend.flat(mark) - view.bend.flat(pole) if view else mark - pole
    paper = view.by if view and view.by in BY_PAPER else None
    scale, by_file = _scale(abs(drawn), abs(vector), 1.0 if paper else file_scale, ANOTHER if paper else 1.0)
    askew = 0.0 if short else _askew(drawn, vector, paper)
    flat = _straight(grey, view, pole, scale, askew) if view else by_scale(grey, scale, pole, askew)
    flat.notes += [Phrase("check_askew", angle=Written(f"{abs(askew):.1f}"))] if askew else []
    flat.told, flat.by_file, flat.by_paper = (name, abs(vector)), by_file, paper is not None and not askew
    flat.aslant = BY_PAPER[paper] if paper else 0.0
    if not paper and file_scale is None and not short:
        height, width = grey.shape
        far, known = focal * max(width, height) / scale, view.held.mirrored() if view else UNTOLD
        flat.lens = Lens(flat.place(complex(width, height) / 2), far, flat.place(mark), bool(askew), known)
    return flat


def _scale(drawn: float, true_mm: float, file_scale: float | None, most: float) -> tuple[float, bool]:
    """Pixels to a mm, and whether they are ``file_scale``: if a vector drawn so long differs by no more than
    a hand's error, and by that share at ``most``."""
    if file_scale is None or true_mm < SHORT_MM:
        return file_scale or drawn / true_mm, file_scale is not None
    by_file = abs(drawn / true_mm / file_scale - 1) < min(DRAWN_MM / true_mm, most)
    return file_scale if by_file else drawn / true_mm, by_file


def _askew(drawn: complex, vector: complex, paper: str | None) -> float:
    """By how much a vector (y down) shows its sheet to lie askew, degrees; 0 where its paper tells that itself, or it
    is no more than a hand's error, or more than a sheet is that was laid straight."""
    askew = math.degrees(cmath.phase(drawn.conjugate() / vector))
    least = math.degrees(DRAWN_MM / abs(vector)) if paper else LEAST_ASKEW_DEG
    return askew if paper not in LAID and least < abs(askew) < MOST_ASKEW_DEG else 0.0


def _straight(grey: Greys, view: SheetView, pole: complex, scale: float, askew_deg: float) -> Flat:
    """The sheet from straight above by a view of it (``scale`` of its units to a mm), turned back by how much it lies
    askew; only as much of it as is a sheet's."""
    turn = cmath.rect(PX_PER_MM / scale, math.radians(askew_deg))
    bend = replace(view.bend, view=similar(turn) @ view.bend.view)
    low, high = _seen_box(grey, bend, bend.flat(pole))
    bend.view = similar(1.0, -low) @ bend.view
    size = round((high - low).real), round((high - low).imag)
    if math.prod(size) > MOST_FLAT:
        raise PlanesError(Phrase("check_points"))
    at = bend.flat(pole)
    flat = Flat(remapped(grey, bend, size), PX_PER_MM, -complex(at.real, size[1] - at.imag) / PX_PER_MM, "points")
    flat.bend = bend
    aside = Phrase(f"check_aside_{view.by}", angle=Written(f"{view.tilt_deg:.0f}"))
    flat.notes += [aside] if view.tilt_deg > TOLD_TILT_DEG else []
    return flat


def _seen_box(grey: Greys, bend: Bend, pole: complex) -> tuple[complex, complex]:
    """The box of what a picture shows on its sheet, pixels of the flat one, no farther from the pole than a sheet."""
    height, width = grey.shape
    share, far = numpy.linspace(0, 1, 9), FARTHEST_MM * PX_PER_MM
    seen = bend.flat(width * share[:, None] + 1j * height * share)
    xs, ys = seen.real.clip(pole.real - far, pole.real + far), seen.imag.clip(pole.imag - far, pole.imag + far)
    return complex(xs.min(), ys.min()), complex(xs.max(), ys.max())
