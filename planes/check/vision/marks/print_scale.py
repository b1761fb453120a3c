"""At what share of its size a sheet is seen: as a blank was printed, told by the drawing on it, or as a mark was drawn
from which its scale was taken.

A printer that fits a page into its margins makes all of it smaller, but people draw on it by a ruler: measured by the
corner marks, all they draw is larger by one factor. A drawing to a wrong scale looks the same, so no more is believed
than printers do.
"""

import math
from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import replace

from planes.check.grading.handwork import Miss
from planes.check.grading.paper import TOLD_MM, ReadMark
from planes.check.grading.prepared_plan import PreparedPlan, drawn_at, variants_of
from planes.check.vision.image.picture import Flat
from planes.check.vision.marks.from_aside import as_sure
from planes.check.vision.marks.places import Seen
from planes.geometry.arrays import Greys
from planes.words import Phrase, Written
from planes.words.names import label_of

LEAST, MOST = 0.9, 1.05  # of its size that a page may be printed at
EXACT = 0.006  # nearer to its size than this is its size
TRUE = 0.003  # so true is a scanner
LONG_MM, ASIDE_MM, AGREE_MM = 12.0, 1.2, 0.7  # of a vector that tells it; how far off its end may be, across and along
UNLIKELY = 3.0  # what it costs to believe that a page was printed at just another size
TRIED = 2
WILDEST, SAME = 6.0, 0.005  # how much larger or smaller a picture may seem by a mark drawn wrongly; shares that are one
LYING = 0.01  # how much a sheet lies turned that nothing tells of, radians
ALONG = 0.004  # how much what people draw lies turned on their paper, radians
EXPLAINED = 0.6  # of a sheet's ink by a plan that tells anything

Rows = list[tuple[str, float, float]]  # by vector: how much longer it seems to be, and how long it is


def printed_share(flat: Flat, grey: Greys, scale: float | None) -> float:
    """The share of its size a blank was printed at, told by a scan that knows its pixels to a millimetre; 1 of others
    (those that see it askew among them), and where no printer makes it so large."""
    if scale is None:
        return 1.0
    height, width = grey.shape
    far, middle = min(height, width) / 4, complex(width, height) / 2
    across, down = (2 * far / scale / abs(flat.place(middle + far * w) - flat.place(middle - far * w)) for w in (1, 1j))
    share = (across + down) / 2
    true = LEAST < share < MOST and abs(across - down) < TRUE < abs(share - 1)
    return share if true else 1.0


def likely_shares(flat: Flat, pairs: Iterable[tuple[str, complex, complex]]) -> list[float]:
    """What a sheet may have been printed at: its size, or what its file tells, then what may be vectors of the plan
    tell, the likeliest first; these by name, as seen and as they should be."""
    rows, found = _rows(pairs) if flat.by == "marks" else [], [*dict.fromkeys((flat.printed, 1.0))]
    for _, share in sorted(((-len(_agreeing(rows, r)), 1 / r) for _, r, _ in rows)):
        agreeing = _agreeing(rows, 1 / share)
        share = 1 / _mean(agreeing)
        shown = abs(flat.printed / share - 1) * math.hypot(*(mm for _, mm in agreeing.values())) > AGREE_MM
        if shown and all(abs(share / one - 1) > EXACT for one in found):
            found.append(share)
    return found[: 1 + TRIED]


def shares_of(bench: PreparedPlan, seen: Seen, pole: complex) -> dict[float, Container[int]]:
    """At what shares of its size a sheet may be seen, the likeliest first; and for which ways its plan may have been
    drawn: 0 rightly, then with each mistake.

    By two points: the mark its scale was taken from, which some mistakes put elsewhere, was so far from the pole.
    """
    flat, variants = seen.ink.flat, variants_of(bench, {}, bench.said_mu)
    if flat.told is None or flat.by_file:
        pairs = seen_from(seen, pole, bench.true_marks)
        return dict.fromkeys(likely_shares(flat, pairs), range(len(variants) + 1))
    found: dict[float, list[int]] = {}
    for k, variant in enumerate((None, *variants)):
        z = drawn_at(bench, variant, flat.told[0])
        share = 1.0 if z is None else abs(z) / flat.told[1]
        one = next((known for known in found if abs(share / known - 1) < SAME), share)
        if 1 / WILDEST < share < WILDEST:
            found.setdefault(one, []).append(k)
    return dict(found)


def seen_from(seen: Seen, pole: complex, true: Mapping[str, complex]) -> Iterator[tuple[str, complex, complex]]:
    """What may be the vectors from a pole to marks: where something ends about as far in their directions, or, where
    the drive was reversed, against them."""
    middle = (1 / LEAST + 1 / MOST) / 2
    for name, z in ((name, z) for name, v in true.items() for z in (v, -v)):
        for place in seen.within(pole + middle * z, (1 / LEAST - middle) * abs(z) + ASIDE_MM):
            if place.ended or place.tip:
                yield name, place.z - pole, z


def _rows(pairs: Iterable[tuple[str, complex, complex]]) -> Rows:
    """By vector how much longer it is seen than it should be, where that may be a printer's doing."""
    rows = ((name, seen / true, abs(true)) for name, seen, true in pairs if abs(true) > LONG_MM)
    return [(n, r.real, mm) for n, r, mm in rows if abs(r.imag) * mm < ASIDE_MM and 1 / MOST < r.real < 1 / LEAST]


def _agreeing(rows: Rows, ratio: float) -> dict[str, tuple[float, float]]:
    """The vectors that are longer by that, each as nearly as it can be."""
    near = [row for row in rows if abs(row[1] - ratio) * row[2] < AGREE_MM]
    return {name: (r, mm) for name, r, mm in sorted(near, key=lambda row: -abs(row[1] - ratio))}


def _mean(rows: Mapping[str, tuple[float, float]]) -> float:
    """By how much vectors are longer, long ones counting most."""
    return sum(r * mm**2 for r, mm in rows.values()) / sum(mm**2 for _, mm in rows.values())


def by_ruler(
    flat: Flat, about: complex, share: float, spots: list[ReadMark], explained: float, true: Mapping[str, complex]
) -> list[ReadMark]:
    """Marks of a sheet printed at about a share of its size, and its picture from now on, in millimetres of a ruler;
    the place they are ``about`` keeps its own. What they should be tells the share better."""
    if share == 1 or explained < EXPLAINED:
        return spots
    if flat.told:
        return _resized(flat, about, share, spots)
    if share == flat.printed:
        return _printed_at(flat, about, share, spots)
    rows = _agreeing(_rows((s.name, s.place - about, true[s.name]) for s in spots if s.name in true), 1 / share)
    return _printed_at(flat, about, 1 / _mean(rows) if rows else share, spots)


def measured_by(flat: Flat, about: complex, spots: list[ReadMark], own: Mapping[str, Miss]) -> list[ReadMark]:
    """Marks as sure as what their sheet was measured by: a vector that is itself off by what a hand errs (``own``, by
    mark) and by how surely its ends were pointed to, and seen by a camera that may have been tilted."""
    if flat.told is None:
        return spots
    name, length = flat.told
    hand = next((miss.mean for mark, miss in own.items() if label_of(mark) == name), 0.0)
    drawn = math.hypot(hand, TOLD_MM) / max(length, LONG_MM)
    turned = ALONG if flat.by_paper else drawn / math.sqrt(2) if length > LONG_MM else LYING
    share = math.hypot(turned if flat.by_file else drawn, flat.aslant)
    return [as_sure(s, about, share, flat.lens) for s in spots]


def _printed_at(flat: Flat, about: complex, share: float, spots: Iterable[ReadMark]) -> list[ReadMark]:
    """The marks of a sheet printed at a share of its size, which is told."""
    flat.notes.append(Phrase("check_printed_at", share=Written(f"{100 * share:.1f}")))
    return _resized(flat, about, share, spots)


def _resized(flat: Flat, about: complex, share: float, spots: Iterable[ReadMark]) -> list[ReadMark]:
    """The marks, and the picture from now on, in millimetres that are so much longer."""
    flat.scale, flat.corner = flat.scale / share, about + (flat.corner - about) * share
    return [replace(s, place=about + (s.place - about) * share) for s in spots]
