"""Pictures in a notebook: after ``%load_ext planes.documents.notebook`` a scene and a solved position show themselves.

Whatever is drawn shows itself without it: ``picture(scene)``, ``picture(position, "velocity-plan")``, ``sheet_of(scene,
None)``.  A scene and a position know nothing of pictures, so they are told here how to be shown.
"""

from __future__ import annotations

from typing import Any

from planes.documents import picture
from planes.scene import Scene
from planes.solving import Position
from planes.words.errors import PlanesError

SVG = "image/svg+xml"


def load_ipython_extension(shell: Any) -> None:
    """Called by IPython: the scheme is what a scene and a position are shown as."""
    formatter = shell.display_formatter.formatters[SVG]
    for kind in (Scene, Position):
        formatter.for_type(kind, shown)


def unload_ipython_extension(shell: Any) -> None:
    """Called by IPython: back to plain text."""
    formatter = shell.display_formatter.formatters[SVG]
    for kind in (Scene, Position):
        formatter.pop(kind, None)


def shown(drawn: Scene | Position) -> str | None:
    """The scheme as SVG; nothing, so that the text is shown, where it cannot be drawn."""
    try:
        return picture(drawn)._repr_svg_()
    except PlanesError:
        return None
