"""Tables of given and found values."""

import cmath
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import zip_longest

from planes.lesson.transfers import TransferFunctions
from planes.plans.force.loads import force_name
from planes.plans.structures.figure import Strain, strains
from planes.scene.vector_equations import VectorEquation
from planes.solving import Position
from planes.solving.given import GivenTable
from planes.solving.own_equations import own_rows
from planes.solving.tables import difference
from planes.solving.text_tables import NOISE, largest
from planes.words import say
from planes.words.frozen import field, frozen
from planes.words.names import CREMONA, kind_of, parts_of, plan_of
from planes.words.naming import Naming
from planes.words.read_off import fixed, measured
from planes.words.units import RATES, UNIT, number
from render.views import View, remark, view
from render.views.formulas import NOISE_MM
from render.views.plotted import of_position
from render.views.table_grid import Row, TableGrid, folded

VECTOR_NAMED = re.compile(r"[^\W\d]+_\w+(?:\^[ntkr])?")


@frozen
class Tables:
    """The tables of a position."""

    position: Position
    naming: Naming
    letter: float = 3.5
    parameters: Mapping[str, float] = field(default_factory=dict)
    once: Callable[[tuple[object, ...], Callable[[], View]], View | None] = lambda key, make: make()
    own: tuple[tuple[VectorEquation, ...], str] = ((), "")  # the user's equations, and their file

    def vectors(self) -> View | None:
        """Length on its plan, magnitude and direction of every vector in a scene of vectors."""
        mu, rows = of_position(self.position).mu, []
        for f in self.position.of("vectors").values():
            mm = abs(f.vector) * mu(plan_of(f.quantity.needs[0]))
            angle = self.tenths(math.degrees(cmath.phase(f.vector))) if mm > NOISE_MM else "—"
            unit = self.say(f.unit)
            rows.append([self.naming.vector(f.quantity.name), self.tenths(mm), self.number(abs(f.vector)), unit, angle])
        return self.table("vectors-table", "measured", ["", self.say("mm"), "", "", self.say("angle")], rows)

    def values(self) -> View | None:
        """The values computed from the vectors."""
        noise, rows = NOISE * largest(self.position), []
        for f in (f for n, f in self.position.of("values").items() if n not in self.strains):
            tell = self.turning if f.unit in RATES[False] else self.number
            value = f.number if abs(f.number) > noise else 0.0
            rows.append([self.naming.vector(f.quantity.name), tell(value), f.unit and self.say(f.unit)])
        return self.table("values", "values_found", ["", "", ""], rows)

    @cached_property
    def strains(self) -> dict[str, Strain]:
        """The state of every member of a truss, tension or compression, by the name of its force."""
        return strains(self.position.plans.figure, self.position.drawing)

    def members(self) -> View | None:
        """Length on the plan, force and state of every member of a truss."""
        values, rows, mu = self.position.of("values"), [], of_position(self.position).mu
        for name, strain in self.strains.items():
            force = values[name].number if name in values and strain != "idle" else 0.0
            mm = self.tenths(abs(force) * mu(CREMONA))
            rows.append([self.naming.vector(name), mm, self.number(force), self.say(f"strain_{strain}")])
        head = ["", self.say("mm"), self.say("N"), ""]
        counted = [x.told(self.naming.lang) for x in figure.counted] if (figure := self.position.plans.figure) else []
        return self.table("members", "members_table", head, rows, counted)

    def say(self, key: str) -> str:
        """A word of the sheet."""
        return say(key, self.naming.lang)

    def number(self, value: float | None) -> str:
        """A result of the sheet."""
        return measured(value, self.naming.lang)

    def tenths(self, value: float) -> str:
        """Millimetres, or degrees."""
        return fixed(value, 1, self.naming.lang)

    def table(
        self, key: str, title: str, head: Row, rows: Sequence[Row], notes: Sequence[str] = (), spanned: bool = False
    ) -> View | None:
        """A table as a view, or None without rows; its ``title`` by the word; ``notes`` are beneath it."""
        if not rows:
            return None
        head, rows = folded(head, rows)

        def make() -> View:
            marks = TableGrid(self.letter, spanned).drawn(head, rows)
            for note in notes:
                marks = (*marks, *remark(note, marks))
            return view(key, self.say(title), marks)

        return self.once(("table", key, self.letter, *map(tuple, rows)), make)

    def all(self, joined: bool = True) -> list[View]:
        """Every table with contents; the measurements on both motion plans ``joined`` in one."""
        if not self.position.plans.moves:
            return [t for t in (self.given(), self.vectors(), self.members(), self.values()) if t]
        tables = (self.given(), *self.rates(joined), self.links(), *self.forces(), self.equations())
        return [t for t in tables if t]

    def forces(self) -> tuple[View | None, ...]:
        """The tables of the force calculation."""
        return self.reactions(), self.edges(), self.friction(), self.check()

    def equations(self) -> View | None:
        """The user's equations: the result of each, or whether it closes and what would close it."""
        p = self.position
        told_rows = own_rows(p, self.own, self.naming.lang)
        rows = [[VECTOR_NAMED.sub(lambda m: self.naming.vector(m[0]), text) for text in row] for row in told_rows]
        return self.table("own-equations", "own_equations", ["", ""], rows)

    def given(self) -> View | None:
        """The data of the scene, each item once."""
        given = GivenTable(self.position, self.naming, self.parameters)
        return self.table("given", "given", ["", "", ""], [*given.rows(), *given.laws()], list(given.formulas()))

    def plan(self, plan: str) -> View | None:
        """The measurements on a plan: vector, segment, mm, value."""
        rows = [row for _, row in self.measured_rows(plan)]
        return self.table(f"{plan}-table", f"by_{plan}", self.measured_head(plan), rows)

    def rates(self, joined: bool) -> list[View | None]:
        """The measurements on the velocity and acceleration plans: a table each, or ``joined`` with the vectors of one
        point, or of one link, side by side."""
        plans = [plan for plan in ("velocity", "acceleration") if any(self.measured_rows(plan))]
        if not joined or len(plans) < 2:
            return [self.plan(plan) for plan in plans]
        by_owner: dict[str, tuple[list[Row], ...]] = {}
        for k, plan in reversed([*enumerate(plans)]):  # in the order of the accelerations
            for owner, row in self.measured_rows(plan):
                by_owner.setdefault(owner, ([], []))[k].append(row)
        sides = (tuple(rows or [[" "] * 4] for rows in both) for both in by_owner.values())
        pairs = (two for both in sides for two in zip_longest(*both, fillvalue=[""] * 4))
        head = [cell for plan in plans for cell in self.measured_head(plan)]
        rows = [[*one, *other] for one, other in pairs]
        return [self.table("rates-table", "by_plans", head, rows, spanned=True)]

    def measured_head(self, plan: str) -> Row:
        """The head over the measurements on a plan."""
        return ["", "", self.say("mm"), self.say(UNIT[kind_of(plan)])]

    def measured_rows(self, plan: str) -> Iterator[tuple[str, Row]]:
        """The measurements on a plan, with the owner of each vector: a point, two points of a link, a guide."""
        known = self.position.results.get("plans", {}).get(plan, {"segments": {}})["segments"]
        if max((s["mm"] for s in known.values()), default=0.0) <= NOISE_MM:
            return
        for vector, segment, measures in self.position.measured_on(plan):
            ends = self.naming.mark(segment.start, plan) + self.naming.mark(segment.end, plan)
            value = self.number(measures["value"] if measures["mm"] > NOISE_MM else 0.0)
            yield parts_of(vector)[1], [self.naming.vector(vector), ends, self.tenths(measures["mm"]), value]

    def links(self) -> View | None:
        """ω and ε of every link with their senses; empty if the driver is at rest."""
        rows, links = [], self.position.rows("links")
        for name in self.position.plans.mechanism.links:
            if name in links and not self.position.plans.at_rest:
                cells = [self.turning(links[name][k].number) if k in links[name] else "" for k in ("omega", "epsilon")]
                if any(cells):
                    rows.append([self.naming.link(name), *cells])
        head = [self.say("column_link"), f"ω, {self.say('rad/s')}", f"ε, {self.say('rad/s²')}"]
        return self.table("links", "links_table", head, rows)

    def transfers(self) -> View | None:
        """Transfer functions by segments of the velocity plan."""
        rows = list(TransferFunctions(self.position, self.naming).rows())
        return self.table("transfers", "of_transfers", ["", "", "", ""], rows)

    def turning(self, value: float) -> str:
        """A signed value and the curved arrow of its sense."""
        shown = self.number(value)
        return shown if shown == "0" else shown + ("↺" if value > 0 else "↻")

    def reactions(self) -> View | None:
        """Length on its force plan, magnitude and direction of every reaction, and a slider's arm, if any force
        acts."""
        if self.idle:
            return None
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
        return self.table("reactions", "reactions_table", head, rows, [convention])

    def edges(self) -> View | None:
        """The forces at both edges of a slider's face, where its length is given."""
        rows = [
            [self.naming.vector(f.quantity.name), self.number(f.number)] for f in self.position.of("edges").values()
        ]
        return self.table("edges", "of_edges", ["", self.say("N")], rows)

    def friction(self) -> View | None:
        """The normal force, the friction and its power in every pair; in a hinge the couple of friction."""
        rubbing = self.position.of("friction").values()
        rows = [
            [self.naming.vector(f.quantity.name), self.number(f.number), self.say(f.quantity.columns[0].unit)]
            for f in rubbing
            if f.number
        ]
        return self.table("friction", "friction_table", ["", "", ""], rows)

    @property
    def idle(self) -> bool:
        """Whether the mechanism has no loads: all reactions are zero."""
        return all(self.number(abs(r.vector)) == "0" for r in self.position.of("reactions").values())

    def lengths(self) -> dict[str, float]:
        """The length of each reaction on the force plan that shows it, or its opposite, mm."""
        plotted, lengths = of_position(self.position), dict[str, float]()
        for s in plotted.segments:
            if kind_of(s.plan) == "force" and plotted.has(s.plan, s.start, s.end):
                mm = plotted.long(s.plan, s)
                for key, reaction in self.position.plans.reactions.items():
                    if s.name in (key, force_name(reaction.pair.other, reaction.pair.link)):
                        lengths.setdefault(key, mm)
        return lengths

    def check(self) -> View | None:
        """The balancing moment (or force), Zhukovsky's, and the difference in per cent, if any force acts."""
        p, rows = self.position, []
        for what, unit in () if self.idle else (("moment", "N·m"), ("force", "N")):
            balancing, check = p.number(f"balancing_{what}"), p.number(f"zhukovsky_{what}")
            head = f"{self.naming.balancing(what == 'moment')}, {self.say(unit)}"
            ways = ("by_force_plan", balancing), ("zhukovsky", check)
            rows += [[self.say(key), head, self.number(value)] for key, value in ways if value is not None]
            if balancing is not None and check is not None:
                apart = 100 * difference(balancing, check)
                rows.append(
                    [self.say("difference_percent"), "", number(apart if apart > 1e-6 else 0.0, self.naming.lang, 2)]
                )
        return self.table("check", "check_table", ["", "", ""], rows)
