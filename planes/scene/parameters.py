"""Parameters of a scene: their values, which may be expressions of one another, and the variants that override them.

Numbers that share a parameter with the drive's position are valid at that position alone: with ``phi: phi_1`` a force
of 3000*sin(phi_1) is calculated once, and would not change as the drive moves.
"""

import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from planes.scene.expressions import RESERVED_NAMES, evaluate_expression, is_parameter_name, names_in_expression
from planes.scene.mechanism import LOAD_NUMBER_KEYS, Law
from planes.scene.paths import Keys, entries_of_table, texts_with_paths
from planes.scene.reader import MAX_NAME_LENGTH, Reader, has_no_value, part_in_words
from planes.scene.source import Items, Node, Nodes, SourceScalar, SourceTable, parse_yaml
from planes.words import Phrase
from planes.words.errors import ExpressionError, PlanesError, list_valid_choices, quoted_excerpt
from planes.words.names import NumbersByName, with_latin_letters

LATIN_SPELLING_OF_VARIANTS = dict(zip("АБВГДЕ", "ABVGDE", strict=True))
"""Russian letters of variants, by their Latin spelling."""


def read_parameters(reader: Reader, node: Node | None, chosen: SourceTable | None) -> NumbersByName:
    """Values of the parameters in the order of the file; those of the chosen variant override them."""
    if node is None:
        return {}
    table = reader.read_table(node, "parameters")
    for name, line in table.lines.items():
        if name in RESERVED_NAMES:
            raise reader.error_by_key("reserved_parameter", line, name=name)
        if len(name) > MAX_NAME_LENGTH or not is_parameter_name(name):
            raise reader.error_by_key("bad_parameter", line, name=quoted_excerpt(name), most=MAX_NAME_LENGTH)
    entries = {**table.entries, **entries_of_table(chosen)}
    written = {name: _scalar_text(reader, entry, Phrase("parameter", name=name)) for name, entry in entries.items()}
    try:
        values = resolve_parameters(written)
    except ExpressionError as error:
        what = Phrase("parameter", name=error.parameter)
        raise reader.error_by_key("about", entries[error.parameter], what=what, why=error.phrase) from None
    for name, text in written.items():
        if text not in written:
            reader.written.remember_number_text(values[name], text)
    return values


def require_finite_numbers(value: Any, name: str, several: bool = True) -> Any:
    """A finite number, or, of ``several``, the numbers of a flat list or array; a :class:`PlanesError` says which
    argument, ``name``, is neither."""
    try:
        plain = value.tolist() if hasattr(value, "tolist") else value
        many = several and isinstance(plain, Iterable) and not isinstance(plain, str)
        numbers = [float(+one) for one in (plain if many else [plain])]  # a text has no sign
        if numbers and all(map(math.isfinite, numbers)):
            return numbers if many else numbers[0]
    except (TypeError, ValueError):
        pass
    key = "not_finite_numbers" if several else "not_finite_number"
    raise PlanesError(Phrase(key, name=name, given=quoted_excerpt(" ".join(repr(value).split()))))


def variant_with_numbers(
    reader: Reader, node: Node | None, chosen: SourceTable | None, numbers: NumbersByName
) -> SourceTable:
    """The chosen variant with the user's numbers for some parameters."""
    known = entries_of_table(node)
    for name in numbers:
        if name not in known:
            valid = reader.valid_names_in_words(name, known)
            raise reader.error_by_key("parameter_unknown", node or 1, name=quoted_excerpt(name), valid=valid)
    line = node.line if node else 1
    given = {
        name: SourceScalar(repr(require_finite_numbers(value, name, False)), line) for name, value in numbers.items()
    }
    return SourceTable({**entries_of_table(chosen), **given}, line)


def _scalar_text(reader: Reader, node: Node, what: Phrase) -> str:
    if isinstance(node, SourceScalar) and not node.is_blank:
        return node.text
    reader.read_number(node, what)
    raise reader.error_by_key("only_number", node, what=what)


def read_variants(reader: Reader, node: Node | None, parameters: Node | None) -> dict[str, SourceTable]:
    """The variants by name, each a table that overrides parameters."""
    if node is None:
        return {}
    known = entries_of_table(parameters)
    variants = reader.read_table_of_names(node, "variants", Phrase("a_variant"))
    tables = {}
    for name, entry in variants.entries.items():
        what = Phrase("variant", name=name)
        table = SourceTable({}, entry.line) if has_no_value(entry) else reader.read_table(entry, what)
        for key, line in table.lines.items():
            if key not in known:
                valid = reader.valid_names_in_words(key, known)
                raise reader.error_by_key("no_parameter", line, name=name, key=quoted_excerpt(key), valid=valid)
            _scalar_text(reader, table.entries[key], part_in_words(key, what))
        tables[name] = table
    return tables


def choose_variant(
    reader: Reader, variants: Mapping[str, SourceTable], variant: str | None, line: int
) -> tuple[str | None, SourceTable | None]:
    """The chosen variant by its name in the file, and its table."""
    if variant is None or variant in variants:
        return variant, None if variant is None else variants[variant]
    alike = variants_meant(variant, variants)
    if len(alike) == 1:
        return (name := next(iter(alike))), variants[name]
    if alike:
        names = tuple(f"{name} (--variant {number})" for name, number in alike.items())
        raise reader.error_by_key("variant_either", line, name=quoted_excerpt(variant), names=names)
    valid = list_valid_choices(variant, variants) or Phrase("no_variants")
    raise reader.error_by_key("no_variant", line, name=quoted_excerpt(variant), valid=valid)


def variants_meant(asked: str, variants: Iterable[str]) -> dict[str, int]:
    """The variants that a name not in the list may mean, with their numbers from 1: the number itself, a letter that
    looks the same in another alphabet, or the Latin spelling of one."""
    return {
        name: number
        for number, name in enumerate(variants, 1)
        if asked in (str(number), LATIN_SPELLING_OF_VARIANTS.get(name))
        or with_latin_letters(asked) == with_latin_letters(name)
    }


def resolve_parameters(written: Mapping[str, str]) -> NumbersByName:
    """Values of parameters that may be expressions of one another, in the order given.

    An error carries its parameter, as ``parameter``; a cycle is refused with its names.
    """
    values: dict[str, float] = {}
    for start in written:
        _resolve_from(start, written, values)
    return {name: values[name] for name in written}


def _resolve_from(start: str, written: Mapping[str, str], values: dict[str, float]) -> None:
    path = {}
    current = None if start in values else start
    while current is not None:
        try:
            if current not in path:
                path[current] = [name for name in names_in_expression(written[current]) if name in written]
            todo = next((name for name in path[current] if name not in values), None)
            if todo in path:
                raise ExpressionError(_circular_definition_phrase(list(path), str(todo)))
            if todo is None:
                values[current] = evaluate_expression(written[current], values, written)
                path.popitem()
        except ExpressionError as error:
            raise ExpressionError(error.phrase, current) from None
        current = todo if todo is not None else next(reversed(path), None)


def _circular_definition_phrase(path: list[str], name: str) -> Phrase:
    loop = [*path[path.index(name) :], name]
    words = loop if len(loop) <= 8 else [*loop[:6], "…", name]
    if len(loop) == 2:
        return Phrase("circle_of_one", name=name)
    return Phrase("circle", names=tuple(words))


_DRIVE_RATE_NUMBER_KEYS = ("omega", "epsilon", "velocity", "acceleration")
Uses = Mapping[str, list[str]]


def read_laws(table: SourceTable, parameters: Nodes) -> dict[Keys, Law]:
    """The places of loads, rates and friction whose numbers change with the drive, with the parameter they share."""
    drive = table.entries["drive"]
    assert isinstance(drive, SourceTable)
    place = next(drive.entries[key] for key in ("phi", "s") if key in drive.entries)
    uses = {name: names_in_node(node) for name, node in parameters.items()} if names_in_node(place) else {}
    moving = _plain_number_parameters(names_in_node(place), uses)
    shape = (node for key in ("frame", "links") for _, node in texts_with_paths(table.entries[key]))
    fixed = (
        _plain_number_parameters((name for node in shape for name in names_in_node(node)), uses) if moving else set()
    )
    with_drive = parameters_depending_on(moving - fixed or moving, uses)
    own = place.text.strip() if isinstance(place, SourceScalar) else ""  # in a load it is a law, not a number
    others = {name: [one for one in used if one != own] for name, used in uses.items()}
    besides = parameters_depending_on((moving - fixed or moving) - {own}, others) - {own}
    laws = {}
    for path, node in _drive_dependent_numbers(table) if with_drive else ():
        names = besides if path[0] == "loads" and "table" not in path else with_drive
        if shared := next((name for name in names_in_node(node) if name in names), None):
            laws[path] = Law(path, shared, node.line)
    return laws


def _drive_dependent_numbers(table: SourceTable) -> Iterator[tuple[Keys, SourceScalar]]:
    for path, node in texts_with_paths(
        SourceTable({k: v for k, v in table.entries.items() if k in ("loads", "drive", "friction")}, 0)
    ):
        if (
            path[0] == "friction"
            or "table" in path
            or path[-1] in (LOAD_NUMBER_KEYS if path[0] == "loads" else _DRIVE_RATE_NUMBER_KEYS)
        ):
            yield path, node


def names_in_node(node: Node) -> list[str]:
    """The names an expression uses; empty where the text is no expression."""
    try:
        if isinstance(node, SourceTable | Items):
            return []
        return names_in_expression(node.text)
    except ExpressionError:
        return []


def _plain_number_parameters(names: Iterable[str], uses: Uses) -> set[str]:
    """The parameters with plain numbers that these depend on."""
    return {name for name in names_reachable_from(names, uses) if name in uses and not uses[name]}


def parameters_depending_on(names: Iterable[str], uses: Uses) -> set[str]:
    """These parameters, and all that depend on them."""
    users = defaultdict(list)
    for name, used in uses.items():
        for one in used:
            users[one].append(name)
    return names_reachable_from(names, users)


def parameter_values_in_use(text: str, file: str, values: NumbersByName) -> NumbersByName:
    """Those of the ``values`` that the mechanism of a scene, or its vectors, depend on, directly or through one
    another; all of them where the scene has no text."""
    entries = parse_yaml(text, file).entries if text else {}
    own = {n: names_in_node(node) for n, node in entries_of_table(entries.get("parameters")).items()}
    shape = (
        node for key, part in entries.items() if key not in KEYS_WITHOUT_EFFECT for _, node in texts_with_paths(part)
    )
    names = names_reachable_from((n for node in shape for n in names_in_node(node)), own)
    return {name: value for name, value in values.items() if name in names or not text}


KEYS_WITHOUT_EFFECT = ("parameters", "variants", "title", "note", "text", "missing", "sheet")
"""Keys of a scene that do not affect its mechanism or vectors."""


def names_reachable_from(names: Iterable[str], ways: Uses) -> set[str]:
    """These names, and all names reachable from them."""
    names_met = set(names)
    todo = list(names_met)
    while todo:
        for name in ways.get(todo.pop(), ()):
            if name not in names_met:
                names_met.add(name)
                todo.append(name)
    return names_met
