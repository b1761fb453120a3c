"""Tables of given and found values as marks: a title, a head, rows between thin lines."""

import cmath
import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from planes.lesson.transfers import TransferFunctions
from planes.plans.loads import force_name
from planes.solving import Position
from planes.solving.given import GivenTable
from planes.solving.tables import difference
from planes.words import say
from planes.words.lettering import Naming
from planes.words.names import kind_of, plan_of
from planes.words.read_off import fixed, measured
from planes.words.units import RATES, UNIT, number
from render.paper import symbols
from render.paper.ink import head as ink_head
from render.paper.marks import Arc, Line, Mark, Shape, Text
from render.paper.typeset import extent, ink_width
from render.views import View, remark, view
from render.views.formulas import NOISE_MM
from render.views.plotted import of_position

Row = Sequence[str]
CLEAR_MM = 0.65  # least distance of a text from the middle of the lines above and beneath it
MOST_ROWS = 18  # of a table in one column
_NUMBER = re.compile(r"([−-]?\d+)(?:[.,]\d*)?(?:·10.*)?[↺↻]?$")
_SENSES = {"↺": 1.0, "↻": -1.0}


@dataclass(frozen=True)
class TableGrid:
    """A table in the making: letters of ``letter`` mm, the head's names in the first row."""

    letter: float = 3.5

    def drawn(self, head: Row, rows: Sequence[Row]) -> tuple[Mark, ...]:
        """The marks of a table whose upper left corner is the origin."""
        lines = [head, *rows] if any(head) else list(rows)
        (high, drop), pad = self.rows(lines), 0.5 * self.letter
        columns = [self.aligned([row[k] for row in lines], any(head)) for k in range(len(lines[0]))]
        widths = [
            max(x + self.wide(row[k]) for x, row in zip(left, lines, strict=True)) + 2 * pad
            for k, left in enumerate(columns)
        ]
        edges = [sum(widths[:k]) for k in range(len(widths) + 1)]
        marks: list[Mark] = []
        for level in range(len(lines) + 1):
            style = "rule" if level == 1 and any(head) else "thin"
            marks.append(Line((complex(0, -level * high), complex(edges[-1], -level * high)), style, "table"))
        for edge in edges:
            marks.append(Line((complex(edge, 0), complex(edge, -len(lines) * high)), "thin", "table"))
        for level, row in enumerate(lines):
            base = -(level + 0.5) * high - drop
            for k, cell in enumerate(row):
                marks += self.cell(cell, complex(edges[k] + pad + columns[k][level], base))
        return tuple(marks)

    def aligned(self, column: Row, alike: bool) -> list[float]:
        """Where the cells of a column begin: numbers of one unit with their decimal signs in one line, others in the
        middle."""
        wide = list(map(self.wide, column))
        whole = [ink_width(m[1], self.letter) if alike and (m := _NUMBER.match(cell)) else 0.0 for cell in column]
        most = max(whole)
        block = max((most - x + w for x, w in zip(whole, wide, strict=True) if x), default=0.0)
        room = max(block, *wide)
        return [(room - block) / 2 + most - x if x else (room - w) / 2 for x, w in zip(whole, wide, strict=True)]

    def rows(self, lines: Sequence[Row]) -> tuple[float, float]:
        """Height of the rows: two letters, more where indices would come near a line; the base line beneath their
        middle."""
        boxes = [extent(cell.rstrip("↺↻"), self.letter) for row in lines for cell in row]
        low, top = min(b[1] for b in boxes), max(b[3] for b in boxes)
        high = max(2.0 * self.letter, top - low + 2 * CLEAR_MM)
        return high, min(max(0.35 * self.letter, top + CLEAR_MM - high / 2), high / 2 - CLEAR_MM + low)

    def wide(self, cell: str) -> float:
        """Width of a cell's ink."""
        return ink_width(cell.rstrip("↺↻"), self.letter) + (self.letter * 1.5 if cell[-1:] in _SENSES else 0.0)

    def cell(self, cell: str, left: complex) -> tuple[Mark, ...]:
        """A text that begins at a place, a curved arrow after it for a sense of turning."""
        sense = _SENSES.get(cell[-1:])
        text = cell.rstrip("↺↻")
        if sense is None:
            return (Text(text, left, self.letter),) if text else ()
        radius = 0.48 * self.letter
        turn = left + self.wide(cell) - radius + 0.5j * self.letter
        low, high = (-60.0, 180.0) if sense > 0 else (0.0, 240.0)
        tip = turn + radius * symbols.unit(high if sense > 0 else low)
        head = ink_head(tip, -1j, 0.5 * self.letter, 0.3 * self.letter)
        return (Text(text, left, self.letter), Arc(turn, radius, low, high, "thin", "table"), Shape(head, "table"))


def folded(head: Row, rows: Sequence[Row]) -> tuple[Row, list[Row]]:
    """A long table in two or more columns side by side."""
    columns = -(-len(rows) // MOST_ROWS)
    if columns < 2:
        return head, list(rows)
    high = -(-len(rows) // columns)
    parts = [[*rows[k * high : (k + 1) * high]] for k in range(columns)]
    parts[-1] += [[""] * len(head)] * (high - len(parts[-1]))
    return [*head] * columns, [[cell for row in line for cell in row] for line in zip(*parts, strict=True)]


@dataclass(frozen=True)
class Tables:
    """The tables of a position."""

    position: Position
    naming: Naming
    letter: float = 3.5
    parameters: Mapping[str, float] = field(default_factory=dict)
    once: Callable[[tuple[object, ...], Callable[[], View]], View | None] = lambda key, make: make()

    def vectors(self) -> View | None:
        """Length on its plan, magnitude and direction of every vector of a scene that states them."""
        mu, rows = of_position(self.position).mu, []
        for f in self.position.of("vectors").values():
            mm = abs(f.vector) * mu(plan_of(f.quantity.needs[0]))
            angle = self.tenths(math.degrees(cmath.phase(f.vector))) if mm > NOISE_MM else "—"
            unit = self.say(f.quantity.columns[0].unit)
            rows.append([self.naming.vector(f.quantity.name), self.tenths(mm), self.number(abs(f.vector)), unit, angle])
        return self.table("vectors-table", self.say("measured"), ["", self.say("mm"), "", "", self.say("angle")], rows)

    def values(self) -> View | None:
        """What is reckoned from the vectors."""
        found = [(f, f.quantity.columns[0].unit) for f in self.position.of("values").values()]
        told = ((f, unit, self.turning if unit in RATES[False] else self.number) for f, unit in found)
        name = self.naming.vector
        rows = [[name(f.quantity.name), tell(f.number), unit and self.say(unit)] for f, unit, tell in told]
        return self.table("values", self.say("values_found"), ["", "", ""], rows)

    def say(self, key: str) -> str:
        """A word of the sheet."""
        return say(key, self.naming.lang)

    def number(self, value: float | None) -> str:
        """A result of the sheet."""
        return measured(value, self.naming.lang)

    def tenths(self, value: float) -> str:
        """Millimetres, or degrees."""
        return fixed(value, 1, self.naming.lang)

    def table(self, key: str, title: str, head: Row, rows: Sequence[Row], notes: Sequence[str] = ()) -> View | None:
        """A table as a view, or nothing when it has no rows; ``notes`` stand beneath it."""
        if not rows:
            return None
        head, rows = folded(head, rows)

        def make() -> View:
            marks = TableGrid(self.letter).drawn(head, rows)
            for note in notes:
                marks = (*marks, *remark(note, marks))
            return view(key, title, marks)

        return self.once(("table", key, self.letter, *map(tuple, rows)), make)

    def all(self) -> list[View]:
        """Every table that has something to say."""
        if not self.position.plans.moves:
            return [t for t in (self.given(), self.vectors(), self.values()) if t]
        rates = self.plan("velocity"), self.plan("acceleration")
        return [t for t in (self.given(), *rates, self.links(), self.reactions(), self.check()) if t]

    def given(self) -> View | None:
        """What the scene gives, each thing once."""
        given = GivenTable(self.position, self.naming, self.parameters)
        return self.table(
            "given", self.say("given"), ["", "", ""], [*given.rows(), *given.laws()], list(given.formulas())
        )

    def plan(self, plan: str) -> View | None:
        """What was measured on a plan: vector, segment, mm, value."""
        measured = self.position.results.get("plans", {}).get(plan)
        if not measured:
            return None
        unit, rows = self.say(UNIT[kind_of(plan)]), []
        if max((s["mm"] for s in measured["segments"].values()), default=0.0) <= NOISE_MM:
            return None
        for vector, segment, found in self.position.measured_on(plan):
            ends = self.naming.mark(segment.start, plan) + self.naming.mark(segment.end, plan)
            value = self.number(found["value"] if found["mm"] > NOISE_MM else 0.0)
            rows.append([self.naming.vector(vector), ends, self.tenths(found["mm"]), value])
        return self.table(f"{plan}-table", self.say(f"by_{plan}"), ["", "", self.say("mm"), unit], rows)

    def links(self) -> View | None:
        """ω and ε of every link with their senses; nothing where the driver stands."""
        rows, found = [], self.position.rows("links")
        for name in (x for x in self.position.plans.mechanism.links if x in found and not self.position.plans.at_rest):
            cells = [self.turning(found[name][k].number) if k in found[name] else "" for k in ("omega", "epsilon")]
            if any(cells):
                rows.append([self.naming.link(name), *cells])
        head = [self.say("column_link"), f"ω, {self.say('rad/s')}", f"ε, {self.say('rad/s²')}"]
        return self.table("links", self.say("links_table"), head, rows)

    def transfers(self) -> View | None:
        """Transfer functions by segments of the velocity plan."""
        rows = list(TransferFunctions(self.position, self.naming).rows())
        return self.table("transfers", self.say("of_transfers"), ["", "", "", ""], rows)

    def turning(self, value: float) -> str:
        """A signed value and the curved arrow of its sense."""
        shown = self.number(value)
        return shown if shown == "0" else shown + ("↺" if value > 0 else "↻")

    def reactions(self) -> View | None:
        """Length on its force plan, magnitude and direction of every reaction, and a slider's arm."""
        rows, armed, lengths = [], False, self.lengths()
        for name, r in self.position.of("reactions").items():
            mm = self.tenths(lengths[name]) if name in lengths else "—"
            angle = self.tenths(math.degrees(cmath.phase(r.vector))) if r.vector else "—"
            arm = self.number(r.arm) if r.slides else ""
            armed |= arm not in ("", "0")
            rows.append([self.naming.vector(name), mm, self.number(abs(r.vector)), angle, arm])
        convention = self.say("from_on" if self.naming.from_on else "on_from")
        table = [["", self.say("mm"), self.say("N"), self.say("angle"), self.say("column_arm")], *rows]
        head, *rows = [row[: 5 if armed else 4] for row in table]
        return self.table("reactions", self.say("reactions_table"), head, rows, [convention])

    def lengths(self) -> dict[str, float]:
        """How long each reaction is on the force plan that shows it, or its opposite, mm."""
        plotted, found = of_position(self.position), dict[str, float]()
        for s in (s for s in plotted.segments if kind_of(s.plan) == "force" and plotted.has(s.plan, s.start, s.end)):
            mm = abs(plotted.mark(s.plan, s.end) - plotted.mark(s.plan, s.start))
            for key, reaction in self.position.plans.reactions.items():
                if s.name in (key, force_name(reaction.pair.other, reaction.pair.link)):
                    found.setdefault(key, mm)
        return found

    def check(self) -> View | None:
        """The balancing moment (or force), Zhukovsky's, and the difference in per cent."""
        p, rows = self.position, []
        for what, unit in (("moment", "N·m"), ("force", "N")):
            found, check = p.number(f"balancing_{what}"), p.number(f"zhukovsky_{what}")
            name = self.naming.balancing(what == "moment")
            if found is not None:
                rows.append([self.say("by_force_plan"), f"{name}, {self.say(unit)}", self.number(found)])
            if check is not None:
                rows.append([self.say("zhukovsky"), f"{name}, {self.say(unit)}", self.number(check)])
            if found is not None and check is not None:
                apart = 100 * difference(found, check)
                rows.append(
                    [self.say("difference_percent"), "", number(apart if apart > 1e-6 else 0.0, self.naming.lang, 2)]
                )
        return self.table("check", self.say("check_table"), ["", "", ""], rows)
