"""A drafting machine for the theory of mechanisms: plans drawn construction by construction, then measured.

>>> import planes
>>> scene = planes.load("samples/six-link.yaml")
>>> planes.solve(scene, phi=150).omega["2"]  # rad/s
8.122...

The public face: :func:`load`, :func:`loads`, :func:`solve`, :func:`cycle`, :func:`check`, :func:`sheet`,
:func:`picture`, :func:`lesson`, :func:`animate`, :func:`crank`, and ``Scene``, ``Position``, ``Exact``, ``Pencil``,
``PlanesError``.
Each comes when it is first used, so that nothing is imported that is not needed.

The rooms, from the ground up: ``words`` (all text for people) · ``geometry scene drafting plans solving`` (the engine:
vector equations drawn step by step into one program) · ``batch accuracy diagrams`` (many positions) · ``check lesson
course crank_slider`` (readers of the program) · the renderer ``render`` · ``documents cli``.
"""

from __future__ import annotations

import sys
from importlib import import_module
from types import ModuleType
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from planes.documents.face import animate, check, cycle, lesson, picture, sheet, solve
    from planes.documents.notebook import crank
    from planes.drafting.instruments import Exact, Pencil
    from planes.scene import Scene, load, loads
    from planes.solving import Position
    from planes.words.errors import PlanesError

__version__ = "0.8.0"

_FROM = {
    "planes.scene": ("Scene", "load", "loads"),
    "planes.documents.face": ("animate", "check", "cycle", "lesson", "picture", "sheet", "solve"),
    "planes.drafting.instruments": ("Exact", "Pencil"),
    "planes.solving": ("Position",),
    "planes.words.errors": ("PlanesError",),
    "planes.documents": ("shown",),  # asked by whatever a notebook shows as a picture
    "planes.documents.notebook": ("crank", "in_notebook"),
}
_HOME = {name: module for module, names in _FROM.items() for name in names}
__all__ = [
    "Exact",
    "Pencil",
    "PlanesError",
    "Position",
    "Scene",
    "animate",
    "check",
    "crank",
    "cycle",
    "lesson",
    "load",
    "loads",
    "picture",
    "sheet",
    "solve",
]


class _Face(ModuleType):
    """The package: its public names win over the rooms of the same names, ``check`` and ``lesson``."""

    def __getattribute__(self, name: str) -> Any:
        if name in _HOME:
            return getattr(import_module(_HOME[name]), name)
        return super().__getattribute__(name)

    def __dir__(self) -> list[str]:
        return [*__all__, "__version__"]


sys.modules[__name__].__class__ = _Face
