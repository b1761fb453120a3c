"""Who gets what: assignments in turn, the variants of each in order, drawn numbers once they have run out."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator
from dataclasses import dataclass

from planes.course import Assignment, Course, Student
from planes.course.students import wished

DEVICES = ("con", "prn", "aux", "nul", *(f"{port}{n}" for port in ("com", "lpt") for n in "0123456789¹²³"))
"""What Windows takes for a device, whatever folder it is in."""


@dataclass(frozen=True)
class Share:
    """One student's one assignment, in the folder ``place``; ``variant`` is None where numbers are drawn."""

    student: Student
    assignment: Assignment
    variant: str | None
    place: str


def shares(course: Course) -> tuple[Share, ...]:
    """What everybody gets, in the order of the list."""
    places = _places(course.students)
    wanted = [
        (s, a, p)
        for k, (s, p) in enumerate(zip(course.students, places, strict=True))
        for a in _assignments(course, s, k)
    ]
    free = {a.name: _free(a, [s for s, own, _ in wanted if own is a]) for a in course.assignments}
    return tuple(
        Share(
            s,
            a,
            s.variant or (next(free[a.name], None) if course.given_first else None),
            f"{place}/{a.name}" if course.each > 1 else place,
        )
        for s, a, place in wanted
    )


def _assignments(course: Course, student: Student, number: int) -> list[Assignment]:
    """The assignment a student is to have, or the next ones in turn."""
    own = wished(student, course.assignments)
    count = min(course.each, len(course.assignments))
    return [own] if own else [course.assignments[(number + k) % len(course.assignments)] for k in range(count)]


def _free(assignment: Assignment, students: list[Student]) -> Iterator[str]:
    """The variants none of its students has asked for."""
    taken = {s.variant for s in students}
    return (v for v in assignment.variants if v not in taken)


def _places(students: tuple[Student, ...]) -> list[str]:
    """A folder for each student: the name in letters any disk holds; the second of one name gets a number."""
    found = dict.fromkeys(DEVICES, "")  # by what a disk that knows no capitals tells apart
    for number, s in enumerate(students, 1):
        base = place = _slug(s.name) or f"student-{number}"
        if s.group and place.casefold() in found:
            base = place = f"{place}-{_slug(s.group)}"
        count = 2
        while place.casefold() in found:
            place, count = f"{base}-{count}", count + 1
        found[place.casefold()] = place
    return [place for place in found.values() if place]


def _slug(name: str) -> str:
    return re.sub(r"[\W_]+", "-", unicodedata.normalize("NFC", name)).strip("-")[:40].strip("-")
