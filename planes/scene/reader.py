"""How the values of a scene are read: numbers, names, places, tables with known keys, each with its error message."""

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Self

from planes.geometry.arithmetic import cos_deg, sin_deg
from planes.scene.expressions import evaluate
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.scene.written_numbers import WrittenNumbers
from planes.words import Phrase, Told
from planes.words.errors import ExpressionError, SceneError, choices, shown

MOST = 1e50  # the largest number of a scene: products of several stay far from overflow
MOST_TURNS = 1_000_000  # the largest angle: beyond it a double has too few digits for the position within the turn
MAX_NAME = 40
_NAME = re.compile(r"[\w'′″-]*\w[\w'′″-]*")


class Reader:
    """Reads nodes of one file with one set of parameters."""

    def __init__(self, file: str, parameters: Mapping[str, float] | None = None) -> None:
        self.file = file
        self.parameters: Mapping[str, float] = parameters or {}
        self.taken: set[str] = set()  # names of points, in Latin letters
        self.written = WrittenNumbers()

    def error(self, phrase: Told, where: Node | int) -> SceneError:
        """An error at a node or a line."""
        return SceneError(phrase, self.file, where if isinstance(where, int) else where.line)

    def fault(self, key: str, where: Node | int, /, **parts: object) -> SceneError:
        """The same in the words of a key."""
        return self.error(Phrase(key, **parts), where)

    def table(self, node: Node, what: Told, keys: Sequence[str] | None = None) -> SourceTable:
        """The node as a table; its keys must be among ``keys`` if those are given."""
        if not isinstance(node, SourceTable):
            raise self.fault("table_needed", node, what=what, kind=kind(node))
        for key in node.entries if keys is not None else ():
            if key not in (keys or ()):
                self.check_colon(node, key, keys or ())
                valid = choices(key, keys or ())
                raise self.fault("no_key", node.lines[key], what=what, key=shown(key), valid=valid)
        return node

    def check_colon(self, table: SourceTable, key: str, names: Iterable[str]) -> None:
        """In {phi 30} the colon is forgotten, in {phi:30} the space after it, and all of it is a key."""
        first, sign, rest = [*re.split("([ :])", key, maxsplit=1), "", ""][:3]
        value = table.entries[key]
        if rest and first in names and isinstance(value, SourceScalar) and value.absent:
            forgotten = Phrase("colon_after", key=shown(first), text=shown(key))
            raise self.error(Phrase("colon_space", key=first) if sign == ":" else forgotten, table.lines[key])

    def names(self, node: Node, what: Told, kind: Phrase) -> SourceTable:
        """The node as a table whose keys are names of a ``kind``: "a point"."""
        table = self.table(node, what)
        for key, line in table.lines.items():
            self.check_name(key, kind, line)
        return table

    def check_name(self, name: str, kind: Phrase, where: Node | int) -> str:
        """The name itself, if it is well formed."""
        if len(name) > MAX_NAME:
            raise self.fault("long_name", where, name=shown(name), of=kind, most=MAX_NAME)
        if not _NAME.fullmatch(name):
            raise self.fault("bad_name", where, name=shown(name), of=kind)
        return name

    def items(self, node: Node, what: Told) -> list[Node]:
        """The node as a list."""
        if not isinstance(node, Items):
            raise self.fault("list_needed", node, what=what, kind=kind(node))
        return node.items

    def text(self, node: Node, what: Told) -> str:
        """The node as a non-empty text."""
        if not isinstance(node, SourceScalar):
            raise self.fault("word_needed", node, what=what, kind=kind(node))
        if node.absent:
            raise self.fault("no_value", node, what=what)
        return node.text

    def word(self, node: Node, what: Told, words: Sequence[str]) -> str:
        """The node as one of a few words."""
        text = self.text(node, what)
        if text not in words:
            raise self.fault("bad_word", node, what=what, word=shown(text), valid=choices(text, words))
        return text

    def known(self, node: Node, what: Told, names: Iterable[str], kind: Phrase) -> str:
        """The node as a defined name of a ``kind``: "point"."""
        text = self.text(node, what)
        if text not in (names if isinstance(names, Mapping) else (names := list(names))):
            valid = self.offer(text, names)
            raise self.fault("unknown_name", node, what=what, of=kind, name=shown(text), valid=valid)
        return text

    def offer(self, given: str, names: Iterable[str]) -> Told:
        """Words with the valid names, or that there are none."""
        return choices(given, names) or Phrase("none_defined")

    def number(self, node: Node, what: Told) -> float:
        """The finite value of a number or an expression."""
        if not isinstance(node, SourceScalar):
            hint = Phrase("decimal_fraction") if isinstance(node, Items) and _comma(node) else ""
            raise self.fault("number_needed", node, what=what, kind=kind(node), hint=hint)
        if node.absent:
            raise self.fault("no_value", node, what=what)
        try:
            value = evaluate(node.text, self.parameters)
        except ExpressionError as error:
            raise self.fault("about", node, what=what, why=error.phrase) from None
        if abs(value) > MOST:
            raise self.fault("out_of_range", node, what=what, value=value, most=MOST)
        if node.text not in self.parameters:
            self.written.note(value, node.text)
        return value

    def positive(self, node: Node, what: Told) -> float:
        """A number that is not negative."""
        value = self.number(node, what)
        if value < 0.0:
            raise self.fault("negative", node, what=what, value=value)
        return value

    def present(self, table: SourceTable) -> dict[str, Node]:
        """The non-empty values of a table."""
        return {key: node for key, node in table.entries.items() if not absent(node)}

    def place(self, node: Node, what: Told, on_axis: bool = False) -> complex:
        """A place as [x, y] or {r, angle}; with ``on_axis`` also as a number along the x axis."""
        if isinstance(node, Items):
            return self._pair(node, what)
        if isinstance(node, SourceTable):
            polar = Fields(self, node, what, ("r", "angle"))
            radius, angle = polar.positive("r"), polar.said("angle") or 0.0
            return self.written.note_place(complex(radius * cos_deg(angle), radius * sin_deg(angle)), radius, angle)
        if not on_axis:
            raise self.fault("place_needed", node, what=what, given=shown(node.text))
        return complex(self.number(node, what), 0.0)

    def _pair(self, node: Items, what: Told) -> complex:
        if len(node.items) != 2:
            hint = Phrase("decimal_no_comma") if _comma(node) else ""
            raise self.fault("pair_needed", node, what=what, count=len(node.items), hint=hint)
        x, y = (self.number(item, part(axis, what)) for axis, item in zip("xy", node.items, strict=True))
        return self.written.note_place(complex(x, y))


class Fields:
    """The values under the keys of one table, each with its error messages; ``what`` is the owner of the keys."""

    def __init__(self, reader: Reader, node: Node, what: Told, keys: Sequence[str] | None = None) -> None:
        self.reader, self.what, self.table = reader, what, reader.table(node, what, keys)

    def __contains__(self, key: str) -> bool:
        return key in self.table.entries

    def error(self, phrase: Told, key: str = "") -> SceneError:
        """An error at a key, or at the table."""
        return self.reader.error(phrase, self.table.lines.get(key, self.table.line))

    def fault(self, words: str, key: str = "", /, **parts: object) -> SceneError:
        """The same in the words of a key of the table."""
        return self.error(Phrase(words, **parts), key)

    def named(self, key: str) -> Phrase:
        """The value under a key, as a sentence names it."""
        return part(key, self.what)

    def optional(self, key: str) -> Node | None:
        """The value of a key, or None when it is missing or empty."""
        node = self.table.entries.get(key)
        return None if node is None or absent(node) else node

    def required(self, key: str) -> Node:
        """The value of a required key."""
        if key not in self:
            raise self.fault("needs_key", what=self.what, key=key)
        if absent(self.table.entries[key]):
            raise self.fault("no_value", key, what=self.named(key))
        return self.table.entries[key]

    def one_of(self, *keys: str) -> str:
        """Which one of these keys the table has: exactly one is required."""
        given = [key for key in keys if key in self]
        if len(given) == 1:
            return given[0]
        if given:
            raise self.fault("both_keys", given[1], what=self.what, one=given[0], two=given[1])
        raise self.fault("needs_one_key", what=self.what, keys=keys)

    def inner(self, key: str, keys: Sequence[str] | None = None) -> Self:
        """The table under a key."""
        return type(self)(self.reader, self.required(key), self.named(key), keys)

    def number(self, key: str, usual: float | None = None) -> float:
        """A number; ``usual`` where none is given."""
        if usual is not None and self.optional(key) is None:
            return usual
        return self.reader.number(self.required(key), self.named(key))

    def said(self, key: str) -> float | None:
        """A number, or None."""
        return None if self.optional(key) is None else self.number(key)

    def positive(self, key: str, usual: float | None = None) -> float:
        """A number that is not negative; ``usual`` where none is given."""
        if usual is not None and self.optional(key) is None:
            return usual
        return self.reader.positive(self.required(key), self.named(key))

    def place(self, key: str) -> complex:
        """A place."""
        return self.reader.place(self.required(key), self.named(key))

    def text(self, key: str) -> str:
        """A text that is not empty."""
        return self.reader.text(self.required(key), self.named(key))

    def word(self, key: str, words: Sequence[str]) -> str:
        """One of a few words."""
        return self.reader.word(self.required(key), self.named(key), words)

    def known(self, key: str, names: Iterable[str], kind: Phrase) -> str:
        """A defined name."""
        return self.reader.known(self.required(key), self.named(key), names, kind)


def absent(node: Node) -> bool:
    """Whether the key has no value."""
    return isinstance(node, SourceScalar) and node.absent


def _comma(node: Items) -> bool:
    """Whether decimal commas broke a list: digits right after a comma, in "0,5" or "[0,1, 0,2]"."""
    glued = [isinstance(item, SourceScalar) and item.glued and item.text.isdigit() for item in node.items]
    return any(glued) and (len(glued) == 2 or not all(glued[1:]))


def part(key: str, what: Told) -> Phrase:
    """A part of an object in words: "mass of link 2"."""
    return Phrase("part", key=key, what=what)


def section(name: str) -> Phrase:
    """A key of the scene as the owner of its keys: "omega of drive"."""
    return Phrase("section", name=name)


def kind(node: Node) -> Told:
    """The type of a node, in words."""
    if isinstance(node, SourceTable):
        return Phrase("a_table")
    return Phrase("a_list") if isinstance(node, Items) else (Phrase("empty") if node.absent else shown(node.text))
