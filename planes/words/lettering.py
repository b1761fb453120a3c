"""Letters with their indices: S2 -> S_{2}, phi_1 -> φ_{1}. Whole names are lettered in :mod:`planes.words.naming`.
Sentences name an object in words, never by the program's internal marks.

Construction marks: "°y-y" is the position of a guide, "H°CL" the line through H parallel to a guide, "H⊥CL" the foot of
the perpendicular from H to it, "B°s" the origin of a driver's stroke. Directions: "∥CL", "⊥BC" or, by a vector, "∠v_C"
and "→v_C".
"""

import re

from planes.words import Phrase, Told
from planes.words.names import Mark, PlanId, label_of, letter_of, written_direction

_GREEK_LETTER_NAMES = ("omega", "epsilon", "phi", "alpha", "beta", "gamma", "delta", "psi", "theta", "rho")
GREEK_LETTER_BY_NAME = dict(zip(_GREEK_LETTER_NAMES, "ωεφαβγδψθρ", strict=True))
_NUMBERED_LETTER_PATTERN = re.compile(r"([^\W\d_]+)(\d+)")
_HELPER_MARK_PATTERN = re.compile(r"(?P<point>[^°⊥∥]*)(?P<sign>[°⊥∥])(?P<guide>[^°⊥∥]+)")


def without_index_markup(text: str) -> str:
    """A name without its index markup, for use inside an index."""
    return "".join(c for c in text if c not in "_^{}")


def terminal_spelling(lettered: str) -> str:
    """A lettered name as a terminal has it: F_{56}^{t} -> F_56^t."""
    return lettered.replace("{", "").replace("}", "")


def letter_and_analogue_index(letter: str) -> tuple[str, str]:
    """The letter as written, and the index of an analogue: omegaq -> ω, q."""
    plain = letter.removesuffix("q")
    known = plain in ("v", "a", *GREEK_LETTER_BY_NAME)
    if known:
        return (GREEK_LETTER_BY_NAME.get(plain, plain), letter[len(plain) :])
    return (letter, "")


def with_number_as_subscript(name: str) -> str:
    """A letter with its number as a subscript: S2 -> S_{2}."""
    match = _NUMBERED_LETTER_PATTERN.fullmatch(name)
    if match:
        return f"{match[1]}_{{{match[2]}}}"
    head, _, index = name.partition("_")
    return f"{head}_{{{index}}}" if index and head else name


def parameter_lettering(name: str) -> str:
    """The name of a parameter: phi_1 -> φ_{1}, l_BS2 -> l_{BS2}."""
    letter, _, index = name.partition("_")
    if letter == "angle" and index:
        return f"∠{index.replace('_', ',')}"
    return GREEK_LETTER_BY_NAME.get(letter, letter) + (f"_{{{index.replace('_', ',')}}}" if index else "")


def with_index_markup(text: str) -> str:
    """Sentences in which the indices of names are set as such: v_H, F21^t, phi_1."""
    name = rf"(?<!\w)([^\W\d_]{{1,2}}\d*|{'|'.join(GREEK_LETTER_BY_NAME)})([_^])([^\W_]+)(?!\w)"
    return re.sub(name, lambda m: f"{GREEK_LETTER_BY_NAME.get(m[1], m[1])}{m[2]}{{{m[3]}}}", text)


def letter_of_scale(lettered: str) -> str:
    """The letter that the μ of a lettered quantity is written with: a^{k}_{4} -> a."""
    return letter_of(lettered).partition("^")[0]


def name_in_words(name: str) -> Told:
    """A mark, direction or value as a sentence names it; ``name`` may include its plan."""
    label = written_direction(label_of(name).rstrip("′"))
    match = _HELPER_MARK_PATTERN.fullmatch(label)
    if match is None:
        return label.strip("|‖∠→").removesuffix("_given") or label
    if match["guide"] == "s" and match["point"]:
        return Phrase("start_of_stroke", point=match["point"])
    if match["point"]:
        key = "beside_guide" if match["sign"] == "°" else "foot_on_guide"
        return Phrase(key, point=match["point"], guide=match["guide"])
    if match["sign"] == "⊥":
        return label
    return Phrase("guide_named", name=match["guide"])


def line_in_words(along: str, start: Mark) -> Phrase:
    """A line through a mark, or the guide itself."""
    mark = start.label
    _, parallel, guide = written_direction(along).partition("∥")
    point, sign, other = next((mark.partition(s) for s in "°⊥" if s in mark), ("", "", ""))
    if parallel and sign and written_direction(other) == guide:
        if sign == "°" and point:
            return Phrase("line_beside", point=point, name=guide)
        return Phrase("line_guide", name=guide)
    return Phrase("line_through", along=written_direction(along), start=name_in_words(start))


def plan_phrase(plan: PlanId) -> Phrase:
    """The name of a plan in words."""
    if plan == "force":
        return Phrase("plan_forces")
    links = plan.links
    if plan.is_force and len(links) == 1:
        return Phrase("plan_force_alone", links=links[0])
    return Phrase(f"plan_{plan.kind}", links=", ".join(links))
