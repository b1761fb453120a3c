"""Rectifies and scales a photograph or scan of a plan on paper by the blank's corner marks or by two points."""

from dataclasses import dataclass, field, replace

import numpy

from planes.check.fiducials import (
    MARK_CELLS_PER_SIDE,
    MARK_PATTERNS,
    MARK_SIDE_MM,
    SHEET_MM,
    Size,
    corner_mark_cells,
    corner_mark_centres,
)
from planes.check.vision.image.bend import PX_PER_MM, Bend, add_paper_distortion, measure_distortion
from planes.check.vision.image.lens import Lens
from planes.check.vision.image.opencv import cv, pairs, reduce_to_longest_side
from planes.check.vision.image.several import Found, SheetMarks, SheetsSeen, group_marks_by_sheet, may_show_more_marks
from planes.geometry.arrays import Array, Greys
from planes.words import Phrase
from planes.words.errors import PlanesError

LARGEST_SIDE_PX = 3200  # maximum longer side of a picture in analysis
SHEET_PX = round(SHEET_MM[0] * PX_PER_MM), round(SHEET_MM[1] * PX_PER_MM)
SHEET_MARGIN_MM = 5.0  # around a sheet cut out of a picture
MOST_SHEET_PX = 34_000_000  # pixels of the largest sheet, A1
SEARCH_SIDES_PX = (1100, 700, 2000, 3200)  # longer sides for the search: small ones are quick and hide the grain
# of the longer side: a mark's outline is a sixth of its sheet's length
LEAST_MARK_OUTLINE_SHARE = 0.07
LEAST_FAR_MARK_SHARE = 0.035


@dataclass
class Flat:
    """A rectified picture: grey, ``scale`` pixels per millimetre, its lower left corner at ``corner`` (mm)."""

    grey: Greys
    scale: float
    corner: complex = 0j
    by: str = "marks"  # reference: "marks" of a blank, "points" named, the "frame", its file's "scale"
    warp: Array | None = None
    notes: list[Phrase] = field(default_factory=list)
    bend: Bend | None = None  # instead of ``warp``, if the picture's lens or paper bends it
    told: tuple[str, float] | None = None  # the mark that set its scale, and its assumed distance from the pole
    lens: Lens | None = None  # of a photograph with unknown camera tilt
    aslant: float = 0.0  # relative length by which a vector may seem longer than another, due to the tilt
    by_file: bool = False  # whether two points only set its rotation, and its file or paper sets its scale
    by_paper: bool = False  # whether its paper sets its rotation, too
    printed: float = 1.0  # print scale of a blank, if the file has its size
    pole: complex | None = None  # the pole of a blank from its code (mm)

    @property
    def size_mm(self) -> Size:
        """Width and height."""
        return self.grey.shape[1] / self.scale, self.grey.shape[0] / self.scale

    def sheet_point_of_pixel(self, pixel: complex) -> complex:
        """The point on the sheet for a pixel of the source (x right, y down)."""
        if self.bend is not None:
            z = complex(self.bend.to_rectified(pixel))
            return self.px_to_mm(z.real, z.imag)
        x, y, w = (self.warp @ numpy.array([pixel.real, pixel.imag, 1.0])).tolist()
        return self.px_to_mm(x / w, y / w)

    def px_to_mm(self, x: float, y: float) -> complex:
        """Pixels to millimetres, y up."""
        return self.corner + complex(x, self.grey.shape[0] - y) / self.scale

    def mm_to_px(self, z: complex) -> tuple[float, float]:
        """Millimetres to pixels."""
        local = (z - self.corner) * self.scale
        return local.real, self.grey.shape[0] - local.imag


def marker_dictionary() -> object:
    """The blank's corner marks for OpenCV's detector."""
    aruco = cv().aruco
    rows = [1 - numpy.array(corner_mark_cells(k), numpy.uint8)[1:-1, 1:-1] for k in range(len(MARK_PATTERNS))]
    table = numpy.concatenate([aruco.Dictionary.getByteListFromBits(r) for r in rows])
    return aruco.Dictionary(table, 5, 3)


def find_marks(grey: Greys) -> SheetMarks:
    """Corners of the blank's marks in pixels, by their numbers; of the first if there are several blanks."""
    return next(iter(find_sheets(grey).sheets), {})


def find_blanks(grey: Greys) -> SheetsSeen:
    """The blanks of a picture of any size, in pixels of the reduced picture."""
    return find_sheets(reduce_to_longest_side(grey, LARGEST_SIDE_PX)[0])


def find_sheets(grey: Greys) -> SheetsSeen:
    """The corners, in pixels, of the marks of each blank.

    Smaller marks, of a more distant blank, are searched only where the known ones leave room: a grid's cell is as
    small.
    """
    marks = list[Found]()
    for longest in SEARCH_SIDES_PX:
        if not marks or len(marks) % 4:
            _detect_marks(grey, longest, LEAST_MARK_OUTLINE_SHARE, marks)
    for longest in SEARCH_SIDES_PX:
        if marks and may_show_more_marks(group_marks_by_sheet(marks), grey.shape[0] * grey.shape[1]):
            _detect_marks(grey, longest, LEAST_FAR_MARK_SHARE, marks)
    return group_marks_by_sheet(marks)


def _detect_marks(grey: Greys, longest: int, least: float, marks: list[Found]) -> None:
    """Adds the marks of a picture reduced to this size, with outlines of at least this share of its longer side."""
    aruco = cv().aruco
    parameters = aruco.DetectorParameters()
    parameters.adaptiveThreshWinSizeMin = 13
    parameters.adaptiveThreshWinSizeMax = 53
    parameters.adaptiveThreshWinSizeStep = 20
    parameters.minMarkerPerimeterRate = least
    small, factor = reduce_to_longest_side(grey, longest)
    corners, numbers, _ = aruco.ArucoDetector(marker_dictionary(), parameters).detectMarkers(small)
    for quad, number in zip(corners, [] if numbers is None else numbers.ravel(), strict=False):
        one = _refined_mark_corners(grey, (quad.reshape(4, 2) + 0.5) / factor - 0.5)
        if all(n != number or abs(other - one).max() > numpy.ptp(one) / 2 for n, other in marks):
            marks.append((int(number), one))


def isolate_sheet(grey: Greys, marks: SheetMarks) -> Greys:
    """One of several blanks, with these marks; the rest of the picture is painted as light as its paper."""
    cv2 = cv()
    factor = reduce_to_longest_side(grey, LARGEST_SIDE_PX)[1]
    seen = numpy.concatenate([*marks.values()])
    w, h = SHEET_MM
    rim = SHEET_MARGIN_MM
    there = numpy.array([(z.real, z.imag) for number in marks for z in _mark_corners_mm(number)])
    warp, _ = cv2.findHomography(there, seen / factor)
    outline = numpy.array([[(-rim, -rim), (w + rim, -rim), (w + rim, h + rim), (-rim, h + rim)]], float)
    quad = cv2.perspectiveTransform(outline, warp)[0]
    inside = cv2.fillPoly(numpy.zeros(grey.shape, numpy.uint8), [quad.round().astype(numpy.int32)], 1)
    left, top = quad.min(axis=0).clip(0).astype(int)
    right, low = quad.max(axis=0).astype(int)
    part = slice(top, low), slice(left, right)
    return numpy.where(inside[part], grey[part], numpy.uint8(numpy.median(grey[inside > 0])))


def _mark_corners_mm(number: int) -> list[complex]:
    """Corners of a mark on the sheet, mm, clockwise from the upper left."""
    return [corner_mark_centres()[number] + MARK_SIDE_MM / 2 * z for z in (-1 + 1j, 1 + 1j, 1 - 1j, -1 - 1j)]


def _refined_mark_corners(grey: Greys, quad: Array) -> Array:
    """Corners of a mark to subpixel accuracy, from the intersections of its edges in the full picture."""
    cv2 = cv()
    side = float(numpy.linalg.norm(quad - numpy.roll(quad, 1, axis=0), axis=1).mean())
    reach = int(min(max(side / MARK_CELLS_PER_SIDE * 0.6, 2), 12))
    stop = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 30, 0.005)
    start = numpy.ascontiguousarray(quad, numpy.float32).reshape(-1, 1, 2)
    sharp: Array = cv2.cornerSubPix(grey, start, (reach, reach), (-1, -1), stop).reshape(4, 2)
    return sharp


def flatten(grey: Greys) -> Flat | None:
    """The sheet seen from straight above, if at least three of its corner marks are found."""
    cv2 = cv()
    small, factor = reduce_to_longest_side(grey, LARGEST_SIDE_PX)
    blanks = find_sheets(small)
    marks = next(iter(blanks.sheets), {})
    if len(marks) < 3:
        return None
    places = [z for number in marks for z in _mark_corners_mm(number)]
    seen = [corner for quad in marks.values() for corner in quad]
    true = [(z.real * PX_PER_MM, (SHEET_MM[1] - z.imag) * PX_PER_MM) for z in places]
    warp, _ = cv2.findHomography(numpy.array(seen), numpy.array(true), cv2.RANSAC, 0.6 * PX_PER_MM)
    if warp is None:
        return None
    notes = [] if len(marks) == 4 else [Phrase("check_three_marks")]
    if len(blanks.sheets) > 1:
        notes.append(Phrase("check_several_blanks", count=len(blanks.sheets)))
    if blanks.partial_sheet_mark_count:
        notes.append(Phrase("check_blank_in_part", count=blanks.partial_sheet_mark_count))
    bend = measure_distortion(small, warp)
    if bend is not None:
        unbent = _rectify_distorted(small, bend, seen, true)
        return Flat(unbent, PX_PER_MM, 0j, "marks", None, notes, replace(bend, shrink=factor))
    flat = cv2.warpPerspective(small, warp, SHEET_PX, flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)
    to_flat = warp @ numpy.diag([factor, factor, 1.0])  # from the original picture
    return Flat(flat, PX_PER_MM, 0j, "marks", to_flat, notes)


def _rectify_distorted(grey: Greys, bend: Bend, seen: list[Array], true: list[tuple[float, float]]) -> Greys:
    """A distorted picture rectified by its corner marks as seen without lens distortion."""
    cv2 = cv()
    straight = bend.remove_lens_distortion(numpy.array(seen, float) @ numpy.array([1, 1j]))
    bend.view, _ = cv2.findHomography(pairs(straight), numpy.array(true))
    add_paper_distortion(bend, grey)
    return remap_picture(grey, bend, SHEET_PX)


def remap_picture(grey: Greys, bend: Bend, size: tuple[int, int]) -> Greys:
    """A distorted picture rectified (width, height)."""
    cv2 = cv()
    width, height = size
    cell = 16  # a map this smooth is interpolated between grid points
    across, down = (numpy.arange(n // cell + 1) * cell + (cell - 1) / 2 for n in size)
    source = bend.to_original(across + 1j * down[:, None])
    map_size = len(across) * cell, len(down) * cell
    maps = (cv2.resize(m.astype(numpy.float32), map_size)[:height, :width] for m in (source.real, source.imag))
    flat: Greys = cv2.remap(grey, *maps, cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)
    return flat


def is_plausible_scale(grey: Greys, scale: float) -> bool:
    """Whether a picture at this scale (pixels per mm) shows a sheet no larger than people draw on."""
    factor = PX_PER_MM / scale
    return 0.05 < factor < 8 and grey.size * factor * factor <= MOST_SHEET_PX


def rectify_by_scale(grey: Greys, scale: float, pole: complex | None = None, askew_deg: float = 0.0) -> Flat:
    """The picture at this scale (pixels per mm), its rotation corrected; the pole, if named, becomes the origin."""
    cv2 = cv()
    factor = PX_PER_MM / scale
    if not is_plausible_scale(grey, scale):
        raise PlanesError(Phrase("check_points"))
    how = cv2.INTER_AREA if factor < 1 else cv2.INTER_CUBIC
    flat = cv2.resize(grey, None, fx=factor, fy=factor, interpolation=how)
    warp = numpy.diag([factor, factor, 1.0])
    at = (pole or 0j) * factor
    if askew_deg:
        back = cv2.getRotationMatrix2D((at.real, at.imag), -askew_deg, 1.0)
        flat = cv2.warpAffine(flat, back, flat.shape[::-1], flags=cv2.INTER_CUBIC, borderMode=cv2.BORDER_REPLICATE)
        warp = numpy.vstack([back, [0, 0, 1]]) @ warp
    corner = -complex(at.real, flat.shape[0] - at.imag) / PX_PER_MM if pole is not None else 0j
    return Flat(flat, PX_PER_MM, corner, "scale" if pole is None else "points", warp)
