"""Numbers of a scene that depend on what the drive's place is taken from: they hold at that place alone.

With ``phi: phi_1`` a force of 3000*sin(phi_1) is calculated once, and would stay as it is while the drive moves.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from planes.scene.expressions import names_in
from planes.scene.mechanism import Law
from planes.scene.reader import Keys, texts
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.words.errors import ExpressionError

_GIVEN = ("force", "moment", "direction", "angle")  # numbers of a load
_RATES = ("omega", "epsilon", "velocity", "acceleration")
Uses = Mapping[str, list[str]]


def read_laws(table: SourceTable, parameters: Mapping[str, Node]) -> dict[Keys, Law]:
    """The places of loads, rates and friction whose numbers change with the drive, with the parameter they share."""
    drive = table.entries["drive"]
    assert isinstance(drive, SourceTable)
    place = next(drive.entries[key] for key in ("phi", "s") if key in drive.entries)
    uses = {name: _names(node) for name, node in parameters.items()} if _names(place) else {}
    moving = _leaves(_names(place), uses)
    shape = (node for key in ("frame", "links") for _, node in texts(table.entries[key]))
    fixed = _leaves((name for node in shape for name in _names(node)), uses) if moving else set()
    with_drive = _users(moving - fixed or moving, uses)
    found = {}
    for path, node in _numbers(table) if with_drive else ():
        if shared := next((name for name in _names(node) if name in with_drive), None):
            found[path] = Law(path, shared, node.line)
    return found


def _numbers(table: SourceTable) -> Iterator[tuple[Keys, SourceScalar]]:
    for path, node in texts(
        SourceTable({k: v for k, v in table.entries.items() if k in ("loads", "drive", "friction")}, 0)
    ):
        if path[0] == "friction" or path[-1] in (_GIVEN if path[0] == "loads" else _RATES):
            yield path, node


def _names(node: Node) -> list[str]:
    """The names an expression uses; none where the text is something else."""
    try:
        return [] if isinstance(node, SourceTable | Items) else names_in(node.text)
    except ExpressionError:
        return []


def _leaves(names: Iterable[str], uses: Uses) -> set[str]:
    """The parameters given by numbers that these are made of."""
    return {name for name in _reached(names, uses) if name in uses and not uses[name]}


def _users(names: Iterable[str], uses: Uses) -> set[str]:
    """These parameters, and all that are made of them."""
    users: dict[str, list[str]] = {}
    for name, used in uses.items():
        for one in used:
            users.setdefault(one, []).append(name)
    return _reached(names, users)


def _reached(names: Iterable[str], ways: Uses) -> set[str]:
    found = set(names)
    todo = list(found)
    while todo:
        for name in ways.get(todo.pop(), ()):
            if name not in found:
                found.add(name)
                todo.append(name)
    return found
