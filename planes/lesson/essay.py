"""An essay on the method of plans: ten short pages, one figure a paragraph, from two vectors to six links with forces.

A page is the data of a lesson, and of each paragraph its words and what its figure shows of that lesson.
"""

from collections.abc import Container, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from planes.lesson.data import lesson_data
from planes.lesson.formulas import slots
from planes.lesson.frame import in_both
from planes.scene import load, loads
from planes.words import say
from planes.words.records import Json

TEMPLATES = Path(__file__).parents[1] / "templates"
KEPT = ("key", "plan", "makes", "uses", "equation", "terms", "moments", "turns")
"""What of a frame a figure needs: its own words are the paragraph's."""
RAFT = """\
planes: 1
vectors: {v_B: {value: 1.4, direction: 12}, v_CB: {value: 1, direction: 80}, v_C: {}}
equations: ["v_C = v_B + v_CB"]
mu: 30 mm/(m/s)
"""


@dataclass(frozen=True)
class EssayFigure:
    """The figure of a paragraph: the scheme or a plan, as far as the frame that ``makes`` a mark, or has a ``key`` and
    speaks of a name; the numbers that stand under it to be slid."""

    view: str
    frame: str
    knobs: tuple[str, ...] = ()

    def place(self, frames: list[Json]) -> int:
        """Its frame in the lesson."""
        key, _, name = self.frame.rpartition("@")
        if not key:
            return next(k for k, f in enumerate(frames) if name in f["makes"])
        return max(k for k, f in enumerate(frames) if f["key"] == key and name in (*f["terms"], f["plan"]))


ON = ("phi",)
"""The driver under the figure."""
PAGES: tuple[tuple[str, tuple[EssayFigure, ...]], ...] = (
    (
        "raft",
        (
            EssayFigure("velocity", "velocity:b", ("mu_velocity",)),
            EssayFigure("velocity", "velocity:c"),
            EssayFigure("velocity", "measured@velocity", ("|v_B|", "|v_CB|", "angle_∠v_CB")),
        ),
    ),
    (
        "vectors",
        (
            EssayFigure("velocity", "velocity:b", ("|v_B|",)),
            EssayFigure("velocity", "velocity:c", ("angle_∠v_CB", "angle_∠v_C")),
            EssayFigure("velocity", "velocity:c", ("angle_∠v_C",)),
        ),
    ),
    (
        "four-bar",
        (
            EssayFigure("position", "position:B", (*ON, "l_AB")),
            EssayFigure("velocity", "velocity:a", (*ON, "omega_1")),
            EssayFigure("velocity", "velocity:b", ON),
            EssayFigure("position", "sense@v_BA", ON),
        ),
    ),
    (
        "four-bar",
        (
            EssayFigure("velocity", "measured@v_BA", ON),
            EssayFigure("velocity", "velocity:s2", ON),
            EssayFigure("velocity", "velocity:b", (*ON, "l_OA")),
        ),
    ),
    (
        "four-bar",
        (
            EssayFigure("acceleration", "acceleration:a'", (*ON, "epsilon_1")),
            EssayFigure("acceleration", "acceleration:n_BC", ON),
            EssayFigure("acceleration", "acceleration:b'", (*ON, "epsilon_1")),
            EssayFigure("position", "sense@a_BA^t", ON),
        ),
    ),
    (
        "slotted-lever",
        (
            EssayFigure("position", "position:D", ON),
            EssayFigure("velocity", "velocity:b3", ON),
            EssayFigure("acceleration", "acceleration:k_B3B", ON),
            EssayFigure("acceleration", "acceleration:b3'", (*ON, "epsilon_1")),
        ),
    ),
    (
        "four-bar",
        (
            EssayFigure("position", "moments@F_21^t", (*ON, "m_2")),
            EssayFigure("position", "moments@F_30^t", (*ON, "M_3_given")),
            EssayFigure("force:2-3", "force:2-3:F_30n", (*ON, "m_2", "m_3")),
            EssayFigure("position", "force:2-3:F_30n", ON),
        ),
    ),
    (
        "four-bar",
        (
            EssayFigure("force:2-3", "apart@F_32", (*ON, "M_3_given")),
            EssayFigure("force:1", "closing@F_10", ON),
            EssayFigure("position", "moments@F_12", ON),
        ),
    ),
    (
        "four-bar",
        (
            EssayFigure("lever", "lever:s3", ON),
            EssayFigure("lever", "moments@MI_3", ON),
            EssayFigure("lever", "moments@MI_3", (*ON, "M_3_given", "m_2", "epsilon_1")),
        ),
    ),
    (
        "six-link",
        (
            EssayFigure("position", "position:F", ON),
            EssayFigure("velocity", "velocity:f", ON),
            EssayFigure("acceleration", "acceleration:f'", ON),
            EssayFigure("force:4-5", "force:4-5:F_50", (*ON, "P_5_given")),
            EssayFigure("lever", "moments@MI_4", ON),
        ),
    ),
)
"""Of each page its scene and its figures."""


def essay_data(number: int) -> Json:
    """All that a page shows, numbered from one."""
    name, shown = PAGES[number - 1]
    data = dict(lesson_data(loads(RAFT, "raft") if name == "raft" else load(str(TEMPLATES / f"{name}.yaml"))))
    frames, count = data["frames"], range(1, len(shown) + 1)
    said = {
        k: {lang: _known(text, data["values"]) for lang, text in _told(f"essay_{number}_{k}").items()} for k in count
    }
    told = [{**vars(s), "frame": s.place(frames), "said": said[k]} for k, s in zip(count, shown, strict=True)]
    kept: Mapping[str, object] = {"said": {"en": ""}, "why": {"en": ""}}
    for unused in ("practice", "results", "blunt"):
        del data[unused]
    titles = [_told(f"essay_{k}") for k in range(1, len(PAGES) + 1)]
    own = {"frames": [{**{key: f[key] for key in KEPT}, **kept} for f in frames], "paragraphs": told}
    return {**data, **own, "title": titles[number - 1], "titles": titles, "number": number}


def _known(text: str, values: Container[str]) -> str:
    """A text with lengths of vectors that are given, not measured, by the names of what is given."""
    for name in slots(text):
        text = text if name in values else text.replace(name, name.replace("‖", "|"))
    return text


def _told(key: str) -> Json:
    return in_both(partial(say, key))
