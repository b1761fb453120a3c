"""A course: individual work for a list of students, from a folder with a list of names and scenes.

The folder holds ``students.txt`` (a name per line) or ``students.csv`` (a head ``name,group,assignment,variant``, of
which only the name is required; semicolons or tabs work too) and the scenes of the assignments. A ``course.yaml``
gives details; all its keys except ``course`` are optional::

    course: 1                            # the format
    title: Курсовой проект, осень 2026   # printed on every task
    lang: ru
    sheet: {group: М-31, teacher: Петров П. П.}   # texts of every sheet, with the keys of a scene's ``sheet``
    students: students.csv               # or a list here: names, or {name: …, group: …, assignment: 12, variant: Б}
    assignments: [../12.yaml, ../more]   # scenes, or folders of them, handed out in turn
    each: 1                              # how many assignments a student gets
    variants: given                      # the variants of the scene first, then drawn numbers; or: drawn
    draw: {phi_1: {from: 0, to: 345, step: 15}, l_AB: 10 %, F_5: [1000, 1500, 2000]}
    sharpness: 15                        # degrees: with drawn numbers no lines of any plan cross at less, all round
    documents: [task, blank, key, sheets, lesson]   # note, book, scorm, moodle, stack, prairielearn too
    formats: [pdf]                       # of the sheets: dxf, svg, png as well
    plans: [velocity, acceleration, force]          # what is asked: in tasks, on blanks, on platforms
    seed: 1

A student's numbers depend on the name, the assignment and the seed alone, so a name added to the list changes nobody
else's; only the given variants go by the order of the list. No two have drawn numbers that give the same ``plans``.
"""

from collections.abc import Mapping
from pathlib import Path

from planes.scene.mechanism import nothing
from planes.scene.settings import Words
from planes.scene.source import Nodes
from planes.words import Lang
from planes.words.errors import Doubt
from planes.words.formats import DRAWING_SUFFIXES
from planes.words.frozen import field, frozen
from planes.words.names import NameTuple

PLATFORMS = ("moodle", "stack", "prairielearn")
DOCUMENTS = ("task", "blank", "key", "sheets", "lesson", "note", "book", "scorm", *PLATFORMS)
FORMATS = tuple(suffix[1:] for suffix in DRAWING_SUFFIXES)


@frozen
class Student:
    """A student of the list. ``assignment`` is the name of a scene's file without its suffix, None to get one in turn;
    ``variant`` one of its variants; ``line`` the student's line in the list."""

    name: str
    group: str = ""
    assignment: str | None = None
    variant: str | None = None
    line: int = 0


@frozen
class ParameterChoice:
    """The choices for a parameter: ``values`` as written, or ``percent`` around the scene's own."""

    values: NameTuple = ()
    percent: float | None = None


@frozen
class Assignment:
    """A scene to hand out: its file, its text, its variants, and the doubts about any of them."""

    file: Path
    text: str
    variants: NameTuple
    doubts: tuple[Doubt, ...] = ()

    @property
    def name(self) -> str:
        """The name of the file without its suffix."""
        return self.file.stem


Students = tuple[Student, ...]
Assignments = tuple[Assignment, ...]


@frozen
class Course:
    """The contents of a course folder. ``draw`` is None where the program chooses what to draw."""

    file: str
    students: Students
    assignments: Assignments
    title: Words = field(default_factory=nothing)
    sheet: Nodes = field(default_factory=nothing)
    each: int = 1
    given_first: bool = True
    draw: Mapping[str, ParameterChoice] | None = None
    sharpness_deg: float = 15.0
    documents: NameTuple = DOCUMENTS[:5]
    formats: NameTuple = FORMATS[:1]
    plans: NameTuple = ("velocity", "acceleration", "force")
    seed: int = 1
    lang: Lang | None = None
    unread: str = ""  # a list of students in the folder that is not used
