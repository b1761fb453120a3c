"""The explanatory note: the frames of a lesson as prose, with tables and places for figures, in the usual order.

A note is a list of blocks; names of vectors and values stand in ⟨…⟩. How it looks, and the figures, are not its matter.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import groupby
from typing import Any

from planes.lesson import Frame, Teller, mu_said, value_of
from planes.lesson.formulas import fill, number, unit
from planes.plans.measuring import say_plan
from planes.scene import Scene
from planes.scene.mechanism import FRAME
from planes.solving import Position, told
from planes.words import Lang
from planes.words.names import kind_of, links_of, mu_of
from planes.words.note import note_said

NOISE = 1e-12


@dataclass(frozen=True)
class Heading:
    """A heading; level 0 is the note's own title."""

    text: str
    level: int = 1


@dataclass(frozen=True)
class Prose:
    """A paragraph; ``why`` is set apart as the reason of what it says; ``plan`` is where its marks stand."""

    text: str
    why: str = ""
    number: int = 0
    plan: str = ""


@dataclass(frozen=True)
class Figure:
    """A place for a figure: "scheme", a plan, or "equations …" of a plan."""

    key: str
    caption: str = ""


@dataclass(frozen=True)
class Table:
    """A table with its caption; the first row is the head."""

    caption: str
    rows: tuple[tuple[str, ...], ...]


Block = Heading | Prose | Figure | Table


@dataclass
class Note:
    """Writes the note of one position of a scene."""

    scene: Scene
    position: Position
    lang: Lang

    def __post_init__(self) -> None:
        self.teller = Teller(self.position.plans, self.position.drawing, self.position.scales)
        self.frames = self.teller.frames()
        self.tables = self.figures = 0
        self.given: set[str] = set()  # reasons given already

    def blocks(self) -> list[Block]:
        """The whole note."""
        return [*self.opening(), *self.structure(), *self.plans(), *self.results()]

    def say(self, key: str, **names: object) -> str:
        return note_said(key, self.lang, **names)

    def table(self, key: str, head: tuple[str, ...], rows: Sequence[tuple[str, ...]]) -> Iterator[Block]:
        """A numbered table, unless it is empty."""
        if rows:
            self.tables += 1
            yield Table(self.say("note_table", number=self.tables, title=self.say(key)), (head, *rows))

    def figure(self, key: str, title: str) -> Figure:
        self.figures += 1
        return Figure(key, self.say("note_figure", number=self.figures, title=title))

    def opening(self) -> Iterator[Block]:
        """Title, task and given numbers."""
        plans, drive = self.position.plans, self.position.plans.mechanism.drive
        title = self.scene.title.get(self.lang) or next(iter(self.scene.title.values()), "")
        yield Heading(f"{self.say('note')}. {title}" if title else self.say("note"), 0)
        yield Heading(self.say("note_given"))
        where = told(self.position.at, drive.kind, self.lang)
        where = f"{'φ' if drive.kind == 'phi' else 's'} = {where.replace('.', ',') if self.lang == 'ru' else where}"
        yield Prose(self.say("note_task", title=title, drive=where))
        rows = []
        for name, size in plans.given.items():
            letter = name.partition("_")[0]
            shown = letter in ("l", "e", "m", "J", "g", "omega", "epsilon", "f") or name.endswith("_given")
            if shown and not isinstance(size, complex) and "°" not in name:
                rows.append((f"⟨{name}⟩", number(float(size), self.lang), unit(name, self.lang)))
        head = (self.say("quantity"), self.say("value"), self.say("unit"))
        yield from self.table("note_given_table", head, rows)

    def structure(self) -> Iterator[Block]:
        """Degree of freedom, groups, formula."""
        s, m = self.position.plans.structure, self.position.plans.mechanism
        yield Heading(self.say("note_structure"))
        yield Prose(self.say("note_freedom", n=len(m.links), p=len(s.pairs), W=s.W, q=s.q))
        for g in s.groups:
            yield Prose(self.say("note_group_kind", links=", ".join(g.links), kind=g.kind, name=g.name))
        yield Prose(self.say("note_formula", formula=s.formula.replace("->", "→")))

    def plans(self) -> Iterator[Block]:
        """Every plan with its equations, its steps in words, and its figure."""
        seen = 0
        for plan, frames in groupby(self.placed(), key=lambda pair: pair[0]):
            held = [f for _, f in frames]
            yield Heading(self.heading(plan))
            if plan not in ("position", "lever"):
                yield Figure(f"equations {plan}")
            for frame in held:
                seen += 1
                yield self.prose(frame, seen)
            if plan != "lever":
                yield self.figure("scheme" if plan == "position" else plan, self.caption(plan))
            else:
                yield from self.compared()
        if not any(kind_of(f.plan) == "force" for f in self.frames):
            yield Prose(self.say("note_no_forces"))

    def placed(self) -> list[tuple[str, Frame]]:
        """Frames with the plan they are told under: a moment equation under the plan it serves."""
        found, here = [], "position"
        for frame in self.frames:
            here = here if frame.moments is not None and frame.plan == "position" else frame.plan
            found.append((here, frame))
        return found

    def heading(self, plan: str) -> str:
        if kind_of(plan) != "force":
            return self.say(f"note_{plan}")
        links = links_of(plan)
        return self.say("note_group" if len(links) > 1 else "note_driver", links=", ".join(links))

    def caption(self, plan: str) -> str:
        mu = mu_said(self.position.scales[mu_of(plan)], kind_of(plan), self.lang)
        if plan == "position":
            return self.say("note_scheme", mu=mu)
        return self.say("note_plan", plan=say_plan(plan, self.lang), mu=mu)

    def prose(self, frame: Frame, index: int) -> Prose:
        """A frame as a paragraph."""
        read = lambda name: float(value_of(name, self.teller, self.position.drawing))  # noqa: E731
        why = frame.why[self.lang] if frame.why[self.lang] not in self.given else ""
        self.given.add(why)
        return Prose(fill(frame.said[self.lang], read, self.lang), why, index, frame.plan)

    def compared(self) -> Iterator[Block]:
        """The balancing load two ways."""
        plans, drawing = self.position.plans, self.position.drawing
        found, check = float(drawing[plans.balancing]), float(drawing[plans.zhukovsky])
        largest = max(abs(found), abs(check))
        percent = 100 * abs(found - check) / largest if largest else 0.0
        names = {"found": number(found, self.lang), "check": number(check, self.lang)}
        shown = number(percent if percent > 1e-6 else 0.0, self.lang, 2)
        yield Prose(self.say("note_difference", **names, unit=unit(plans.balancing, self.lang), percent=shown))

    def results(self) -> Iterator[Block]:
        """Tables of what was found, and what must be known of it."""
        r = self.position.results
        yield Heading(self.say("note_results"))
        v, a, w, e, n = (unit(x, self.lang) for x in ("v", "a", "omega", "epsilon", "F"))
        angle = self.say("angle")
        head: tuple[str, ...] = (self.say("point"), f"v, {v}", angle, f"a, {a}", angle)
        rows = [(f"⟨{p}⟩", *self.vector(x.get("v")), *self.vector(x.get("a"))) for p, x in r.get("points", {}).items()]
        yield from self.table("note_points_table", head, rows)
        head = (self.say("link"), f"ω, {w}", f"ε, {e}")
        shown = [(k, *(self.number(x.get(i)) for i in ("omega", "epsilon"))) for k, x in r.get("links", {}).items()]
        yield from self.table("note_links_table", head, [row for row in shown if row[0] != FRAME])
        forces = [(k, x["force"] if isinstance(x, dict) else x) for k, x in r.get("reactions", {}).items()]
        if any(any(abs(c) > NOISE for c in f) for _, f in forces):
            head = (self.say("reaction"), f"|F|, {n}", angle)
            yield from self.table("note_reactions_table", head, [(f"⟨{k}⟩", *self.vector(f)) for k, f in forces])
        for warning in r.get("warnings", []):
            yield Prose(self.say("note_warning", text=warning.rstrip(".")))

    def vector(self, xy: Any) -> tuple[str, str]:
        """Size and direction."""
        if xy is None:
            return "—", "—"
        z = complex(*xy)
        if abs(z) <= 1e-9:
            return "0", "—"
        return number(abs(z), self.lang), number(round(math.degrees(cmath.phase(z)), 1), self.lang)

    def number(self, size: float | None) -> str:
        return "—" if size is None else number(0.0 if abs(size) <= 1e-9 else size, self.lang)
