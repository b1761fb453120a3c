"""The command line: ``planes solve · structure · sheet``. Bad input is one sentence and exit status 2."""

from __future__ import annotations

import argparse
import json
import locale
import os
import sys
from collections.abc import Callable, Sequence
from typing import Any

from planes.angles import read_range
from planes.scene import Scene, load
from planes.wording import PlanesError


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    args = _parser().parse_args(argv)
    try:
        return int(args.command(args))
    except PlanesError as error:
        print(error, file=sys.stderr)
        return 2
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except KeyboardInterrupt:
        return 130


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="planes", description="Plans of mechanisms, drawn and measured.")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    solve = _command(commands, "solve", _solve, "draw the plans of a scene and print what they measure")
    _positions(solve)
    solve.add_argument("--json", action="store_true", help="print an object for programs instead of tables")
    solve.add_argument("--pencil", action="store_true", help="draw with a pencil's errors instead of exactly")
    solve.add_argument("--seed", type=int, default=1, help="which errors the pencil makes")
    structure = _command(commands, "structure", _structure, "print W, q, Assur groups and the formula of structure")
    structure.add_argument("--json", action="store_true", help="print an object for programs")
    sheet = _command(commands, "sheet", _sheet, "draw the sheet of a scene: SVG, PDF or PNG by the file's suffix")
    _positions(sheet)
    sheet.add_argument("-o", "--output", required=True, metavar="FILE", help="the file to write (.svg, .pdf, .png)")
    return parser


def _command(commands: Any, name: str, run: Callable[[argparse.Namespace], int], text: str) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(name, help=text, description=text)
    parser.add_argument("scene", metavar="SCENE", help="the scene file (YAML)")
    parser.add_argument("--variant", help="which variant of the scene's numbers")
    parser.add_argument("--lang", choices=("ru", "en"), default=_home_lang(), help="language of the words")
    parser.set_defaults(command=run)
    return parser


def _home_lang() -> str:
    """Russian where the system speaks Russian, Belarusian, Ukrainian or Kazakh; else English."""
    said = next((os.environ[k] for k in ("LC_ALL", "LC_MESSAGES", "LANG") if os.environ.get(k)), "")
    return "ru" if (said or locale.getlocale()[0] or "").lower().startswith(("ru", "be", "uk", "kk")) else "en"


def _positions(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--phi", metavar="A[:B:STEP]", help="angle(s) of the driver, degrees, instead of the scene's")
    parser.add_argument("--s", metavar="A[:B:STEP]", help="place(s) of a sliding driver, m")


def _values(args: argparse.Namespace, scene: Scene) -> list[float] | None:
    """The values of the drive asked for on the command line."""
    kind = scene.mechanism.drive.kind if scene.mechanism else None
    asked = {"phi": args.phi, "s": args.s}
    for option, text in asked.items():
        if text is not None and option != kind:
            other = f"its driver is given by --{kind}" if kind else "it has no driver"
            raise PlanesError(f"--{option} does not fit {scene.file}: {other}")
    text = asked.get(kind or "")
    return None if text is None else read_range(text, f"--{kind}")


def _solve(args: argparse.Namespace) -> int:
    from planes.instruments import Exact, Pencil
    from planes.solving import solve
    from planes.tables import report

    scene = load(args.scene, args.variant)
    if scene.mechanism is None:
        return _solve_vectors(args, scene)
    instrument = Pencil(seed=args.seed) if args.pencil else Exact()
    solved = solve(scene, _values(args, scene), instrument, args.lang)
    for failure in solved.failed:
        print(failure["error"], file=sys.stderr)
    if args.json:
        if solved.positions or solved.failed:
            print(json.dumps(solved.json(), ensure_ascii=False, allow_nan=False))
    elif solved.positions:
        print(report(solved, args.lang), end="")
    return 0 if solved.positions else 2


def _solve_vectors(args: argparse.Namespace, scene: Scene) -> int:
    from planes.tables import vector_report
    from planes.vectors import solve_vectors

    results = solve_vectors(scene)
    print(json.dumps(results.json(), ensure_ascii=False) if args.json else vector_report(results, args.lang))
    return 0


def _structure(args: argparse.Namespace) -> int:
    from planes.solving import structure_json
    from planes.structure import analyse
    from planes.tables import structure_report

    scene = load(args.scene, args.variant)
    if scene.mechanism is None:
        raise PlanesError(f"{args.scene}: states vectors and has no mechanism, so it has no structure")
    found = analyse(scene.mechanism, scene.file)
    print(json.dumps(structure_json(found)) if args.json else structure_report(found, args.lang))
    return 0


def _sheet(args: argparse.Namespace) -> int:
    from planes.roof import draw_sheet

    scene = load(args.scene, args.variant)
    draw_sheet(scene, _values(args, scene), args.output, args.lang)
    return 0


if __name__ == "__main__":
    sys.exit(main())
