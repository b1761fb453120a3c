"""Frames of marks -> an animation: GIF by Pillow, SVG whose frames are shown in turn, MP4 by OpenCV."""

import io
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING

from planes.words import Phrase
from planes.words.errors import PlanesError
from render.files import pdf, svg
from render.paper.marks import Mark, Size

if TYPE_CHECKING:
    from PIL.Image import Image

ANIMATION_SUFFIXES = (".gif", ".svg", ".mp4")
GIF_WIDTH_PX = 900
"""Width of a GIF."""
FILM_WIDTH_PX = 1600
"""Width of a film: more than a projector needs for the letters."""
GREY_LEVELS = 8
Step = Callable[[int, int], None] | None


def animation_bytes(
    frames: Sequence[Sequence[Mark]],
    size_mm: Size,
    seconds: float,
    suffix: str,
    step: Step = None,
    title: str = "",
    lang: str = "en",
) -> bytes:
    """The file: the frames, each ``size_mm`` wide and high, evenly over so many seconds, without end; an SVG says its
    ``title`` and the language of its words.

    ``step`` is called after every frame. :class:`PlanesError` for MP4 without OpenCV.
    """
    if suffix == ".svg":
        pages = []
        for k, marks in enumerate(frames, 1):
            pages.append(svg.write(marks, size_mm, title, lang=lang).decode())
            if step:
                step(k, len(frames))
        return _svg_bytes(pages, seconds)
    pictures = _frame_pictures(frames, size_mm, GIF_WIDTH_PX if suffix == ".gif" else FILM_WIDTH_PX, step)
    if suffix == ".gif":
        return _gif_bytes(pictures, seconds)
    return _mp4_bytes(pictures, seconds)


def _frame_pictures(frames: Sequence[Sequence[Mark]], size_mm: Size, wide: int, step: Step) -> "list[Image]":
    from PIL.Image import open as opened

    pictures = []
    for k, marks in enumerate(frames):
        data = pdf.write_png(marks, size_mm, "", dpi=25.4 * wide / size_mm[0])
        pictures.append(opened(io.BytesIO(data)).convert("L"))
        if step:
            step(k + 1, len(frames))
    return pictures


def _gif_bytes(pictures: "Sequence[Image]", seconds: float) -> bytes:
    out = io.BytesIO()
    first, *rest = (p.quantize(GREY_LEVELS) for p in pictures)
    lasts = round(1000 * seconds / len(pictures))
    first.save(out, format="GIF", save_all=True, append_images=rest, duration=lasts, loop=0, optimize=True)
    return out.getvalue()


def _mp4_bytes(pictures: "Sequence[Image]", seconds: float) -> bytes:
    try:
        import cv2
    except ImportError:
        raise PlanesError(Phrase("film_needs_opencv")) from None
    import numpy

    with TemporaryDirectory() as folder:
        file = Path(folder) / "film.mp4"
        wide, high = (side // 2 * 2 for side in pictures[0].size)  # a film has even sides
        film = cv2.VideoWriter(str(file), cv2.VideoWriter.fourcc(*"mp4v"), len(pictures) / seconds, (wide, high))
        for picture in pictures:
            film.write(cv2.cvtColor(numpy.asarray(picture)[:high, :wide], cv2.COLOR_GRAY2BGR))
        film.release()
        return file.read_bytes()


def _svg_bytes(pages: Sequence[str], seconds: float) -> bytes:
    """Frames as groups, of which one at a time is seen; no script."""
    head = pages[0][: pages[0].index("<g ")]
    parts = []
    for k, page in enumerate(pages):
        body = re.sub(r' id="\w+"', "", page[page.index("<g ") : page.rindex("</svg>")])
        times = ";".join(f"{t:g}" for t in (0, k / len(pages), (k + 1) / len(pages)))
        shown = "none;inline;none" if k else "inline;inline;none"
        turn = f'<animate attributeName="display" values="{shown}" keyTimes="{times}" calcMode="discrete"'
        turn += f' dur="{seconds:g}s" repeatCount="indefinite"/>'
        parts.append(f'<g display="{"none" if k else "inline"}">{turn}{body}</g>')
    return "".join((head, *parts, "</svg>\n")).encode()
