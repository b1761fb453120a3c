"""The papers for student and teacher, as blocks of a note: the task, the answers. A scheme that must not give the
answer away is drawn in a clear position, not in the one asked for."""

import math
import re
from collections.abc import Iterator, Sequence
from itertools import combinations

from planes.drafting.drawing import Drawing
from planes.lesson.conditions import condition_sentences
from planes.lesson.formulas import unit_of_name
from planes.lesson.stated_note import position_note
from planes.plans import Plans
from planes.plans.measuring import plan_name_in_words, scene_lettering
from planes.plans.scales import drawn_in_si
from planes.plans.statements.of_scene import names_to_find
from planes.scene import Scene
from planes.scene.vector_amounts import VectorAmount
from planes.scene.vectors import AlongVector, Statement
from planes.solving import Position, drive_position_in_words
from planes.solving.document import Block, Blocks, DocumentTable, DrawnViews, Figure, Heading, Paragraph
from planes.solving.given import GivenTable
from planes.words import Lang, Phrase, say, with_decimal_sign
from planes.words.errors import PlanFailure, SceneError
from planes.words.lettering import parameter_lettering, without_index_markup
from planes.words.names import POLE_LABEL, PlanId
from planes.words.naming import Naming
from planes.words.units import Convention, mu_text, number_text, unit_of_parameter

_NAME_PATTERN = re.compile(r"[^\W\d]\w*(?:\^(?!\d)\w+)?(?!\w*\()")
ZERO_SEGMENT_MM = 1e-6  # a segment shorter than this is zero
GIVEN_NUMBERS_PER_LINE = 4  # numbers per line
LONGEST_NARROW_CELL = 26  # longest name in such a line
_WORK_KEYS = ("structure", "position", "velocity", "acceleration", "force", "lever")


def task_sheet_blocks(
    scene: Scene, drawn: Position, shown: Position, heads: Sequence[str], lang: Lang, plans: Sequence[str] = ()
) -> Blocks:
    """The sheet of a task: whose it is (``heads``), the scheme as ``shown``, the numbers, the loads, what is to do:
    the ``plans`` asked for, all if none is."""
    yield Heading(heads[0], 0)
    yield from (Paragraph(line) for line in heads[1:] if line)
    opened = (("studio",),) if scene.sheet.get("studio") else ()
    if drawn.plans.has_mechanism:
        yield Figure(DrawnViews(scene, shown, (("scheme",), *opened)), say("task_scheme", lang))
    yield given_data_block(scene, drawn, lang)
    if not drawn.plans.has_mechanism:
        yield from stated_equation_blocks(scene, drawn, lang)
        yield from (Figure(DrawnViews(scene, drawn, (one,)), "") for one in opened)
        return
    if said := conditions_in_words(scene, drawn, lang):
        yield Heading(say("task_conditions", lang))
        yield Paragraph(said)
    yield Heading(say("task_todo", lang))
    yield from (Paragraph(line, number=k) for k, line in enumerate(work_sentences(scene, drawn, lang, plans), 1))


def given_data_block(scene: Scene, drawn: Position, lang: Lang) -> Block:
    """The data as on the sheet, as many per line as there is room for."""
    cells = list(given_data_table(scene, drawn, lang).given_rows())
    across = GIVEN_NUMBERS_PER_LINE if max(len(cell) for row in cells for cell in row) <= LONGEST_NARROW_CELL else 2
    high = -(-len(cells) // across)
    cells += [("", "", "")] * (across * high - len(cells))
    rows = (tuple(c for k in range(across) for c in cells[row + k * high]) for row in range(high))
    head = tuple(say(k, lang) for k in ("task_quantity", "task_value", "task_unit"))
    return DocumentTable(say("task_given", lang), (head * across, *rows))


def given_data_table(scene: Scene, drawn: Position, lang: Lang, steady: bool = False) -> GivenTable:
    """The data of a scene for its questions. :class:`SceneError` where two numbers would have one name."""
    table = GivenTable(drawn, Naming(lang, **scene_lettering(scene, drawn.plans)), scene.used, steady)
    seen: dict[str, float] = {}
    for row in table.listed_givens():
        for name in row.name.split(" = "):
            if (other := seen.setdefault(name, row.value)) != row.value:
                raise repeated_name_error(scene, name, number_text(other, lang, 6), number_text(row.value, lang, 6))
    return table


def repeated_name_error(scene: Scene, name: str, one: str, other: str) -> SceneError:
    """The error that a name is a parameter's, and a user's for another number too."""
    own = next((p for p in scene.used if parameter_lettering(p) == name), without_index_markup(name))
    why = Phrase("given_twice", name=own, one=one, other=other)
    return SceneError(why, scene.file, scene.where.get(("parameters", own)))


def conditions_in_words(scene: Scene, drawn: Position, lang: Lang) -> str:
    """The data in words: conditions; for stated vectors, lengths and directions that depend on others."""
    if scene.statement is None:
        return " ".join(condition_sentences(drawn.plans, lang))
    near = ((name, v.near_deg) for name, v in scene.statement.vectors.items() if v.near_deg is not None)
    said = [say("task_near_way", lang, name=name, angle=number_text(angle, lang, 6)) for name, angle in near]
    amounts = "; ".join(amount_formulas(scene.statement))
    return " ".join([*([say("task_amounts", lang, amounts=amounts)] if amounts else []), *said])


def stated_equation_blocks(scene: Scene, drawn: Position, lang: Lang) -> Blocks:
    """The equations of stated vectors, or bodies with their supports and loads, and the results to find."""
    of_bodies = drawn.plans.figure is not None
    names = [f"asked {plan}" for plan in dict.fromkeys(e.plan for e in drawn.plans.equations)]
    for name in ["structure"] if of_bodies else names:
        yield Figure(DrawnViews(scene, drawn, ((name,),)), "")
    if amounts := conditions_in_words(scene, drawn, lang):
        yield Paragraph(amounts)
    yield Heading(say("task_todo", lang))
    sought = tuple(f"⟨{name}⟩" for name in position_note(scene, drawn, lang).wanted_results())
    said = [say("task_statics" if of_bodies else "task_stated", lang), say("task_find", lang, names=sought)]
    yield from (Paragraph(line, number=k) for k, line in enumerate(said, 1))


def amount_formulas(statement: Statement) -> Iterator[str]:
    """The formulas of lengths, directions that depend on other vectors, and the values."""
    for name, v in statement.vectors.items():
        if isinstance(v.value, VectorAmount):
            yield f"⟨{name}⟩ = {amount_text(v.value)}"
        if isinstance(v.direction, AlongVector):
            way = v.direction
            sign = "∥" if way.quarter % 2 == 0 else "⊥"
            yield f"⟨{name}⟩ {sign} ⟨{way.vector}⟩"
    for name, value in statement.values.items():
        if isinstance(value, VectorAmount):
            yield f"⟨{name}⟩ = {amount_text(value)}"


def amount_text(amount: VectorAmount) -> str:
    """An amount as stated, its names lettered."""
    return _NAME_PATTERN.sub(lambda m: f"⟨{m[0]}⟩", amount.text).replace("*", "·")


def parameter_unit(name: str, lang: Lang) -> str:
    """The unit of a parameter, as far as its name shows it."""
    key = unit_of_parameter(name)
    return say(key, lang) if key else ""


def work_sentences(scene: Scene, drawn: Position, lang: Lang, asked: Sequence[str]) -> Iterator[str]:
    """What is to be done, as far as it is ``asked`` (all, if nothing is) and the mechanism asks for it."""
    plans = {name.kind for name in drawn.plans.plan_names} | {"structure"}
    m = drawn.plans.mechanism
    drive = drawn.plans.drive
    value = with_decimal_sign(drive_position_in_words(drawn.at, drive.kind, lang), lang)
    value = f"⟨{'phi' if drive.rotates else 's'}_{drive.link}⟩ = {value}"
    for key in _WORK_KEYS:
        due = not asked or key in ("structure", "position") or ("force" if key == "lever" else key) in asked
        if due and key in plans and (m.loaded or key not in ("force", "lever")):
            yield say("task_force_plan" if key == "force" else f"task_{key}", lang, drive=value)
    if scene.find:
        yield say("task_find", lang, names=tuple(f"⟨{name}⟩" for name in names_to_find(scene)))


def answer_key_blocks(scene: Scene, drawn: Position, heads: Sequence[str], lang: Lang) -> Blocks:
    """The key: the numbers, the measurements on every plan, the results."""
    yield Heading(say("key_title", lang, title=heads[0]), 0)
    yield from (Paragraph(line) for line in heads[1:] if line)
    yield given_data_block(scene, drawn, lang)
    note = position_note(scene, drawn, lang)
    yield from note.answer_blocks()
    if drawn.plans.zhukovsky in drawn.drawing:
        yield from note.balancing_comparison()
    yield Heading(say("key_plans", lang))
    for name in drawn.results.get("plans", ()):
        if name != "position" and (table := segment_table(drawn, name, lang, scene.mu_convention)):
            yield table
    if drawn.drawing.crossing_sharpness:  # the bluntest crossing, for the marker of the drawing
        least = min(drawn.drawing.crossing_sharpness.values())
        angle = math.degrees(math.asin(max(0.0, min(1.0, least))))
        yield Paragraph(say("key_sharpness", lang, angle=number_text(angle, lang, 3)))


def segment_table(drawn: Position, name: PlanId, lang: Lang, convention: Convention) -> DocumentTable | None:
    """The segments of one plan: name, ends, millimetres, value."""
    rows = []
    kind = name.kind
    pole = Naming(lang).mark(POLE_LABEL, kind)
    for vector, s, segment in drawn.measured_on(name):
        rows.append(
            (
                f"⟨{vector}⟩",
                f"⟨{pole if s.start == POLE_LABEL else s.start}⟩⟨{pole if s.end == POLE_LABEL else s.end}⟩",
                with_decimal_sign(f"{segment['mm']:.1f}", lang),
                number_text(segment["value"] if segment["mm"] > ZERO_SEGMENT_MM else 0.0, lang),
            )
        )
    size = unit_of_name({"velocity": "v", "acceleration": "a"}.get(name, "F")).told(lang)
    head = (say("key_vector", lang), say("segment", lang), say("mm", lang), size)
    mu = with_decimal_sign(mu_text(drawn.scales[name.mu_name], kind, lang, convention), lang)
    if rows:
        return DocumentTable(f"{plan_name_in_words(name, lang)}, μ = {mu}", (head, *rows))
    return None


TRIED_ANGLE_STEP_DEG = 15
LEAST_ANGLE_APART_DEG = 30.0
CLEAR_DISTANCE_RATIO = 4.0  # points a quarter of the mechanism apart are as clear as links at a right angle


def clearest_driver_angle(plans: Plans, value: float) -> float:
    """The driver's angle (degrees), well away from ``value``, at which points and links are most distinct.

    A sliding driver stays where it is.
    """
    if not plans.has_mechanism or not plans.drive.rotates:
        return value
    scores = dict(_clarity_by_position(plans, value))
    return max(scores, key=lambda v: round(scores[v], 3), default=value)


def _clarity_by_position(plans: Plans, value: float) -> Iterator[tuple[float, float]]:
    """Every position that can be drawn, and its clarity, from 0 to 1."""
    for phi in range(0, 360, TRIED_ANGLE_STEP_DEG):
        if abs((phi - value + 180) % 360 - 180) >= LEAST_ANGLE_APART_DEG:
            try:
                drawing = drawn_in_si(plans, float(phi))
            except PlanFailure:
                continue
            yield float(phi), min(_nearest_hinges_distance(plans, drawing), _least_link_angle_sine(plans, drawing))


def _nearest_hinges_distance(plans: Plans, drawing: Drawing) -> float:
    """The distance of the two nearest hinges, relative to the whole."""
    hinges = dict.fromkeys(pair.point for pair in plans.structure.pairs if pair.kind == "R")
    spots = [complex(drawing[plans.points[name].position]) for name in hinges]
    gaps = [abs(a - b) for a, b in combinations(spots, 2)]
    gaps = [gap for gap in gaps if gap > 1e-6 * max(gaps)]
    return CLEAR_DISTANCE_RATIO * min(gaps) / max(gaps) if gaps else 1.0


def _least_link_angle_sine(plans: Plans, drawing: Drawing) -> float:
    """The sine of the least angle between two links joined by a hinge."""
    sines = [1.0]
    for pair in plans.structure.pairs:
        one, two = (plans.links[name].angle for name in (pair.link, pair.other))
        if one and two and pair.kind == "R":
            sines.append(abs(math.sin(math.radians(drawing[one] - drawing[two]))))
    return min(sines)
