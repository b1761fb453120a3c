"""A tape as a page reads it: plain data, in the arithmetic of a page, with nothing that no wanted number depends on."""

import math
from collections.abc import Iterable

from planes.batch.symbols import Num, Vec
from planes.batch.tape import Tape
from planes.batch.tracing import Recording, Source
from planes.geometry.arithmetic import Real
from planes.words.records import Json


class PlainRecording(Recording):
    """The arithmetic of a page: what is only there for the last digits is done without."""

    def gap(self, c: Vec, d: Vec, r: Num, s: Num) -> Real:
        """(r + s)² - |d - c|²."""
        way = d - c
        return (r + s) * (r + s) - (way.real * way.real + way.imag * way.imag)


def exported(tape: Tape, wanted: Iterable[int], sources: Iterable[Source] = ()) -> tuple[Json, dict[int, int]]:
    """Names of operations, [operation, arguments…] in order, constants, givens, sources; and the new place of each old
    one that leads to the wanted."""
    new = {place: k for k, place in enumerate(tape.needed(list(wanted)))}
    ops, values = [tape.ops[place] for place in new], [(p, v) for p, v in tape.values.items() if p in new]
    names = sorted({op for op, _ in ops})
    consts = [(p, v) for p, v in values if tape.ops[p][0] == "const"]
    told = {
        "names": names,
        "ops": [[names.index(op), *(new[a] for a in args)] for op, args in ops],
        "consts": {new[p]: float(v) if math.isfinite(v) else None for p, v in consts},
        "givens": {v: new[p] for p, v in values if tape.ops[p][0] == "given"},
        "sources": [[new[s.place], s.size] for s in sources if s.place in new],
    }
    return told, new
