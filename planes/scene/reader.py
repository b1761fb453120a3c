"""How the values of a scene are read: numbers, names, places, tables with known keys, each with its error message."""

import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Self

from planes.geometry.arithmetic import cos_deg, sin_deg
from planes.scene.expressions import evaluate_expression
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.scene.written_numbers import WrittenNumbers
from planes.words import Phrase, Told
from planes.words.errors import ExpressionError, SceneError, list_valid_choices, quoted_excerpt
from planes.words.names import NumbersByName

LARGEST_SCENE_NUMBER = 1e50  # the largest number of a scene: products of several stay far from overflow
# the largest angle: beyond it a double has too few digits for the position within the turn
MOST_ANGLE_TURNS = 1_000_000
MAX_NAME_LENGTH = 40
_NAME_PATTERN = re.compile(r"[\w'′″-]*\w[\w'′″-]*")


class Reader:
    """Reads nodes of one file with one set of parameters."""

    def __init__(self, file: str, parameters: NumbersByName | None = None) -> None:
        self.file = file
        self.parameters: NumbersByName = parameters or {}
        self.taken: set[str] = set()  # names of points, in Latin letters
        self.written = WrittenNumbers()

    def error(self, phrase: Told, where: Node | int) -> SceneError:
        """An error at a node or a line."""
        return SceneError(phrase, self.file, where if isinstance(where, int) else where.line)

    def error_by_key(self, key: str, where: Node | int, /, **parts: object) -> SceneError:
        """The same in the words of a key."""
        return self.error(Phrase(key, **parts), where)

    def read_table(self, node: Node, what: Told, keys: Sequence[str] | None = None) -> SourceTable:
        """The node as a table; its keys must be among ``keys`` if those are given."""
        if not isinstance(node, SourceTable):
            raise self.error_by_key("table_needed", node, what=what, kind=kind_of_node_in_words(node))
        for key in node.entries if keys is not None else ():
            if key not in (keys or ()):
                self.check_colon(node, key, keys or ())
                valid = list_valid_choices(key, keys or ())
                raise self.error_by_key("no_key", node.lines[key], what=what, key=quoted_excerpt(key), valid=valid)
        return node

    def check_colon(self, table: SourceTable, key: str, names: Iterable[str]) -> None:
        """In {phi 30} the colon is forgotten, in {phi:30} the space after it, and all of it is a key."""
        first, sign, rest = [*re.split("([ :])", key, maxsplit=1), "", ""][:3]
        value = table.entries[key]
        if rest and first in names and isinstance(value, SourceScalar) and value.is_blank:
            forgotten = Phrase("colon_after", key=quoted_excerpt(first), text=quoted_excerpt(key))
            raise self.error(Phrase("colon_space", key=first) if sign == ":" else forgotten, table.lines[key])

    def read_table_of_names(self, node: Node, what: Told, kind: Phrase) -> SourceTable:
        """The node as a table whose keys are names of a ``kind``: "a point"."""
        table = self.read_table(node, what)
        for key, line in table.lines.items():
            self.check_name(key, kind, line)
        return table

    def check_name(self, name: str, kind: Phrase, where: Node | int) -> str:
        """The name itself, if it is well formed."""
        if len(name) > MAX_NAME_LENGTH:
            raise self.error_by_key("long_name", where, name=quoted_excerpt(name), of=kind, most=MAX_NAME_LENGTH)
        if not _NAME_PATTERN.fullmatch(name):
            raise self.error_by_key("bad_name", where, name=quoted_excerpt(name), of=kind)
        return name

    def read_list(self, node: Node, what: Told) -> list[Node]:
        """The node as a list."""
        if not isinstance(node, Items):
            raise self.error_by_key("list_needed", node, what=what, kind=kind_of_node_in_words(node))
        return node.items

    def read_text(self, node: Node, what: Told) -> str:
        """The node as a non-empty text."""
        if not isinstance(node, SourceScalar):
            raise self.error_by_key("word_needed", node, what=what, kind=kind_of_node_in_words(node))
        if node.is_blank:
            raise self.error_by_key("no_value", node, what=what)
        return node.text

    def read_word(self, node: Node, what: Told, words: Sequence[str]) -> str:
        """The node as one of a few words."""
        text = self.read_text(node, what)
        if text not in words:
            raise self.error_by_key(
                "bad_word", node, what=what, word=quoted_excerpt(text), valid=list_valid_choices(text, words)
            )
        return text

    def read_known_name(self, node: Node, what: Told, names: Iterable[str], kind: Phrase) -> str:
        """The node as a defined name of a ``kind``: "point"."""
        text = self.read_text(node, what)
        if text not in (names if isinstance(names, Mapping) else (names := list(names))):
            valid = self.valid_names_in_words(text, names)
            raise self.error_by_key("unknown_name", node, what=what, of=kind, name=quoted_excerpt(text), valid=valid)
        return text

    def valid_names_in_words(self, given: str, names: Iterable[str]) -> Told:
        """Words with the valid names, or that there are none."""
        return list_valid_choices(given, names) or Phrase("none_defined")

    def read_number(self, node: Node, what: Told) -> float:
        """The finite value of a number or an expression."""
        if not isinstance(node, SourceScalar):
            hint = Phrase("decimal_fraction") if isinstance(node, Items) and _has_decimal_comma(node) else ""
            raise self.error_by_key("number_needed", node, what=what, kind=kind_of_node_in_words(node), hint=hint)
        if node.is_blank:
            raise self.error_by_key("no_value", node, what=what)
        try:
            value = evaluate_expression(node.text, self.parameters)
        except ExpressionError as error:
            raise self.error_by_key("about", node, what=what, why=error.phrase) from None
        if abs(value) > LARGEST_SCENE_NUMBER:
            raise self.error_by_key("out_of_range", node, what=what, value=value, most=LARGEST_SCENE_NUMBER)
        if node.text not in self.parameters:
            self.written.remember_number_text(value, node.text)
        return value

    def read_non_negative(self, node: Node, what: Told) -> float:
        """A number that is not negative."""
        value = self.read_number(node, what)
        if value < 0.0:
            raise self.error_by_key("negative", node, what=what, value=value)
        return value

    def non_empty_values(self, table: SourceTable) -> dict[str, Node]:
        """The non-empty values of a table."""
        return {key: node for key, node in table.entries.items() if not has_no_value(node)}

    def read_place(self, node: Node, what: Told, on_axis: bool = False) -> complex:
        """A place as [x, y] or {r, angle}; with ``on_axis`` also as a number along the x axis."""
        if isinstance(node, Items):
            return self._read_pair(node, what)
        if isinstance(node, SourceTable):
            polar = Fields(self, node, what, ("r", "angle"))
            radius = polar.read_non_negative("r")
            angle = polar.number_if_given("angle") or 0.0
            return self.written.remember_polar_place(
                complex(radius * cos_deg(angle), radius * sin_deg(angle)), radius, angle
            )
        if not on_axis:
            raise self.error_by_key("place_needed", node, what=what, given=quoted_excerpt(node.text))
        return complex(self.read_number(node, what), 0.0)

    def _read_pair(self, node: Items, what: Told) -> complex:
        if len(node.items) != 2:
            hint = Phrase("decimal_no_comma") if _has_decimal_comma(node) else ""
            raise self.error_by_key("pair_needed", node, what=what, count=len(node.items), hint=hint)
        x, y = (self.read_number(item, part_in_words(axis, what)) for axis, item in zip("xy", node.items, strict=True))
        return self.written.remember_polar_place(complex(x, y))


class Fields:
    """The values under the keys of one table, each with its error messages; ``what`` is the owner of the keys."""

    def __init__(self, reader: Reader, node: Node, what: Told, keys: Sequence[str] | None = None) -> None:
        self.reader = reader
        self.what = what
        self.table = reader.read_table(node, what, keys)

    def __contains__(self, key: str) -> bool:
        return key in self.table.entries

    def error(self, phrase: Told, key: str = "") -> SceneError:
        """An error at a key, or at the table."""
        return self.reader.error(phrase, self.table.lines.get(key, self.table.line))

    def error_by_key(self, words: str, key: str = "", /, **parts: object) -> SceneError:
        """The same in the words of a key of the table."""
        return self.error(Phrase(words, **parts), key)

    def phrase_of_key(self, key: str) -> Phrase:
        """The value under a key, as a sentence names it."""
        return part_in_words(key, self.what)

    def optional_node(self, key: str) -> Node | None:
        """The value of a key, or None when it is missing or empty."""
        node = self.table.entries.get(key)
        return None if node is None or has_no_value(node) else node

    def required_node(self, key: str) -> Node:
        """The value of a required key."""
        if key not in self:
            raise self.error_by_key("needs_key", what=self.what, key=key)
        if has_no_value(self.table.entries[key]):
            raise self.error_by_key("no_value", key, what=self.phrase_of_key(key))
        return self.table.entries[key]

    def require_one_key(self, *keys: str) -> str:
        """Which one of these keys the table has: exactly one is required."""
        given = [key for key in keys if key in self]
        if len(given) == 1:
            return given[0]
        if given:
            raise self.error_by_key("both_keys", given[1], what=self.what, one=given[0], two=given[1])
        raise self.error_by_key("needs_one_key", what=self.what, keys=keys)

    def inner_fields(self, key: str, keys: Sequence[str] | None = None) -> Self:
        """The table under a key."""
        return type(self)(self.reader, self.required_node(key), self.phrase_of_key(key), keys)

    def read_number(self, key: str, usual: float | None = None) -> float:
        """A number; ``usual`` where none is given."""
        if usual is not None and self.optional_node(key) is None:
            return usual
        return self.reader.read_number(self.required_node(key), self.phrase_of_key(key))

    def number_if_given(self, key: str) -> float | None:
        """A number, or None."""
        if self.optional_node(key) is None:
            return None
        return self.read_number(key)

    def read_non_negative(self, key: str, usual: float | None = None) -> float:
        """A number that is not negative; ``usual`` where none is given."""
        if usual is not None and self.optional_node(key) is None:
            return usual
        return self.reader.read_non_negative(self.required_node(key), self.phrase_of_key(key))

    def read_place(self, key: str) -> complex:
        """A place."""
        return self.reader.read_place(self.required_node(key), self.phrase_of_key(key))

    def read_text(self, key: str) -> str:
        """A text that is not empty."""
        return self.reader.read_text(self.required_node(key), self.phrase_of_key(key))

    def read_word(self, key: str, words: Sequence[str]) -> str:
        """One of a few words."""
        return self.reader.read_word(self.required_node(key), self.phrase_of_key(key), words)

    def read_known_name(self, key: str, names: Iterable[str], kind: Phrase) -> str:
        """A defined name."""
        return self.reader.read_known_name(self.required_node(key), self.phrase_of_key(key), names, kind)


def has_no_value(node: Node) -> bool:
    """Whether the key has no value."""
    return isinstance(node, SourceScalar) and node.is_blank


def _has_decimal_comma(node: Items) -> bool:
    """Whether decimal commas broke a list: digits right after a comma, in "0,5" or "[0,1, 0,2]"."""
    glued = [isinstance(item, SourceScalar) and item.glued and item.text.isdigit() for item in node.items]
    return any(glued) and (len(glued) == 2 or not all(glued[1:]))


def part_in_words(key: str, what: Told) -> Phrase:
    """A part of an object in words: "mass of link 2"."""
    return Phrase("part", key=key, what=what)


def section_in_words(name: str) -> Phrase:
    """A key of the scene as the owner of its keys: "omega of drive"."""
    return Phrase("section", name=name)


def kind_of_node_in_words(node: Node) -> Told:
    """The type of a node, in words."""
    if isinstance(node, SourceTable):
        return Phrase("a_table")
    if isinstance(node, Items):
        return Phrase("a_list")
    if node.is_blank:
        return Phrase("empty")
    return quoted_excerpt(node.text)
