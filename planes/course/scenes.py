"""A student's own scene: the assignment's, with other numbers in its parameters, written as a file anew."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping

from planes.scene.reader import entries_of
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.scene.source import parse as parse_text

_PLAIN = re.compile(r"[\w+−*/()^. -]*[\w)]|[+-]?[\d.]+")
WIDTH = 110  # a table that fits stands on one line


def own_scene(text: str, file: str, variant: str | None, numbers: Mapping[str, str], sheet: Mapping[str, Node]) -> str:
    """The scene with the numbers of a variant, then ``numbers``, in its parameters; ``sheet`` joins its own."""
    table = parse_text(text, file)
    entries = dict(table.entries)
    variants = entries.pop("variants", None)
    if isinstance(parameters := entries.get("parameters"), SourceTable):
        more = entries_of(entries_of(variants).get(variant or ""))
        drawn = {name: SourceScalar(value, 0) for name, value in numbers.items()}
        entries["parameters"] = SourceTable({**parameters.entries, **more, **drawn}, 0)
    if sheet:
        entries["sheet"] = SourceTable({**entries_of(entries.get("sheet")), **sheet}, 0)
    return "".join(f"{key}:{_block(value, 0, len(key))}\n" for key, value in entries.items())


def _block(node: Node, depth: int, used: int) -> str:
    """A node after its key: on the same line if it fits, else a line for each entry."""
    flow = _flow(node)
    if not isinstance(node, SourceTable) or not node.entries or used + len(flow) + 2 * depth <= WIDTH or depth > 2:
        return f" {flow}"
    pad = "\n" + "  " * (depth + 1)
    return "".join(f"{pad}{_word(k)}:{_block(v, depth + 1, len(k))}" for k, v in node.entries.items())


def _flow(node: Node) -> str:
    if isinstance(node, SourceTable):
        return "{" + ", ".join(f"{_word(k)}: {_flow(v)}" for k, v in node.entries.items()) + "}"
    if isinstance(node, Items):
        return "[" + ", ".join(map(_flow, node.items)) + "]"
    return ("~" if node.absent else _word(node.text)) if node.plain else _quoted(node.text)


def _word(text: str) -> str:
    return text if _PLAIN.fullmatch(text) else _quoted(text)


def _quoted(text: str) -> str:
    return json.dumps(text, ensure_ascii=False)


def used_names(text: str, file: str) -> tuple[str, ...]:
    """The parameters a scene's mechanism is made of, directly or through one another."""
    table = parse_text(text, file)
    own = entries_of(table.entries.get("parameters"))
    found = {n for key, node in table.entries.items() if key not in _WORDS for n in _names(node)} & own.keys()
    todo = list(found)
    while todo:
        more = set(_names(own[todo.pop()])) & own.keys() - found
        found |= more
        todo += more
    return tuple(n for n in own if n in found)


_WORDS = ("parameters", "variants", "title", "note", "text", "missing", "sheet")
_NAME = re.compile(r"[^\W\d][\w'′″]*")


def _names(node: Node) -> Iterator[str]:
    """Every word that could name a parameter."""
    if isinstance(node, SourceScalar):
        yield from _NAME.findall(node.text)
    for inner in node.items if isinstance(node, Items) else entries_of(node).values():
        yield from _names(inner)
