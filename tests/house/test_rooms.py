"""The house: six layers of rooms, who may import whom, read off the files."""

from __future__ import annotations

import ast
import subprocess
import sys
from functools import cache
from pathlib import Path

import pytest

from tests.helpers import ROOT

LAYERS = (  # a room imports from the layers above its own in this list, and from the rooms before it in its own
    "words",
    "geometry scene drafting plans batch solving",  # the engine; drafting knows no mechanism
    "accuracy diagrams",  # many positions looked at
    "check lesson studio course crank_slider",  # readers
    "render",  # draws, computes no mechanics
    "documents cli",
)
ROOMS = [room for layer in LAYERS for room in layer.split()]
LAYER = {room: number for number, layer in enumerate(LAYERS) for room in layer.split()}
FACE = ("planes", "planes.__main__")  # face and commands open every door; no room imports them


def files(package: str) -> dict[str, Path]:
    """Modules of a package by name."""
    found = sorted((ROOT / package).rglob("*.py"))
    return {".".join(f.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): f for f in found}


MODULES = {**files("planes"), **files("render")}


@cache
def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


@cache
def imports(module: str) -> frozenset[str]:
    """The modules of both packages a module imports anywhere in its file, or names in a string of its own."""
    found: set[str] = set()
    for node in ast.walk(tree(MODULES[module])):
        if isinstance(node, ast.Import):
            found |= {a.name for a in node.names}
        elif isinstance(node, ast.ImportFrom):
            assert not node.level, f"{module}: relative import in line {node.lineno}"
            whole = [f"{node.module}.{a.name}" for a in node.names]
            found |= {name if name in MODULES else node.module or "" for name in whole}
        elif isinstance(node, ast.Constant) and "." in str(node.value):  # an arrow all the same, drawn by import_module
            found |= {str(node.value).rstrip(".")}
    return frozenset(found & set(MODULES)) - {module}


def room_of(module: str) -> str:
    """The room a module stands in."""
    top, *rest = module.split(".")
    return top if top == "render" else rest[0]


def test_a_room_imports_only_from_lower_layers_and_earlier_rooms() -> None:
    for module in (m for m in MODULES if m not in FACE):
        room = room_of(module)
        for other in imports(module):
            assert other not in FACE, f"{module} imports the public face"
            there = room_of(other)
            lower = LAYER[there] < LAYER[room] or (
                LAYER[there] == LAYER[room] and ROOMS.index(there) <= ROOMS.index(room)
            )
            assert lower, f"{module} imports {other}: {there} stands above {room}"


@pytest.mark.parametrize(
    ("house", "order"),
    [("plans", "assur position motion force statements"), ("check", "evidence grading explaining report")],
)
def test_rooms_within_a_room_import_from_those_before_them(house: str, order: str) -> None:
    front, rooms = f"planes.{house}.", order.split()
    of = {m: m.removeprefix(front).split(".")[0] for m in MODULES if m.startswith(front)}
    of = {m: room for m, room in of.items() if room in rooms}
    ways = [(m, other) for m in of for other in imports(m) if other in of]
    assert len(ways) > 50
    assert not [(m, other) for m, other in ways if rooms.index(of[other]) > rooms.index(of[m])]


def test_every_module_stands_in_a_room() -> None:
    assert {room_of(m) for m in MODULES if m not in FACE} == set(ROOMS)


def test_there_are_no_circles_of_imports() -> None:
    done: set[str] = set()

    def visit(module: str, way: tuple[str, ...]) -> None:
        assert module not in way, " -> ".join((*way, module))
        if module not in done:
            for other in imports(module):
                visit(other, (*way, module))
            done.add(module)

    for module in MODULES:
        visit(module, ())


def test_the_engine_draws_without_heavy_libraries() -> None:
    """One position needs neither numpy nor shapely nor matplotlib to be imported."""
    program = (
        "import sys\nfrom planes.scene import load\nfrom planes.solving import solve\n"
        "solve(load('samples/six-link.yaml'))\n"
        "print([m for m in ('numpy', 'shapely', 'matplotlib', 'reportlab') if m in sys.modules])\n"
    )
    found = subprocess.run([sys.executable, "-c", program], cwd=ROOT, capture_output=True, text=True, check=True)
    assert found.stdout == "[]\n"


def test_no_class_name_means_two_things() -> None:
    homes: dict[str, list[str]] = {}
    for module, path in MODULES.items():
        for node in ast.walk(tree(path)):
            if isinstance(node, ast.ClassDef):
                homes.setdefault(node.name, []).append(module)
    assert not {name: where for name, where in homes.items() if len(where) > 1}


def test_every_module_says_what_it_is() -> None:
    for module, path in MODULES.items():
        assert ast.get_docstring(tree(path)), module
