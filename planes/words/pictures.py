"""Things that a notebook shows as pictures."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, ClassVar


class Pictured:
    """Shown as its scheme or its plans, by whoever stands above and can draw them: the public face tells who."""

    painter: ClassVar[Callable[[Any], str | None]] = staticmethod(lambda thing: None)

    def _repr_svg_(self) -> str | None:
        return type(self).painter(self)
