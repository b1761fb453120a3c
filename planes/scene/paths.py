"""Paths down the tree of a file: the nodes beneath a node, each with its path of keys and its line."""

from collections.abc import Iterator

from planes.scene.source import Items, Node, Nodes, SourceScalar, SourceTable, walk_nodes
from planes.words.names import NameTuple

Keys = NameTuple


def entries_of_table(node: Node | None) -> Nodes:
    """The entries of a table; empty where the node is not a table."""
    return node.entries if isinstance(node, SourceTable) else {}


def texts_with_paths(node: Node) -> Iterator[tuple[Keys, SourceScalar]]:
    """All texts beneath a node, each with its path."""
    return ((path, one) for path, one, _ in walk_nodes(node) if isinstance(one, SourceScalar))


def line_of_path(table: SourceTable, path: Keys) -> int:
    """The line of the deepest existing key of a path."""
    return [table.line, *(line for _, line in nodes_along_path(table, path))][-1]


def nodes_along_path(node: Node, path: Keys) -> Iterator[tuple[Node, int]]:
    """The nodes along a path, each with the line of its key; missing keys are left out."""
    for key in path:
        if isinstance(node, Items):
            node = node.items[int(key)]
            yield node, node.line
        elif isinstance(node, SourceTable) and key in node.entries:
            line = node.lines[key]
            node = node.entries[key]
            yield node, line
