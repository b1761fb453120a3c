"""A line of calculation as data: the result, its formula, the numbers substituted, its value and unit."""

from collections.abc import Iterable, Iterator
from functools import partial

from planes.drafting.steps.reckoning import Calculate
from planes.lesson.formulas import (
    LESSON_LANGS,
    SLOT_PATTERN,
    UNITS_BY_LETTER,
    formula_and_numbers,
    in_lesson_languages,
    sentence_in_lesson_languages,
    unit_of_name,
    value_slot,
)
from planes.words import Lang, say, sentences_with_prefix
from planes.words.frozen import frozen
from planes.words.names import NamePair, split_value_name
from planes.words.records import Json

REMARKED_ROW_KINDS = ("reduced", "couple", "couple_settled")  # kinds of lines that need a remark


@frozen
class Row:
    """``head = letters = numbers = value unit``, all with slots and names in ⟨…⟩.

    ``name`` is the result. ``kind`` sets the wording of the line: "" a formula, "measured" on paper, "moments" (solved
    for ``name``, whose arm may be named), "reduced" for an arm, "couple" and "couple_settled" for friction.
    ``unit_key`` is that of the unit where the name does not show it; ``turns``: its sense is given too.
    """

    name: str
    letters: str
    numbers: str
    value: str
    kind: str = ""
    head: str = ""
    arm: str = ""
    unit_key: str = ""
    turns: bool = False

    def text_in_words(self, lang: Lang) -> str:
        """The line in words."""
        if not self.numbers:
            return f"⟨{self.name}⟩ = 0"
        parts = {"unit": unit_of_name(self.name, self.unit_key), "remark": row_remark(self.kind, lang)}
        parts["head"] = self.head or f"⟨{self.name}⟩"
        parts["arm"] = (
            f" (⟨{self.arm}⟩ = {value_slot(self.arm, 'a')} {unit_of_name(self.arm).told(lang)})" if self.arm else ""
        )
        parts["found"] = f"; ⟨{self.name}⟩" if "·" in self.head else ""
        sense = f" ({value_slot(self.name, 's')})" if self.turns else ""
        return say(f"lesson_row_{self.kind or 'formula'}", lang, **{**vars(self), **parts}) + sense

    @property
    def unit_word_key(self) -> str:
        """The key of its unit's word, "" without a unit."""
        return self.unit_key or UNITS_BY_LETTER.get(split_value_name(self.name)[0], "")

    def json(self) -> Json:
        """The row for a page, which words it by :func:`templates` and typesets it."""
        keys = ("name", "kind", "head", "letters", "numbers", "value", "arm", "turns")
        return {k: z for k, z in {**{k: getattr(self, k) for k in keys}, "unit": self.unit_word_key}.items() if z}

    def slots_of_numbers(self) -> Iterator[NamePair]:
        """Its numbers: how they are written, and of which values."""
        more = value_slot(self.arm, "a") if self.arm else ""
        sense = value_slot(self.name, "s") if self.turns else ""
        for how, name, _ in SLOT_PATTERN.findall(f"{self.head}{self.letters}{self.numbers}{more}{self.value}{sense}"):
            yield how, name


def calculation_row(step: Calculate, called: str = "", unit_key: str = "", turns: bool = False) -> Row:
    """A value with its formula, by the name of the step or the one it is ``called`` by."""
    return Row(called or step.makes, *formula_and_numbers(step), value_slot(step.makes), unit_key=unit_key, turns=turns)


def row_remark(kind: str, lang: Lang) -> str:
    """What must be said of the value of a kind of line besides."""
    if kind in REMARKED_ROW_KINDS:
        return say(f"lesson_remark_{kind}", lang)
    return ""


def row_templates(rows: Iterable[Row]) -> Json:
    """The templates for a page: the sentence of every kind with its placeholders, and the units."""
    units = dict.fromkeys(["m", *(row.unit_word_key for row in rows if row.unit_word_key)])
    sentences = in_lesson_languages(partial(sentences_with_prefix, "lesson_row_"))
    words = {
        kind: {lang: sentences[lang][kind].replace("{remark}", row_remark(kind, lang)) for lang in LESSON_LANGS}
        for kind in sentences["en"]
    }
    return {"words": words, "units": {key: sentence_in_lesson_languages(key) for key in units}}
