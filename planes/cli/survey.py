"""``planes solve FOLDER``: every scene of a folder in every variant, as one table."""

from __future__ import annotations

import argparse
from collections.abc import Callable

from planes.course.survey import lines_of, report, scenes_of
from planes.course.workers import crowd
from planes.documents.lesson import bar


def run(args: argparse.Namespace, as_json: Callable[[object], str]) -> int:
    """Solve, print; exit status 0 if everything is solved and its balancing loads agree, else 1."""
    tasks = [(str(path), args.lang, args.variant) for path in scenes_of(args.scene)]
    found = {}
    with crowd(ready=("planes.course.survey",)) as each, bar() as step:
        for k, lines in each(lines_of, tasks):
            found[k] = lines
            if step:
                step(len(found), len(tasks))
    rows = [row for k in sorted(found) for row in found[k]]
    print(as_json([row.json() for row in rows]) if args.json else report(rows, args.lang), end="\n" * args.json)
    return 0 if all(row.right for row in rows) else 1
