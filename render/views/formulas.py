"""Vector equations as on paper: bars over vectors, underlines for known parts, lines of action and numbers beneath."""

import cmath
import math
import re
from dataclasses import dataclass, field

from planes.drafting.equations import Equation, Term
from planes.words import say
from planes.words.frozen import frozen
from planes.words.names import PlanId, PlanTuple, parallel_vector_name, written_direction, written_line_of_action
from planes.words.naming import Naming
from planes.words.read_off import fixed_decimals_text, read_off_text
from render.paper.marks import Line, Mark, Text
from render.paper.symbols import Marks
from render.paper.typeset import ink_bounds, ink_width, overbar_interval
from render.views.plotted import Plotted

ROUNDING_NOISE_MM = 1e-7  # a shorter vector is rounding noise
WORD_GAP_RATIO = 0.55  # between words of an equation, over the letter height
MOST_ROW_WIDTH_RATIO = 40.0  # width of a row, over the letter height: a longer equation continues in the next one
_SIGN_PATTERN = re.compile("[+−=]")
_LEADING_LETTER_PATTERN = re.compile(r"^[^\W\d_]+")


@frozen
class Word:
    """A piece of an equation: with ``known`` underlines, a line of action and a number beneath; a sign has none."""

    text: str
    known: int = 0
    action: str = ""
    value: str = ""
    vector: bool = True


@dataclass
class Setter:
    """Sets one equation on its base line, from the left."""

    letter: float
    marks: list[Mark] = field(default_factory=list)
    x: float = 0.0

    @property
    def beneath_letter_height(self) -> float:
        """Letter height of the texts beneath."""
        return 2.5 if self.letter <= 3.5 else 3.5

    def set_row(self, words: list[Word], y: float) -> float:
        """Set the words at base line ``y``, broken before signs where they are too long; returns the lowest ink."""
        lowest = y
        for k, line in enumerate(self.break_into_lines(words)):
            lowest = self.set_line(line, y, 3 * WORD_GAP_RATIO * self.letter if k else 0.0)
            y = lowest - 1.7 * self.letter
        return lowest

    def break_into_lines(self, words: list[Word]) -> list[list[Word]]:
        """The words in lines within the width, each but the first beginning with a sign."""
        lines: list[list[Word]] = [[]]
        wide = 0.0
        gap = WORD_GAP_RATIO * self.letter
        for k, word in enumerate(words):
            sign = bool(_SIGN_PATTERN.match(word.text)) and not word.vector
            end = k + 1 + sign
            with_last = end == len(words) - 1 and words[-1].text[:1] == "="  # "= 0" is never alone on a line
            step = sum(self.word_width(w) + gap for w in words[k : end + with_last])
            if sign and lines[-1] and wide + step > MOST_ROW_WIDTH_RATIO * self.letter:
                lines.append([])
                wide = 0.0
            lines[-1].append(word)
            wide += self.word_width(word) + gap
        return lines

    def word_width(self, word: Word) -> float:
        """Width of a word with the texts beneath it."""
        beneath = (ink_width(t, self.beneath_letter_height) for t in (word.action, word.value) if t)
        return max(ink_width(word.text, self.letter), *beneath, 0.0)

    def set_line(self, words: list[Word], y: float, left: float = 0.0) -> float:
        """Set one line at base line ``y`` from ``left``; returns the lowest ink."""
        under = y + min(ink_bounds(w.text, self.letter)[1] for w in words) - 0.9
        has_action = any(w.action for w in words)
        has_value = any(w.value for w in words)
        action_y = under - 2.2 - 1.1 * self.beneath_letter_height
        value_y = action_y - 1.75 * self.beneath_letter_height if has_action else action_y
        self.x = left
        for word in words:
            self.set_word(word, y, under, action_y, value_y)
        lines = value_y if has_value else action_y if has_action else under - 1.0
        return lines - 0.45 * self.beneath_letter_height

    def set_word(self, word: Word, y: float, under: float, action_y: float, value_y: float) -> None:
        """One word centred over the texts beneath it."""
        own = ink_width(word.text, self.letter)
        wide = self.word_width(word)
        middle = self.x + wide / 2
        left = middle - own / 2
        self.marks.append(Text(word.text, complex(left, y), self.letter, name=word.text))
        if word.vector:
            self.set_vector_bar(word.text, left, y)
        for k in range(word.known):
            level = under - 0.9 * k
            self.marks.append(Line((complex(left, level), complex(left + own, level)), "thin", "text"))
        for text, level in ((word.action, action_y), (word.value, value_y)):
            if text:
                self.marks.append(Text(text, complex(middle, level), self.beneath_letter_height, "middle"))
        self.x += wide + WORD_GAP_RATIO * self.letter

    def set_vector_bar(self, text: str, left: float, y: float) -> None:
        """The bar over the letter of a vector."""
        match = _LEADING_LETTER_PATTERN.match(text)
        if match:
            level = y + self.letter + 0.9
            start, end = overbar_interval(match[0], self.letter, level - y)
            ends = complex(left + start, level), complex(left + end, level)
            self.marks.append(Line(ends, "thin", "text", name=f"{text} bar"))


@frozen
class Formulas:
    """The equations of some plans, set one beneath another."""

    plotted: Plotted
    naming: Naming
    letter: float = 5.0
    asked: bool = False  # in the form for drawing: without numbers

    def drawn_marks(self, plans: PlanTuple) -> Marks:
        """All equations of these plans, from the top down."""
        setter = Setter(self.letter)
        y = 0.0
        for equation in self.plotted.equations:
            shown = (self.plotted.has_marks(equation.plan, t.start, t.end) for t in equation.all_terms)
            if equation.plan in plans and all(shown):
                words = self.equation_words(equation) if equation.total else self.closed_polygon_words(equation)
                y = setter.set_row(words, y) - 1.9 * self.letter
        return tuple(setter.marks)

    def equation_words(self, equation: Equation) -> list[Word]:
        """v_C = v_B + v_CB; the motion of a point relative to the frame is its absolute vector, with its line of
        action."""
        total = equation.total or ""
        unit = say(equation.plan.unit, self.naming.lang)
        first = Word(self.naming.lettered_vector(total), value="" if self.asked else unit)
        sides = []
        for chain in equation.chains:
            terms = [t for t in chain if t.action != "=0"]
            if len(terms) == 1 and len(chain) > 1 and terms[0].known_part_count == 1 and not first.known:
                first = Word(self.naming.lettered_vector(total), 1, self.line_of_action_text(terms[0]), first.value)
            elif chain:
                sides.append(terms or list(chain))
        words = [first]
        for terms in sides:
            for k, term in enumerate(terms):
                sign = "−" if term.sign < 0 else "+" if k else ""
                words += [Word("=", vector=False)] * (not k)
                words += [Word(sign, vector=False)] * bool(sign)
                words.append(self.term_word(term, equation.plan))
        return words

    def closed_polygon_words(self, equation: Equation) -> list[Word]:
        """The unit; both sides as stated, or the sum of all vectors of a closed polygon, equal to zero."""
        unit = say(equation.plan.unit, self.naming.lang)
        words = [Word("", vector=False, value="" if self.asked else unit)]
        sides = equation.sides_as_written
        for n, side in enumerate(sides):
            words += [Word("=", vector=False)] * bool(n)
            for k, (sign, term) in enumerate(side):
                words += [Word("−" if sign < 0 else "+", vector=False)] * bool(k or sign < 0)
                words.append(self.term_word(term, equation.plan))
        if equation.is_closed_polygon:
            return [*words, Word("= 0", vector=False)]
        return words

    def term_word(self, term: Term, plan: PlanId) -> Word:
        """A vector with its underlines, its line of action and, where known, its number."""
        text = self.naming.lettered_vector(term.name)
        known = term.known_part_count
        value = ""
        if known == 2 and not self.asked:
            length = self.plotted.vector_length_mm(plan, term)
            si = length / self.plotted.plan_mu(plan) if length > ROUNDING_NOISE_MM else 0.0
            value = read_off_text(si, self.naming.lang)
        return Word(text, known, self.line_of_action_text(term), value)

    def line_of_action_text(self, term: Term) -> str:
        """The line of action as written beneath: ⊥BC, ∥y–y, C→B."""
        text = written_direction(term.action).replace("-", "–")
        if text[:1] == "∠" and term.direction:
            way = complex(self.plotted.drawing[term.direction])
            if text[1:2] != "⊥":
                return f"∠{fixed_decimals_text(math.degrees(cmath.phase(way)), 1, self.naming.lang)}°"
            normal = complex(self.plotted.drawing[term.action[1:]])
            leaning = math.degrees(math.asin(min(1.0, abs((way * normal.conjugate()).imag))))
            return say(
                "leans", self.naming.lang, angle=fixed_decimals_text(leaning, 1, self.naming.lang), line=text[1:]
            )
        along = parallel_vector_name(term.action)
        if along:
            return f"∥{self.naming.lettered_vector(along)}"
        return written_line_of_action(term.action)
