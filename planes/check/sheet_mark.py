"""The square code of a blank: scene, variant, student and plan in one short line of text.

`planes2|scene|variant|student|plan|value|mu|x,y`, the last two being the position of the pole (mm). Earlier blanks
begin with `planes1` and have no pole; they are read, too. No content is trusted: a mark is only compared with those of
the scenes named by the teacher, and any other format is no mark.
"""

from __future__ import annotations

import hashlib
import re
import unicodedata
from collections.abc import Iterator
from contextlib import suppress
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING

from planes.check.fiducials import CODE_SIDE_MM, code_centre
from planes.words.frozen import frozen

if TYPE_CHECKING:
    from planes.check.grading.prepared_plan import Asked
    from planes.check.vision.image.picture import Flat
    from planes.geometry.arrays import Greys

MARK_PREFIX, EARLIER_MARK_PREFIX = "planes2", "planes1"
LONGEST_FIELDS = (24, 12, 28, 16)  # maximum lengths of scene, variant, student and plan
LONGEST_MARK_TEXT = 200  # maximum length of the text
NAME_HASH_LENGTH = 5  # length of the hash that replaces the rest of a longer name
_NUMBER_PATTERN = re.compile(r"(-?\d{1,9}(\.\d{1,9})?(e-?\d{1,2})?)?")
_POLE_PATTERN = re.compile(r"\d{1,3}(\.\d)?,\d{1,3}(\.\d)?")


@frozen
class SheetMark:
    """The data on a sheet: its owner, the drive value if not the scene's, the scale (mm per SI unit), the pole (mm)."""

    scene: str
    variant: str = ""
    student: str = ""
    plan: str = ""
    value: float | None = None
    mu: float | None = None
    pole: complex | None = None

    @classmethod
    def from_asked(cls, asked: Asked) -> SheetMark:
        """The mark of a blank, from its scene."""
        scene = asked.scene
        student = str(scene.sheet.get("student", ""))
        return cls(Path(scene.file).stem, scene.variant or "", student, asked.plan, asked.value, asked.mu)

    @property
    def printed_text(self) -> str:
        """The text as printed."""
        words = zip((self.scene, self.variant, self.student, self.plan), LONGEST_FIELDS, strict=True)
        numbers = ("" if n is None else f"{n:.7g}".replace("e+", "e") for n in (self.value, self.mu))
        fields = *(shortened_name(word, most) for word, most in words), *numbers
        if self.pole is None:
            return "|".join((EARLIER_MARK_PREFIX, *fields))
        return "|".join((MARK_PREFIX, *fields, f"{round(self.pole.real, 1):g},{round(self.pole.imag, 1):g}"))

    def matches_task_and_student(self, scene: str, student: str) -> bool:
        """Whether it names this scene and this student, as printed; "" matches any."""
        pairs = ((scene, self.scene, LONGEST_FIELDS[0]), (student, self.student, LONGEST_FIELDS[2]))
        return all(not own or shortened_name(own, most) == shortened_name(read, most) for own, read, most in pairs)


def shortened_name(name: str, most: int) -> str:
    """A name shortened for a mark to printable characters; a longer one ends with a hash of the rest."""
    plain = unicodedata.normalize("NFC", name)
    plain = "".join(c if c.isprintable() and c != "|" else "_" for c in plain)
    if len(plain) <= most:
        return plain
    return f"{plain[: most - NAME_HASH_LENGTH]}~{hashlib.sha256(plain.encode()).hexdigest()[: NAME_HASH_LENGTH - 1]}"


def parse_mark(text: str) -> SheetMark | None:
    """The mark encoded in a text, if any."""
    begins, *parts = text[: LONGEST_MARK_TEXT + 1].split("|")
    place = parts.pop() if begins == MARK_PREFIX else ""
    begins_well = begins == EARLIER_MARK_PREFIX or (begins == MARK_PREFIX and _POLE_PATTERN.fullmatch(place))
    if (
        len(text) > LONGEST_MARK_TEXT
        or not begins_well
        or len(parts) != 6
        or not all(map(_NUMBER_PATTERN.fullmatch, parts[4:]))
    ):
        return None
    scene, variant, student, plan, *numbers = parts
    value, mu = (float(n) if n else None for n in numbers)
    pole = complex(*map(float, place.split(","))) if place else None
    is_mark = SheetMark(scene, variant, student, plan, value, mu, pole)
    if is_mark.printed_text == text and (mu is None or mu > 0):
        return is_mark
    return None


def qr_code_cells(text: str) -> list[list[bool]]:
    """Black cells of the code of a text, top row first."""
    import segno

    code = segno.make_qr(text, error="l", encoding="utf-8", eci=False)
    return [[bool(cell) for cell in row] for row in code.matrix]


CODE_BORDER_MM = 4.0  # white border around the code
REDUCED_SIDE_PX = 2000


def read_mark_on_picture(grey: Greys) -> SheetMark | None:
    """The mark of the sheet on a picture: at the place given by the corner marks, otherwise anywhere."""
    from planes.check.vision.image.opencv import reduce_to_longest_side
    from planes.check.vision.image.picture import flatten

    flat = flatten(grey)
    if flat is None:
        return _decode_mark(reduce_to_longest_side(grey, REDUCED_SIDE_PX)[0], close=False)
    return read_mark_of_sheet(flat)


def read_mark_of_sheet(flat: Flat) -> SheetMark | None:
    """The mark of a sheet rectified by its corner marks."""
    reach = (CODE_SIDE_MM / 2 + CODE_BORDER_MM) * (1 + 1j)
    (left, low), (right, top) = (flat.mm_to_px(code_centre() + by) for by in (-reach, reach))
    return _decode_mark(flat.grey[max(0, int(top)) : int(low), int(left) : int(right)])


def _decode_mark(grey: Greys, close: bool = True) -> SheetMark | None:
    """The mark on a part of a picture, tried with several filters; with more of them on the code alone."""
    from planes.check.vision.image.opencv import cv

    cv2 = cv()
    detectors = (cv2.QRCodeDetector(), *([cv2.QRCodeDetectorAruco()] if close else []))
    for look, detector in product(_filtered_pictures(grey, close), detectors):
        with suppress(cv2.error, UnicodeDecodeError):  # a damaged code may hold any bytes
            mark = parse_mark(detector.detectAndDecode(look)[0])
            if mark:
                return mark
    return None


def _filtered_pictures(grey: Greys, close: bool) -> Iterator[Greys]:
    """The picture as it is, smaller, sharpened against motion blur and, if ``close``, in black and white."""
    from planes.check.vision.image.opencv import cv, resize_by_factor

    cv2 = cv()
    yield grey
    yield resize_by_factor(grey, 0.5)
    for by in (1.5, 3.0):
        yield cv2.addWeighted(grey, 1 + by, cv2.GaussianBlur(grey, (0, 0), 3), -by, 0)
    if close:
        yield cv2.threshold(grey, 0, 255, cv2.THRESH_OTSU)[1]
