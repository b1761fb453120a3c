"""Which characters the drawing lettering has."""

from __future__ import annotations

from render.paper.lettering import GLYPHS, SAME, SHIFTED, _clean


def missing(text: str) -> str:
    """Characters of the text that have no glyph, each once, in order; blanks need none."""
    drawn = {*GLYPHS, *SAME, *SHIFTED}
    return "".join(dict.fromkeys(c for c in _clean(text) if not c.isspace() and c not in drawn))
