"""``planes course``: the whole set of a course, what was made, what could not be, and what must be said of it."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from planes.course.reading import read_course
from planes.course.workers import crowd
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.options import home_lang

FOLDER = "out"
READY = ("planes.documents.course", "render.report.pdf", "reportlab.platypus", "numpy", "shapely")


def run(args: argparse.Namespace) -> int:
    """Make the course; exit status 0 if all came out, 1 if something is missing, 2 if nothing could be begun."""
    said: Lang | None = args.lang
    args.lang = said or home_lang()
    if args.jobs is not None and args.jobs < 1:
        raise PlanesError(Phrase("course_jobs", count=args.jobs))
    course = read_course(args.folder)
    lang = said or course.lang or args.lang
    from planes.documents.course_run import conduct
    from planes.documents.lesson import bar

    for doubt in (doubt for assignment in course.assignments for doubt in assignment.doubts):
        print(doubt.told(lang), file=sys.stderr)
    folder = Path(args.output) if args.output else Path(course.file).parent / FOLDER
    with crowd(args.jobs, args.scheduler, READY) as each, bar() as step:
        report = conduct(course, folder, each, lang, step, bool(args.scheduler))
    for place, file, sentence in (*report.faults, *report.said):
        print(f"{place}{f'/{file}' if file else ''}: {sentence}", file=sys.stderr)
    counts = {"students": len(course.students), "made": report.made, "kept": report.kept, "faults": len(report.faults)}
    print(say("course_done", args.lang, folder=str(folder), **counts))
    return 1 if report.faults else 0
