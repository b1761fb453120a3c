"""The law of a load as people write it: 3000·sin(φ₁), a table over s₅, a value for the working stroke."""

from collections.abc import Callable

from planes.scene.expressions import split_into_tokens
from planes.scene.mechanism import Amount, Drive, LoadLaw, StrokeLoad
from planes.words import Lang, say
from planes.words.units import number_text

LAW_NUMBER_DIGITS = 6
_POWER_SIGNS = {"2": "²", "3": "³"}
Letter = Callable[[str], str]


def law_in_words(value: Amount | StrokeLoad, drive: Drive, letter: Letter, lang: Lang, pairs: bool = True) -> str:
    """A number of a load in words: ``letter`` writes a name, ``pairs`` says whether to list those of a table."""
    if isinstance(value, StrokeLoad):
        working, idle = (law_in_words(x, drive, letter, lang, pairs) for x in (value.working, value.idle))
        way = say(f"stroke_{value.stroke}", lang)
        return say("law_of_strokes", lang, working=working, idle=idle, slider=value.slider, way=way)
    if not isinstance(value, LoadLaw):
        return number_text(value, lang, LAW_NUMBER_DIGITS)
    text = _expression_in_words(value.text, drive, letter, lang)
    if not value.table:
        return text
    pairs_text = "; ".join(
        f"{number_text(x, lang, LAW_NUMBER_DIGITS)} → {number_text(y, lang, LAW_NUMBER_DIGITS)}" for x, y in value.table
    )
    return say("law_of_table", lang, over=text) + (f" ({pairs_text})" if pairs else "")


def _expression_in_words(text: str, drive: Drive, letter: Letter, lang: Lang) -> str:
    said: list[str] = []
    for kind, word in split_into_tokens(text):
        if said[-1:] == ["^"] and word in _POWER_SIGNS:
            said[-1] = _POWER_SIGNS[word]
        elif kind == "number":
            said.append(number_text(float(word), lang, LAW_NUMBER_DIGITS))
        elif kind == "name" and ("_" in word or word == drive.kind):
            said.append(letter(drive.motion_names[0] if word == drive.kind else word))
        else:
            said.append({"*": "·", "**": "^", "-": "−", ",": "; ", "pi": "π"}.get(word, word))
    return "".join(said)
