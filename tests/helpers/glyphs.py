"""The characters of the drawing lettering."""

from __future__ import annotations

from render.paper.lettering import GLYPHS, SAME, SHIFTED, _clean


def missing(text: str) -> str:
    """Characters of the text without a glyph, each once, in order; blanks need none."""
    drawn = {*GLYPHS, *SAME, *SHIFTED}
    return "".join(dict.fromkeys(c for c in _clean(text) if not c.isspace() and c not in drawn))
