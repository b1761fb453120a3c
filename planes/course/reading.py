"""The folder of a course: its course.yaml, its list of students, its scenes; each error with file:line."""

import os
from contextlib import suppress
from pathlib import Path
from types import MappingProxyType

from planes.course import DOCUMENTS, FORMATS, Assignment, Course, ParameterChoice, Student
from planes.course.students import FILES, check_students, read_file
from planes.scene import loads, source
from planes.scene.reader import Fields, Reader, part
from planes.scene.settings import read_sheet, read_words
from planes.scene.source import Items, Node, SourceScalar, SourceTable
from planes.words import Phrase, Told, langs
from planes.words.errors import PlanesError, SceneError, choices, near_file, shown
from planes.words.units import PLANS

NAME = "course.yaml"
_KEYS = "course title lang sheet students assignments each variants draw sharpness documents formats plans seed"
KEYS = tuple(_KEYS.split())
STUDENT_KEYS = ("name", "group", "assignment", "variant")
DRAW_KEYS = ("from", "to", "step")
MOST_VALUES = 10_000  # values a parameter may be drawn from
MOST_EACH = 100


def read_course(folder: str | Path) -> Course:
    """The course of a folder, or of a course file itself; :class:`SceneError` says what is invalid, and where."""
    path = Path(folder)
    file = path if path.is_file() else path / NAME
    if not path.exists():
        raise SceneError(Phrase("course_no_folder", near=near_file(folder)), str(folder))
    table = source.parse(source.read(file), str(file)) if file.is_file() else SourceTable({}, 1)
    reader = Reader(str(file))
    course = Fields(reader, table, Phrase("the_course"), KEYS)
    if file.is_file():
        version = reader.text(course.required("course"), "course")
        if version != "1":
            raise reader.fault("course_format", table.entries["course"], version=shown(version))
    return _course(course, file.parent)


def _course(course: Fields, folder: Path) -> Course:
    reader, get = course.reader, {key: course.optional(key) for key in KEYS}
    assignments = _assignments(reader, get["assignments"], folder)
    students = _students(reader, get["students"], folder)
    check_students(*students, assignments)
    sheet = get["sheet"]
    read_sheet(reader, sheet)
    lang = None if get["lang"] is None else reader.word(get["lang"], "lang", langs())
    way = "given" if get["variants"] is None else reader.word(get["variants"], "variants", ("given", "drawn"))
    return Course(
        file=reader.file,
        students=students[1],
        assignments=assignments,
        title=MappingProxyType(read_words(reader, get["title"], "title")),
        sheet=MappingProxyType(sheet.entries if isinstance(sheet, SourceTable) else {}),
        each=_whole(reader, get["each"], "each", MOST_EACH),
        given_first=way == "given",
        draw=_draw(reader, get["draw"], assignments),
        sharpness_deg=_sharpness(reader, get["sharpness"]),
        documents=_words(reader, get["documents"], "documents", DOCUMENTS, DOCUMENTS[:5]),
        formats=_words(reader, get["formats"], "formats", FORMATS, FORMATS[:1]),
        plans=_words(reader, get["plans"], "plans", PLANS, PLANS[1:]),
        seed=_whole(reader, get["seed"], "seed", 10**9),
        lang=lang,
        unread="" if get["students"] is None or students[0] != reader.file else _list_in(folder),
    )


def _students(reader: Reader, node: Node | None, folder: Path) -> tuple[str, tuple[Student, ...]]:
    """The file of the list, and the list."""
    if isinstance(node, SourceScalar):
        path = _path(reader, node, "students", folder)
        return str(path), read_file(path)
    if node is not None:
        return reader.file, tuple(_student(reader, n, item) for n, item in enumerate(reader.items(node, "students"), 1))
    if not (list_file := _list_in(folder)):
        raise SceneError(Phrase("course_no_students", folder=str(folder), files=FILES), reader.file)
    return list_file, read_file(Path(list_file))


def _list_in(folder: Path) -> str:
    """The list of students found in a folder, "" where there is none."""
    return next((str(folder / name) for name in FILES if (folder / name).is_file()), "")


def _student(reader: Reader, number: int, node: Node) -> Student:
    what = Phrase("entry", number=number, what="students")
    if isinstance(node, SourceScalar):
        return Student(reader.text(node, what), line=node.line)
    student = Fields(reader, node, what, STUDENT_KEYS)
    said = {k: student.text(k) for k in reader.present(student.table)}
    student.required("name")
    return Student(said["name"], said.get("group", ""), said.get("assignment"), said.get("variant"), node.line)


def _assignments(reader: Reader, node: Node | None, folder: Path) -> tuple[Assignment, ...]:
    """The scenes, in the order given; by default those of the folder itself."""
    if node is None:
        files = scenes_in(folder)
    else:
        nodes = [node] if isinstance(node, SourceScalar) else reader.items(node, "assignments")
        entries = ((n, Phrase("entry", number=k, what="assignments")) for k, n in enumerate(nodes, 1))
        paths = [_path(reader, n, what, folder) for n, what in entries]
        files = [f for p in paths for f in (scenes_in(p) if p.is_dir() else [p])]
    if not files:
        where = reader.file if node is not None else str(folder)
        raise SceneError(Phrase("course_no_scenes"), where, None if node is None else node.line)
    assignments = tuple(_assignment(f) for f in files)
    names = [a.name for a in assignments]
    if twice := next((n for n in names if names.count(n) > 1), None):
        raise SceneError(Phrase("course_scene_twice", name=twice), reader.file, None if node is None else node.line)
    return assignments


def _path(reader: Reader, node: Node, what: Told, folder: Path) -> Path:
    """A file or a folder that the course names."""
    text = reader.text(node, what)
    if not os.path.exists(folder / text):
        raise reader.fault("course_no_file", node, what=what, file=shown(text))
    return folder / text


def scenes_in(folder: Path) -> list[Path]:
    """Scenes of a folder, without the course file."""
    return sorted(f for f in folder.iterdir() if f.suffix in (".yaml", ".yml") and f.name != NAME and f.is_file())


def _assignment(file: Path) -> Assignment:
    text = source.read(file)
    scene = loads(text, str(file))
    doubts = list(scene.doubts)
    for variant in scene.variants:
        with suppress(PlanesError):  # reported to whoever gets it
            doubts += loads(text, str(file), variant).doubts
    return Assignment(file, text, scene.variants, tuple({d.told(): d for d in doubts}.values()))


def _draw(
    reader: Reader, node: Node | None, assignments: tuple[Assignment, ...]
) -> MappingProxyType[str, ParameterChoice] | None:
    """The choices for each named parameter."""
    if node is None:
        return None
    table = reader.table(node, "draw")
    known = dict.fromkeys(name for a in assignments for name in loads(a.text, str(a.file)).parameters)
    for name, line in table.lines.items():
        if name not in known:
            raise reader.fault("course_draw_name", line, name=shown(name), valid=choices(name, known))
    return MappingProxyType({name: _choice(reader, name, entry) for name, entry in table.entries.items()})


def _choice(reader: Reader, name: str, node: Node) -> ParameterChoice:
    what = part(name, "draw")
    if isinstance(node, Items):
        values = [reader.number(n, what) for n in reader.items(node, what)]
    elif isinstance(node, SourceTable):
        low, high, step = map(Fields(reader, node, what, DRAW_KEYS).number, DRAW_KEYS)
        if step <= 0 or high < low or (high - low) / step > MOST_VALUES:
            raise reader.fault("course_range", node, what=what, most=MOST_VALUES)
        values = [low + k * step for k in range(int((high - low) / step + 1e-9) + 1)]
    else:
        text = reader.text(node, what)
        if not text.endswith("%"):
            raise reader.fault("course_choice", node, what=what, text=shown(text))
        return ParameterChoice(percent=reader.positive(SourceScalar(text[:-1].strip(), node.line), what))
    if not values:
        raise reader.fault("course_choice", node, what=what, text="[]")
    return ParameterChoice(tuple(f"{v:.10g}" for v in values))


def _sharpness(reader: Reader, node: Node | None) -> float:
    value = Course.sharpness_deg if node is None else reader.number(node, "sharpness")
    if not 0 <= value < 90:
        raise reader.fault("course_sharpness", node or 1, value=value)
    return value


def _whole(reader: Reader, node: Node | None, key: str, most: int) -> int:
    value = 1 if node is None else reader.number(node, key)
    if value != int(value) or not 0 <= value <= most or (key == "each" and value < 1):
        raise reader.fault("course_whole", node or 1, key=key, value=value, most=most)
    return int(value)


def _words(
    reader: Reader, node: Node | None, key: str, known: tuple[str, ...], default: tuple[str, ...]
) -> tuple[str, ...]:
    """Some of the known words, in their standard order."""
    if node is None:
        return default
    nodes = [node] if isinstance(node, SourceScalar) else reader.items(node, key)
    said = {reader.word(n, Phrase("entry", number=k, what=key), known) for k, n in enumerate(nodes, 1)}
    return tuple(word for word in known if word in said)
