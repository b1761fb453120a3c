"""Scenes that were handed out, found again for returned work: by the mark of a sheet, or by the name of a file.

A teacher names a scene, a folder of scenes, or a course: its folder, its course.yaml, or its output folder, which holds
every student's scene. No mark or name can lead to any other file.
"""

import re
import unicodedata
from collections.abc import Iterable, Sequence
from functools import cached_property
from pathlib import Path

from planes.check.grading.prepared_plan import known_plans
from planes.check.sheet_mark import SheetMark
from planes.course.ledger import MANIFEST_FILE_NAME
from planes.course.reading import COURSE_FILE_NAME, scene_files_in
from planes.course.students import STUDENT_LIST_FILES
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene, load
from planes.words import Phrase
from planes.words.errors import PlanesError, SceneError
from planes.words.frozen import field, frozen

OUTPUT_FOLDER_NAME = "out"
TEACHER_FOLDER_NAME = "teacher"
SCENE_FILE_NAME = "scene.yaml"
_PLAN_WORD_BEGINNINGS = {
    "velocity": "velocit|скорост|швидк|хуткас",
    "acceleration": "accel|ускор|прискор|паскар",
    "position": "position|полож|станов|схем",
}
"""Beginnings of words for plans, in the languages of students."""
_VARIANT_WORD_PATTERN = r"(?:variant|var|вариант|варіант|варыянт|вар|v|в)\W*"


@frozen
class Task:
    """One scene that was handed out: to whom (the name of the student's folder), for which assignment; "" is any."""

    file: Path
    scene: str = ""
    student: str = ""
    read: dict[str | None, Scene] = field(default_factory=dict, compare=False, repr=False)

    def scene_in_variant(self, name: str | None) -> Scene:
        """The scene in a variant; a student's own scene has none and is returned itself."""
        name = None if self.student else name or None
        if name not in self.read:
            self.read[name] = load(self.file, name)
        return self.read[name]


def are_of_several_assignments(tasks: Iterable[Task]) -> bool:
    """Whether tasks belong to more than one assignment."""
    return len({t.scene for t in tasks}) > 1


@frozen
class HandedOut:
    """All scenes that a teacher has named."""

    tasks: tuple[Task, ...]

    def task_of_mark(self, mark: SheetMark) -> Task | None:
        """The task of a sheet's mark."""
        tasks = [t for t in self.tasks if mark.matches_task_and_student(t.scene, t.student)]
        return tasks[0] if len(tasks) == 1 else None

    def task_of_file_name(self, stem: str) -> Task | None:
        """The task of a file's name: by the student's names, or the last name alone if it is unique."""
        words = words_of_name(stem)
        by_full_name = [t for t in self.tasks if t.student and set(self._words_of_students[t]) <= set(words)]
        last = [t for t in self.tasks if t.student and self._words_of_students[t][0] in words]
        tasks = by_full_name or (last if len({t.student for t in last}) == 1 else [])
        of_scene = [t for t in tasks if set(words_of_name(t.scene)) <= set(words)]
        tasks = of_scene if len(tasks) > 1 else tasks
        return tasks[0] if len(tasks) == 1 else None

    @cached_property
    def _words_of_students(self) -> dict[Task, list[str]]:
        return {t: words_of_name(t.student) or [t.student] for t in self.tasks}


def words_of_name(text: str) -> list[str]:
    """Words of a name, in lower case."""
    return re.findall(r"[^\W_]+", unicodedata.normalize("NFC", text).casefold())


def variant_in_file_name(stem: str, variants: Sequence[str]) -> str | None:
    """The variant in a file's name: after the word for it."""
    text = " ".join(words_of_name(stem))
    named_variants = [
        v for v in variants if re.search(rf"\b{_VARIANT_WORD_PATTERN}{re.escape(' '.join(words_of_name(v)))}\b", text)
    ]
    return max(named_variants, key=len, default=None)


def plan_in_file_name(stem: str, scene: Scene) -> str | None:
    """The plan in a file's name: velocity, скорости, force 2-3."""
    text = " ".join(words_of_name(stem))
    plans = known_plans(scene_plans(scene)) if scene.mechanism else []
    forms = {p: _PLAN_WORD_BEGINNINGS.get(p, rf"\b{' '.join(words_of_name(p))}\b") for p in plans}
    named_plans = [p for p in plans if re.search(forms[p], text)]
    return named_plans[0] if len(named_plans) == 1 else None


def is_course(path: Path) -> bool:
    """Whether the path is a course or a folder of scenes: anything but one scene."""
    return path.is_dir() or path.name == COURSE_FILE_NAME


def scenes_handed_out(path: Path) -> HandedOut:
    """The scenes of the path that a teacher gave; :class:`PlanesError` where a course has not been made yet."""
    if not is_course(path):
        return HandedOut((Task(path, path.stem),))
    folder = path if path.is_dir() else path.parent
    made = next(
        (
            f
            for f in (folder, folder / OUTPUT_FOLDER_NAME)
            if (f / MANIFEST_FILE_NAME).is_file() and (f / TEACHER_FOLDER_NAME).is_dir()
        ),
        None,
    )
    if made:
        own = sorted((made / TEACHER_FOLDER_NAME).glob(f"*/{SCENE_FILE_NAME}")) + sorted(
            (made / TEACHER_FOLDER_NAME).glob(f"*/*/{SCENE_FILE_NAME}")
        )
        return HandedOut(tuple(_own_task(file, made / TEACHER_FOLDER_NAME) for file in own))
    if any((folder / name).is_file() for name in (COURSE_FILE_NAME, *STUDENT_LIST_FILES)):
        raise PlanesError(Phrase("course_not_made", folder=str(folder)))
    tasks = tuple(Task(file, file.stem) for file in scene_files_in(folder))
    if not tasks:
        raise SceneError(Phrase("course_no_scenes"), str(folder))
    return HandedOut(tasks)


def _own_task(file: Path, teacher: Path) -> Task:
    """A student's scene, in the student's folder, or in one of several assignments there."""
    student, *scene = file.parent.relative_to(teacher).parts
    return Task(file, "".join(scene), student)
