"""Ways down the tree of a file: what stands beneath a node, with its path of keys and its line."""

from collections.abc import Iterator, Mapping

from planes.scene.source import Items, Node, SourceScalar, SourceTable, walk

Keys = tuple[str, ...]


def entries_of(node: Node | None) -> Mapping[str, Node]:
    """What a table holds; nothing where the node is no table."""
    return node.entries if isinstance(node, SourceTable) else {}


def texts(node: Node) -> Iterator[tuple[Keys, SourceScalar]]:
    """Every text beneath a node with its path."""
    return ((path, one) for path, one, _ in walk(node) if isinstance(one, SourceScalar))


def line_of(table: SourceTable, path: Keys) -> int:
    """The line of the deepest key of a path that is there."""
    return [table.line, *(line for _, line in down(table, path))][-1]


def down(node: Node, path: Keys) -> Iterator[tuple[Node, int]]:
    """What is met on the way down a path, each with its line, that of its key; a key that is not there is left out."""
    for key in path:
        if isinstance(node, Items):
            node = node.items[int(key)]
            yield node, node.line
        elif isinstance(node, SourceTable) and key in node.entries:
            line, node = node.lines[key], node.entries[key]
            yield node, line
