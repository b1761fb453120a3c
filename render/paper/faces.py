"""How the text of a sheet is lettered: by the engine's own strokes or in an installed font, upright or at 75°.

A text mark holds its face, so that whoever measures or draws it later needs to know nothing else; while marks are
made, ``lettered`` says which face they take.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass


@dataclass(frozen=True)
class Face:
    """``font`` is the path of a font's file, "" for the engine's own lettering; ``family`` what the font is called."""

    font: str = ""
    slanted: bool = False
    family: str = ""


OWN = Face()
_chosen: ContextVar[Face] = ContextVar("face", default=OWN)


def current() -> Face:
    """The face of texts that are made now."""
    return _chosen.get()


@contextmanager
def lettered(face: Face) -> Iterator[None]:
    """Within it, texts are made and measured in that face."""
    token = _chosen.set(face)
    try:
        yield
    finally:
        _chosen.reset(token)
