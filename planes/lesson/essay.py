"""An essay on the method of plans: twelve short pages, one figure per paragraph, from two vectors to six links with
forces, then a beam and a truss.

A page is the data of a lesson, with the words of each paragraph and the part of the lesson in its figure.
"""

from collections.abc import Container
from pathlib import Path

from planes.lesson.data import lesson_data
from planes.lesson.formulas import sentence_in_lesson_languages, slot_value_names
from planes.scene import load, loads
from planes.words.records import Json

TEMPLATE_FOLDER = Path(__file__).parents[1] / "templates"
FIGURE_FRAME_KEYS = ("key", "plan", "makes", "uses", "equation", "terms", "moments", "turns")
"""The parts of a frame that a figure needs; the paragraph replaces its words."""
RAFT_SCENE_TEXT = """\
planes: 1
vectors: {v_B: {value: 1.4, direction: 12}, v_CB: {value: 1, direction: 80}, v_C: {}}
equations: ["v_C = v_B + v_CB"]
mu: 30 mm/(m/s)
"""


FIGURES_BY_PAGE = (
    (
        "raft",
        "velocity velocity:b mu_velocity",
        "velocity velocity:c",
        "velocity measured@velocity |v_B| |v_CB| angle_∠v_CB",
    ),
    (
        "vectors",
        "velocity velocity:b |v_B|",
        "velocity velocity:c angle_∠v_CB angle_∠v_C",
        "velocity velocity:c angle_∠v_C",
    ),
    (
        "four-bar",
        "position position:B phi l_AB",
        "velocity velocity:a phi omega_1",
        "velocity velocity:b phi",
        "position sense@v_BA phi",
    ),
    ("four-bar", "velocity measured@v_BA phi", "velocity velocity:s2 phi", "velocity velocity:b phi l_OA"),
    (
        "four-bar",
        "acceleration acceleration:a' phi epsilon_1",
        "acceleration acceleration:n_BC phi",
        "acceleration acceleration:b' phi epsilon_1",
        "position sense@a_BA^t phi",
    ),
    (
        "slotted-lever",
        "position position:D phi",
        "velocity velocity:b3 phi",
        "acceleration acceleration:k_B3B phi",
        "acceleration acceleration:b3' phi epsilon_1",
    ),
    (
        "four-bar",
        "position moments@F_21^t phi m_2",
        "position moments@F_30^t phi M_3_given",
        "force:2-3 force:2-3:F_30n phi m_2 m_3",
        "position force:2-3:F_30n phi",
    ),
    ("four-bar", "force:2-3 apart@F_32 phi M_3_given", "force:1 closing@F_10 phi", "position moments@F_12 phi"),
    ("four-bar", "lever lever:s3 phi", "lever moments@MI_3 phi", "lever moments@MI_3 phi M_3_given m_2 epsilon_1"),
    (
        "six-link",
        "position position:F phi",
        "velocity velocity:f phi",
        "acceleration acceleration:f' phi",
        "force:4-5 force:4-5:F_50 phi P_5_given",
        "lever moments@MI_4 phi",
    ),
    (
        "beam",
        "force force:O |P_C| |pO|",
        "position position:3 |pO| angle_∠O",
        "force measured@R_A angle_∠O |P_C|",
        "position position:D·· |P_C| |pO|",
    ),
    (
        "truss",
        "force measured@R_A |P_C| angle_∠P_C",
        "cremona cremona:c |P_C|",
        "cremona measured@S_DF |P_C| angle_∠P_C",
    ),
)
"""For each page its scene, and its figures: the scheme or a plan, up to the frame that makes a mark, or that has a key
and mentions a name (key@name); then the numbers with sliders beneath it."""


def data_of_essay_pages(number: int) -> Json:
    """The data of every page, numbered from one."""
    name, *shown = FIGURES_BY_PAGE[number - 1]
    data = dict(
        lesson_data(loads(RAFT_SCENE_TEXT, "raft") if name == "raft" else load(str(TEMPLATE_FOLDER / f"{name}.yaml")))
    )
    frames = data["frames"]
    paragraphs = []
    for k, (view, frame, *knobs) in enumerate(map(str.split, shown), 1):
        said = {
            lang: _with_names_of_givens(text, data["values"])
            for lang, text in sentence_in_lesson_languages(f"essay_{number}_{k}").items()
        }
        paragraphs.append({"view": view, "frame": _index_of_frame(frame, frames), "knobs": knobs, "said": said})
    kept = {"said": {"en": ""}, "why": {"en": ""}}
    for unused in ("practice", "results", "blunt"):
        del data[unused]
    titles = [sentence_in_lesson_languages(f"essay_{k}") for k in range(1, len(FIGURES_BY_PAGE) + 1)]
    own = {"frames": [{**{key: f[key] for key in FIGURE_FRAME_KEYS}, **kept} for f in frames], "paragraphs": paragraphs}
    return {**data, **own, "title": titles[number - 1], "titles": titles, "number": number}


def _index_of_frame(frame: str, frames: list[Json]) -> int:
    """The index of a figure's frame in the lesson."""
    key, _, name = frame.rpartition("@")
    if not key:
        return next(k for k, f in enumerate(frames) if name in f["makes"])
    return max(k for k, f in enumerate(frames) if f["key"] == key and name in (*f["terms"], f["plan"]))


def _with_names_of_givens(text: str, values: Container[str]) -> str:
    """A text in which vectors with given, not measured, lengths have the names of their givens."""
    for name in slot_value_names(text):
        text = text if name in values else text.replace(name, name.replace("‖", "|"))
    return text
