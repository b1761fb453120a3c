"""A scene's text with one part changed and the rest as written: comments, order, line breaks."""

from collections.abc import Sequence
from functools import lru_cache

import yaml

from planes.scene.source import parse_yaml
from planes.words.frozen import frozen

Path = Sequence[str]
SCENE_FILE_NAME = "scene.yaml"


@frozen
class Edited:
    """The text after a change, and the changed lines, from 1."""

    text: str
    lines: tuple[int, ...] = ()

    def with_value(self, path: Path, value: str) -> "Edited":
        """The text with a value at a path of keys (numbers in lists); missing keys are added."""
        node, depth = _node_at_path(self.text, path)
        if depth == len(path):
            start = node.start_mark
            return self._with_replaced_span(start.index, _node_end(node).index, value, start.line)
        return self._with_key(node, path[depth], _nested_text(path[depth + 1 :], value))

    def with_item(self, path: Path, value: str) -> "Edited":
        """The text with one more item in the list at a path, which is created if it is missing."""
        node, depth = _node_at_path(self.text, path)
        if depth < len(path):
            return self.with_value(path, f"[{value}]")
        if isinstance(node, yaml.SequenceNode) and node.flow_style is False and node.value:
            first = node.value[0].start_mark
            last = _node_end(node.value[-1])
            at = self._line_end(last.index)
            return self._with_replaced_span(at, at, f"\n{' ' * (first.column - 2)}- {value}", last.line + 1)
        at = node.end_mark.index - 1
        return self._with_replaced_span(at, at, f", {value}" if node.value else value, node.end_mark.line)

    def without_key(self, path: Path) -> "Edited":
        """The text without a key and its value, or an item of a list; unchanged if it is missing."""
        parent, depth = _node_at_path(self.text, path[:-1])
        if depth < len(path) - 1 or not isinstance(parent, yaml.CollectionNode):
            return self
        parts = [p if isinstance(p, tuple) else (p, p) for p in parent.value]
        keys = (
            [p[0].value for p in parts] if isinstance(parent, yaml.MappingNode) else list(map(str, range(len(parts))))
        )
        if path[-1] not in keys:
            return self
        k = keys.index(path[-1])
        if len(parts) == 1:
            if len(path) > 1:
                return self.without_key(path[:-1])
            return Edited("", (1,))
        start = parts[k][0].start_mark
        end = parts[k][1].end_mark
        if not parent.flow_style:
            begin = self.text.rfind("\n", 0, start.index) + 1
            last = self._line_end(_node_end(parts[k][1]).index)
            return self._with_replaced_span(begin, min(last + 1, len(self.text)), "", start.line)
        if k + 1 < len(parts):
            return self._with_replaced_span(start.index, parts[k + 1][0].start_mark.index, "", start.line)
        return self._with_replaced_span(parts[k - 1][1].end_mark.index, end.index, "", start.line)

    def with_renamed_key(self, path: Path, name: str) -> "Edited":
        """The text with another name of the last key of a path, which is there."""
        node, _ = _node_at_path(self.text, path[:-1])
        key = next(k for k, _ in node.value if k.value == path[-1])
        return self._with_replaced_span(key.start_mark.index, key.end_mark.index, name, key.start_mark.line)

    def _with_key(self, node: yaml.Node, key: str, value: str) -> "Edited":
        """The text with one more key in a mapping; an empty node, or one that is no mapping, becomes one."""
        if node.start_mark is None:  # the text is empty
            return Edited(f"{key}: {value}\n", (1,))
        if not isinstance(node, yaml.MappingNode) or not node.value:
            start = node.start_mark.index
            end = node.end_mark.index
            line = self.text[self.text.rfind("\n", 0, start) + 1 : start]
            if line[:1].strip():  # a top-level value: a line for each of its keys
                return self._with_replaced_span(
                    start - (line[-1:] == " "), end, f"\n  {key}: {value}", node.start_mark.line + 1
                )
            space = " " * (self.text[start - 1 : start] not in ("", " ", "\n"))
            return self._with_replaced_span(start, end, f"{space}{{{key}: {value}}}", node.start_mark.line)
        if node.flow_style:
            end = node.end_mark
            return self._with_replaced_span(end.index - 1, end.index - 1, f", {key}: {value}", end.line)
        last = _node_end(node.value[-1][1])
        at = self._line_end(last.index)
        indent = " " * node.value[0][0].start_mark.column
        return self._with_replaced_span(at, at, f"\n{indent}{key}: {value}", self.text.count("\n", 0, at) + 1)

    def _line_end(self, at: int) -> int:
        end = self.text.find("\n", at)
        return len(self.text) if end < 0 else end

    def _with_replaced_span(self, start: int, end: int, value: str, line: int) -> "Edited":
        text = self.text[:start] + value + self.text[end:]
        return Edited(text, tuple(sorted({*self.lines, line + 1})))


@lru_cache(maxsize=2)  # many changes are tried on one text
def _yaml_tree(text: str) -> yaml.Node:
    """The text as nodes with positions; an empty text is an empty mapping."""
    if text.strip():
        parse_yaml(text, SCENE_FILE_NAME)  # refuses in words a file that is not a plain document
    node: yaml.Node | None = yaml.compose(text, yaml.SafeLoader)
    return node or yaml.MappingNode("tag:yaml.org,2002:map", [])


def _node_at_path(text: str, path: Path) -> tuple[yaml.Node, int]:
    """The node at a path as far as it exists, and the number of keys that lead to it."""
    node = _yaml_tree(text)
    for depth, key in enumerate(path):
        if isinstance(node, yaml.MappingNode):
            inner = next((value for k, value in node.value if k.value == key), None)
        else:
            items = node.value if isinstance(node, yaml.SequenceNode) else []
            inner = items[int(key)] if key.isdigit() and int(key) < len(items) else None
        if inner is None:
            return node, depth
        node = inner
    return node, len(path)


def _node_end(node: yaml.Node) -> yaml.Mark:
    """The end of a node's last item: a block's own end is the beginning of the next part."""
    while isinstance(node, yaml.CollectionNode) and not node.flow_style and node.value:
        last = node.value[-1]
        node = last[1] if isinstance(last, tuple) else last
    return node.end_mark


def _nested_text(keys: Path, value: str) -> str:
    if not keys:
        return value
    return f"{{{keys[0]}: {_nested_text(keys[1:], value)}}}"
