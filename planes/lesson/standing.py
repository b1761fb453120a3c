"""A point at rest in the position shown: its mark lies at the pole, and a sentence says so."""

from collections.abc import Iterable

from planes.drafting.drawing import Drawing
from planes.lesson.frame import Frame, Frames
from planes.lesson.scheme import special_points
from planes.plans import Plans
from planes.words import Lang, say
from planes.words.frozen import replace
from planes.words.names import POLE_LABEL, Mark, NamesByName, letter_of, name_index, name_without_plan

MOST_STILL_OFFSET_MM = 1e-4
"""Tolerance of a mark at its pole: a page's drive is known to a millionth of a degree."""


def with_zero_vector_sentences(frames: Iterable[Frame], plans: Plans) -> Frames:
    """The frames; those that end the vector of a point get the sentence for a zero vector."""
    named: NamesByName = {
        mark: p for p, m in plans.points.items() if p not in plans.fixed_points for mark in (m.velocity, m.acceleration)
    }
    special = special_points(plans)
    for s in plans.segments:
        if s.start == POLE_LABEL and letter_of(s.name) in ("v", "a") and name_index(s.name) in special:
            named[s.ends[1]] = name_index(s.name)
    return [
        replace(f, still=zero_vector_sentence(f.makes[0], named, special)) if f.makes and f.makes[0] in named else f
        for f in frames
    ]


def zero_vector_sentence(mark: Mark, named: NamesByName, special: NamesByName) -> NamesByName:
    """The sentence, and its names."""
    plan = mark.plan
    point = named[mark]
    key = "special" if point in special and plan == "velocity" else plan
    names = {"said": key, "point": point, "mark": name_without_plan(mark), "vector": f"{plan[0]}_{point}"}
    return {**names, "link": special[point]} if key == "special" else names


def point_at_rest_sentence(frame: Frame, drawing: Drawing, lang: Lang) -> str:
    """The sentence, where the point is at rest."""
    if not frame.still or not abs(complex(drawing[frame.makes[0]])) < MOST_STILL_OFFSET_MM:
        return ""
    return say(f"lesson_still_{frame.still['said']}", lang, **frame.still)
