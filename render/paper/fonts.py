"""The face a scene asks for: the engine's own lettering, or a font found by name among the installed, or a file."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from planes.scene import Scene
from planes.words import Phrase, Told
from planes.words.errors import SceneError, choices, shown
from render.paper import outlines
from render.paper.marks import Face

FILES = (".ttf", ".otf", ".ttc")
TRIAL = "АЯабёжщэяABZabyz0123456789.,+−=()′μωεφ"


def face_of(scene: Scene) -> Face:
    """The face of a scene's sheets; a font that is not there is a :class:`SceneError` that names near ones."""
    slanted, font = scene.sheet.get("lettering") == "slanted", str(scene.sheet.get("font") or "").strip()
    if not font:
        return Face("", slanted)
    path, family = _file(scene, font) if font.lower().endswith(FILES) else _installed(scene, font)
    return Face(path, slanted, family)


def _file(scene: Scene, name: str) -> tuple[str, str]:
    """A font's file, its path taken from the scene's folder."""
    path = Path(scene.file).parent / Path(name).expanduser()
    if not path.is_file():
        raise _refused(scene, Phrase("no_font_file", file=shown(name)))
    return str(path), _checked(scene, str(path), name)


def _installed(scene: Scene, name: str) -> tuple[str, str]:
    """The upright regular file of an installed family, by its name in any letter case."""
    from matplotlib.font_manager import fontManager

    plain = [f for f in fontManager.ttflist if f.style == "normal" and str(f.fname).lower().endswith(FILES)]
    fitting = [f for f in plain if f.name.casefold() == name.casefold()]
    if fitting:
        best = min(fitting, key=lambda f: (abs(_weight(f.weight) - 400), f.stretch != "normal", f.fname))
        return str(best.fname), _checked(scene, str(best.fname), name) and str(best.name)
    for path, family in _newly_installed({str(f.fname) for f in fontManager.ttflist}):
        if family.casefold() == name.casefold():
            return path, family
    families = sorted({f.name for f in plain if "mpl-data" not in f.fname} | {"DejaVu Sans"})
    raise _refused(scene, Phrase("no_font", name=shown(name), valid=choices(name, families)))


def _weight(weight: object) -> float:
    return float(weight) if isinstance(weight, (int, float)) else 400.0


def _newly_installed(known: set[str]) -> Iterator[tuple[str, str]]:
    """Files and families of fonts that matplotlib's list, kept from an earlier run, does not have."""
    from fontTools.ttLib import TTLibError
    from matplotlib.font_manager import findSystemFonts

    for path in sorted(set(findSystemFonts()) - known):
        try:
            yield path, outlines.family(path)
        except (OSError, TTLibError, ValueError):
            continue


def _checked(scene: Scene, path: str, name: str) -> str:
    """The name of the family, once letters of the file have been drawn for a trial."""
    try:
        outlines.contours(TRIAL, 5.0, path)
        return outlines.family(path)
    except Exception as error:  # whatever a reader of fonts says of a file that is none, or a broken one
        raise _refused(scene, Phrase("bad_font", name=shown(name), why=str(error)[:80] or "?")) from None


def _refused(scene: Scene, why: Told) -> SceneError:
    return SceneError(why, scene.file, scene.where.get(("sheet", "font")))
