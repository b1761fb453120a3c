"""Places of views on a sheet: packed into the field, then spread so that white space is shared; all in mm."""

import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise, permutations

from render.labels.footprints import Bounds
from render.sheet.rectangles import RULES, PlacedRectangle, Rule, Size, filled

GAP_MM = 7.0  # least distance of views from each other and from the frame
ROUNDS = 80
FIRST = 4.0  # how much more the place of the first view matters than those of the others


@dataclass(frozen=True)
class Effort:
    """How many orders are tried, how many arrangements are enough to choose from, how many moves better the best."""

    tries: int = 160
    enough: int = 40
    moves: int = 0


FULL, USUAL, QUICK = Effort(moves=400), Effort(), Effort(80, 12)


@dataclass(frozen=True)
class Packed:
    """Places of rectangles, how far they are from being read easily, whether the first figure stands first, and out of
    how many arrangements they are the best."""

    spots: list[PlacedRectangle]
    cost: float
    led: bool = True
    choice: int = 1


@dataclass(frozen=True)
class Field:
    """What is to be filled: the inside of a frame, what stands in it already, how many figures come first."""

    inside: Bounds
    blocked: Sequence[Bounds]
    figures: int = 0
    gap: float = GAP_MM

    def filled(self, sizes: Sequence[Size], order: Sequence[int], rule: Rule) -> Packed | None:
        """The rectangles placed one after the other."""
        found = filled([sizes[k] for k in order], self.inside, self.blocked, self.gap, rule)
        if found is None:
            return None
        spots = [found[order.index(k)] for k in range(len(sizes))]
        led = not any(_before(other, spots[0]) for other in spots[1 : self.figures])
        return Packed(spots, _cost(spots, self.inside, self.figures), led)

    def holds(self, sizes: Sequence[Size]) -> bool:
        """Whether there is any use in trying."""
        x0, y0, x1, y1 = self.inside
        wide, high, gap = x1 - x0, y1 - y0, self.gap
        taken = sum((b[2] - b[0]) * (b[3] - b[1]) for b in self.blocked)
        area = sum((w + gap) * (h + gap) for w, h in sizes) + taken
        return area <= wide * high and all(w + 2 * gap <= wide and h + 2 * gap <= high for w, h in sizes)


def pack(sizes: Sequence[Size], field: Field, effort: Effort = FULL) -> Packed | None:
    """Places for rectangles of these sizes, the figures in reading order; None if no try fits them all."""
    if not field.holds(sizes):
        return None
    found: list[tuple[Packed, list[int], Rule]] = []
    for order in _orders(sizes, effort.tries):
        tried = ((field.filled(sizes, order, rule), rule) for rule in RULES)
        found += [(packed, order, rule) for packed, rule in tried if packed]
        if len(found) >= effort.enough:
            break
    if not found:
        return None
    best = min(found, key=lambda one: one[0].cost)
    return replace(_improved(sizes, field, *best, effort.moves), choice=len(found))


def _improved(sizes: Sequence[Size], field: Field, found: Packed, order: list[int], rule: Rule, moves: int) -> Packed:
    """The arrangement after so many tries to place one rectangle earlier or later, or two in exchange."""
    shuffler = random.Random(2)
    for turn in range(moves):
        tried = list(order)
        i, j = shuffler.randrange(len(order)), shuffler.randrange(len(order))
        if turn % 2:
            tried[i], tried[j] = tried[j], tried[i]
        else:
            tried.insert(j, tried.pop(i))
        other = RULES[shuffler.randrange(len(RULES))] if turn % 5 == 0 else rule
        better = field.filled(sizes, tried, other)
        if better and better.cost < found.cost:
            found, order, rule = better, tried, other
    return found


def _cost(spots: Sequence[PlacedRectangle], field: Bounds, figures: int) -> float:
    """How far an arrangement is from one that is read easily: in order, from the upper left, in few rows.

    The first ``figures`` are read one after the other; tables may stand anywhere, best near each other and towards
    the title block.
    """
    cost = 5.0 * (spots[0].x - field[0] + field[3] - spots[0].top)
    for k, later in enumerate(spots):
        for j, earlier in enumerate(spots[:k]):
            if _before(later, earlier):
                cost += (1.0 if j else FIRST) * (90.0 if k < figures else 8.0)
            elif later.top > earlier.top + 8:
                cost += 12.0 if k < figures else 2.0
    cost += 15.0 * len({round(spot.top) for spot in spots}) + 5.0 * len({round(spot.x) for spot in spots})
    near = sum(0.25 * abs(complex(b.x - a.x, b.top - a.top)) for a, b in pairwise(spots))
    aside = sum(0.1 * (field[2] - spot.right + spot.y - field[1]) for spot in spots[figures:])
    return cost + near + aside


def _before(later: PlacedRectangle, earlier: PlacedRectangle) -> bool:
    """Whether a rectangle that is to be read later stands above, or on the left in the same row."""
    higher, common = later.top > earlier.top + 8, min(earlier.top, later.top) - max(earlier.y, later.y)
    in_row = common > 0.5 * min(earlier.height, later.height)
    return later.x < earlier.right and (higher or (later.x < earlier.x and in_row))


def _orders(sizes: Sequence[Size], tries: int) -> Iterator[list[int]]:
    """Orders to try: as given, the largest, tallest, widest first, then shuffled ones, always the same."""
    plain = list(range(len(sizes)))
    by_height = sorted(plain, key=lambda k: -sizes[k][1])
    yield from (plain, by_height)
    yield sorted(plain, key=lambda k: -sizes[k][0] * sizes[k][1])
    yield sorted(plain, key=lambda k: -sizes[k][0])
    yield sorted(plain, key=lambda k: -max(sizes[k]))
    shuffler = random.Random(1)
    for turn in range(tries):
        ranks = plain if turn % 2 else by_height
        loose = (0.2, 0.35, 0.6, 1.0)[turn % 4] * len(sizes)
        yield sorted(plain, key=lambda k: ranks.index(k) + shuffler.uniform(0, loose))


def spread(spots: list[PlacedRectangle], field: Field) -> list[PlacedRectangle]:
    """The same arrangement with white space shared: every view comes to stand midway between its neighbours.

    Views that stood side by side with their tops in one line keep doing so.
    """
    fixed = [PlacedRectangle(b[0], b[1], b[2] - b[0], b[3] - b[1], True) for b in field.blocked]
    everything, gap = [*spots, *fixed], field.gap
    pairs = list(permutations(range(len(everything)), 2))
    sides = [(i, j) for i, j in pairs if _beside(everything[i], everything[j], gap)]
    for _ in range(ROUNDS):
        for k, spot in enumerate(spots):
            low = max([field.inside[0] + gap, *(everything[i].right + gap for i, j in sides if j == k)])
            high = min([field.inside[2] - gap, *(everything[j].x - gap for i, j in sides if i == k)])
            spot.x = (low + high - spot.width) / 2
    above = [(i, j) for i, j in pairs if _above(everything[i], everything[j], gap)]
    rows: dict[float, list[int]] = {}
    for k, spot in enumerate(spots):
        rows.setdefault(round(spot.top, 1), []).append(k)
    for _ in range(ROUNDS):
        for row in rows.values():
            ceilings = [[field.inside[3] - gap, *(everything[i].y - gap for i, j in above if j == k)] for k in row]
            floors = [[field.inside[1] + gap, *(everything[j].top + gap for i, j in above if i == k)] for k in row]
            up = min(min(c) - spots[k].top for c, k in zip(ceilings, row, strict=True))
            down = min(spots[k].y - max(f) for f, k in zip(floors, row, strict=True))
            for k in row:
                spots[k].y += (up - down) / 2
    return spots


def _beside(a: PlacedRectangle, b: PlacedRectangle, gap: float) -> bool:
    """Whether spot a stands to the left of b, within reach of it up and down."""
    return a.right <= b.x + 1e-6 and a.y < b.top + gap - 1e-6 and b.y < a.top + gap - 1e-6


def _above(a: PlacedRectangle, b: PlacedRectangle, gap: float) -> bool:
    """Whether spot a stands above b, within reach of it sideways."""
    return a.y >= b.top - 1e-6 and a.x < b.right + gap - 1e-6 and b.x < a.right + gap - 1e-6
