"""The command line: ``planes solve · structure · sheet``. Bad input is one sentence and exit status 2."""

from __future__ import annotations

import argparse
import io
import json
import locale
import os
import sys
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

from planes.angles import read_range, read_span
from planes.check_options import add_blank_options, add_options
from planes.scene import Scene, load
from planes.wording import PlanesError
from planes.words import Lang, Phrase, say
from planes.words_method import METHOD


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # a terminal without Cyrillic still gets the numbers
    args = _parser().parse_args(argv)
    try:
        return int(args.command(args))
    except PlanesError as error:
        print(error.told(args.lang), file=sys.stderr)
        return 2
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 0
    except KeyboardInterrupt:
        return 130


def _json(thing: object) -> str:
    """JSON in the letters the output can hold."""
    wide = (sys.stdout.encoding or "").lower().startswith("utf")
    return json.dumps(thing, ensure_ascii=not wide, allow_nan=False)


class _Parser(argparse.ArgumentParser):
    """A reader of the command line that speaks the home language."""

    def format_help(self) -> str:
        return _at_home(super().format_help())

    def format_usage(self) -> str:
        return _at_home(super().format_usage())

    def error(self, message: str) -> NoReturn:
        self.exit(2, self.format_usage() + _at_home(f"{self.prog}: error: {message}\n"))


def _at_home(text: str) -> str:
    lang = _home_lang()
    for key in METHOD if lang != "en" else ():
        if key.startswith("usage_"):
            text = text.replace(say(key), say(key, lang))
    return text


def _help(key: str) -> str:
    return say(key, _home_lang())


def _parser() -> argparse.ArgumentParser:
    parser = _Parser(prog="planes", description=_help("help_planes"))
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    solve = _command(commands, "solve", _solve, _help("help_solve"))
    _positions(solve)
    solve.add_argument("--json", action="store_true", help=_help("help_json"))
    solve.add_argument("--pencil", action="store_true", help=_help("help_pencil"))
    solve.add_argument("--seed", type=int, default=1, help=_help("help_seed"))
    solve.add_argument("--explain", action="store_true", help=_help("help_explain"))
    structure = _command(commands, "structure", _structure, _help("help_structure"))
    structure.add_argument("--json", action="store_true", help=_help("help_object"))
    sheet = _command(commands, "sheet", _sheet, _help("help_sheet"))
    _positions(sheet)
    sheet.add_argument("-o", "--output", required=True, metavar="FILE", help=_help("help_output"))
    sheet.add_argument("--sheet", type=int, choices=(1, 2), help=_help("help_sheet_number"))
    lesson = _command(commands, "lesson", _lesson, _help("help_lesson"))
    lesson.add_argument("-o", "--output", required=True, metavar="FILE", help=_help("help_lesson_output"))
    note = _command(commands, "note", _note, _help("help_note"))
    _positions(note)
    note.add_argument("-o", "--output", required=True, metavar="FILE", help=_help("help_note_output"))
    cycle = _command(commands, "cycle", _cycle, _help("help_cycle"))
    _positions(cycle)
    cycle.add_argument("-o", "--output", required=True, metavar="FILE", help=_help("help_cycle_output"))
    cycle.add_argument("--plain", action="store_true", help=_help("help_slow"))
    chart = _command(commands, "chart", _chart, _help("help_chart"))
    chart.add_argument("-o", "--output", required=True, metavar="FILE", help=_help("help_chart_output"))
    chart.add_argument("--table", metavar="FILE", help=_help("help_table"))
    crank = _command(commands, "crank-slider", _crank_slider, _help("help_crank_slider"))
    crank.add_argument("-o", "--output", metavar="FILE", help=_help("help_report"))
    crank.add_argument("--json", action="store_true", help=_help("help_object"))
    crank.add_argument("--sheet", metavar="FILE", help=_help("help_force_sheet"))
    crank.add_argument("--phi", type=float, metavar="A", help=_help("help_sheet_phi"))
    check = _command(commands, "check", _check, _help("help_check"))
    _positions(check)
    add_options(check, _help)
    blank = _command(commands, "blank", _blank, _help("help_blank"))
    _positions(blank)
    add_blank_options(blank, _help)
    return parser


def _command(commands: Any, name: str, run: Callable[[argparse.Namespace], int], text: str) -> argparse.ArgumentParser:
    parser: argparse.ArgumentParser = commands.add_parser(name, help=text, description=text)
    parser.add_argument("scene", metavar="SCENE", help=_help("help_scene"))
    parser.add_argument("--variant", help=_help("help_variant"))
    parser.add_argument("--lang", choices=("ru", "en"), default=_home_lang(), help=_help("help_lang"))
    parser.set_defaults(command=run)
    return parser


def _home_lang() -> Lang:
    """Russian where the system speaks Russian, Belarusian, Ukrainian or Kazakh; else English."""
    said = next((os.environ[k] for k in ("LC_ALL", "LC_MESSAGES", "LANG") if os.environ.get(k)), "")
    return "ru" if (said or locale.getlocale()[0] or "").lower().startswith(("ru", "be", "uk", "kk")) else "en"


def _positions(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--phi", metavar="A[:B:STEP]", help=_help("help_phi"))
    parser.add_argument("--s", metavar="A[:B:STEP]", help=_help("help_s"))


def _values(args: argparse.Namespace, scene: Scene) -> list[float] | None:
    """The values of the drive asked for on the command line."""
    kind, text = _range(args, scene)
    return None if text is None else read_range(text, f"--{kind}")


def _range(args: argparse.Namespace, scene: Scene) -> tuple[str, str | None]:
    """The kind of the drive, and its values as they were written."""
    kind = scene.mechanism.drive.kind if scene.mechanism else None
    asked = {"phi": args.phi, "s": args.s}
    for option, text in asked.items():
        if text is not None and option != kind:
            why = Phrase("driver_by", kind=kind) if kind else Phrase("no_driver")
            raise PlanesError(Phrase("option_misfit", option=option, file=scene.file, why=why))
    return kind or "", asked.get(kind or "")


def _solve(args: argparse.Namespace) -> int:
    from planes.instruments import Exact, Pencil
    from planes.solving import solve
    from planes.tables import report

    scene = load(args.scene, args.variant)
    values = _values(args, scene)
    if scene.mechanism is None:
        return _solve_vectors(args, scene)
    if args.explain:
        from planes.explaining import explain

        print(explain(scene, args.lang), end="")
        return 0
    instrument = Pencil(seed=args.seed) if args.pencil else Exact()
    solved = solve(scene, values, instrument, args.lang)
    for failure in solved.failed:
        print(failure["error"], file=sys.stderr)
    if args.json:
        if solved.positions or solved.failed:
            print(_json(solved.json()))
    elif solved.positions:
        print(report(solved, args.lang), end="")
    return 0 if solved.positions else 2


def _solve_vectors(args: argparse.Namespace, scene: Scene) -> int:
    from planes.tables import vector_report
    from planes.vectors import solve_vectors

    results = solve_vectors(scene)
    print(_json(results.json()) if args.json else vector_report(results, args.lang))
    return 0


def _structure(args: argparse.Namespace) -> int:
    from planes.solving import structure_json
    from planes.structure import analyse
    from planes.tables import structure_report

    scene = load(args.scene, args.variant)
    if scene.mechanism is None:
        raise PlanesError(Phrase("no_structure", file=args.scene))
    found = analyse(scene.mechanism, scene.file)
    print(_json(structure_json(found)) if args.json else structure_report(found, args.lang))
    return 0


def _check(args: argparse.Namespace) -> int:
    from planes.cli_check import run

    scene = load(args.scene, args.variant)
    values = _values(args, scene)
    return run(args, scene, values[0] if values else None)


def _blank(args: argparse.Namespace) -> int:
    from planes.cli_check import write_blank

    scene = load(args.scene, args.variant)
    values = _values(args, scene)
    return write_blank(args, scene, values[0] if values else None)


def _sheet(args: argparse.Namespace) -> int:
    from planes.roof import draw_sheet

    scene = load(args.scene, args.variant)
    draw_sheet(scene, _values(args, scene), args.output, args.lang, args.sheet)
    return 0


def _lesson(args: argparse.Namespace) -> int:
    from planes.roof_lesson import write_lesson

    write_lesson(load(args.scene, args.variant), args.output, args.lang)
    return 0


def _note(args: argparse.Namespace) -> int:
    from planes.roof_lesson import write_note

    scene = load(args.scene, args.variant)
    write_note(scene, _values(args, scene), args.output, args.lang)
    return 0


def _cycle(args: argparse.Namespace) -> int:
    from planes.long_run import write_cycle

    scene = load(args.scene, args.variant)
    kind, text = _range(args, scene)
    span = None if text is None else read_span(text, f"--{kind}")
    return write_cycle(scene, span, args.output, args.lang, False if args.plain else None)


def _chart(args: argparse.Namespace) -> int:
    from planes.roof_charts import draw_chart

    draw_chart(load(args.scene, args.variant), args.output, args.table, args.lang)
    return 0


def _crank_slider(args: argparse.Namespace) -> int:
    from planes.roof_crank_slider import run

    return run(load(args.scene, args.variant), args, args.lang)


if __name__ == "__main__":
    sys.exit(main())
