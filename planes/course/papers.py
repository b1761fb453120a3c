"""The papers for student and teacher, as blocks of a note: the task, the answers. A scheme that must not give the
answer away is drawn in a clear position, not in the one asked for."""

import math
import re
from collections.abc import Iterator, Sequence
from itertools import combinations

from planes.drafting.drawing import Drawing
from planes.lesson.conditions import conditions
from planes.lesson.formulas import unit
from planes.lesson.stated_note import note_of
from planes.plans import Plans
from planes.plans.measuring import lettering, say_plan
from planes.plans.scales import drawn_in_si
from planes.plans.statements.of_scene import found_of
from planes.scene import Scene
from planes.scene.vector_amounts import VectorAmount
from planes.scene.vectors import AlongVector, Statement
from planes.solving import Position, told
from planes.solving.document import Block, DocumentTable, DrawnViews, Figure, Heading, Paragraph
from planes.solving.given import GivenTable
from planes.words import Lang, Phrase, decimal, say
from planes.words.errors import PlanFailure, SceneError
from planes.words.lettering import flat, greek
from planes.words.names import POLE, kind_of, mu_of
from planes.words.naming import Naming
from planes.words.units import Convention, mu_text, number, unit_of_parameter

_NAME = re.compile(r"[^\W\d]\w*(?:\^(?!\d)\w+)?(?!\w*\()")
NOISE_MM = 1e-6  # a segment shorter than this is zero
ACROSS, NARROW = 4, 26  # numbers per line; longest name in such a line
_WORK = ("structure", "position", "velocity", "acceleration", "force", "lever")


def task(
    scene: Scene, drawn: Position, shown: Position, heads: Sequence[str], lang: Lang, plans: Sequence[str] = ()
) -> Iterator[Block]:
    """The sheet of a task: whose it is (``heads``), the scheme as ``shown``, the numbers, the loads, what is to do:
    the ``plans`` asked for, all if none is."""
    yield Heading(heads[0], 0)
    yield from (Paragraph(line) for line in heads[1:] if line)
    opened = (("studio",),) if scene.sheet.get("studio") else ()
    if drawn.plans.moves:
        yield Figure(DrawnViews(scene, shown, (("scheme",), *opened)), say("task_scheme", lang))
    yield given(scene, drawn, lang)
    if not drawn.plans.moves:
        yield from stated(scene, drawn, lang)
        yield from (Figure(DrawnViews(scene, drawn, (one,)), "") for one in opened)
        return
    if said := said_of(scene, drawn, lang):
        yield Heading(say("task_conditions", lang))
        yield Paragraph(said)
    yield Heading(say("task_todo", lang))
    yield from (Paragraph(line, number=k) for k, line in enumerate(work(scene, drawn, lang, plans), 1))


def given(scene: Scene, drawn: Position, lang: Lang) -> Block:
    """The data as on the sheet, as many per line as there is room for."""
    cells: list[tuple[str, ...]] = list(given_of(scene, drawn, lang).rows())
    across = ACROSS if max(len(cell) for row in cells for cell in row) <= NARROW else 2
    high = -(-len(cells) // across)
    cells += [("", "", "")] * (across * high - len(cells))
    rows = (tuple(c for k in range(across) for c in cells[row + k * high]) for row in range(high))
    head = tuple(say(k, lang) for k in ("task_quantity", "task_value", "task_unit"))
    return DocumentTable(say("task_given", lang), (head * across, *rows))


def given_of(scene: Scene, drawn: Position, lang: Lang, steady: bool = False) -> GivenTable:
    """The data of a scene for its questions. :class:`SceneError` where two numbers would have one name."""
    table = GivenTable(drawn, Naming(lang, **lettering(scene, drawn.plans)), scene.used, steady)
    seen: dict[str, float] = {}
    for row in table.listed():
        for name in row.name.split(" = "):
            if (other := seen.setdefault(name, row.value)) != row.value:
                raise twice(scene, name, number(other, lang, 6), number(row.value, lang, 6))
    return table


def twice(scene: Scene, name: str, one: str, other: str) -> SceneError:
    """The error that a name is a parameter's, and a user's for another number too."""
    own = next((p for p in scene.used if greek(p) == name), flat(name))
    why = Phrase("given_twice", name=own, one=one, other=other)
    return SceneError(why, scene.file, scene.where.get(("parameters", own)))


def said_of(scene: Scene, drawn: Position, lang: Lang) -> str:
    """The data in words: conditions; for stated vectors, lengths and directions that depend on others."""
    if scene.statement is None:
        return " ".join(conditions(drawn.plans, lang))
    near = ((name, v.near_deg) for name, v in scene.statement.vectors.items() if v.near_deg is not None)
    said = [say("task_near_way", lang, name=name, angle=number(angle, lang, 6)) for name, angle in near]
    amounts = "; ".join(amounts_of(scene.statement))
    return " ".join([*([say("task_amounts", lang, amounts=amounts)] if amounts else []), *said])


def stated(scene: Scene, drawn: Position, lang: Lang) -> Iterator[Block]:
    """The equations of stated vectors, or bodies with their supports and loads, and the results to find."""
    of_bodies = drawn.plans.figure is not None
    names = [f"asked {plan}" for plan in dict.fromkeys(e.plan for e in drawn.plans.equations)]
    for name in ["structure"] if of_bodies else names:
        yield Figure(DrawnViews(scene, drawn, ((name,),)), "")
    if amounts := said_of(scene, drawn, lang):
        yield Paragraph(amounts)
    yield Heading(say("task_todo", lang))
    sought = tuple(f"⟨{name}⟩" for name in note_of(scene, drawn, lang).sought())
    said = [say("task_statics" if of_bodies else "task_stated", lang), say("task_find", lang, names=sought)]
    yield from (Paragraph(line, number=k) for k, line in enumerate(said, 1))


def amounts_of(statement: Statement) -> Iterator[str]:
    """The formulas of lengths, directions that depend on other vectors, and the values."""
    for name, v in statement.vectors.items():
        if isinstance(v.value, VectorAmount):
            yield f"⟨{name}⟩ = {amount_said(v.value)}"
        if isinstance(v.direction, AlongVector):
            way = v.direction
            sign = "∥" if way.quarter % 2 == 0 else "⊥"
            yield f"⟨{name}⟩ {sign} ⟨{way.vector}⟩"
    for name, value in statement.values.items():
        if isinstance(value, VectorAmount):
            yield f"⟨{name}⟩ = {amount_said(value)}"


def amount_said(amount: VectorAmount) -> str:
    """An amount as stated, its names lettered."""
    return _NAME.sub(lambda m: f"⟨{m[0]}⟩", amount.text).replace("*", "·")


def unit_of(name: str, lang: Lang) -> str:
    """The unit of a parameter, as far as its name shows it."""
    key = unit_of_parameter(name)
    return say(key, lang) if key else ""


def work(scene: Scene, drawn: Position, lang: Lang, asked: Sequence[str]) -> Iterator[str]:
    """What is to be done, as far as it is ``asked`` (all, if nothing is) and the mechanism asks for it."""
    plans = {kind_of(name) for name in drawn.plans.drawn} | {"structure"}
    m, drive = drawn.plans.mechanism, drawn.plans.drive
    value = decimal(told(drawn.at, drive.kind, lang), lang)
    value = f"⟨{'phi' if drive.rotates else 's'}_{drive.link}⟩ = {value}"
    for key in _WORK:
        due = not asked or key in ("structure", "position") or ("force" if key == "lever" else key) in asked
        if due and key in plans and (m.loaded or key not in ("force", "lever")):
            yield say("task_force_plan" if key == "force" else f"task_{key}", lang, drive=value)
    if scene.find:
        yield say("task_find", lang, names=tuple(f"⟨{name}⟩" for name in found_of(scene)))


def answers(scene: Scene, drawn: Position, heads: Sequence[str], lang: Lang) -> Iterator[Block]:
    """The key: the numbers, the measurements on every plan, the results."""
    yield Heading(say("key_title", lang, title=heads[0]), 0)
    yield from (Paragraph(line) for line in heads[1:] if line)
    yield given(scene, drawn, lang)
    note = note_of(scene, drawn, lang)
    yield from note.answers()
    if drawn.plans.zhukovsky in drawn.drawing:
        yield from note.compared()
    yield Heading(say("key_plans", lang))
    for name in drawn.results.get("plans", ()):
        if name != "position" and (table := segments(drawn, name, lang, scene.mu_convention)):
            yield table
    if drawn.drawing.sharpness:  # the bluntest crossing, for the marker of the drawing
        least = min(drawn.drawing.sharpness.values())
        angle = math.degrees(math.asin(max(0.0, min(1.0, least))))
        yield Paragraph(say("key_sharpness", lang, angle=number(angle, lang, 3)))


def segments(drawn: Position, name: str, lang: Lang, convention: Convention) -> DocumentTable | None:
    """The segments of one plan: name, ends, millimetres, value."""
    rows, kind = [], kind_of(name)
    pole = Naming(lang).mark(POLE, kind)
    for vector, s, segment in drawn.measured_on(name):
        rows.append(
            (
                f"⟨{vector}⟩",
                f"⟨{pole if s.start == POLE else s.start}⟩⟨{pole if s.end == POLE else s.end}⟩",
                decimal(f"{segment['mm']:.1f}", lang),
                number(segment["value"] if segment["mm"] > NOISE_MM else 0.0, lang),
            )
        )
    size = unit({"velocity": "v", "acceleration": "a"}.get(name, "F")).told(lang)
    head = (say("key_vector", lang), say("segment", lang), say("mm", lang), size)
    mu = decimal(mu_text(drawn.scales[mu_of(name)], kind, lang, convention), lang)
    return DocumentTable(f"{say_plan(name, lang)}, μ = {mu}", (head, *rows)) if rows else None


STEP_DEG, APART_DEG = 15, 30.0
FAR = 4.0  # points a quarter of the mechanism apart are as clear as links at a right angle


def clearest(plans: Plans, value: float) -> float:
    """The driver's angle (degrees), well away from ``value``, at which points and links are most distinct.

    A sliding driver stays where it is.
    """
    if not plans.moves or not plans.drive.rotates:
        return value
    scores = dict(_scores(plans, value))
    return max(scores, key=lambda v: round(scores[v], 3), default=value)


def _scores(plans: Plans, value: float) -> Iterator[tuple[float, float]]:
    """Every position that can be drawn, and its clarity, from 0 to 1."""
    for phi in range(0, 360, STEP_DEG):
        if abs((phi - value + 180) % 360 - 180) >= APART_DEG:
            try:
                drawing = drawn_in_si(plans, float(phi))
            except PlanFailure:
                continue
            yield float(phi), min(_points_apart(plans, drawing), _links_apart(plans, drawing))


def _points_apart(plans: Plans, drawing: Drawing) -> float:
    """The distance of the two nearest hinges, relative to the whole."""
    hinges = dict.fromkeys(pair.point for pair in plans.structure.pairs if pair.kind == "R")
    spots = [complex(drawing[plans.points[name].position]) for name in hinges]
    gaps = [abs(a - b) for a, b in combinations(spots, 2)]
    gaps = [gap for gap in gaps if gap > 1e-6 * max(gaps)]
    return FAR * min(gaps) / max(gaps) if gaps else 1.0


def _links_apart(plans: Plans, drawing: Drawing) -> float:
    """The sine of the least angle between two links joined by a hinge."""
    sines = [1.0]
    for pair in plans.structure.pairs:
        one, two = (plans.links[name].angle for name in (pair.link, pair.other))
        if one and two and pair.kind == "R":
            sines.append(abs(math.sin(math.radians(drawing[one] - drawing[two]))))
    return min(sines)
