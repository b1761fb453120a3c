"""Things that a notebook shows as pictures."""

from __future__ import annotations

from importlib import import_module


class Pictured:
    """Shown as its scheme or its plans. Who draws it stands floors above, so it is called by name when asked."""

    def _repr_svg_(self) -> str | None:
        shown: str | None = import_module("planes.documents").shown(self)
        return shown
