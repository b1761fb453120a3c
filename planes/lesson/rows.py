"""A line of reckoning as data: what is found, its formula, the numbers put into it, its value and unit."""

from collections.abc import Iterator

from planes.drafting.steps.reckoning import Calculate
from planes.lesson.formulas import SLOT, formula, in_both, slot, unit
from planes.words import Lang, say
from planes.words.frozen import frozen
from planes.words.records import Json


@frozen
class Row:
    """``head = letters = numbers = value unit``, all with slots and names in ⟨…⟩.

    ``name`` is the value that is found. ``kind`` is how the line is worded: "" a formula, "measured" on paper,
    "moments" (solved for ``name``, whose arm may be named), "reduced" of an arm, "couple" and "couple_settled" of
    friction. ``unit_key`` is that of the unit where the name does not tell it; ``turns``: its sense is told too.
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

    def unit(self, lang: Lang) -> str:
        """Its unit, as the language writes it."""
        return say(self.unit_key, lang) if self.unit_key else unit(self.name, lang)

    def text(self, lang: Lang) -> str:
        """The line in words."""
        if not self.numbers:
            return f"⟨{self.name}⟩ = 0"
        parts = {k: getattr(self, k) for k in ("name", "letters", "numbers", "value")}
        parts |= {"head": self.head or f"⟨{self.name}⟩", "unit": self.unit(lang)}
        arm = f" (⟨{self.arm}⟩ = {slot(self.arm, 'a')} {unit(self.arm, lang)})" if self.arm else ""
        found = f"; ⟨{self.name}⟩" if "·" in parts["head"] else ""
        sense = f" ({slot(self.name, 's')})" if self.turns else ""
        return say(f"lesson_row_{self.kind or 'formula'}", lang, **parts, arm=arm, found=found) + sense

    def json(self) -> Json:
        """For a page that sets it as mathematics."""
        parts = {k: getattr(self, k) for k in ("name", "kind", "head", "letters", "numbers", "value")}
        parts["arm"] = f"⟨{self.arm}⟩ = {slot(self.arm, 'a')}" if self.arm else ""
        parts["turns"] = f"({slot(self.name, 's')})" if self.turns else ""
        said = {"said": in_both(self.text), "unit": in_both(self.unit)}
        return {k: z for k, z in {**parts, **said}.items() if z}

    def slots(self) -> Iterator[tuple[str, str]]:
        """How it tells numbers, and of which values."""
        more = slot(self.arm, "a") if self.arm else ""
        sense = slot(self.name, "s") if self.turns else ""
        for how, name, _ in SLOT.findall(f"{self.head}{self.letters}{self.numbers}{more}{self.value}{sense}"):
            yield how, name


def reckoned(step: Calculate, called: str = "", unit_key: str = "", turns: bool = False) -> Row:
    """A value with its formula, by the name of the step or the one it is ``called`` by."""
    return Row(called or step.makes, *formula(step), slot(step.makes), unit_key=unit_key, turns=turns)
