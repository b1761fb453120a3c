"""The ink of marks as shapely shapes, and where labels and strokes meet; all in mm of the sheet."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import chain

import numpy as np
import shapely
from numpy.typing import NDArray

from planes.geometry.arrays import Array, Indices
from render.paper.ink import Polyline, arrow_parts, flattened, is_circle
from render.paper.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text
from render.paper.style import pen
from render.paper.typeset import box_around, box_of, layout

Bounds = tuple[float, float, float, float]
"""x0, y0, x1, y1 in mm."""

Shapes = NDArray[np.object_]
"""Geometries of shapely."""

_TOUCH_MM = 0.01


@dataclass(frozen=True)
class InkedShapes:
    """Shapes and half the pen width of each: a point is inked if it is nearer to the shape than that."""

    shapes: Shapes
    halves: Array
    owners: tuple[int, ...]

    @cached_property
    def tree(self) -> shapely.STRtree:
        """The shapes by where they are."""
        return shapely.STRtree(self.shapes)

    def gaps(self, areas: Shapes, clear: float) -> tuple[Indices, Array]:
        """Pairs (number of the area, number of the shape) that may be nearer than ``clear`` mm, and how far apart."""
        x0, y0, x1, y1 = shapely.bounds(areas).T
        most = clear + float(self.halves.max(initial=0.0))
        pairs = self.tree.query(shapely.box(x0 - most, y0 - most, x1 + most, y1 + most))
        return pairs, shapely.distance(areas[pairs[0]], self.shapes[pairs[1]]) - self.halves[pairs[1]]

    def within(self, areas: Shapes, clear: float) -> Indices:
        """Pairs (number of the area, number of the shape) with less than ``clear`` mm between them."""
        pairs, apart = self.gaps(areas, clear)
        return pairs[:, apart <= clear]


@dataclass(frozen=True)
class Conflict:
    """Something a strict teacher would circle: ``first`` and ``second`` are texts or kinds of marks."""

    kind: str
    first: str
    second: str
    place: complex

    def __str__(self) -> str:
        words = {"label": "overlaps the label", "stroke": "lies on", "field": "sticks out of"}
        where = f"at ({self.place.real:.1f}; {self.place.imag:.1f}) mm"
        return f"{self.first!r} {words[self.kind]} {self.second!r} {where}"


def ink(marks: Iterable[Mark]) -> InkedShapes:
    """The ink of marks; texts count as their boxes, hatched regions and filled shapes as areas."""
    parts = list(map(_parts, marks))
    paths = [(line, half, owner) for owner, (half, lines, _) in enumerate(parts) for line in lines]
    areas = [(area, 0.0, owner) for owner, (_, _, filled) in enumerate(parts) for area in filled]
    strings = _strings([line for line, _, _ in paths], shapely.linestrings)
    shapes = np.concatenate([strings, polygons([area for area, _, _ in areas])])
    everything = [*paths, *areas]
    return InkedShapes(shapes, np.array([half for _, half, _ in everything]), tuple(k for _, _, k in everything))


def bounds(marks: Iterable[Mark]) -> Bounds:
    """The box around all ink of the marks; of none a box of no size."""
    parts = list(map(_parts, marks))
    edges = [(z, half) for half, lines, _ in parts for z in chain(*lines)]
    return box_around([*edges, *((z, 0.0) for _, _, filled in parts for z in chain(*filled))])


def _parts(mark: Mark) -> tuple[float, list[Polyline], list[Polyline]]:
    """Half the pen width, the lines and the areas of a mark."""
    if isinstance(mark, Text):
        corners = box_of(mark)
        return 0.0, [], [corners] if corners[0] != corners[2] else []
    if isinstance(mark, (Shape, Hatch)):
        return 0.0, [], [mark.points]
    half = pen(mark.style).width / 2
    if isinstance(mark, Arrow):
        shaft, head = arrow_parts(mark)
        return half, [shaft], [head] if head else []
    if isinstance(mark, Line):
        return half, [(*mark.points, mark.points[0]) if mark.closed else mark.points], []
    round_ = flattened(mark, 0.02)
    filled = mark.fill != "none" and is_circle(mark)
    return half, [round_], [round_] if filled else []


def _strings(paths: Sequence[Polyline], made: Callable[..., Shapes]) -> Shapes:
    """Lines or rings through complex points."""
    if not paths:
        return np.array([], dtype=object)
    flat = np.array([z for path in paths for z in path])
    owners = np.repeat(np.arange(len(paths)), [len(path) for path in paths])
    return made(np.column_stack([flat.real, flat.imag]), indices=owners)


def polygons(areas: Sequence[Polyline]) -> Shapes:
    """Polygons with complex corners."""
    return np.array(shapely.polygons(_strings(areas, shapely.linearrings)), dtype=object)


def conflicts(texts: Sequence[Text], marks: Sequence[Mark] = (), field: Bounds | None = None) -> tuple[Conflict, ...]:
    """Where labels overlap each other or any ink of ``marks``, or anything leaves the ``field``.

    Texts among the marks are labels too; the same text given twice is one.
    """
    labels = tuple(dict.fromkeys([*texts, *(mark for mark in marks if isinstance(mark, Text))]))
    labels = tuple(label for label in labels if layout(label).strokes)
    others = [mark for mark in marks if not isinstance(mark, Text)]
    boxes = shapely.buffer(polygons([layout(label).box for label in labels]), -_TOUCH_MM)
    return (*_struck(labels, boxes, others), *_outside(labels, others, field))


def _struck(labels: Sequence[Text], boxes: Shapes, others: Sequence[Mark]) -> Iterator[Conflict]:
    """Labels on labels, then labels on strokes."""
    for i, j in sorted(map(tuple, shapely.STRtree(boxes).query(boxes, predicate="intersects").T.tolist())):
        if i < j:
            yield Conflict("label", labels[i].text, labels[j].text, labels[i].place)
    inked = ink(others)
    if len(inked.shapes) and labels:
        for i, k in sorted({(i, inked.owners[k]) for i, k in inked.within(boxes, 0.0).T.tolist()}):
            yield Conflict("stroke", labels[i].text, described(others[k]), labels[i].place)


def overprinted(marks: Sequence[Mark]) -> list[str]:
    """Labels whose letters, not their boxes alone, lie on another label or on any stroke but their own bars."""
    held = [m for m in marks if not (isinstance(m, Line) and m.layer == "text" and m.name != "leader")]
    texts = [m for m in held if isinstance(m, Text) and layout(m).strokes]
    crowded = {name for c in conflicts((), held) for name in (c.first, c.second)}
    inked = {k: letters(t) for k, t in enumerate(texts) if t.text in crowded}
    rest = ink([m for m in held if not isinstance(m, Text)])
    found = []
    for k, own in inked.items():
        others = [shape for j, shape in inked.items() if j != k]
        struck = len(rest.shapes) and len(rest.within(np.array([own]), 0.0)[0])
        if struck or any(own.intersects(other) for other in others):
            found.append(texts[k].text)
    return found


def letters(text: Text) -> shapely.Geometry:
    """The ink of a text's own letters."""
    laid = layout(text)
    drawn = [(pen_mm, line) for pen_mm, line in zip(laid.pens, laid.strokes, strict=True) if len(line) > 1]
    halves = [pen_mm / 2 or _TOUCH_MM for pen_mm, _ in drawn]
    return shapely.union_all(shapely.buffer(_strings([line for _, line in drawn], shapely.linestrings), halves))


def _outside(labels: Sequence[Text], others: Sequence[Mark], field: Bounds | None) -> list[Conflict]:
    if field is None:
        return []
    marks = (*labels, *others)
    inked = ink(marks)
    bounds = shapely.bounds(inked.shapes) + np.outer(inked.halves, [-1, -1, 1, 1])
    out = (bounds - np.array(field)) * np.array([-1, -1, 1, 1]) > _TOUCH_MM
    beyond = sorted({inked.owners[k] for k in np.flatnonzero(out.any(axis=1))})
    return [Conflict("field", described(marks[k]), "field", _first(marks[k])) for k in beyond]


def described(mark: Mark) -> str:
    """A mark in a few words: its kind, its layer and what it shows."""
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
