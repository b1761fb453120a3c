"""Strokes and words of a PDF page drawn in lines: its paths and texts as an SVG picture."""

import ctypes
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pypdfium2
import pypdfium2.raw as pdf

from planes.check.reading.opened import LARGEST_FILE_BYTES, read_bounded_bytes
from planes.check.reading.parts import merge_word_pieces
from planes.check.reading.strokes import ReadDrawing
from planes.check.reading.svg import drawing_from_svg

MOST_OBJECTS = 60_000  # objects of a page
MOST_FORM_DEPTH = 15  # nesting depth of forms
LEAST_LINES_BESIDE_IMAGE = 4  # with fewer lines, a page that also shows an image is a picture
PICTURE_PAGE_SHARE = 0.5  # an image over this share of the page is its content


def read_pdf(path: str | Path, page: int = 0) -> ReadDrawing | None:
    """The strokes of a page in mm, y up; None if it shows a picture or cannot be read."""
    data = read_bounded_bytes(path, LARGEST_FILE_BYTES)
    try:
        document = pypdfium2.PdfDocument(data)
    except pypdfium2.PdfiumError:
        return None
    with document:
        root = _page_as_svg(document[page]) if 0 <= page < len(document) else None
        if root is None:
            return None
        drawing = drawing_from_svg(root, str(path))
        drawing.words = merge_word_pieces(drawing.words)
        return drawing


def _page_as_svg(page: Any) -> ElementTree.Element | None:
    """The page as an SVG: y down from its upper edge, in points."""
    width, height = page.get_size()
    root = ElementTree.Element("svg", width=f"{width}pt", height=f"{height}pt", viewBox=f"0 0 {width} {height}")
    box = page.get_mediabox()
    turned = ElementTree.SubElement(root, "g", transform=f"matrix(1 0 0 -1 {-box[0]} {box[3]})")
    words = page.get_textpage()
    count = 0
    shows = False
    for thing, _ in zip(page.get_objects(max_depth=MOST_FORM_DEPTH), range(MOST_OBJECTS), strict=False):
        if thing.type == pdf.FPDF_PAGEOBJ_PATH:
            count += _add_path(turned, thing)
        elif thing.type == pdf.FPDF_PAGEOBJ_TEXT:
            _add_text(turned, thing, words)
        elif thing.type == pdf.FPDF_PAGEOBJ_IMAGE:
            left, low, right, high = thing.get_bounds()
            if (right - left) * (high - low) > PICTURE_PAGE_SHARE * width * height:
                return None
            shows = True
    return root if count >= (LEAST_LINES_BESIDE_IMAGE if shows else 1) else None


def _add_path(root: ElementTree.Element, thing: Any) -> bool:
    """A path with its style; whether it is visible."""
    fill = ctypes.c_int()
    stroke = ctypes.c_int()
    pdf.FPDFPath_GetDrawMode(thing, fill, stroke)
    looks = {"stroke": "#000" if stroke.value else "none", "fill": "#000" if fill.value else "none"}
    matrix = "matrix({})".format(" ".join(map(str, thing.get_matrix().get())))
    ElementTree.SubElement(root, "path", looks, d=" ".join(_svg_path_commands(thing)), transform=matrix)
    return bool(stroke.value or fill.value)


def _svg_path_commands(thing: Any) -> Iterator[str]:
    """A path's pieces in SVG notation."""
    letters = {pdf.FPDF_SEGMENT_MOVETO: "M", pdf.FPDF_SEGMENT_LINETO: "L", pdf.FPDF_SEGMENT_BEZIERTO: "C"}
    x = ctypes.c_float()
    y = ctypes.c_float()
    handles = list[str]()
    for k in range(pdf.FPDFPath_CountSegments(thing)):
        piece = pdf.FPDFPath_GetPathSegment(thing, k)
        letter = letters.get(pdf.FPDFPathSegment_GetType(piece), "")
        pdf.FPDFPathSegment_GetPoint(piece, x, y)
        place = f"{x.value} {y.value}"
        if letter == "C" and len(handles) < 2:
            handles.append(place)
            continue
        yield f"{letter}{' '.join([*handles, place])}"
        handles = []
        if pdf.FPDFPathSegment_GetClose(piece):
            yield "Z"


def _add_text(root: ElementTree.Element, thing: Any, words: Any) -> None:
    """A piece of text at its start, upright in its local axes."""
    length = pdf.FPDFTextObj_GetText(thing, words, None, 0)
    held = ctypes.create_string_buffer(max(length, 2))
    pdf.FPDFTextObj_GetText(thing, words, ctypes.cast(held, ctypes.POINTER(ctypes.c_ushort)), length)
    text = held.raw.decode("utf-16-le", "replace").rstrip("\0")
    matrix = thing.get_matrix()
    local = "matrix({}) scale(1 -1)".format(" ".join(map(str, matrix.get())))
    looks = {"font-size": str(thing.get_font_size()), "transform": local}
    left, _, right, _ = thing.get_bounds()
    if abs(matrix.b) < 1e-6 < abs(matrix.a):
        looks["textLength"] = str((right - left) / abs(matrix.a))
    ElementTree.SubElement(root, "text", looks).text = text
