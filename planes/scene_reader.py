"""How any value of a scene is read: numbers, names, places, tables with known keys, each with its refusal."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from planes.degrees import cos_deg, sin_deg
from planes.expressions import evaluate
from planes.source import Items, Node, Table, Text
from planes.wording import ExpressionError, SceneError, choices, shown

MAX_NAME = 40
_NAME = re.compile(r"[\w'′″-]*\w[\w'′″-]*")


class Reader:
    """Reads nodes of one file with one set of parameters."""

    def __init__(self, file: str, parameters: Mapping[str, float] | None = None) -> None:
        self.file = file
        self.parameters: Mapping[str, float] = parameters or {}

    def error(self, sentence: str, where: Node | int) -> SceneError:
        """A refusal at a node or a line."""
        return SceneError(sentence, self.file, where if isinstance(where, int) else where.line)

    def table(self, node: Node, what: str, keys: Sequence[str] | None = None) -> Table:
        """The node as a table, all of whose keys are among ``keys`` if those are given."""
        if not isinstance(node, Table):
            raise self.error(f"{what} must be a table of 'key: value', not {kind(node)}", node)
        for key in node.entries if keys is not None else ():
            if key not in (keys or ()):
                raise self.error(f"{what} has no key {shown(key)}{choices(key, keys or ())}", node.lines[key])
        return node

    def names(self, node: Node, what: str, of: str) -> Table:
        """The node as a table whose keys are names; ``of`` says of what: "a point"."""
        table = self.table(node, what)
        for key, line in table.lines.items():
            self.check_name(key, of, line)
        return table

    def check_name(self, name: str, of: str, where: Node | int) -> str:
        """The name itself, if it is made as names are."""
        if len(name) > MAX_NAME:
            raise self.error(f"the name {shown(name)} of {of} is longer than {MAX_NAME} characters", where)
        if not _NAME.fullmatch(name):
            raise self.error(f"{shown(name)} cannot be the name of {of}; "
                             "valid are letters of any alphabet, digits, _ - and ' without spaces", where)
        return name

    def items(self, node: Node, what: str) -> list[Node]:
        """The node as a list."""
        if not isinstance(node, Items):
            raise self.error(f"{what} must be a list, not {kind(node)}", node)
        return node.items

    def text(self, node: Node, what: str) -> str:
        """The node as a text that is not empty."""
        if not isinstance(node, Text):
            raise self.error(f"{what} must be a word, not {kind(node)}", node)
        if node.absent:
            raise self.error(f"{what} has no value", node)
        return node.text

    def word(self, node: Node, what: str, words: Sequence[str]) -> str:
        """The node as one of a few words."""
        text = self.text(node, what)
        if text not in words:
            raise self.error(f"{what} cannot be {shown(text)}{choices(text, words)}", node)
        return text

    def known(self, node: Node, what: str, names: Iterable[str], of: str) -> str:
        """The node as a name that is defined; ``of`` says what kind of thing: "point"."""
        text = self.text(node, what)
        if text not in (names if isinstance(names, Mapping) else (names := list(names))):
            raise self.error(f"{what}: there is no {of} {shown(text)}{self.offer(text, names, of)}", node)
        return text

    def offer(self, given: str, names: Iterable[str], of: str) -> str:
        """Words with the valid names, or that there are none."""
        return choices(given, names) or f"; no {of} is defined there"

    def number(self, node: Node, what: str) -> float:
        """The finite value of a number or an expression."""
        if not isinstance(node, Text):
            comma = isinstance(node, Items) and len(node.items) == 2
            raise self.error(f"{what} must be a number, not {kind(node)}"
                             + ("; a decimal fraction is written with a point" if comma else ""), node)
        if node.absent:
            raise self.error(f"{what} has no value", node)
        try:
            return evaluate(node.text, self.parameters)
        except ExpressionError as error:
            raise self.error(f"{what}: {error.sentence}", node) from None

    def positive(self, node: Node, what: str) -> float:
        """A number that is not negative."""
        value = self.number(node, what)
        if value < 0.0:
            raise self.error(f"{what} cannot be negative, but is {value:g}", node)
        return value

    def optional(self, table: Table, key: str) -> Node | None:
        """The value of a key, or None when it is missing or empty."""
        node = table.entries.get(key)
        return None if isinstance(node, Text) and node.absent else node

    def required(self, table: Table, key: str, what: str) -> Node:
        """The value of a key that must be there."""
        node = table.entries.get(key)
        if node is None:
            raise self.error(f"{what} needs the key {key}", table)
        if isinstance(node, Text) and node.absent:
            raise self.error(f"{key} of {what} has no value", table.lines[key])
        return node

    def one_of(self, table: Table, keys: Sequence[str], what: str) -> str:
        """Which one of these keys the table has: exactly one must be there."""
        given = [key for key in keys if key in table.entries]
        if len(given) == 1:
            return given[0]
        if given:
            raise self.error(f"{what} has both {given[0]} and {given[1]}; write one of them",
                             table.lines[given[1]])
        raise self.error(f"{what} needs one of the keys {', '.join(keys)}", table)

    def place(self, node: Node, what: str, on_axis: bool = False) -> complex:
        """A place as [x, y] or {r, angle}; with ``on_axis`` also as a number along the x axis."""
        if isinstance(node, Items):
            return self._pair(node, what)
        if isinstance(node, Table):
            table = self.table(node, what, ("r", "angle"))
            radius = self.number(self.required(table, "r", what), f"r of {what}")
            angle = self.angle(table, what) or 0.0
            return complex(radius * cos_deg(angle), radius * sin_deg(angle))
        if not on_axis:
            raise self.error(f"{what} must be [x, y] or {{r: ..., angle: ...}}, not {shown(node.text)}", node)
        return complex(self.number(node, what), 0.0)

    def angle(self, table: Table, what: str) -> float | None:
        """The number under the key angle, or None."""
        node = self.optional(table, "angle")
        return None if node is None else self.number(node, f"angle of {what}")

    def _pair(self, node: Items, what: str) -> complex:
        if len(node.items) != 2:
            hint = "; a decimal fraction is written with a point, not a comma" if len(node.items) > 2 else ""
            raise self.error(f"{what} must be [x, y], two numbers, not {len(node.items)}{hint}", node)
        return complex(self.number(node.items[0], f"x of {what}"), self.number(node.items[1], f"y of {what}"))


def kind(node: Node) -> str:
    """What a node is, in words."""
    if isinstance(node, Table):
        return "a table"
    return "a list" if isinstance(node, Items) else ("empty" if node.absent else shown(node.text))
