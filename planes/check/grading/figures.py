"""Numbers written by a person, with their measurement on a drawing: lengths of segments, results."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import permutations, product

from planes.check.grading.prepared_plan import PreparedPlan
from planes.geometry.arithmetic import Many, Real
from planes.plans.quantities import Quantity
from planes.words import Phrase, Told
from planes.words.errors import closest_name
from planes.words.frozen import frozen
from planes.words.lettering import without_index_markup
from planes.words.names import (
    ACCELERATION_PLAN,
    NO_PLAN,
    POLE_LABEL,
    VELOCITY_PLAN,
    NamesByName,
    PlanId,
    vector_end_label,
)
from planes.words.naming import Names
from planes.words.written_units import unit_in_si

Things = Mapping[str, Real]


@frozen
class WrittenNumber:
    """One number: as written (SI or mm), and as measured on a drawing (an array over the error columns)."""

    name: str
    given: float
    read: Callable[[Things], Real]
    signed: bool = False
    plan: PlanId = NO_PLAN
    value: str = ""  # its name in the program, if any
    unit: str = ""  # of a result


Written = tuple[str, float, str]  # a name, a value and its unit, as written


@dataclass
class Figures:
    """The content of a table: figures; unknown names with the nearest known; faulty units; and missing results."""

    figures: list[WrittenNumber]
    unknown: NamesByName
    strange: dict[str, Phrase] = field(default_factory=dict)
    missing: list[str] = field(default_factory=list)

    @property
    def notes(self) -> list[Phrase]:
        """Notes on the numbers left out."""
        unknown = [Phrase("check_unknown_results", names=name_suggestions(self.unknown))] if self.unknown else []
        return [*self.strange.values(), *unknown]


def name_suggestions(unknown: Mapping[str, str]) -> tuple[Told, ...]:
    """Unknown names, each with the nearest known one."""
    return tuple(Phrase("check_name_near", name=name, near=near) if near else name for name, near in unknown.items())


def _nearest_known_name(written: str, names: Names) -> str:
    near = closest_name(written, map(names.naming.typed_name, names.known))
    return near if re.sub(r"\d", "", near) != re.sub(r"\d", "", written) else ""  # another link is no misspelling


def read_results(
    known: Mapping[str, Quantity], names: Names, written: Sequence[Written], asked: Iterable[str]
) -> Figures:
    """The figures of a table of results, in SI; two names of one quantity are equivalent."""
    meant = {text: names.possible_names(text) for text, *_ in written}
    sure = {text: one[0] for text, one in meant.items() if len({known[n].json_path for n in one}) == 1}
    figures = []
    unknown = {}
    strange = {}
    for text, value, unit in written:
        name = sure.get(text)
        right = known[name].column_to_write.unit if name else ""
        in_si = unit_in_si(unit, right)
        if in_si is None:
            strange[text] = Phrase("check_unit", name=text, unit=unit)
        elif name is None:
            unknown[text] = _nearest_known_name(text, names)
        elif in_si[1] not in ("", right):
            strange[text] = Phrase("check_other_unit", name=text, unit=unit, right=Phrase(right))
        else:
            figures.append(quantity_figure(name, known[name], value * in_si[0]))
    given = {known[f.name].json_path for f in figures}
    missing = [n for n in asked if (ways := names.possible_names(n)) and known[ways[0]].json_path not in given]
    return Figures(figures, unknown, strange, missing)


def quantity_figure(name: str, q: Quantity, value: float) -> WrittenNumber:
    """The measurement of a quantity of the catalogue on a drawing."""
    one = q.column_to_write
    plan = one.end.plan if one.part else {"omega": VELOCITY_PLAN, "epsilon": ACCELERATION_PLAN}.get(q.key, NO_PLAN)
    return WrittenNumber(
        name, value, lambda things: one.read_from_drawing(things, Many()), not one.part, plan, one.value, one.unit
    )


def segment_figures(bench: PreparedPlan, written: Iterable[tuple[str, float]]) -> Figures:
    """Figures of a table of segments ("pb", "bc"; of a force plan also "G_2")."""
    plan = bench.plan
    labels = [m.label for m in bench.marks]
    ends = [n for n in (POLE_LABEL, *labels) if plan.mark(n) in bench.program.result_names]  # a scheme has no pole
    pairs = {one + two: (one, two) for one, two in permutations(ends, 2)}
    for s in bench.plans.segments:
        if s.plan == plan and s.start != s.end and {s.start, s.end} <= set(ends):
            pairs.setdefault(vector_end_label(s.name), (s.start, s.end))
    ways = {
        end: (
            end,
            *bench.written_mark_names.more.get(end, ()),
            without_index_markup(bench.naming.lettered_name(end, plan)),
        )
        for end in ends
    }
    more = {one + two: ["".join(way) for way in product(ways[one], ways[two])] for one, two in permutations(ends, 2)}
    names = bench.naming.name_finder(pairs, poles=False, more=more)
    read = [(names.find_name(text), text, mm) for text, mm in written]
    figures = [WrittenNumber(n, mm, _segment_length_reader(plan, *pairs[n]), False, plan) for n, _, mm in read if n]
    return Figures(figures, {text: _nearest_known_name(text, names) for n, text, _ in read if not n})


def _segment_length_reader(plan: PlanId, start: str, end: str) -> Callable[[Things], Real]:
    return lambda things: abs(things[plan.mark(end)] - things[plan.mark(start)])


def value_without_error_columns(value: Real) -> float:
    """A value without its error columns."""
    return float(value[0] if getattr(value, "shape", None) else value)
