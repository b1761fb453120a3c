"""A tape for a web page: plain data, in the page's arithmetic, without operations that no wanted number needs."""

import math
import operator
from collections.abc import Iterable, Mapping

from planes.batch.symbols import Num, Vec
from planes.batch.tape import Op, Tape
from planes.batch.tracing import Recording, Source
from planes.geometry.arithmetic import Real, squared_circle_gap
from planes.geometry.listed import greater_or_nan, less_or_nan, with_fallback_value
from planes.words.records import Json

DIGIT_LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_"
"""Numbers as a page reads them: five bits each, the lowest first, 32 more where another follows."""


FLOAT_OPERATIONS: Mapping[str, Op] = {
    "add": operator.add,
    "sub": operator.sub,
    "mul": operator.mul,
    "inv": with_fallback_value(lambda a: 1 / a),
    "neg": operator.neg,
    "abs": abs,
    "sqrt": lambda a: math.sqrt(a) if a > 0 else a * 0,
    "hypot": math.hypot,
    "sin": with_fallback_value(math.sin),
    "cos": with_fallback_value(math.cos),
    "atan2": math.atan2,
    "floor": with_fallback_value(math.floor),
    "gap": squared_circle_gap,
    "max": greater_or_nan,
    "min": less_or_nan,
    "sel": lambda ok, a, b: a if ok else b,
    "lt": operator.lt,
    "le": operator.le,
    "eq": operator.eq,
    "and": lambda a, b: bool(a) and bool(b),
    "or": lambda a, b: bool(a) or bool(b),
    "not": operator.not_,
}
"""The operations of a tape by Python's floats, one position at a time."""


class PlainRecording(Recording):
    """The arithmetic of a page, without the operations that only serve the last digits."""

    def gap(self, c: Vec, d: Vec, r: Num, s: Num) -> Real:
        """(r + s)² - |d - c|²."""
        way = d - c
        return (r + s) * (r + s) - (way.real * way.real + way.imag * way.imag)


def export_operations(tape: Tape, wanted: Iterable[int], sources: Iterable[Source] = ()) -> tuple[Json, dict[int, int]]:
    """Names of operations with their numbers of arguments, operations in order as letters (:func:`numbers_as_letters`),
    constants, givens, sources; and the new place of each old one that the wanted ones need."""
    new = {place: k for k, place in enumerate(tape.places_needed(list(wanted)))}
    ops = [tape.ops[place] for place in new]
    values = [(p, v) for p, v in tape.values.items() if p in new]
    names = dict(sorted({op: len(args) for op, args in ops}.items()))
    index = {op: k for k, op in enumerate(names)}
    consts = [(p, v) for p, v in values if tape.ops[p][0] == "const"]
    exported_tape = {
        "names": names,
        "ops": "".join(
            DIGIT_LETTERS[index[op]] + numbers_as_letters(p - new[a] for a in args) for p, (op, args) in enumerate(ops)
        ),
        "consts": {new[p]: float(v) if math.isfinite(v) else None for p, v in consts},
        "givens": {v: new[p] for p, v in values if tape.ops[p][0] == "given"},
        "sources": [[new[s.place], s.size] for s in sources if s.place in new],
    }
    return exported_tape, new


def numbers_as_letters(numbers: Iterable[int]) -> str:
    """Numbers from 0 as letters, small ones short: an argument is stored as its distance back."""
    text = ""
    for n in numbers:
        while n > 31:
            text = text + DIGIT_LETTERS[32 + n % 32]
            n = n // 32
        text += DIGIT_LETTERS[n]
    return text
