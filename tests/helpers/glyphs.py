"""The characters of the drawing lettering."""

from __future__ import annotations

from render.paper.lettering import GLYPH_PATHS, SAME_SHAPED_CHARACTERS, SHIFTED_CHARACTERS, _clean_text


def missing(text: str) -> str:
    """Characters of the text without a glyph, each once, in order; blanks need none."""
    drawn = {*GLYPH_PATHS, *SAME_SHAPED_CHARACTERS, *SHIFTED_CHARACTERS}
    return "".join(dict.fromkeys(c for c in _clean_text(text) if not c.isspace() and c not in drawn))
