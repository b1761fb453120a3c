"""The QR code that opens a scene in a studio, as a view of a sheet, a figure of a text, or a separate page."""

from planes.scene import Scene
from planes.studio.links import CODE_RIM_MODULES, code_module_mm, qr_code_cells
from planes.words import Lang, say
from planes.words.frozen import replace
from render.paper.marks import Mark, Text
from render.sheet.blank_sheet import corner_mark_boxes
from render.views import View, make_view

BEST_CODE_MODULE_MM = 0.4  # of a module
CODE_ROOM_MM, SMALL_CODE_ROOM_MM = 74.0, 45.0  # on a sheet, and where that is to be an A4 or an A3
CODE_ON_TASK_MM, CODE_ON_BACK_MM = 62.0, 160.0
CAPTION_LETTER_MM = 3.5
SMALL_FORMATS = ("A4", "A3")


def studio_code_view(
    scene: Scene, lang: Lang, room_mm: float | None = None, best_mm: float = BEST_CODE_MODULE_MM
) -> View | None:
    """The code with its white rim, None where the scene names no studio. :class:`SceneError` where it has no room."""
    squares = qr_code_cells(scene)
    if not squares:
        return None
    small = scene.sheet.get("format") in SMALL_FORMATS
    room = room_mm or (SMALL_CODE_ROOM_MM if small else CODE_ROOM_MM)
    module = code_module_mm(scene, len(squares), room, best_mm)
    side = module * (len(squares) + 2 * CODE_RIM_MODULES)
    marks = corner_mark_boxes(complex(side, side) / 2, squares, module * len(squares))
    made = make_view("studio", say("studio_code", lang), marks)
    return replace(made, inked=(0.0, 0.0, side, side), heading=CAPTION_LETTER_MM)


def blank_back_marks(scene: Scene, size_mm: tuple[float, float], lang: Lang) -> list[Mark]:
    """The back of a blank, with the code in its middle; empty without one."""
    made = studio_code_view(scene, lang, CODE_ON_BACK_MM, best_mm=0.6)
    if made is None:
        return []
    corner = complex(size_mm[0] - made.width, size_mm[1] + made.height) / 2
    title = Text(scene.title.get(lang, ""), corner + complex(made.width / 2, 10), 5.0, "middle")
    return [*made.marks_placed_at(corner.real, corner.imag), *([title] if title.text else [])]
