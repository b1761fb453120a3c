"""What a thing of the drawing is called in a sentence: guides and feet by their names, never the program's own marks.

A helper mark is named "°y-y" (where a guide stands), "H°CL" (the line of H beside a guide), "H⊥CL" (the foot of H on
it), "B°s" (where a driver's stroke is counted from); a direction "∥CL", "⊥BC" or, by a vector, "∠v_C" and "→v_C".
"""

from __future__ import annotations

import re

from planes.words import Phrase, Told
from planes.words.names import kind_of, label_of, links_of, written

_HELPER = re.compile(r"(?P<point>[^°⊥∥]*)(?P<sign>[°⊥∥])(?P<guide>[^°⊥∥]+)")


def name_in_words(name: str) -> Told:
    """A mark, direction or value as a sentence names it; ``name`` may carry its plan."""
    label = written(label_of(name).rstrip("′"))
    found = _HELPER.fullmatch(label)
    if found is None:
        return label.strip("|‖∠→") or label
    if found["guide"] == "s" and found["point"]:
        return Phrase("start_of_stroke", point=found["point"])
    if found["point"]:
        key = "beside_guide" if found["sign"] == "°" else "foot_on_guide"
        return Phrase(key, point=found["point"], guide=found["guide"])
    return label if found["sign"] == "⊥" else Phrase("guide_named", name=found["guide"])


def line_in_words(along: str, start: str) -> Phrase:
    """A line through a mark: the guide itself where it is one."""
    mark, (_, parallel, guide) = label_of(start), written(along).partition("∥")
    point, sign, other = next((mark.partition(s) for s in "°⊥" if s in mark), ("", "", ""))
    if parallel and sign and written(other) == guide:
        if sign == "°" and point:
            return Phrase("line_beside", point=point, name=guide)
        return Phrase("line_guide", name=guide)
    return Phrase("line_through", along=written(along), start=name_in_words(start))


def plan_phrase(plan: str) -> Phrase:
    """The name of a plan in words."""
    return Phrase(f"plan_{kind_of(plan)}", links=", ".join(links_of(plan)))
