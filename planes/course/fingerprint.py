"""What a file was made by: the program's own text, Python and the libraries that reckon and draw, as one hash."""

from __future__ import annotations

import hashlib
import platform
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

LIBRARIES = ("numpy", "shapely", "reportlab", "ezdxf", "svgwrite", "matplotlib", "fonttools", "pillow", "pypdfium2")
_SUFFIXES = (".py", ".js", ".css", ".html")


@cache
def fingerprint() -> str:
    """The same for two programs that make the same files of the same scenes."""
    house = Path(__file__).parents[2]
    files = [f for room in ("planes", "render") for f in (house / room).rglob("*") if f.suffix in _SUFFIXES]
    found = hashlib.sha256()
    for file in sorted(files, key=lambda f: f.relative_to(house).as_posix()):
        found.update(file.relative_to(house).as_posix().encode() + b"\0" + file.read_bytes() + b"\0")
    found.update(repr(made_with()).encode())
    return found.hexdigest()


def made_with() -> dict[str, str]:
    """Python and the libraries, with their versions."""
    python = {"python": f"{platform.python_implementation()} {platform.python_version()}"}
    return python | {name: _version(name) for name in LIBRARIES}


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "-"
