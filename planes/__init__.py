"""A drafting machine for the theory of mechanisms: plans drawn construction by construction, then measured.

>>> import planes
>>> scene = planes.load("samples/six-link.yaml")
>>> planes.solve(scene, phi=150).omega["2"]  # rad/s
8.122...

Public names: :func:`load`, :func:`loads`, :func:`solve`, :func:`cycle`, :func:`extremes`, :func:`check`,
:func:`sheet`, :func:`picture`, :func:`lesson`, :func:`animate`, :func:`crank`, and ``Scene``, ``Linkage``,
``Position``, ``Solved``, ``Table``, ``Exact``, ``Pencil``, ``PlanesError``, ``PlanFailure``.
Each is imported on first use, so that nothing is loaded without need.

Packages, lowest level first: ``words`` (all text for people) · ``geometry scene drafting plans solving`` (the engine:
vector equations drawn step by step into one program) · ``batch accuracy diagrams`` (many positions) · ``check lesson
studio course crank_slider`` (readers of the program) · the renderer ``render`` · ``documents cli``.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from functools import cache, update_wrapper
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from planes.batch.table import Table
    from planes.documents.face import animate, check, cycle, extremes, lesson, picture, sheet
    from planes.documents.notebook import crank
    from planes.drafting.instruments import Exact, Pencil
    from planes.scene import Scene
    from planes.solving import Position, Solved
    from planes.solving.building import Linkage
    from planes.solving.of_scene import load, loads, solve
    from planes.words.errors import PlanesError, PlanFailure

__version__ = "0.24.0"

_FROM = {
    "planes.scene": ("Scene",),
    "planes.solving.building": ("Linkage",),
    "planes.documents.face": ("animate", "check", "cycle", "extremes", "lesson", "picture", "sheet"),
    "planes.solving.of_scene": ("load", "loads", "solve"),
    "planes.drafting.instruments": ("Exact", "Pencil"),
    "planes.solving": ("Position", "Solved"),
    "planes.batch.table": ("Table",),
    "planes.words.errors": ("PlanFailure", "PlanesError"),
    "planes.solving.tables": ("text_of",),  # asked for by every printed table
    "planes.documents.drawn": ("shown",),  # asked for by every picture in a notebook
    "planes.documents.notebook": ("crank", "in_notebook"),
}
_ROOMS = ("check", "lesson")
_HOME = {name: module for module, names in _FROM.items() for name in names}
__all__ = [
    "Exact",
    "Linkage",
    "Pencil",
    "PlanFailure",
    "PlanesError",
    "Position",
    "Scene",
    "Solved",
    "Table",
    "animate",
    "check",
    "crank",
    "cycle",
    "extremes",
    "lesson",
    "load",
    "loads",
    "picture",
    "sheet",
    "solve",
]


class _Verb:
    """A public function whose name a room has too: ``planes.check(scene, …)`` and ``import planes.check.reading``
    both work. Its class is called as ``help`` is to call it, "function check"."""

    def __init__(self, act: Callable[..., Any], room: str) -> None:
        update_wrapper(self, act)
        self._act = act
        self._room = room

    def __call__(self, *given: Any, **named: Any) -> Any:
        return self._act(*given, **named)

    def __get__(self, _: object, __: type | None = None) -> _Verb:
        return self  # so ``help`` takes it for a function, and shows its signature

    def __getattr__(self, name: str) -> Any:
        return getattr(import_module(self._room), name)


@cache
def _public(name: str) -> Any:
    act = getattr(import_module(_HOME[name]), name)
    if name in _ROOMS:
        return type(f"function {name}", (_Verb,), {})(act, f"{__name__}.{name}")
    return act


class _Face(ModuleType):
    """The package: its public names take precedence over the rooms of the same names, ``check`` and ``lesson``."""

    def __getattribute__(self, name: str) -> Any:
        if name in _HOME:
            return _public(name)
        return super().__getattribute__(name)

    def __dir__(self) -> list[str]:
        return [*__all__, "__version__"]


sys.modules[__name__].__class__ = _Face
