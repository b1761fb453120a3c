"""Installed fonts: the one named in a scene, by name or by file, and text as its outlines.

Text is measured and drawn from the font's own glyphs, so the reader needs no font.  The same contract as ``lettering``:
a height is that of the capitals, ink begins at x = 0 on the base line, all in mm.  A character missing in the font is
taken from DejaVu Sans, which comes with matplotlib.
"""

from __future__ import annotations

import io
import logging
import math
import unicodedata
from collections.abc import Iterator
from functools import cache, lru_cache
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from planes.scene import Scene
from planes.words import Phrase, Told
from planes.words.errors import SceneError, list_valid_choices, quoted_excerpt
from render.paper.lettering import NARROW_SPACES
from render.paper.marks import Face, Polyline

if TYPE_CHECKING:
    from fontTools.ttLib import TTFont
    from fontTools.ttLib.ttGlyphSet import _TTGlyphSet

_FLATTENING_ERROR = 2e-3  # largest error of a flattened curve, over the height of capitals: 0.01 mm at 5 mm


@lru_cache(maxsize=1)
def dejavu_file() -> Path:
    """The file of DejaVu Sans; it comes with matplotlib."""
    spec = find_spec("matplotlib")
    if spec is None or spec.origin is None:
        raise FileNotFoundError("the font DejaVuSans.ttf is looked for in matplotlib; install matplotlib")
    return Path(spec.origin).parent / "mpl-data" / "fonts" / "ttf" / "DejaVuSans.ttf"


def font_tables(path: str) -> TTFont:
    """The tables of a font's file (the first of a collection), read on demand."""
    from fontTools.ttLib import TTFont

    logging.getLogger("fontTools").setLevel(logging.CRITICAL)  # serious faults get our own sentence
    return TTFont(io.BytesIO(Path(path).read_bytes()), fontNumber=0, lazy=True)


def family_name(path: str) -> str:
    """The family name of a font file."""
    font = font_tables(path)
    return str((font["name"].getBestFamilyName() if "name" in font else "") or Path(path).stem)


class Font:
    """An open font file: glyphs flattened to polylines, in heights of its capitals."""

    def __init__(self, path: str) -> None:
        font = font_tables(path)
        self.map: dict[int, str] = font.getBestCmap() or {}
        self.glyphs: _TTGlyphSet = font.getGlyphSet()
        self.unit = 1.0
        tops = [z.imag for line in self.character_contours("H") for z in line] if self.has_character("H") else []
        self.unit = max(tops, default=0.0) or 0.7 * float(font["head"].unitsPerEm)
        self.character_contours.cache_clear()

    def has_character(self, char: str) -> bool:
        """Whether the font draws a character."""
        return ord(char) in self.map

    def advance_width(self, char: str) -> float:
        """From a character to the next."""
        return float(self.glyphs[self.map[ord(char)]].width) / self.unit

    @cache  # noqa: B019  one font lives as long as the program
    def character_contours(self, char: str) -> tuple[Polyline, ...]:
        """Closed outlines of a character, the first point repeated at the end."""
        from render.paper.font_pen import Flattened

        pen = Flattened(self.glyphs, _FLATTENING_ERROR * self.unit)
        self.glyphs[self.map[ord(char)]].draw(pen)
        return tuple(tuple([z / self.unit for z in line]) for line in pen.lines if len(line) > 2)


@lru_cache(maxsize=16)
def open_font(path: str) -> Font:
    """The font of a file; an error of fontTools or OSError if it is not one."""
    return Font(path)


@lru_cache(maxsize=4096)
def _lay_out_line(text: str, path: str) -> tuple[float, tuple[Polyline, ...]]:
    """Width of the ink and the outlines of a line of text, in heights of capitals."""
    own = open_font(path)
    spare = open_font(str(dejavu_file()))
    x = 0.0
    lines = []
    for char in unicodedata.normalize("NFC", text).strip():
        if unicodedata.category(char) == "Cf":
            continue
        if char.isspace():
            x += space_width(path) / (2 if char in NARROW_SPACES else 1)
            continue
        font = own if own.has_character(char) else spare
        known = char if font.has_character(char) else "\ufffd"
        lines += [tuple([z + x for z in line]) for line in font.character_contours(known)]
        x += font.advance_width(known)
    across = [z.real for line in lines for z in line] or [0.0]
    left = min(across)
    return max(across) - left, tuple(tuple([z - left for z in line]) for line in lines)


def space_width(path: str) -> float:
    """The width of a space over the height of capitals."""
    font = open_font(path)
    return font.advance_width(" ") if font.has_character(" ") else 0.4


def line_ink_width(text: str, height_mm: float, path: str) -> float:
    """Width in mm of the ink of a line of text."""
    return _lay_out_line(text, path)[0] * height_mm


def line_contours(text: str, height_mm: float, path: str) -> tuple[Polyline, ...]:
    """Closed outlines of a line of text as polylines x + iy in mm, to be filled by the non-zero rule."""
    if not 0 < height_mm < math.inf:
        raise ValueError(f"letter height must be a positive number of mm, not {height_mm!r}")
    return tuple(tuple([z * height_mm for z in line]) for line in _lay_out_line(text, path)[1])


FONT_SUFFIXES = (".ttf", ".otf", ".ttc")
TRIAL_TEXT = "АЯабёжщэяABZabyz0123456789.,+−=()′μωεφ"


def face_of_scene(scene: Scene) -> Face:
    """The face of a scene's sheets; for a missing font a :class:`SceneError` suggests similar ones."""
    slanted = scene.sheet.get("lettering") == "slanted"
    font = str(scene.sheet.get("font") or "").strip()
    if not font:
        return Face("", slanted)
    path, name = _font_from_file(scene, font) if font.lower().endswith(FONT_SUFFIXES) else _installed_font(scene, font)
    return Face(path, slanted, name)


def _font_from_file(scene: Scene, name: str) -> tuple[str, str]:
    """A font's file, its path relative to the scene's folder."""
    path = Path(scene.file).parent / Path(name).expanduser()
    if not path.is_file():
        raise _font_error(scene, Phrase("no_font_file", file=quoted_excerpt(name)))
    return str(path), _check_font(scene, str(path), name)


def _installed_font(scene: Scene, name: str) -> tuple[str, str]:
    """The upright regular file of an installed family, by its name, ignoring case."""
    from matplotlib.font_manager import fontManager

    plain = [f for f in fontManager.ttflist if f.style == "normal" and str(f.fname).lower().endswith(FONT_SUFFIXES)]
    fitting = [f for f in plain if f.name.casefold() == name.casefold()]
    if fitting:
        best = min(fitting, key=lambda f: (abs(_numeric_weight(f.weight) - 400), f.stretch != "normal", f.fname))
        return str(best.fname), _check_font(scene, str(best.fname), name) and str(best.name)
    for path, called in _unlisted_fonts({str(f.fname) for f in fontManager.ttflist}):
        if called.casefold() == name.casefold():
            return path, called
    families = sorted({f.name for f in plain if "mpl-data" not in f.fname} | {"DejaVu Sans"})
    raise _font_error(scene, Phrase("no_font", name=quoted_excerpt(name), valid=list_valid_choices(name, families)))


def _numeric_weight(weight: object) -> float:
    return float(weight) if isinstance(weight, (int, float)) else 400.0


def _unlisted_fonts(known: set[str]) -> Iterator[tuple[str, str]]:
    """Files and families of fonts that are missing in matplotlib's cached list."""
    from fontTools.ttLib import TTLibError
    from matplotlib.font_manager import findSystemFonts

    for path in sorted(set(findSystemFonts()) - known):
        try:
            yield path, family_name(path)
        except (OSError, TTLibError, ValueError):
            continue


def _check_font(scene: Scene, path: str, name: str) -> str:
    """The name of the family, after a trial drawing of some letters of the file."""
    try:
        line_contours(TRIAL_TEXT, 5.0, path)
        return family_name(path)
    except Exception as error:  # any exception of a font reader for a file that is not a font, or is broken
        raise _font_error(scene, Phrase("bad_font", name=quoted_excerpt(name), why=str(error)[:80] or "?")) from None


def _font_error(scene: Scene, why: Told) -> SceneError:
    return SceneError(why, scene.file, scene.where.get(("sheet", "font")))
