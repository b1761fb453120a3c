"""Faults that a strict teacher would circle on a sheet: labels on labels or strokes, anything outside a field."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import shapely

from render.labels.footprints import BOX_SHRINKAGE_MM, Bounds, InkedShapes, inked_shapes, make_polygons
from render.labels.nearness import Shapes
from render.paper.marks import Arc, Arrow, Mark, Text
from render.paper.typeset import lay_out_text, text_box_corners


@dataclass(frozen=True)
class Conflict:
    """``first`` and ``second`` are texts or kinds of marks."""

    kind: str
    first: str
    second: str
    place: complex

    def __str__(self) -> str:
        words = {"label": "overlaps the label", "stroke": "lies on", "field": "sticks out of"}
        where = f"at ({self.place.real:.1f}; {self.place.imag:.1f}) mm"
        return f"{self.first!r} {words[self.kind]} {self.second!r} {where}"


def conflicts(texts: Sequence[Text], marks: Sequence[Mark] = (), field: Bounds | None = None) -> tuple[Conflict, ...]:
    """Labels that overlap each other or the ink of ``marks``, and anything outside the ``field``.

    Texts among the marks are labels, too; the same text given twice counts as one.
    """
    labels = tuple(dict.fromkeys([*texts, *(mark for mark in marks if isinstance(mark, Text))]))
    labels = tuple(label for label in labels if lay_out_text(label).strokes)
    others = [mark for mark in marks if not isinstance(mark, Text)]
    boxes = shapely.buffer(make_polygons([text_box_corners(label) for label in labels]), -BOX_SHRINKAGE_MM)
    return (*_struck(labels, boxes, others), *_outside((*labels, *others), field))


def _owned(marks: Sequence[Mark]) -> tuple[InkedShapes, list[int]]:
    """The ink of marks, mark by mark, and for each shape the number of its mark."""
    parts = [inked_shapes([mark]) for mark in marks]
    shapes = np.concatenate([part.shapes for part in parts]) if parts else np.array([], object)
    halves = np.concatenate([part.halves for part in parts]) if parts else np.array([])
    return InkedShapes(shapes, halves), [k for k, part in enumerate(parts) for _ in part.shapes]


def _struck(labels: Sequence[Text], boxes: Shapes, others: Sequence[Mark]) -> Iterator[Conflict]:
    """Labels on labels, then labels on strokes."""
    for i, j in sorted(map(tuple, shapely.STRtree(boxes).query(boxes, predicate="intersects").T.tolist())):
        if i < j:
            yield Conflict("label", labels[i].text, labels[j].text, labels[i].place)
    inked, owners = _owned(others)
    if len(inked.shapes) and labels:
        for i, k in sorted({(i, owners[k]) for i, k in inked.pairs_within(boxes, 0.0).T.tolist()}):
            yield Conflict("stroke", labels[i].text, described(others[k]), labels[i].place)


def _outside(marks: Sequence[Mark], field: Bounds | None) -> list[Conflict]:
    if field is None:
        return []
    inked, owners = _owned(marks)
    bounds = shapely.bounds(inked.shapes) + np.outer(inked.halves, [-1, -1, 1, 1])
    out = (bounds - np.array(field)) * np.array([-1, -1, 1, 1]) > BOX_SHRINKAGE_MM
    beyond = sorted({owners[k] for k in np.flatnonzero(out.any(axis=1))})
    return [Conflict("field", described(marks[k]), "field", _first(marks[k])) for k in beyond]


def described(mark: Mark) -> str:
    """A mark in a few words: its kind, its layer and its content."""
    if isinstance(mark, Text):
        return mark.text
    named = f" {mark.name}" if isinstance(mark, Arrow) and mark.name else ""
    place = _first(mark)
    return f"{type(mark).__name__.lower()}{named} of {mark.layer} from ({place.real:.1f}; {place.imag:.1f})"


def _first(mark: Mark) -> complex:
    if isinstance(mark, Text):
        return mark.place
    if isinstance(mark, Arrow):
        return mark.start
    return mark.centre if isinstance(mark, Arc) else mark.points[0]
