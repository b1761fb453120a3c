"""The list of students: one name per line, or a table with a head; its errors; and the shares: assignments in turn, the
variants of each in order, then drawn numbers."""

import csv
import re
import unicodedata
from pathlib import Path

from planes.course import Assignment, Assignments, Course, Student, Students
from planes.scene import source
from planes.words import Phrase
from planes.words.errors import SceneError, list_valid_choices, quoted_excerpt
from planes.words.frozen import frozen
from planes.words.names import NamePair

STUDENT_LIST_FILES = ("students.csv", "students.txt")
MOST_NAME_LETTERS = 100
_COLUMN_HEADS = {
    "name": ("name", "student", "имя", "фио", "студент", "фамилия"),
    "group": ("group", "группа"),
    "assignment": ("assignment", "task", "задание"),
    "variant": ("variant", "вариант"),
}


def read_students(path: Path) -> Students:
    """The students of a file: a table if its suffix is .csv or .tsv, else a name a line; ``#`` begins a remark."""
    text = unicodedata.normalize("NFC", source.read_file_text(path, table=True))
    if path.suffix.lower() in (".csv", ".tsv"):
        return _students_of_table(text, str(path))
    lines = ((n, line.partition("#")[0].strip()) for n, line in enumerate(text.splitlines(), 1))
    return tuple(Student(line, line=n) for n, line in lines if line)


def _students_of_table(text: str, file: str) -> Students:
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
            columns = _column_meanings(cells, file)
            continue
        said = dict(zip(columns, cells, strict=False))
        if not said.get("name"):
            raise SceneError(Phrase("course_no_name"), file, rows.line_num)
        assignment, variant = (said.get(key) or None for key in ("assignment", "variant"))
        students.append(Student(said["name"], said.get("group", ""), assignment, variant, rows.line_num))
    return tuple(students)


def _column_meanings(cells: list[str], file: str) -> list[str]:
    """The meaning of each column; a column with any other name is ignored."""
    known = {word: key for key, words in _COLUMN_HEADS.items() for word in words}
    columns = [known.get(cell.casefold(), "") for cell in cells]
    if "name" not in columns:
        names = tuple(words[0] for words in _COLUMN_HEADS.values())
        raise SceneError(Phrase("course_head", found=quoted_excerpt(", ".join(cells)), names=names), file, 1)
    return columns


def check_students(file: str, students: Students, assignments: Assignments) -> None:
    """Refuse an empty list, a repeated name or one with odd letters, and unknown assignments and variants."""
    if not students:
        raise SceneError(Phrase("course_nobody"), file)
    seen: dict[NamePair, int] = {}
    for s in students:
        if len(s.name) > MOST_NAME_LETTERS:
            raise SceneError(
                Phrase("course_long_name", name=quoted_excerpt(s.name), most=MOST_NAME_LETTERS), file, s.line
            )
        if not (s.name + s.group).isprintable():
            raise SceneError(Phrase("course_odd_name", name=quoted_excerpt(s.name + s.group)), file, s.line)
        if (s.name, s.group) in seen:
            first = seen[s.name, s.group]
            raise SceneError(Phrase("course_twice", name=quoted_excerpt(s.name), first=first), file, s.line)
        seen[s.name, s.group] = s.line
        _check_wish(s, assignments, file)


def _check_wish(s: Student, assignments: Assignments, file: str) -> None:
    """Check the requested assignment and variant of a student."""
    own = requested_assignment(s, assignments)
    if s.assignment and own is None:
        valid = list_valid_choices(s.assignment, [a.name for a in assignments])
        raise SceneError(Phrase("course_no_assignment", name=quoted_excerpt(s.assignment), valid=valid), file, s.line)
    if s.variant and own is None and len(assignments) > 1:
        raise SceneError(Phrase("course_variant_of", name=quoted_excerpt(s.variant)), file, s.line)
    known = (own or assignments[0]).variants
    if s.variant and s.variant not in known:
        valid = list_valid_choices(s.variant, known) or Phrase("no_variants")
        raise SceneError(Phrase("no_variant", name=quoted_excerpt(s.variant), valid=valid), file, s.line)


def requested_assignment(s: Student, assignments: Assignments) -> Assignment | None:
    """The assignment requested for a student: 1 is 01 too."""
    name = (s.assignment or "").lstrip("0")
    return next((a for a in assignments if name and a.name.lstrip("0") == name), None)


WINDOWS_DEVICE_NAMES = ("con", "prn", "aux", "nul", *(f"{port}{n}" for port in ("com", "lpt") for n in "0123456789¹²³"))
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


def shares_of_course(course: Course) -> tuple[Share, ...]:
    """Everybody's share, in the order of the list."""
    placed = enumerate(zip(course.students, _folder_names(course.students), strict=True))
    wanted = [(s, a, p) for k, (s, p) in placed for a in _assignments_of_student(course, s, k)]
    taken = {(a.name, s.variant) for s, a, _ in wanted}  # variants requested in the list
    free = {a.name: iter([v for v in a.variants if (a.name, v) not in taken]) for a in course.assignments}

    def variant(s: Student, a: Assignment) -> str | None:
        return s.variant or (next(free[a.name], None) if course.given_first else None)

    return tuple(Share(s, a, variant(s, a), f"{p}/{a.name}" if course.each > 1 else p) for s, a, p in wanted)


def _assignments_of_student(course: Course, student: Student, number: int) -> list[Assignment]:
    """The requested assignment of a student, or the next ones in turn."""
    own = requested_assignment(student, course.assignments)
    count = min(course.each, len(course.assignments))
    if own:
        return [own]
    return [course.assignments[(number + k) % len(course.assignments)] for k in range(count)]


def _folder_names(students: Students) -> list[str]:
    """A folder for each student: the name in letters valid on any disk; the second student of the same name gets a
    number."""
    place_of = dict.fromkeys(WINDOWS_DEVICE_NAMES, "")  # as compared by a disk that ignores case
    for number, s in enumerate(students, 1):
        base = place = _folder_name(s.name) or f"student-{number}"
        if s.group and place.casefold() in place_of:
            base = place = f"{place}-{_folder_name(s.group)}"
        count = 2
        while place.casefold() in place_of:
            place = f"{base}-{count}"
            count = count + 1
        place_of[place.casefold()] = place
    return [place for place in place_of.values() if place]


def _folder_name(name: str) -> str:
    return re.sub(r"[\W_]+", "-", unicodedata.normalize("NFC", name)).strip("-")[:40].strip("-")
