"""A scene without a mechanism: vectors of which something is given, and the equations that tie them."""

import re
from dataclasses import dataclass
from itertools import pairwise

from planes.scene.reader import MAX_NAME, Reader
from planes.scene.source import Node, SourceScalar
from planes.words import Phrase
from planes.words.errors import EquationError, shown
from planes.words.names import POLE

_RATE = re.compile(r"([va])_([^\W\d_]\d*)([^\W\d_]\d*)?(?:\^([ntkr]))?")


@dataclass(frozen=True)
class Sides:
    """An equation as names: the vectors of each side, each with its sign made plus by moving it across."""

    text: str
    left: tuple[str, ...]
    right: tuple[str, ...]

    def __str__(self) -> str:
        return " = ".join(" + ".join(side) or "0" for side in (self.left, self.right))


def read_equation(text: str) -> Sides:
    """Read "v_C = v_B + v_CB" or "F_21 + G_2 - F_03 = 0"; a minus carries a vector to the other side.

    :class:`EquationError` where the text is no sum of names, a name stands twice, or a chain breaks.
    """
    parts = text.split("=")
    if len(parts) != 2:
        raise EquationError(Phrase("one_equals", text=text))
    sides: tuple[list[str], list[str]] = ([], [])
    for index, side in enumerate(parts):
        for sign, name in _terms(side, text):
            sides[index if sign == "+" else 1 - index].append(name)
    names = sides[0] + sides[1]
    for name in names:
        if names.count(name) > 1:
            raise EquationError(Phrase("vector_twice", text=text, name=name))
    if not names:
        raise EquationError(Phrase("no_vectors", text=text))
    found = Sides(text, tuple(sides[0]), tuple(sides[1]))
    check_chain(found)
    return found


def _terms(part: str, text: str) -> list[tuple[str, str]]:
    part = part.strip().replace("−", "-")
    if part == "0":
        return []
    pieces = re.split(r"([+-])", part)
    pieces = pieces[1:] if pieces[0].strip() == "" else ["+", *pieces]
    found = []
    for sign, name in zip(pieces[::2], pieces[1::2], strict=False):
        if not re.fullmatch(r"[^\W\d][\w^'′]*", name.strip()):
            word = repr(name.strip()) if name.strip() else Phrase("nothing")
            raise EquationError(Phrase("not_vector", text=text, name=word))
        found.append((sign, name.strip()))
    if not found:
        raise EquationError(Phrase("side_empty", text=text))
    return found


def ends(name: str) -> tuple[str, str] | None:
    """Marks a velocity or acceleration runs between by its name: v_C p→c, v_CB b→c, a_CB^n b'→n_CB; else None."""
    match = _RATE.fullmatch(name)
    if not match:
        return None
    letter, one, other, part = match.groups()
    prime = "'" if letter == "a" else ""
    start = other.lower() + prime if other else POLE
    end = one.lower() + prime
    middle = f"{'n' if part in 'nt' else 'k'}_{one}{other or ''}" if part else ""
    if part in ("n", "k"):
        return start, middle
    return (middle, end) if part else (start, end)


def check_chain(sides: Sides) -> None:
    """Each vector of a side starts where the one before it ends, and both sides join the same marks."""
    reached = []
    for side in (sides.left, sides.right):
        spans = [(name, ends(name)) for name in side]
        if not spans or any(span is None for _, span in spans):
            return
        for (_, before), (name, after) in pairwise(spans):
            assert before and after
            if before[1] != after[0]:
                ends_at = {"start": after[0], "reached": before[1]}
                raise EquationError(Phrase("chain_order", text=sides.text, name=name, **ends_at))
        first, last = spans[0][1], spans[-1][1]
        assert first and last
        reached.append((first[0], last[1]))
    if len(reached) == 2 and reached[0] != reached[1]:
        (start, end), (other_start, other_end) = reached
        why = Phrase("chain_ends", text=sides.text, start=start, end=end, other_start=other_start, other_end=other_end)
        raise EquationError(why)


VECTOR_KEYS = ("value", "direction", "perpendicular_to", "near")
_NAME = re.compile(r"[^\W\d][\w'′″^]*")


@dataclass(frozen=True)
class VectorGiven:
    """What a scene says of a vector; ``near_deg`` tells which of two solutions is meant."""

    value: float | None = None
    direction_deg: float | None = None
    near_deg: float | None = None


def read_vectors(reader: Reader, node: Node) -> dict[str, VectorGiven]:
    """The vectors in the order of the file."""
    table = reader.table(node, "vectors")
    if not table.entries:
        raise reader.error(Phrase("vectors_empty"), table)
    for name, line in table.lines.items():
        if len(name) > MAX_NAME or not _NAME.fullmatch(name):
            raise reader.error(Phrase("bad_vector", name=shown(name), most=MAX_NAME), line)
    return {name: _vector(reader, name, entry) for name, entry in table.entries.items()}


def _vector(reader: Reader, name: str, node: Node) -> VectorGiven:
    what = Phrase("vector", name=name)
    if isinstance(node, SourceScalar) and node.absent:
        return VectorGiven()
    table = reader.table(node, what, VECTOR_KEYS)
    if "direction" in table.entries and "perpendicular_to" in table.entries:
        reader.one_of(table, ("direction", "perpendicular_to"), what)
    given = {key: reader.said(table, key, what) for key in VECTOR_KEYS}
    normal = given["perpendicular_to"]
    return VectorGiven(given["value"], given["direction"] if normal is None else normal + 90.0, given["near"])


def read_equations(reader: Reader, node: Node) -> tuple[tuple[str, ...], tuple[int, ...]]:
    """The equations as they are written, and their lines."""
    nodes = [node] if isinstance(node, SourceScalar) else reader.items(node, "equations")
    if not nodes:
        raise reader.error(Phrase("equations_empty"), node)
    texts = tuple(reader.text(entry, Phrase("equation", number=n)).strip() for n, entry in enumerate(nodes, 1))
    for text, entry in zip(texts, nodes, strict=True):
        if text.count("=") != 1:
            raise reader.error(Phrase("not_equation", text=shown(text)), entry)
    return texts, tuple(entry.line for entry in nodes)
