"""A scene written as the text of a file."""

import math
from collections.abc import Container, Mapping, Sequence
from contextlib import suppress
from typing import Any

import yaml

from planes.scene.paths import entries_of_table
from planes.scene.source import Nodes, SourceScalar, SourceTable, parse_yaml


class _Lines(yaml.SafeDumper):
    """Outer tables on separate lines, all below them on one line."""


_Lines.add_representer(complex, lambda dumper, z: dumper.represent_sequence("tag:yaml.org,2002:seq", [z.real, z.imag]))


def scene_file_text(parts: Mapping[str, object]) -> str:
    """The text of a file with these parts, each as originally written if that was kept."""
    return "".join(_yaml_part_text(key, _node_as_written(value)) for key, value in parts.items())


def scene_text_with_numbers(
    text: str, file: str, variant: str | None, numbers: Mapping[str, str], sheet: Nodes, without: Container[str] = ()
) -> str:
    """The scene with the numbers of a variant, then ``numbers``, in its parameters; ``sheet`` joins its own. Keys it
    is to be ``without`` are left out, those of its sheet too."""
    entries = {key: node for key, node in parse_yaml(text, file).entries.items() if key not in without}
    variants = entries.pop("variants", None)
    if isinstance(parameters := entries.get("parameters"), SourceTable):
        more = entries_of_table(entries_of_table(variants).get(variant or ""))
        drawn = {name: SourceScalar(value, 0) for name, value in numbers.items()}
        entries["parameters"] = SourceTable({**parameters.entries, **more, **drawn}, 0)
    if sheet:
        entries["sheet"] = SourceTable({**entries_of_table(entries.get("sheet")), **sheet}, 0)
    if kept := {key: node for key, node in entries_of_table(entries.get("sheet")).items() if key not in without}:
        entries["sheet"] = SourceTable(kept, 0)
    else:
        entries.pop("sheet", None)
    return scene_file_text(entries)


def _yaml_part_text(key: str, value: object) -> str:
    flow = None if isinstance(value, dict | list) else False
    return yaml.dump(
        {key: value}, Dumper=_Lines, allow_unicode=True, sort_keys=False, width=110, default_flow_style=flow
    )


def _node_as_written(node: Any) -> object:
    """A part of the scene as it was written; of anything else plain tables, lists, texts and numbers, whichever
    library they come from."""
    if isinstance(node, SourceScalar):
        return _scalar_value(node)
    if isinstance(node, SourceTable | Mapping):
        entries = node.entries if isinstance(node, SourceTable) else node
        return {key: _node_as_written(one) for key, one in entries.items()}
    plain = node.tolist() if hasattr(node, "tolist") else getattr(node, "items", node)
    if plain is None or isinstance(plain, str | int | complex):
        return plain
    if isinstance(plain, Sequence):
        return [_node_as_written(one) for one in plain]
    number = float(plain) if hasattr(plain, "__float__") else math.nan
    return number if math.isfinite(number) else str(plain)


def _scalar_value(node: SourceScalar) -> object:
    for kind in (int, float) if node.plain else ():
        with suppress(ValueError):
            return kind(node.text)
    return None if node.is_blank else node.text
