"""The folder of a course: its course.yaml, its list of students, its scenes; each error with file:line."""

import os
from contextlib import suppress
from pathlib import Path
from types import MappingProxyType

from planes.course import DOCUMENTS, FORMATS, Assignment, Assignments, Course, ParameterChoice, Student, Students
from planes.course.students import STUDENT_LIST_FILES, check_students, read_students
from planes.scene import loads, source
from planes.scene.reader import Fields, Reader, part_in_words
from planes.scene.settings import read_sheet_settings, read_text_by_language
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.words import Phrase, Told, available_languages
from planes.words.errors import PlanesError, SceneError, list_valid_choices, quoted_excerpt, suggest_file
from planes.words.names import NameTuple
from planes.words.units import PLANS_WITH_MU

COURSE_FILE_NAME = "course.yaml"
_COURSE_KEY_WORDS = (
    "course title lang sheet students assignments each variants draw sharpness documents formats plans seed"
)
COURSE_KEYS = tuple(_COURSE_KEY_WORDS.split())
STUDENT_KEYS = ("name", "group", "assignment", "variant")
DRAW_KEYS = ("from", "to", "step")
MOST_PARAMETER_VALUES = 10_000  # values a parameter may be drawn from
MOST_ASSIGNMENTS_EACH = 100


def read_course(folder: str | Path) -> Course:
    """The course of a folder, or of a course file itself; :class:`SceneError` says what is invalid, and where."""
    path = Path(folder)
    file = path if path.is_file() else path / COURSE_FILE_NAME
    if not path.exists():
        raise SceneError(Phrase("course_no_folder", near=suggest_file(folder)), str(folder))
    table = source.parse_yaml(source.read_file_text(file), str(file)) if file.is_file() else SourceTable({}, 1)
    reader = Reader(str(file))
    course = Fields(reader, table, Phrase("the_course"), COURSE_KEYS)
    if file.is_file():
        version = reader.read_text(course.required_node("course"), "course")
        if version != "1":
            raise reader.error_by_key("course_format", table.entries["course"], version=quoted_excerpt(version))
    return _read_course_table(course, file.parent)


def _read_course_table(course: Fields, folder: Path) -> Course:
    reader = course.reader
    get = {key: course.optional_node(key) for key in COURSE_KEYS}
    assignments = _read_assignments(reader, get["assignments"], folder)
    students = _read_student_list(reader, get["students"], folder)
    check_students(*students, assignments)
    sheet = get["sheet"]
    read_sheet_settings(reader, sheet)
    lang = None if get["lang"] is None else reader.read_word(get["lang"], "lang", available_languages())
    way = "given" if get["variants"] is None else reader.read_word(get["variants"], "variants", ("given", "drawn"))
    return Course(
        file=reader.file,
        students=students[1],
        assignments=assignments,
        title=MappingProxyType(read_text_by_language(reader, get["title"], "title")),
        sheet=MappingProxyType(sheet.entries if isinstance(sheet, SourceTable) else {}),
        each=_read_whole_number(reader, get["each"], "each", MOST_ASSIGNMENTS_EACH),
        given_first=way == "given",
        draw=_read_draw_choices(reader, get["draw"], assignments),
        sharpness_deg=_read_sharpness(reader, get["sharpness"]),
        documents=_read_known_words(reader, get["documents"], "documents", DOCUMENTS, DOCUMENTS[:5]),
        formats=_read_known_words(reader, get["formats"], "formats", FORMATS, FORMATS[:1]),
        plans=_read_known_words(reader, get["plans"], "plans", PLANS_WITH_MU, PLANS_WITH_MU[1:]),
        seed=_read_whole_number(reader, get["seed"], "seed", 10**9),
        lang=lang,
        unread="" if get["students"] is None or students[0] != reader.file else _student_list_in_folder(folder),
    )


def _read_student_list(reader: Reader, node: Node | None, folder: Path) -> tuple[str, Students]:
    """The file of the list, and the list."""
    if isinstance(node, SourceScalar):
        path = _read_path(reader, node, "students", folder)
        return str(path), read_students(path)
    if node is not None:
        return reader.file, tuple(
            _read_student(reader, n, item) for n, item in enumerate(reader.read_list(node, "students"), 1)
        )
    if not (list_file := _student_list_in_folder(folder)):
        raise SceneError(Phrase("course_no_students", folder=str(folder), files=STUDENT_LIST_FILES), reader.file)
    return list_file, read_students(Path(list_file))


def _student_list_in_folder(folder: Path) -> str:
    """The list of students found in a folder, "" where there is none."""
    return next((str(folder / name) for name in STUDENT_LIST_FILES if (folder / name).is_file()), "")


def _read_student(reader: Reader, number: int, node: Node) -> Student:
    what = Phrase("entry", number=number, what="students")
    if isinstance(node, SourceScalar):
        return Student(reader.read_text(node, what), line=node.line)
    student = Fields(reader, node, what, STUDENT_KEYS)
    said = {k: student.read_text(k) for k in reader.non_empty_values(student.table)}
    student.required_node("name")
    return Student(said["name"], said.get("group", ""), said.get("assignment"), said.get("variant"), node.line)


def _read_assignments(reader: Reader, node: Node | None, folder: Path) -> Assignments:
    """The scenes, in the order given; by default those of the folder itself."""
    if node is None:
        files = scene_files_in(folder)
    else:
        nodes = [node] if isinstance(node, SourceScalar) else reader.read_list(node, "assignments")
        entries = ((n, Phrase("entry", number=k, what="assignments")) for k, n in enumerate(nodes, 1))
        paths = [_read_path(reader, n, what, folder) for n, what in entries]
        files = [f for p in paths for f in (scene_files_in(p) if p.is_dir() else [p])]
    if not files:
        where = reader.file if node is not None else str(folder)
        raise SceneError(Phrase("course_no_scenes"), where, None if node is None else node.line)
    assignments = tuple(map(_assignment_of_file, files))
    names = [a.name for a in assignments]
    if twice := next((n for n in names if names.count(n) > 1), None):
        raise SceneError(Phrase("course_scene_twice", name=twice), reader.file, None if node is None else node.line)
    return assignments


def _read_path(reader: Reader, node: Node, what: Told, folder: Path) -> Path:
    """A file or a folder that the course names."""
    text = reader.read_text(node, what)
    if not os.path.exists(folder / text):
        raise reader.error_by_key("course_no_file", node, what=what, file=quoted_excerpt(text))
    return folder / text


def scene_files_in(folder: Path) -> list[Path]:
    """Scenes of a folder, without the course file."""
    return sorted(
        f for f in folder.iterdir() if f.suffix in (".yaml", ".yml") and f.name != COURSE_FILE_NAME and f.is_file()
    )


def _assignment_of_file(file: Path) -> Assignment:
    text = source.read_file_text(file)
    scene = loads(text, str(file))
    doubts = list(scene.doubts)
    for variant in scene.variants:
        with suppress(PlanesError):  # reported to whoever gets it
            doubts += loads(text, str(file), variant).doubts
    return Assignment(file, text, scene.variants, tuple({d.told(): d for d in doubts}.values()))


def _read_draw_choices(
    reader: Reader, node: Node | None, assignments: Assignments
) -> MappingProxyType[str, ParameterChoice] | None:
    """The choices for each named parameter."""
    if node is None:
        return None
    table = reader.read_table(node, "draw")
    known = dict.fromkeys(name for a in assignments for name in loads(a.text, str(a.file)).parameters)
    for name, line in table.lines.items():
        if name not in known:
            raise reader.error_by_key(
                "course_draw_name", line, name=quoted_excerpt(name), valid=list_valid_choices(name, known)
            )
    return MappingProxyType({name: _read_choice(reader, name, entry) for name, entry in table.entries.items()})


def _read_choice(reader: Reader, name: str, node: Node) -> ParameterChoice:
    what = part_in_words(name, "draw")
    if isinstance(node, Items):
        values = [reader.read_number(n, what) for n in reader.read_list(node, what)]
    elif isinstance(node, SourceTable):
        low, high, step = map(Fields(reader, node, what, DRAW_KEYS).read_number, DRAW_KEYS)
        if step <= 0 or high < low or (high - low) / step > MOST_PARAMETER_VALUES:
            raise reader.error_by_key("course_range", node, what=what, most=MOST_PARAMETER_VALUES)
        values = [low + k * step for k in range(int((high - low) / step + 1e-9) + 1)]
    else:
        text = reader.read_text(node, what)
        if not text.endswith("%"):
            raise reader.error_by_key("course_choice", node, what=what, text=quoted_excerpt(text))
        return ParameterChoice(percent=reader.read_non_negative(SourceScalar(text[:-1].strip(), node.line), what))
    if not values:
        raise reader.error_by_key("course_choice", node, what=what, text="[]")
    return ParameterChoice(tuple(f"{v:.10g}" for v in values))


def _read_sharpness(reader: Reader, node: Node | None) -> float:
    value = Course.sharpness_deg if node is None else reader.read_number(node, "sharpness")
    if not 0 <= value < 90:
        raise reader.error_by_key("course_sharpness", node or 1, value=value)
    return value


def _read_whole_number(reader: Reader, node: Node | None, key: str, most: int) -> int:
    value = 1 if node is None else reader.read_number(node, key)
    if value != int(value) or not 0 <= value <= most or (key == "each" and value < 1):
        raise reader.error_by_key("course_whole", node or 1, key=key, value=value, most=most)
    return int(value)


def _read_known_words(reader: Reader, node: Node | None, key: str, known: NameTuple, default: NameTuple) -> NameTuple:
    """Some of the known words, in their standard order."""
    if node is None:
        return default
    nodes = [node] if isinstance(node, SourceScalar) else reader.read_list(node, key)
    said = {reader.read_word(n, Phrase("entry", number=k, what=key), known) for k, n in enumerate(nodes, 1)}
    return tuple(word for word in known if word in said)
