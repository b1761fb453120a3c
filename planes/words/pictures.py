"""Things that a notebook shows as pictures."""

from __future__ import annotations

import sys


class Pictured:
    """Shown as its scheme or its plans. Who draws them stands floors above: the face of the whole package knows."""

    def _repr_svg_(self) -> str | None:
        shown: str | None = sys.modules[__name__.partition(".")[0]].shown(self)
        return shown
