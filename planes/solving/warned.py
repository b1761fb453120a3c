"""Warnings about the numbers of one position: blunt crossings, loads at standstill, lost digits."""

import math
from collections.abc import Iterator, Sequence

from planes.drafting.clearness import ZERO_FORCE_RATIO, has_wide_length_range, is_clear_drawing
from planes.drafting.tools import Things
from planes.plans.measuring import BLUNT_CROSSING_SINE, DrawingReader, plan_name_in_words
from planes.plans.quantities import Quantity, results_wanted
from planes.words import Lang, Written, say
from planes.words.frozen import replace
from planes.words.lettering import terminal_spelling
from planes.words.names import ACCELERATION_PLAN, VELOCITY_PLAN, name_index


def accuracy_warnings(reader: DrawingReader, wanted: Sequence[Quantity] | None, given: Things, lang: Lang) -> list[str]:
    """The sentences, grouped by kind."""
    blunt = _blunt_mark_warnings(reader, lang).items()
    passive = reader.stated.structure.passive
    said = [say("passive", lang, links=", ".join(passive))] if passive else []
    if passive and reader.stated.mechanism.loaded:
        said.append(say("passive_forces", lang, links=", ".join(passive)))
    said += [say("blunt", lang, makes=", ".join(marks), angle_deg=Written(angle)) for angle, marks in blunt]
    for reason, step, _ in reader.drawing.tool.notes:
        said.append(say(reason, lang, makes=name_index(str(getattr(step, "makes", "")))))
    rough, none = _doubtful_results_and_reactions(reader, wanted, given)
    naming = replace(reader.stated.default_naming, lang=lang)
    for key, names in (("faint", [*_faint_vector_names(reader), *none]), ("doubtful", rough)):
        if names:
            said.append(
                say(key, lang, makes=", ".join(terminal_spelling(naming.lettered_vector(name)) for name in names))
            )
    return said


def _blunt_mark_warnings(reader: DrawingReader, lang: Lang) -> dict[str, list[str]]:
    """Marks where lines meet bluntly, by the angle."""
    marks: dict[str, list[str]] = {}
    for plan in reader.stated.plan_names:
        for label, sharpness in reader.crossing_sharpness(plan).items():
            if sharpness < BLUNT_CROSSING_SINE:
                angle = f"{math.degrees(math.asin(min(1.0, sharpness))):.2g}"
                marks.setdefault(angle, []).append(f"{label} ({plan_name_in_words(plan, lang)})")
    return marks


def _faint_vector_names(reader: DrawingReader) -> Iterator[str]:
    """Velocities and accelerations of points without a correct digit: not zero, but negligible beside the largest of
    their plan."""
    for letter, plan in (("v", VELOCITY_PLAN), ("a", ACCELERATION_PLAN)):
        sizes = {}
        for point, marks in reader.stated.points.items():
            mark = marks.velocity if letter == "v" else marks.acceleration
            if mark in reader.drawing:
                sizes[point] = abs(reader.drawing[mark])
        limit = ZERO_FORCE_RATIO * max(sizes.values(), default=0.0) / reader.bluntest_sharpness(plan)
        yield from (f"{letter}_{point}" for point, size in sizes.items() if 0 < size <= limit)


def _doubtful_results_and_reactions(
    reader: DrawingReader, wanted: Sequence[Quantity] | None, given: Things
) -> tuple[Sequence[str], Sequence[str]]:
    """Results of an exact drawing with less than three digits, and reactions with none; the running bound is computed
    only in case of doubt."""
    drawn = reader.drawing
    if drawn.tool.doubt_mm or (wanted is not None and not wanted):
        return [], []
    stated = reader.stated
    forces = {(r.start, r.end) for r in stated.reactions.values() if r.start in drawn and r.end in drawn}
    if is_clear_drawing(drawn.program, drawn.things, drawn.tool, forces) and not has_wide_length_range(
        stated.given, stated.means
    ):
        return [], []
    import numpy as np

    from planes.batch.cycle import Cycle

    asked = results_wanted(stated, wanted)
    cycle = Cycle(stated, known=given, columns=[c for q in asked for c in q.columns])
    table = np.array([[c.read_from_drawing(drawn.things, drawn.tool.ar)] for c in cycle.columns], float)
    bounds = cycle.error_claims.error_bounds_of_columns([cycle.given[stated.drive_given_name]])
    doubtful, faint = (
        iter(decide(table, bounds)[:, 0].tolist())
        for decide in (cycle.error_claims.doubtful_numbers, cycle.error_claims.numbers_on_faint_forces)
    )
    answers = [(q, [[next(answer) for _ in q.columns] for answer in (doubtful, faint)]) for q in asked]
    none = [q.of for q, (_, nothing) in answers if any(nothing)]
    return [q.name for q, (rough, nothing) in answers if any(rough) and not any(nothing)], none
