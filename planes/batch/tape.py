"""A tape: the computation of a program as one straight line of real operations, each recorded once; and its evaluation
with floats, numpy arrays, or any numbers of an arithmetic. Other modules compile it (``compiled``) or bound its errors
(``error_bounds``)."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field

from planes.geometry.arithmetic import Real
from planes.geometry.arrays import Floats, FloatsByName

Args = tuple[int, ...]
COMMUTATIVE_OPERATIONS = frozenset({"add", "mul", "max", "min", "and", "or", "eq", "hypot"})
TEST_OPERATIONS = frozenset({"lt", "le", "eq", "and", "or", "not"})
Leaf = Real  # a constant, or the name of a given
LEAF_OPERATIONS = frozenset({"const", "given", "source"})


@dataclass
class Tape:
    """Operations in order; an operation refers to its arguments by their places on the tape."""

    ops: list[tuple[str, Args]] = field(default_factory=list)
    values: dict[int, Leaf] = field(default_factory=dict)  # of constants ("const") and names of givens ("given")
    seen: dict[object, int] = field(default_factory=dict)

    def record_operation(self, op: str, *args: int) -> int:
        """The place of an operation, recorded if it is new."""
        args = tuple(sorted(args)) if op in COMMUTATIVE_OPERATIONS else args
        return self._place_of_operation((op, args), op, args)

    def record_leaf(self, op: str, value: float | str) -> int:
        """The place of a constant or of a given by its name."""
        place = self._place_of_operation((op, repr(value)), op, ())
        self.values[place] = value
        return place

    def _place_of_operation(self, key: object, op: str, args: Args) -> int:
        place = self.seen.get(key)
        if place is None:
            place = self.seen[key] = len(self.ops)
            self.ops.append((op, args))
        return place

    def places_needed(self, wanted: list[int], stop: frozenset[int] = frozenset()) -> list[int]:
        """The places that the wanted ones need, in order, going no further back than ``stop``."""
        places = set()
        stack = list(wanted)
        while stack:
            place = stack.pop()
            if place not in places:
                places.add(place)
                if place not in stop:
                    stack.extend(self.ops[place][1])
        return sorted(places)

    def places_moved_by(self, names: frozenset[str]) -> frozenset[int]:
        """The places that change when the named givens change."""
        moved = set[int]()
        for place, (op, args) in enumerate(self.ops):
            if (op == "given" and self.values[place] in names) or not moved.isdisjoint(args):
                moved.add(place)
        return frozenset(moved)


Number = Real  # of a tape under evaluation: a float, an array, or a longer number
Op = Callable[..., Number]


def compute_places(
    tape: Tape, order: Iterable[int], given: FloatsByName, real: Callable[[Floats], Number], ops: Mapping[str, Op]
) -> dict[int, Number]:
    """The numbers at the places of ``order``, of the kind ``real``, by the operations ``ops``; errors of instruments
    are 0."""
    numbers = {}
    for place in order:
        op, args = tape.ops[place]
        if op in LEAF_OPERATIONS:
            leaf = tape.values[place]
            numbers[place] = real(given[leaf] if op == "given" else leaf if op == "const" else 0.0)
        else:
            numbers[place] = ops[op](*(numbers[a] for a in args))
    return numbers
