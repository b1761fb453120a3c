"""Arrowheads that stand by themselves, where a pencil's line fades away before its head, or runs on beside the line of
another vector that was taken for it: told by their shape, and only where a vector should end."""

from dataclasses import dataclass, field

import numpy

from planes.check.vision.image.picture import cv
from planes.check.vision.strokes.ink import Ink
from planes.geometry.arrays import Array, Complexes

LENGTH = (0.6, 1.45)  # of a lone head, in usual ones
WIDE_MM = (0.5, 2.4)
PARTS = 5  # of its length, in which its width is measured
BROADER_MM, POINTED = 0.15, 0.55  # by which a part may be wider than the one behind it; the front to the back
FILLED = (0.42, 0.8)  # the share of its length and width that is ink
ASIDE_MM = 1.2  # how far aside of a line that runs on its head may be
BEND_MM = 0.35  # how far its middle may be aside of its vector's way
ABOUT_MM = 2.2  # how far its tip may be from where it is looked for
GAP_MM, LED = 4.5, 0.7  # what is faint behind it at the most; the share of the way before that is drawn
SHORT_MM = 8.0  # shorter vectors have no line to tell them
ROW_MM = 0.3  # in which the shaft behind a head is told from it


@dataclass
class LoneHeads:
    """Pieces of ink that may be arrowheads."""

    ink: Ink
    usual_mm: float
    left: list[Complexes] = field(default_factory=list)  # on no line, though it hangs together with some
    pieces: list[Complexes] = field(default_factory=list)
    middles: list[complex] = field(default_factory=list)  # of the pieces

    def __post_init__(self) -> None:
        flat, mask = self.ink.flat, self.ink.mask
        _, labels, stats, _ = cv().connectedComponentsWithStats(mask, connectivity=8)
        low, high = (share * self.usual_mm * flat.scale for share in (0.7 * LENGTH[0], LENGTH[1]))
        for k, (x, y, w, h, _) in enumerate(stats.tolist()):
            if k and low < max(w, h) < high:
                down, across = numpy.nonzero(labels[y : y + h, x : x + w] == k)
                self.pieces.append(numpy.asarray(flat.mm(x + 0.5, y + 0.5) + (across - 1j * down) / flat.scale))
        self.middles = [complex(piece.mean()) for piece in self.pieces]

    def tip(self, start: complex, end: complex) -> complex | None:
        """The tip of the head that a vector from ``start`` has about its ``end``, apart from its line."""
        length = abs(end - start)
        if length < SHORT_MM:
            return None
        way, found, reach = (end - start) / length, list[complex](), self.usual_mm + ABOUT_MM
        own = (piece for piece, z in zip(self.pieces, self.middles, strict=True) if abs(z - end) < reach)
        near = (_without_shaft(piece, way) for piece in self.left if abs(piece - end).min() < reach)
        for piece in (*own, *(piece for piece in near if abs(piece.mean() - end) < reach)):
            tip = self._tip(piece, way)
            if tip is not None and abs(tip - end) < ABOUT_MM and self._led(start, tip):
                found.append(tip)
        return min(found, key=lambda z: abs(z - end), default=None)

    def past(self, start: complex, end: complex, near: float, far: float) -> bool:
        """Whether the line of a vector runs on past its end, so far, to a head that stands by itself."""
        way = (end - start) / abs(end - start)
        for piece in (*self.pieces, *(_without_shaft(piece, way) for piece in self.left)):
            off = (complex(piece.mean()) - end) / way
            beyond = near < off.real < far and abs(off.imag) < ASIDE_MM
            if beyond and (tip := self._tip(piece, way)) is not None and self._led(end, tip):
                return True
        return False

    def _tip(self, piece: Complexes, way: complex) -> complex | None:
        """The tip of a piece that narrows along a way as a head does."""
        middle = complex(piece.mean())
        local = (piece - middle) / way
        low, high = float(local.real.min()), float(local.real.max())
        if not LENGTH[0] * self.usual_mm < high - low < LENGTH[1] * self.usual_mm:
            return None
        part = numpy.minimum(((local.real - low) / (high - low) * PARTS).astype(int), PARTS - 1)
        count = numpy.bincount(part, minlength=PARTS)
        if not count.all():
            return None
        wide = count * PARTS / (high - low) / self.ink.flat.scale**2
        aside: Array = numpy.bincount(part, local.imag, PARTS) / count
        filled = len(piece) / self.ink.flat.scale**2 / (high - low) / float(wide.max())
        narrows = bool((numpy.diff(wide) < BROADER_MM).all()) and wide[-1] < POINTED * wide[:2].max()
        if not narrows or not WIDE_MM[0] < wide.max() < WIDE_MM[1] or not FILLED[0] < filled < FILLED[1]:
            return None
        return middle + way * complex(high, float(aside[-1])) if abs(numpy.diff(aside)).max() < BEND_MM else None

    def _led(self, start: complex, tip: complex) -> bool:
        """Whether a line leads from a vector's start to but a little before its head."""
        length = abs(tip - start)
        drawn = length - self.usual_mm - GAP_MM
        return drawn > 0 and self.ink.covered(start, start + (tip - start) * drawn / length) > LED


def _without_shaft(piece: Complexes, way: complex) -> Complexes:
    """What of a piece lies before where it is widest across a way, if that is most of it."""
    along = (piece / way).real
    row = ((along - along.min()) / ROW_MM).astype(int)
    found: Complexes = piece[row >= numpy.bincount(row).argmax()]
    return found if 2 * len(found) > len(piece) else piece
