"""Charts in files, by their suffix: the same chart gives the same bytes."""

from __future__ import annotations

import io
import re
from pathlib import Path

from matplotlib.figure import Figure

from planes.scene import files

METADATA: dict[str, dict[str, None]] = {
    ".png": {"Software": None},
    ".svg": {"Date": None},
    ".pdf": {"CreationDate": None},
}
NAME = re.compile(rb"\b[pmh][0-9a-f]{10}\b")  # of a clip, a marker or a hatch, made of numbers to the last bit


def save(figure: Figure, path: Path) -> None:
    """Write a figure; the names within an SVG are its own count, which rounding of the layout does not change."""
    kind = path.suffix.lower()
    out = io.BytesIO()
    figure.savefig(out, format=kind[1:], metadata=METADATA[kind])
    data, names = out.getvalue(), dict[bytes, bytes]()
    if kind == ".svg":
        data = NAME.sub(lambda m: names.setdefault(m[0], b"n%d" % (len(names) + 1)), data)
    files.save(data, path)
