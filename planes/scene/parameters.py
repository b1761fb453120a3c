"""Parameters of a scene: their values, which may be expressions of one another, and the variants that override them."""

from __future__ import annotations

from collections.abc import Mapping

from planes.scene.expressions import RESERVED, evaluate, is_name, names_in
from planes.scene.reader import MAX_NAME, Reader, part
from planes.scene.source import Node, SourceScalar, SourceTable
from planes.words import Phrase
from planes.words.errors import ExpressionError, choices, shown


def read_parameters(reader: Reader, node: Node | None, chosen: SourceTable | None) -> dict[str, float]:
    """Values of the parameters in the order of the file, those of the chosen variant in place of their own."""
    if node is None:
        return {}
    table = reader.table(node, "parameters")
    for name, line in table.lines.items():
        _check_parameter(reader, name, line)
    entries = {**table.entries, **(chosen.entries if chosen else {})}
    texts = {name: _scalar(reader, entry, Phrase("parameter", name=name)) for name, entry in entries.items()}
    try:
        return resolve(texts)
    except ExpressionError as error:
        what = Phrase("parameter", name=error.parameter)
        raise reader.error(Phrase("about", what=what, why=error.phrase), entries[error.parameter]) from None


def with_numbers(
    reader: Reader, node: Node | None, chosen: SourceTable | None, numbers: Mapping[str, float]
) -> SourceTable:
    """The chosen variant with numbers put in the place of parameters by whoever runs the program."""
    known = node.entries if isinstance(node, SourceTable) else {}
    for name in numbers:
        if name not in known:
            valid = reader.offer(name, known, Phrase("parameters_all"))
            raise reader.error(Phrase("parameter_unknown", name=shown(name), valid=valid), node or 1)
    line = node.line if node else 1
    given: dict[str, Node] = {name: SourceScalar(repr(float(value)), line) for name, value in numbers.items()}
    return SourceTable({**(chosen.entries if chosen else {}), **given}, line)


def _check_parameter(reader: Reader, name: str, line: int) -> None:
    if name in RESERVED:
        raise reader.error(Phrase("reserved_parameter", name=name), line)
    if len(name) > MAX_NAME or not is_name(name):
        raise reader.error(Phrase("bad_parameter", name=shown(name), most=MAX_NAME), line)


def _scalar(reader: Reader, node: Node, what: Phrase) -> str:
    if isinstance(node, SourceScalar) and not node.absent:
        return node.text
    reader.number(node, what)
    raise reader.error(Phrase("only_number", what=what), node)


def read_variants(reader: Reader, node: Node | None, parameters: Node | None) -> dict[str, SourceTable]:
    """The variants by name, each a table that overrides parameters."""
    if node is None:
        return {}
    known = parameters.entries if isinstance(parameters, SourceTable) else {}
    variants = reader.names(node, "variants", Phrase("a_variant"))
    tables: dict[str, SourceTable] = {}
    for name, entry in variants.entries.items():
        what, absent = Phrase("variant", name=name), isinstance(entry, SourceScalar) and entry.absent
        table = SourceTable({}, entry.line) if absent else reader.table(entry, what)
        for key, line in table.lines.items():
            if key not in known:
                valid = reader.offer(key, known, Phrase("parameters_all"))
                raise reader.error(Phrase("no_parameter", name=name, key=shown(key), valid=valid), line)
            _scalar(reader, table.entries[key], part(key, what))
        tables[name] = table
    return tables


def choose(reader: Reader, variants: Mapping[str, SourceTable], variant: str | None, line: int) -> SourceTable | None:
    """The table of the asked variant."""
    if variant is None or variant in variants:
        return None if variant is None else variants[variant]
    valid = choices(variant, variants) or Phrase("no_variants")
    raise reader.error(Phrase("no_variant", name=shown(variant), valid=valid), line)


def resolve(texts: Mapping[str, str]) -> dict[str, float]:
    """Values of parameters that may be expressions of one another, in the order given.

    An error carries the parameter it arose in, as ``parameter``; a cycle is refused with its names.
    """
    values: dict[str, float] = {}
    for start in texts:
        _resolve_from(start, texts, values)
    return {name: values[name] for name in texts}


def _resolve_from(start: str, texts: Mapping[str, str], values: dict[str, float]) -> None:
    path: dict[str, list[str]] = {}
    current: str | None = None if start in values else start
    while current is not None:
        try:
            if current not in path:
                path[current] = [name for name in names_in(texts[current]) if name in texts]
            todo = next((name for name in path[current] if name not in values), None)
            if todo in path:
                raise ExpressionError(_cycle(list(path), str(todo)))
            if todo is None:
                values[current] = evaluate(texts[current], values, texts)
                path.popitem()
        except ExpressionError as error:
            raise ExpressionError(error.phrase, current) from None
        current = todo if todo is not None else next(reversed(path), None)


def _cycle(path: list[str], name: str) -> Phrase:
    loop = [*path[path.index(name) :], name]
    words = loop if len(loop) <= 8 else [*loop[:6], "…", name]
    return Phrase("circle_of_one", name=name) if len(loop) == 2 else Phrase("circle", names=tuple(words))
