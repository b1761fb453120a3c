"""The command ``planes solve``: results of every position as tables or JSON, what failed on stderr."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable

from planes.drafting.instruments import Exact, Instrument, Pencil
from planes.scene import Scene
from planes.solving import solve
from planes.solving.tables import report, vector_report


def run(args: argparse.Namespace, scene: Scene, values: list[float] | None, as_json: Callable[[object], str]) -> int:
    """Solve and print; the exit status."""
    instrument = Pencil(seed=1 if args.seed is None else args.seed) if args.pencil else Exact()
    if args.explain:
        from planes.solving.explaining import explain

        print(explain(scene, args.lang), end="")
        return 0
    if scene.mechanism is None:
        return _vectors(args, scene, instrument, as_json)
    solved = solve(scene, values, instrument, args.lang)
    if args.remedy:
        from planes.solving.remedies import remedy

        remedy(solved, instrument, args.lang)
    if args.errors:
        from planes.accuracy.errors import add_errors

        add_errors(solved, instrument)
    for failure in solved.failed:
        print(f"{scene.file}: {failure['error']}", file=sys.stderr)
    if args.json:
        if solved.positions or solved.failed:
            print(as_json(solved.json()))
    elif solved.positions:
        print(report(solved, args.lang), end="")
    return 0 if solved.positions else 2


def _vectors(args: argparse.Namespace, scene: Scene, instrument: Instrument, as_json: Callable[[object], str]) -> int:
    from planes.solving.vectors import solve_vectors

    results = solve_vectors(scene, instrument)
    if args.errors:
        from planes.accuracy.errors import vector_errors

        results = vector_errors(results, instrument)
    print(as_json(results.json(args.lang)) if args.json else vector_report(results, args.lang))
    return 0
