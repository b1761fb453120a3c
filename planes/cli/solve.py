"""The command ``planes solve``: results of every position as tables or JSON, what failed on stderr."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable

from planes.instruments import Exact, Pencil
from planes.scene import Scene
from planes.solving import solve
from planes.tables import report


def run(args: argparse.Namespace, scene: Scene, values: list[float] | None, as_json: Callable[[object], str]) -> int:
    """Solve and print; the exit status."""
    if args.explain:
        from planes.cycle.explaining import explain

        print(explain(scene, args.lang), end="")
        return 0
    instrument = Pencil(seed=args.seed) if args.pencil else Exact()
    solved = solve(scene, values, instrument, args.lang)
    if args.remedy:
        from planes.remedies import remedy

        remedy(solved, instrument, args.lang)
    if args.errors:
        from planes.erring import add_errors

        add_errors(solved, instrument)
    for failure in solved.failed:
        print(f"{scene.file}: {failure['error']}", file=sys.stderr)
    if args.json:
        if solved.positions or solved.failed:
            print(as_json(solved.json()))
    elif solved.positions:
        print(report(solved, args.lang), end="")
    return 0 if solved.positions else 2
