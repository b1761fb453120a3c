"""What a file was made by: the program's own text and the libraries that draw, as one hash."""

from __future__ import annotations

import hashlib
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

LIBRARIES = ("numpy", "shapely", "reportlab", "ezdxf", "svgwrite", "matplotlib")
_SUFFIXES = (".py", ".js", ".css", ".html")


@cache
def fingerprint() -> str:
    """The same for two programs that make the same files of the same scenes."""
    house = Path(__file__).parents[2]
    files = [f for room in ("planes", "render") for f in (house / room).rglob("*") if f.suffix in _SUFFIXES]
    found = hashlib.sha256()
    for file in sorted(files, key=lambda f: f.relative_to(house).as_posix()):
        found.update(file.relative_to(house).as_posix().encode() + b"\0" + file.read_bytes() + b"\0")
    for name in LIBRARIES:
        found.update(f"{name} {_version(name)}\0".encode())
    return found.hexdigest()


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "-"
