"""Tables of given and found values."""

import cmath
import math
import re
from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from itertools import zip_longest

from planes.lesson.transfers import TransferFunctions
from planes.plans.force.loads import name_of_force
from planes.plans.structures.figure import Strain, member_strains
from planes.scene.vector_equations import VectorEquations
from planes.solving import Position
from planes.solving.given import GivenTable
from planes.solving.own_equations import own_equation_rows
from planes.solving.tables import relative_difference
from planes.solving.text_tables import ZERO_RESULT_RATIO, largest_equilibrium_result
from planes.words import say
from planes.words.frozen import field, frozen
from planes.words.names import ACCELERATION_PLAN, CREMONA_PLAN, VELOCITY_PLAN, NumbersByName, PlanId, split_value_name
from planes.words.naming import Naming
from planes.words.read_off import fixed_decimals_text, read_off_text
from planes.words.units import UNITS_OF_PLACE_AND_RATES, number_text
from render.views import View, make_view, remark_texts
from render.views.formulas import ROUNDING_NOISE_MM
from render.views.plotted import plot_position
from render.views.table_grid import Row, TableGrid, fold_long_table

Tabled = View | None  # none where a table would be empty
VECTOR_NAME_PATTERN = re.compile(r"[^\W\d]+_\w+(?:\^[ntkr])?")


@frozen
class Tables:
    """The tables of a position."""

    position: Position
    naming: Naming
    letter: float = 3.5
    parameters: NumbersByName = field(default_factory=dict)
    once: Callable[[tuple[object, ...], Callable[[], View]], Tabled] = lambda key, make: make()
    own: tuple[VectorEquations, str] = ((), "")  # the user's equations, and their file

    def vectors_table(self) -> Tabled:
        """Length on its plan, magnitude and direction of every vector in a scene of vectors."""
        mu = plot_position(self.position).plan_mu
        rows = []
        for f in self.position.of("vectors").values():
            mm = abs(f.vector) * mu(f.quantity.columns[0].start.plan)
            angle = self.tenths_text(math.degrees(cmath.phase(f.vector))) if mm > ROUNDING_NOISE_MM else "—"
            unit = self.sheet_word(f.unit)
            rows.append(
                [
                    self.naming.lettered_vector(f.quantity.name),
                    self.tenths_text(mm),
                    self.result_text(abs(f.vector)),
                    unit,
                    angle,
                ]
            )
        return self.table_view(
            "vectors-table", "measured", ["", self.sheet_word("mm"), "", "", self.sheet_word("angle")], rows
        )

    def values_table(self) -> Tabled:
        """The values computed from the vectors."""
        noise = ZERO_RESULT_RATIO * largest_equilibrium_result(self.position)
        rows = []
        for f in (f for n, f in self.position.of("values").items() if n not in self.member_states):
            tell = self.turning if f.unit in UNITS_OF_PLACE_AND_RATES[False] else self.result_text
            value = f.number if abs(f.number) > noise else 0.0
            rows.append([self.naming.lettered_vector(f.quantity.name), tell(value), f.unit and self.sheet_word(f.unit)])
        return self.table_view("values", "values_found", ["", "", ""], rows)

    @cached_property
    def member_states(self) -> dict[str, Strain]:
        """The state of every member of a truss, tension or compression, by the name of its force."""
        return member_strains(self.position.plans.figure, self.position.drawing)

    def members_table(self) -> Tabled:
        """Length on the plan, force and state of every member of a truss."""
        values = self.position.of("values")
        rows = []
        mu = plot_position(self.position).plan_mu
        for name, strain in self.member_states.items():
            force = values[name].number if name in values and strain != "idle" else 0.0
            mm = self.tenths_text(abs(force) * mu(CREMONA_PLAN))
            rows.append(
                [self.naming.lettered_vector(name), mm, self.result_text(force), self.sheet_word(f"strain_{strain}")]
            )
        head = ["", self.sheet_word("mm"), self.sheet_word("N"), ""]
        counted = [x.told(self.naming.lang) for x in figure.counted] if (figure := self.position.plans.figure) else []
        return self.table_view("members", "members_table", head, rows, counted)

    def sheet_word(self, key: str) -> str:
        """A word of the sheet."""
        return say(key, self.naming.lang)

    def result_text(self, value: float | None) -> str:
        """A result of the sheet."""
        return read_off_text(value, self.naming.lang)

    def tenths_text(self, value: float) -> str:
        """Millimetres, or degrees."""
        return fixed_decimals_text(value, 1, self.naming.lang)

    def table_view(
        self, key: str, title: str, head: Row, rows: Sequence[Row], notes: Sequence[str] = (), spanned: bool = False
    ) -> Tabled:
        """A table as a view, or None without rows; its ``title`` by the word; ``notes`` are beneath it."""
        if not rows:
            return None
        head, rows = fold_long_table(head, rows)

        def make() -> View:
            marks = TableGrid(self.letter, spanned).drawn_marks(head, rows)
            for note in notes:
                marks = (*marks, *remark_texts(note, marks))
            return make_view(key, self.sheet_word(title), marks)

        return self.once(("table", key, self.letter, *map(tuple, rows)), make)

    def all_tables(self, joined: bool = True) -> list[View]:
        """Every table with contents; the measurements on both motion plans ``joined`` in one."""
        if not self.position.plans.has_mechanism:
            return [
                t for t in (self.given_table(), self.vectors_table(), self.members_table(), self.values_table()) if t
            ]
        tables = (
            self.given_table(),
            *self.rate_tables(joined),
            self.links(),
            *self.force_tables(),
            self.equations_table(),
        )
        return [t for t in tables if t]

    def force_tables(self) -> tuple[Tabled, ...]:
        """The tables of the force calculation."""
        return self.reactions_table(), self.edges_table(), self.friction_table(), self.check_table()

    def equations_table(self) -> Tabled:
        """The user's equations: the result of each, or whether it closes and what would close it."""
        p = self.position
        told_rows = own_equation_rows(p, self.own, self.naming.lang)
        rows = [
            [VECTOR_NAME_PATTERN.sub(lambda m: self.naming.lettered_vector(m[0]), text) for text in row]
            for row in told_rows
        ]
        return self.table_view("own-equations", "own_equations", ["", ""], rows)

    def given_table(self) -> Tabled:
        """The data of the scene, each item once."""
        given = GivenTable(self.position, self.naming, self.parameters)
        return self.table_view(
            "given",
            "given",
            ["", "", ""],
            [*given.given_rows(), *given.load_law_rows()],
            list(given.load_law_formulas()),
        )

    def plan(self, plan: PlanId) -> Tabled:
        """The measurements on a plan: vector, segment, mm, value."""
        rows = [row for _, row in self.measurement_rows(plan)]
        return self.table_view(f"{plan}-table", f"by_{plan}", self.measurement_head(plan), rows)

    def rate_tables(self, joined: bool) -> list[Tabled]:
        """The measurements on the velocity and acceleration plans: a table each, or ``joined`` with the vectors of one
        point, or of one link, side by side."""
        plans = [plan for plan in (VELOCITY_PLAN, ACCELERATION_PLAN) if any(self.measurement_rows(plan))]
        if not joined or len(plans) < 2:
            return [self.plan(plan) for plan in plans]
        by_owner: dict[str, tuple[list[Row], ...]] = {}
        for k, plan in reversed([*enumerate(plans)]):  # in the order of the accelerations
            for owner, row in self.measurement_rows(plan):
                by_owner.setdefault(owner, ([], []))[k].append(row)
        sides = (tuple(rows or [[" "] * 4] for rows in both) for both in by_owner.values())
        pairs = (two for both in sides for two in zip_longest(*both, fillvalue=[""] * 4))
        head = [cell for plan in plans for cell in self.measurement_head(plan)]
        rows = [[*one, *other] for one, other in pairs]
        return [self.table_view("rates-table", "by_plans", head, rows, spanned=True)]

    def measurement_head(self, plan: PlanId) -> Row:
        """The head over the measurements on a plan."""
        return ["", "", self.sheet_word("mm"), self.sheet_word(plan.unit)]

    def measurement_rows(self, plan: PlanId) -> Iterator[tuple[str, Row]]:
        """The measurements on a plan, with the owner of each vector: a point, two points of a link, a guide."""
        known = self.position.results.get("plans", {}).get(plan, {"segments": {}})["segments"]
        if max((s["mm"] for s in known.values()), default=0.0) <= ROUNDING_NOISE_MM:
            return
        for vector, segment, measures in self.position.measured_on(plan):
            ends = self.naming.mark(segment.start, plan) + self.naming.mark(segment.end, plan)
            value = self.result_text(measures["value"] if measures["mm"] > ROUNDING_NOISE_MM else 0.0)
            yield (
                split_value_name(vector)[1],
                [self.naming.lettered_vector(vector), ends, self.tenths_text(measures["mm"]), value],
            )

    def links(self) -> Tabled:
        """ω and ε of every link with their senses; empty if the driver is at rest."""
        rows = []
        links = self.position.rows("links")
        for name in self.position.plans.mechanism.links:
            if name in links and not self.position.plans.at_rest:
                cells = [self.turning(links[name][k].number) if k in links[name] else "" for k in ("omega", "epsilon")]
                if any(cells):
                    rows.append([self.naming.link_number(name), *cells])
        head = [self.sheet_word("column_link"), f"ω, {self.sheet_word('rad/s')}", f"ε, {self.sheet_word('rad/s²')}"]
        return self.table_view("links", "links_table", head, rows)

    def transfers_table(self) -> Tabled:
        """Transfer functions by segments of the velocity plan."""
        rows = list(TransferFunctions(self.position, self.naming).transfer_rows())
        return self.table_view("transfers", "of_transfers", ["", "", "", ""], rows)

    def turning(self, value: float) -> str:
        """A signed value and the curved arrow of its sense."""
        shown = self.result_text(value)
        if shown == "0":
            return shown
        return shown + ("↺" if value > 0 else "↻")

    def reactions_table(self) -> Tabled:
        """Length on its force plan, magnitude and direction of every reaction, and a slider's arm, if any force
        acts."""
        if self.is_unloaded:
            return None
        rows = []
        armed = False
        lengths = self.reaction_lengths_mm()
        for name, r in self.position.of("reactions").items():
            mm = self.tenths_text(lengths[name]) if name in lengths else "—"
            angle = self.tenths_text(math.degrees(cmath.phase(r.vector))) if r.vector else "—"
            arm = self.result_text(r.arm) if r.slides else ""
            armed |= arm not in ("", "0")
            rows.append([self.naming.lettered_vector(name), mm, self.result_text(abs(r.vector)), angle, arm])
        convention = self.sheet_word("from_on" if self.naming.from_on else "on_from")
        table = [
            ["", self.sheet_word("mm"), self.sheet_word("N"), self.sheet_word("angle"), self.sheet_word("column_arm")],
            *rows,
        ]
        head, *rows = [row[: 5 if armed else 4] for row in table]
        return self.table_view("reactions", "reactions_table", head, rows, [convention])

    def edges_table(self) -> Tabled:
        """The forces at both edges of a slider's face, where its length is given."""
        rows = [
            [self.naming.lettered_vector(f.quantity.name), self.result_text(f.number)]
            for f in self.position.of("edges").values()
        ]
        return self.table_view("edges", "of_edges", ["", self.sheet_word("N")], rows)

    def friction_table(self) -> Tabled:
        """The normal force, the friction and its power in every pair; in a hinge the couple of friction."""
        rubbing = self.position.of("friction").values()
        rows = [
            [
                self.naming.lettered_vector(f.quantity.name),
                self.result_text(f.number),
                self.sheet_word(f.quantity.columns[0].unit),
            ]
            for f in rubbing
            if f.number
        ]
        return self.table_view("friction", "friction_table", ["", "", ""], rows)

    @property
    def is_unloaded(self) -> bool:
        """Whether the mechanism has no loads: all reactions are zero."""
        return all(self.result_text(abs(r.vector)) == "0" for r in self.position.of("reactions").values())

    def reaction_lengths_mm(self) -> NumbersByName:
        """The length of each reaction on the force plan that shows it, or its opposite, mm."""
        plotted = plot_position(self.position)
        lengths = dict[str, float]()
        for s in plotted.segments:
            if s.plan.is_force and plotted.has_marks(s.plan, s.start, s.end):
                mm = plotted.vector_length_mm(s.plan, s)
                for key, reaction in self.position.plans.reactions.items():
                    if s.name in (key, name_of_force(reaction.pair.other, reaction.pair.link)):
                        lengths.setdefault(key, mm)
        return lengths

    def check_table(self) -> Tabled:
        """The balancing moment (or force), Zhukovsky's, and the difference in per cent, if any force acts."""
        p = self.position
        rows = []
        for what, unit in () if self.is_unloaded else (("moment", "N·m"), ("force", "N")):
            balancing = p.number(f"balancing_{what}")
            check = p.number(f"zhukovsky_{what}")
            head = f"{self.naming.balancing_letter(what == 'moment')}, {self.sheet_word(unit)}"
            ways = ("by_force_plan", balancing), ("zhukovsky", check)
            rows += [[self.sheet_word(key), head, self.result_text(value)] for key, value in ways if value is not None]
            if balancing is not None and check is not None:
                apart = 100 * relative_difference(balancing, check)
                rows.append(
                    [
                        self.sheet_word("difference_percent"),
                        "",
                        number_text(apart if apart > 1e-6 else 0.0, self.naming.lang, 2),
                    ]
                )
        return self.table_view("check", "check_table", ["", "", ""], rows)
