"""Parameters of a scene: their values, which may be expressions of one another, and the variants that override them.

Numbers that share a parameter with the drive's position are valid at that position alone: with ``phi: phi_1`` a force
of 3000*sin(phi_1) is calculated once, and would not change as the drive moves.
"""

import math
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from planes.scene.expressions import RESERVED, evaluate, is_name, names_in
from planes.scene.mechanism import Law
from planes.scene.paths import Keys, entries_of, texts
from planes.scene.reader import MAX_NAME, Reader, absent, part
from planes.scene.source import Items, Node, SourceScalar, SourceTable, parse
from planes.words import Phrase
from planes.words.errors import ExpressionError, PlanesError, choices, shown
from planes.words.names import latin

SPELLED = dict(zip("АБВГДЕ", "ABVGDE", strict=True))
"""Russian letters of variants, by their Latin spelling."""


def read_parameters(reader: Reader, node: Node | None, chosen: SourceTable | None) -> dict[str, float]:
    """Values of the parameters in the order of the file; those of the chosen variant override them."""
    if node is None:
        return {}
    table = reader.table(node, "parameters")
    for name, line in table.lines.items():
        if name in RESERVED:
            raise reader.fault("reserved_parameter", line, name=name)
        if len(name) > MAX_NAME or not is_name(name):
            raise reader.fault("bad_parameter", line, name=shown(name), most=MAX_NAME)
    entries = {**table.entries, **entries_of(chosen)}
    written = {name: _scalar(reader, entry, Phrase("parameter", name=name)) for name, entry in entries.items()}
    try:
        values = resolve(written)
    except ExpressionError as error:
        what = Phrase("parameter", name=error.parameter)
        raise reader.fault("about", entries[error.parameter], what=what, why=error.phrase) from None
    for name, text in written.items():
        if text not in written:
            reader.written.note(values[name], text)
    return values


def finite(value: Any, name: str, several: bool = True) -> Any:
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
    raise PlanesError(Phrase(key, name=name, given=shown(" ".join(repr(value).split()))))


def with_numbers(
    reader: Reader, node: Node | None, chosen: SourceTable | None, numbers: Mapping[str, float]
) -> SourceTable:
    """The chosen variant with the user's numbers for some parameters."""
    known = entries_of(node)
    for name in numbers:
        if name not in known:
            valid = reader.offer(name, known)
            raise reader.fault("parameter_unknown", node or 1, name=shown(name), valid=valid)
    line = node.line if node else 1
    given = {name: SourceScalar(repr(finite(value, name, False)), line) for name, value in numbers.items()}
    return SourceTable({**entries_of(chosen), **given}, line)


def _scalar(reader: Reader, node: Node, what: Phrase) -> str:
    if isinstance(node, SourceScalar) and not node.absent:
        return node.text
    reader.number(node, what)
    raise reader.fault("only_number", node, what=what)


def read_variants(reader: Reader, node: Node | None, parameters: Node | None) -> dict[str, SourceTable]:
    """The variants by name, each a table that overrides parameters."""
    if node is None:
        return {}
    known = entries_of(parameters)
    variants = reader.names(node, "variants", Phrase("a_variant"))
    tables = {}
    for name, entry in variants.entries.items():
        what = Phrase("variant", name=name)
        table = SourceTable({}, entry.line) if absent(entry) else reader.table(entry, what)
        for key, line in table.lines.items():
            if key not in known:
                valid = reader.offer(key, known)
                raise reader.fault("no_parameter", line, name=name, key=shown(key), valid=valid)
            _scalar(reader, table.entries[key], part(key, what))
        tables[name] = table
    return tables


def choose(
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
        raise reader.fault("variant_either", line, name=shown(variant), names=names)
    valid = choices(variant, variants) or Phrase("no_variants")
    raise reader.fault("no_variant", line, name=shown(variant), valid=valid)


def variants_meant(asked: str, variants: Iterable[str]) -> dict[str, int]:
    """The variants that a name not in the list may mean, with their numbers from 1: the number itself, a letter that
    looks the same in another alphabet, or the Latin spelling of one."""
    return {
        name: number
        for number, name in enumerate(variants, 1)
        if asked in (str(number), SPELLED.get(name)) or latin(asked) == latin(name)
    }


def resolve(written: Mapping[str, str]) -> dict[str, float]:
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
                path[current] = [name for name in names_in(written[current]) if name in written]
            todo = next((name for name in path[current] if name not in values), None)
            if todo in path:
                raise ExpressionError(_cycle(list(path), str(todo)))
            if todo is None:
                values[current] = evaluate(written[current], values, written)
                path.popitem()
        except ExpressionError as error:
            raise ExpressionError(error.phrase, current) from None
        current = todo if todo is not None else next(reversed(path), None)


def _cycle(path: list[str], name: str) -> Phrase:
    loop = [*path[path.index(name) :], name]
    words = loop if len(loop) <= 8 else [*loop[:6], "…", name]
    return Phrase("circle_of_one", name=name) if len(loop) == 2 else Phrase("circle", names=tuple(words))


_GIVEN = ("force", "moment", "direction", "angle", "working", "idle", "over")  # numbers of a load, other than tables
_RATES = ("omega", "epsilon", "velocity", "acceleration")
Uses = Mapping[str, list[str]]


def read_laws(table: SourceTable, parameters: Mapping[str, Node]) -> dict[Keys, Law]:
    """The places of loads, rates and friction whose numbers change with the drive, with the parameter they share."""
    drive = table.entries["drive"]
    assert isinstance(drive, SourceTable)
    place = next(drive.entries[key] for key in ("phi", "s") if key in drive.entries)
    uses = {name: names_of(node) for name, node in parameters.items()} if names_of(place) else {}
    moving = _leaves(names_of(place), uses)
    shape = (node for key in ("frame", "links") for _, node in texts(table.entries[key]))
    fixed = _leaves((name for node in shape for name in names_of(node)), uses) if moving else set()
    with_drive = users_of(moving - fixed or moving, uses)
    own = place.text.strip() if isinstance(place, SourceScalar) else ""  # in a load it is a law, not a number
    others = {name: [one for one in used if one != own] for name, used in uses.items()}
    besides = users_of((moving - fixed or moving) - {own}, others) - {own}
    laws = {}
    for path, node in _numbers(table) if with_drive else ():
        names = besides if path[0] == "loads" and "table" not in path else with_drive
        if shared := next((name for name in names_of(node) if name in names), None):
            laws[path] = Law(path, shared, node.line)
    return laws


def _numbers(table: SourceTable) -> Iterator[tuple[Keys, SourceScalar]]:
    for path, node in texts(
        SourceTable({k: v for k, v in table.entries.items() if k in ("loads", "drive", "friction")}, 0)
    ):
        if path[0] == "friction" or "table" in path or path[-1] in (_GIVEN if path[0] == "loads" else _RATES):
            yield path, node


def names_of(node: Node) -> list[str]:
    """The names an expression uses; empty where the text is no expression."""
    try:
        return [] if isinstance(node, SourceTable | Items) else names_in(node.text)
    except ExpressionError:
        return []


def _leaves(names: Iterable[str], uses: Uses) -> set[str]:
    """The parameters with plain numbers that these depend on."""
    return {name for name in reached(names, uses) if name in uses and not uses[name]}


def users_of(names: Iterable[str], uses: Uses) -> set[str]:
    """These parameters, and all that depend on them."""
    users: dict[str, list[str]] = {}
    for name, used in uses.items():
        for one in used:
            users.setdefault(one, []).append(name)
    return reached(names, users)


def used_values(text: str, file: str, values: Mapping[str, float]) -> Mapping[str, float]:
    """Those of the ``values`` that the mechanism of a scene, or its vectors, depend on, directly or through one
    another; all of them where the scene has no text."""
    entries = parse(text, file).entries if text else {}
    own = {n: names_of(node) for n, node in entries_of(entries.get("parameters")).items()}
    shape = (node for key, part in entries.items() if key not in TOLD for _, node in texts(part))
    names = reached((n for node in shape for n in names_of(node)), own)
    return {name: value for name, value in values.items() if name in names or not text}


TOLD = ("parameters", "variants", "title", "note", "text", "missing", "sheet")
"""Keys of a scene that do not affect its mechanism or vectors."""


def reached(names: Iterable[str], ways: Uses) -> set[str]:
    """These names, and all names reachable from them."""
    names_met = set(names)
    todo = list(names_met)
    while todo:
        for name in ways.get(todo.pop(), ()):
            if name not in names_met:
                names_met.add(name)
                todo.append(name)
    return names_met
