"""Numbers a person wrote down, as they are read off a drawing: lengths of segments, results."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import permutations, product

from planes.check.grading.prepared_plan import PreparedPlan
from planes.geometry.arithmetic import Many, Real
from planes.plans.quantities import Quantity
from planes.words import Phrase
from planes.words.frozen import frozen
from planes.words.lettering import flat
from planes.words.names import POLE, at, end_of, label_of, plan_of
from planes.words.naming import Names
from planes.words.written_units import unit_factor

Things = Mapping[str, Real]


@frozen
class WrittenNumber:
    """One number: as written (SI or mm), and how it is read off a drawing (an array over the errors' columns)."""

    name: str
    given: float
    read: Callable[[Things], Real]
    signed: bool = False
    plan: str = ""
    value: str = ""  # the program's name of it, if it has one


Written = tuple[str, float, str]  # a name, a value and its unit, as written
Figures = tuple[list[WrittenNumber], list[str]]  # those of a table, and the names that mean nothing here


def result_figures(known: Mapping[str, Quantity], names: Names, written: Iterable[tuple[str, float]]) -> Figures:
    """Figures of a table of results, in SI; a name of two that are one quantity means that."""
    read = [(names.meant(text), text, value) for text, value in written]
    sure = {text: n[0] for n, text, _ in read if len({known[one].path for one in n}) == 1}
    figures = [figure(n, known[n], value) for _, text, value in read if (n := sure.get(text))]
    return figures, [text for _, text, _ in read if text not in sure]


def read_results(
    known: Mapping[str, Quantity], names: Names, written: Sequence[Written], asked: Iterable[str]
) -> tuple[list[WrittenNumber], list[str], list[Phrase]]:
    """The figures of a table of results; the names of what could not be understood, or is asked and not there; and
    what is said of the former."""
    read = [(name, value, unit, unit_factor(unit)) for name, value, unit in written]
    strange = {name: unit for name, _, unit, factor in read if factor is None}
    figures, unknown = result_figures(known, names, [(name, value * by) for name, value, _, by in read if by])
    notes = [Phrase("check_unit", name=name, unit=unit) for name, unit in strange.items()]
    notes += [Phrase("check_unknown_results", names=", ".join(unknown))] if unknown else []
    given = {known[f.name].path for f in figures}
    missing = [n for n in asked if (found := names.meant(n)) and known[found[0]].path not in given]
    return figures, list(dict.fromkeys([*strange, *unknown, *missing])), notes


def figure(name: str, q: Quantity, value: float) -> WrittenNumber:
    """How a quantity of the catalogue is read off a drawing."""
    one = q.whole
    plan = plan_of(one.end) if one.part else {"omega": "velocity", "epsilon": "acceleration"}.get(q.key, "")
    return WrittenNumber(name, value, lambda things: one.take(things, Many()), not one.part, plan, one.value)


def segment_figures(bench: PreparedPlan, written: Iterable[tuple[str, float]]) -> Figures:
    """Figures of a table of segments ("pb", "bc"; of a force plan also "G_2")."""
    plan, labels = bench.asked.plan, [label_of(m) for m in bench.marks]
    ends = [n for n in (POLE, *labels) if at(plan, n) in bench.program.made]  # a scheme has no pole
    pairs = {one + two: (one, two) for one, two in permutations(ends, 2)}
    for s in bench.plans.segments:
        if s.plan == plan and s.start != s.end and {s.start, s.end} <= set(ends):
            pairs.setdefault(end_of(s.name), (s.start, s.end))
    ways = {end: (end, *bench.names.more.get(end, ()), flat(bench.naming.named(end, plan))) for end in ends}
    more = {one + two: ["".join(way) for way in product(ways[one], ways[two])] for one, two in permutations(ends, 2)}
    names = bench.naming.names(pairs, poles=False, more=more)
    read = [(names.find(text), text, mm) for text, mm in written]
    found = [WrittenNumber(n, mm, _millimetres(plan, *pairs[n]), False, plan) for n, _, mm in read if n]
    return found, [text for n, text, _ in read if not n]


def _millimetres(plan: str, start: str, end: str) -> Callable[[Things], Real]:
    return lambda things: abs(things[at(plan, end)] - things[at(plan, start)])


def first_of(value: Real) -> float:
    """A value without the columns of its errors."""
    return float(value[0] if getattr(value, "shape", None) else value)
