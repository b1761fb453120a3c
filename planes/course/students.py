"""The list of students: one name per line, or a table with a head; its errors; and the shares: assignments in turn, the
variants of each in order, then drawn numbers."""

import csv
import re
import unicodedata
from pathlib import Path

from planes.course import Assignment, Course, Student
from planes.scene import source
from planes.words import Phrase
from planes.words.errors import SceneError, choices, shown
from planes.words.frozen import frozen

FILES = ("students.csv", "students.txt")
MOST_NAME = 100
_HEADS = {
    "name": ("name", "student", "имя", "фио", "студент", "фамилия"),
    "group": ("group", "группа"),
    "assignment": ("assignment", "task", "задание"),
    "variant": ("variant", "вариант"),
}


def read_file(path: Path) -> tuple[Student, ...]:
    """The students of a file: a table if its suffix is .csv or .tsv, else a name a line; ``#`` begins a remark."""
    text = unicodedata.normalize("NFC", source.read(path, table=True))
    if path.suffix.lower() in (".csv", ".tsv"):
        return _table(text, str(path))
    lines = ((n, line.partition("#")[0].strip()) for n, line in enumerate(text.splitlines(), 1))
    return tuple(Student(line, line=n) for n, line in lines if line)


def _table(text: str, file: str) -> tuple[Student, ...]:
    """The rows under a head of known names."""
    lines = text.splitlines()
    first = lines[0] if lines else ""
    rows = csv.reader(lines, delimiter=max(",;\t", key=first.count))
    columns: list[str] = []
    students = []
    for row in rows:
        cells = [cell.strip() for cell in row]
        if not any(cells):
            continue
        if not columns:
            columns = _head(cells, file)
            continue
        said = dict(zip(columns, cells, strict=False))
        if not said.get("name"):
            raise SceneError(Phrase("course_no_name"), file, rows.line_num)
        assignment, variant = (said.get(key) or None for key in ("assignment", "variant"))
        students.append(Student(said["name"], said.get("group", ""), assignment, variant, rows.line_num))
    return tuple(students)


def _head(cells: list[str], file: str) -> list[str]:
    """The meaning of each column; a column with any other name is ignored."""
    known = {word: key for key, words in _HEADS.items() for word in words}
    columns = [known.get(cell.casefold(), "") for cell in cells]
    if "name" not in columns:
        names = tuple(words[0] for words in _HEADS.values())
        raise SceneError(Phrase("course_head", found=shown(", ".join(cells)), names=names), file, 1)
    return columns


def check_students(file: str, students: tuple[Student, ...], assignments: tuple[Assignment, ...]) -> None:
    """Refuse an empty list, a repeated name or one with odd letters, and unknown assignments and variants."""
    if not students:
        raise SceneError(Phrase("course_nobody"), file)
    seen: dict[tuple[str, str], int] = {}
    for s in students:
        if len(s.name) > MOST_NAME:
            raise SceneError(Phrase("course_long_name", name=shown(s.name), most=MOST_NAME), file, s.line)
        if not (s.name + s.group).isprintable():
            raise SceneError(Phrase("course_odd_name", name=shown(s.name + s.group)), file, s.line)
        if (s.name, s.group) in seen:
            first = seen[s.name, s.group]
            raise SceneError(Phrase("course_twice", name=shown(s.name), first=first), file, s.line)
        seen[s.name, s.group] = s.line
        _check_wish(s, assignments, file)


def _check_wish(s: Student, assignments: tuple[Assignment, ...], file: str) -> None:
    """Check the requested assignment and variant of a student."""
    own = wished(s, assignments)
    if s.assignment and own is None:
        valid = choices(s.assignment, [a.name for a in assignments])
        raise SceneError(Phrase("course_no_assignment", name=shown(s.assignment), valid=valid), file, s.line)
    if s.variant and own is None and len(assignments) > 1:
        raise SceneError(Phrase("course_variant_of", name=shown(s.variant)), file, s.line)
    known = (own or assignments[0]).variants
    if s.variant and s.variant not in known:
        valid = choices(s.variant, known) or Phrase("no_variants")
        raise SceneError(Phrase("no_variant", name=shown(s.variant), valid=valid), file, s.line)


def wished(s: Student, assignments: tuple[Assignment, ...]) -> Assignment | None:
    """The assignment requested for a student: 1 is 01 too."""
    name = (s.assignment or "").lstrip("0")
    return next((a for a in assignments if name and a.name.lstrip("0") == name), None)


DEVICES = ("con", "prn", "aux", "nul", *(f"{port}{n}" for port in ("com", "lpt") for n in "0123456789¹²³"))
"""Names that Windows takes for a device in any folder."""


@frozen
class Share:
    """One student's one assignment, in the folder ``place``; ``variant`` is None where numbers are drawn."""

    student: Student
    assignment: Assignment
    variant: str | None
    place: str

    @property
    def folder(self) -> str:
        """The student's folder, which no other student has."""
        return self.place.partition("/")[0]


def shares(course: Course) -> tuple[Share, ...]:
    """Everybody's share, in the order of the list."""
    placed = enumerate(zip(course.students, _places(course.students), strict=True))
    wanted = [(s, a, p) for k, (s, p) in placed for a in _assignments(course, s, k)]
    taken = {(a.name, s.variant) for s, a, _ in wanted}  # variants requested in the list
    free = {a.name: iter([v for v in a.variants if (a.name, v) not in taken]) for a in course.assignments}

    def variant(s: Student, a: Assignment) -> str | None:
        return s.variant or (next(free[a.name], None) if course.given_first else None)

    return tuple(Share(s, a, variant(s, a), f"{p}/{a.name}" if course.each > 1 else p) for s, a, p in wanted)


def _assignments(course: Course, student: Student, number: int) -> list[Assignment]:
    """The requested assignment of a student, or the next ones in turn."""
    own = wished(student, course.assignments)
    count = min(course.each, len(course.assignments))
    return [own] if own else [course.assignments[(number + k) % len(course.assignments)] for k in range(count)]


def _places(students: tuple[Student, ...]) -> list[str]:
    """A folder for each student: the name in letters valid on any disk; the second student of the same name gets a
    number."""
    place_of = dict.fromkeys(DEVICES, "")  # as compared by a disk that ignores case
    for number, s in enumerate(students, 1):
        base = place = _slug(s.name) or f"student-{number}"
        if s.group and place.casefold() in place_of:
            base = place = f"{place}-{_slug(s.group)}"
        count = 2
        while place.casefold() in place_of:
            place, count = f"{base}-{count}", count + 1
        place_of[place.casefold()] = place
    return [place for place in place_of.values() if place]


def _slug(name: str) -> str:
    return re.sub(r"[\W_]+", "-", unicodedata.normalize("NFC", name)).strip("-")[:40].strip("-")
