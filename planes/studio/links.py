"""A link that opens a scene in a studio, and its QR code: the scene's text is in the address, after the #.

The browser's side of it is in ``render/page/share.js``: raw deflate, then base64 with the letters allowed in addresses.
"""

import base64
import zlib

from planes.scene import Scene
from planes.scene.writing import scene_text_with_numbers
from planes.words import Phrase
from planes.words.errors import SceneError

RAW_DEFLATE_WINDOW_BITS = -15  # deflate without a header
# mm of a module that a telephone can read from paper; modules of white around a code
LEAST_MODULE_MM = 0.33
CODE_RIM_MODULES = 4
Cells = list[list[bool]]


def deflated_text(text: str) -> bytes:
    """A text, compressed (RFC 1951)."""
    packer = zlib.compressobj(
        9, zlib.DEFLATED, RAW_DEFLATE_WINDOW_BITS, 5
    )  # with smaller blocks the largest page is 1 % smaller
    return packer.compress(text.encode()) + packer.flush()


def text_in_link_letters(text: str) -> str:
    """A text in the letters of a link."""
    return base64.urlsafe_b64encode(deflated_text(text)).decode().rstrip("=")


def scene_text(scene: Scene) -> str:
    """The scene as its file says it, without remarks, with the numbers of its variant in, and without the address."""
    scales = ("plans",) if scene.reading.changed else ()  # which were chosen for its own numbers
    return scene_text_with_numbers(scene.to_yaml(), scene.file, None, {}, {}, without=("studio", *scales))


def studio_link(scene: Scene) -> str:
    """The address that opens it; "" where the scene names no studio."""
    address = str(scene.sheet.get("studio", ""))
    return f"{address}#s={text_in_link_letters(scene_text(scene))}" if address and scene.reading.source else ""


def qr_code_cells(scene: Scene) -> Cells:
    """Black cells of the QR code of its link, the top row first; empty where it names no studio.

    :class:`SceneError` where the text is too long for a code.
    """
    import segno

    if not (text := studio_link(scene)):
        return []
    try:
        code = segno.make_qr(text, error="l", boost_error=False)
    except segno.DataOverflowError:
        raise _link_error(scene, "code_long", letters=len(text)) from None
    return [[bool(cell) for cell in row] for row in code.matrix]


def code_module_mm(scene: Scene, count: int, room_mm: float, best_mm: float) -> float:
    """The size of a module in a code with so many, at most the best size. :class:`SceneError` where it is too fine."""
    size = min(best_mm, room_mm / (count + 2 * CODE_RIM_MODULES))
    if size < LEAST_MODULE_MM:
        needed = round(LEAST_MODULE_MM * (count + 2 * CODE_RIM_MODULES))
        raise _link_error(scene, "code_fine", count=count, room=round(room_mm), needed=needed)
    return size


def _link_error(scene: Scene, key: str, **parts: object) -> SceneError:
    return SceneError(Phrase(key, **parts), scene.file, scene.where.get(("sheet", "studio")))
