"""A scene without a mechanism: vectors of which something is given, and the equations that tie them."""

from __future__ import annotations

import re
from dataclasses import dataclass

from planes.scene.reader import MAX_NAME, Reader, part
from planes.scene.source import Node, SourceScalar
from planes.words import Phrase
from planes.words.errors import shown

_KEYS = ("value", "direction", "perpendicular_to", "near")
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
    table = reader.table(node, what, _KEYS)
    if "direction" in table.entries and "perpendicular_to" in table.entries:
        reader.one_of(table, ("direction", "perpendicular_to"), what)
    given = {
        key: None if (entry := reader.optional(table, key)) is None else reader.number(entry, part(key, what))
        for key in _KEYS
    }
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
