"""The text of a vector equation: equal sides, each a sum of vectors with coefficients."""

import re
from collections.abc import Callable
from itertools import pairwise

from planes.words import Phrase
from planes.words.errors import EquationError
from planes.words.frozen import field, frozen
from planes.words.names import NO_PLAN, POLE_LABEL, NamePair, NameTuple, PlanId

VECTOR_NAME_PATTERN = r"[^\W\d][\w^'′″]*"
_RATE_VECTOR_PATTERN = re.compile(r"([va])_([^\W\d_]\d*)([^\W\d_]\d*)?(?:\^([ntkr]))?")
Number = Callable[[str], float]


@frozen
class SideTerm:
    """A vector of a side, with its coefficient."""

    name: str
    times: float = 1.0

    @property
    def term_text(self) -> str:
        """The term as written, without the sign."""
        if abs(self.times) == 1:
            return self.name
        return f"{abs(self.times):.4g}·{self.name}"


Side = tuple[SideTerm, ...]


@frozen
class VectorEquation:
    """Sides that are all equal; () is zero."""

    text: str
    sides: tuple[Side, ...]
    line: int = field(default=0, compare=False)
    plan: PlanId = NO_PLAN  # the plan it is drawn on, if the scene names one: "force:2-3"

    @property
    def vector_names(self) -> NameTuple:
        """Its vectors, in order."""
        return tuple(t.name for side in self.sides for t in side)


VectorEquations = tuple[VectorEquation, ...]


def read_equation(text: str, number: Number, line: int, chained: bool = True) -> VectorEquation:
    """Read "v_S = v_B + 0.4*v_CB", "F_1 + F_30 - F_03 = 0" or "a_C = a_B + a_CB^n + a_CB^t = a_D + …"; ``number``
    evaluates a coefficient; in an equation that is not ``chained`` the vectors need not follow one another.

    Raises :class:`EquationError` where a side is not a sum of vectors, a vector occurs twice, or a chain breaks.
    """
    parts = text.split("=")
    if len(parts) < 2:
        raise EquationError(Phrase("one_equals", text=text))
    sides = tuple(tuple(_terms_of_side(part, text, number)) for part in parts)
    equation = VectorEquation(text, sides, line)
    for name in equation.vector_names:
        if equation.vector_names.count(name) > 1:
            raise EquationError(Phrase("vector_twice", text=text, name=name))
    if not equation.vector_names:
        raise EquationError(Phrase("no_vectors", text=text))
    if sides.count(()) > (len(sides) == 2):
        raise EquationError(Phrase("zero_between", text=text))
    if chained:
        check_vector_chains(equation)
    return equation


def _terms_of_side(part: str, text: str, number: Number) -> list[SideTerm]:
    part = part.strip().replace("−", "-").replace("·", "*")
    if part == "0":
        return []
    pieces = _split_at_signs(part)
    if not pieces:
        raise EquationError(Phrase("side_empty", text=text))
    return [_read_term(sign, piece, text, number) for sign, piece in pieces]


def _split_at_signs(part: str) -> list[NamePair]:
    """The side split at the signs outside brackets."""
    pieces = list[NamePair]()
    depth = 0
    piece = ""
    sign = "+"
    for char in part:
        depth += (char == "(") - (char == ")")
        if char in "+-" and depth == 0 and not piece.rstrip().endswith("*"):
            pieces += [(sign, piece)] * bool(piece.strip() or pieces)
            sign = char
            piece = ""
        else:
            piece += char
    return [*pieces, (sign, piece)] if piece.strip() or pieces else []


def _read_term(sign: str, piece: str, text: str, number: Number) -> SideTerm:
    piece = piece.strip()
    match = re.fullmatch(rf"(?:(.*)\*)?\s*({VECTOR_NAME_PATTERN})\s*(/.*)?", piece)
    if not match:
        word = repr(piece) if piece else Phrase("nothing")
        raise EquationError(Phrase("not_vector", text=text, name=word))
    before, name, after = match.groups()
    times = number(f"{before or 1}{after or ''}") if before or after else 1.0
    if times == 0.0:
        raise EquationError(Phrase("times_nothing", text=text, name=name))
    return SideTerm(name, times if sign == "+" else -times)


def rate_vector_end_marks(name: str) -> NamePair | None:
    """The end marks of a velocity or acceleration, by its name: v_C p→c, v_CB b→c, a_CB^n b'→n_CB; else None."""
    match = _RATE_VECTOR_PATTERN.fullmatch(name)
    if not match:
        return None
    letter, one, other, part = match.groups()
    prime = "'" if letter == "a" else ""
    start = other.lower() + prime if other else POLE_LABEL
    end = one.lower() + prime
    middle = f"{'n' if part in 'nt' else 'k'}_{one}{other or ''}" if part else ""
    if part in ("n", "k"):
        return start, middle
    return (middle, end) if part else (start, end)


def term_end_marks(term: SideTerm) -> NamePair | None:
    """The marks at the ends of a term; None where neither its name nor its coefficient gives any."""
    marks = rate_vector_end_marks(term.name) if abs(term.times) == 1 else None
    return marks[::-1] if marks and term.times < 0 else marks


def check_vector_chains(equation: VectorEquation) -> None:
    """Each vector of a side must start at the end of the one before, and all sides must join the same marks."""
    reached = []
    text = equation.text
    for side in equation.sides:
        spans = [(term.name, term_end_marks(term)) for term in side]
        if not spans or any(span is None for _, span in spans):
            return
        for (_, before), (name, after) in pairwise(spans):
            assert before and after
            if before[1] != after[0]:
                raise EquationError(Phrase("chain_order", text=text, name=name, start=after[0], reached=before[1]))
        first = spans[0][1]
        last = spans[-1][1]
        assert first and last
        reached.append((first[0], last[1]))
    for other in reached[1:]:
        if other != reached[0]:
            start, end = reached[0]
            other_start, other_end = other
            words = {"start": start, "end": end, "other_start": other_start, "other_end": other_end}
            raise EquationError(Phrase("chain_ends", text=text, **words))
