"""The command line: ``planes solve · structure · sheet``. Bad input is one sentence and exit status 2."""

from __future__ import annotations

import argparse
import io
import json
import os
import sys
from collections.abc import Callable, Sequence
from contextlib import suppress

from planes.cli.options import (
    add_blank_options,
    add_check_options,
    add_course_options,
    add_crank_slider_options,
    add_cycle_options,
    add_positions,
    add_solve_options,
    check_needs,
    check_options,
    range_of,
    value_of,
    values_of,
)
from planes.cli.parser import CommandParser, Parser, lang_of
from planes.scene import Scene, load
from planes.scene.ranges import read_span
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # a terminal without Cyrillic still gets the numbers
    argv = sys.argv[1:] if argv is None else argv
    lang = lang_of(argv)
    args = _parser(lang).parse_args(argv)
    try:
        status = int(args.command(args))
        if sys.stdout:
            sys.stdout.flush()
        return status
    except PlanesError as error:
        refused: PlanesError = error
    except BrokenPipeError:
        return 0
    except OSError as error:
        file = error.filename or Phrase("standard_output")
        refused = PlanesError(Phrase("system_refuses", file=file, reason=error.strerror or str(error)))
    except KeyboardInterrupt:
        return 130
    with suppress(OSError):
        print(refused.told(lang), file=sys.stderr)
    return 2


def _json(thing: object) -> str:
    """JSON in the letters the output can hold."""
    wide = (getattr(sys.stdout, "encoding", "") or "").lower().startswith("utf")
    return json.dumps(thing, ensure_ascii=not wide, allow_nan=False)


def _parser(lang: Lang) -> argparse.ArgumentParser:
    def help_of(key: str) -> str:
        return say(key, lang)

    def command(name: str, run: Callable[[argparse.Namespace], int], text: str) -> argparse.ArgumentParser:
        parser = commands.add_parser(name, help=text, description=text, lang=lang)
        parser.add_argument("scene", metavar="SCENE", help=help_of("help_scene"))
        parser.add_argument("--variant", help=help_of("help_variant"))
        parser.add_argument("--lang", choices=("ru", "en"), default=lang, help=help_of("help_lang"))
        parser.set_defaults(command=run)
        return parser

    parser = Parser(prog="planes", description=help_of("help_planes"), lang=lang)
    parser.add_argument("--version", action="version", version=f"planes {sys.modules['planes'].__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND", parser_class=CommandParser)
    solve = command("solve", _solve, help_of("help_solve"))
    add_positions(solve, help_of)
    add_solve_options(solve, help_of)
    structure = command("structure", _structure, help_of("help_structure"))
    structure.add_argument("--json", action="store_true", help=help_of("help_object"))
    sheet = command("sheet", _sheet, help_of("help_sheet"))
    add_positions(sheet, help_of)
    sheet.add_argument("-o", "--output", required=True, metavar="FILE", help=help_of("help_output"))
    sheet.add_argument("--remedy", action="store_true", help=help_of("help_remedy"))
    sheet.add_argument("--text", choices=("text", "strokes"), help=help_of("help_dxf_text"))
    part = sheet.add_mutually_exclusive_group()
    part.add_argument("--sheet", type=int, choices=(1, 2), help=help_of("help_sheet_number"))
    part.add_argument("--view", metavar="NAME", help=help_of("help_view"))
    lesson = command("lesson", _lesson, help_of("help_lesson"))
    lesson.add_argument("-o", "--output", required=True, metavar="FILE", help=help_of("help_lesson_output"))
    note = command("note", _note, help_of("help_note"))
    add_positions(note, help_of)
    note.add_argument("-o", "--output", required=True, metavar="FILE", help=help_of("help_note_output"))
    cycle = command("cycle", _cycle, help_of("help_cycle"))
    add_positions(cycle, help_of)
    add_cycle_options(cycle, help_of)
    chart = command("chart", _chart, help_of("help_chart"))
    chart.add_argument("-o", "--output", required=True, metavar="FILE", help=help_of("help_chart_output"))
    chart.add_argument("--table", metavar="FILE", help=help_of("help_table"))
    crank = command("crank-slider", _crank_slider, help_of("help_crank_slider"))
    add_crank_slider_options(crank, help_of)
    check = command("check", _check, help_of("help_check"))
    add_positions(check, help_of)
    add_check_options(check, help_of)
    blank = command("blank", _blank, help_of("help_blank"))
    add_positions(blank, help_of)
    add_blank_options(blank, help_of)
    course = commands.add_parser("course", help=help_of("help_course"), description=help_of("help_course"), lang=lang)
    add_course_options(course, help_of)
    course.set_defaults(command=_course)
    return parser


def _scene(args: argparse.Namespace) -> Scene:
    """The scene asked for; what is doubtful in it goes to stderr."""
    scene = load(args.scene, args.variant)
    for doubt in scene.doubts:
        print(doubt.told(args.lang), file=sys.stderr)
    return scene


def _solve(args: argparse.Namespace) -> int:
    from planes.cli.solve import run

    if os.path.isdir(args.scene):
        from planes.cli.survey import run as survey

        check_options(args, "solve", "folder")
        return survey(args, _json)
    scene = _scene(args)
    values = values_of(args, scene)
    check_options(args, "solve", "steps" if args.explain else "positions" if scene.mechanism else "vectors")
    check_needs(args, ["seed"])
    if (args.seed or 0) < 0:
        raise PlanesError(Phrase("seed_negative", seed=args.seed))
    return run(args, scene, values, _json)


def _structure(args: argparse.Namespace) -> int:
    from planes.plans import mechanism_plans
    from planes.plans.alignment import aligned
    from planes.plans.structure import analyse
    from planes.solving import structure_json
    from planes.solving.tables import alignment_report, structure_report

    scene = _scene(args)
    if scene.mechanism is None:
        raise PlanesError(Phrase("no_structure", file=args.scene))
    found = analyse(scene.mechanism, scene.file)
    try:
        variant = aligned(mechanism_plans(scene), scene.file)
    except PlanesError as error:  # the structure is known all the same
        print(error.told(args.lang), file=sys.stderr)
        variant = None
    if args.json:
        print(_json({**structure_json(found), "self_aligning": variant and variant.json()}))
    else:
        told = [structure_report(found, args.lang)] + ([alignment_report(variant, args.lang)] if variant else [])
        print(*told, sep="\n\n")
    return 0


def _check(args: argparse.Namespace) -> int:
    from planes.cli.check import run

    scene = _scene(args)
    return run(args, scene, value_of(args, scene))


def _blank(args: argparse.Namespace) -> int:
    from planes.cli.check import write_blank

    scene = _scene(args)
    return write_blank(args, scene, value_of(args, scene))


def _sheet(args: argparse.Namespace) -> int:
    from planes.documents import draw_sheet

    scene = _scene(args)
    values = values_of(args, scene)
    check_options(args, "sheet", "positions" if scene.mechanism else "vectors")
    if args.text and not args.output.lower().endswith(".dxf"):
        raise PlanesError(Phrase("text_dxf"))
    if args.remedy:
        from planes.solving.remedies import for_sheet

        scene, values, said = for_sheet(scene, values, args.lang)
        print(*said, sep="\n", end="\n" if said else "", file=sys.stderr)
    for sentence in draw_sheet(scene, values, args.output, args.lang, args.sheet, args.view, args.text or "text"):
        print(sentence, file=sys.stderr)
    return 0


def _lesson(args: argparse.Namespace) -> int:
    from planes.documents.lesson import write_lesson

    write_lesson(_scene(args), args.output, args.lang)
    return 0


def _note(args: argparse.Namespace) -> int:
    from planes.documents.lesson import write_note

    scene = _scene(args)
    write_note(scene, values_of(args, scene), args.output, args.lang)
    return 0


def _cycle(args: argparse.Namespace) -> int:
    from planes.cli.cycle import run

    scene = _scene(args)
    kind, text = range_of(args, scene)
    return run(args, scene, None if text is None else read_span(text, f"--{kind}"), _json)


def _course(args: argparse.Namespace) -> int:
    from planes.cli.course import run

    return run(args)


def _chart(args: argparse.Namespace) -> int:
    from planes.documents.charts import draw_chart

    draw_chart(_scene(args), args.output, args.table, args.lang)
    return 0


def _crank_slider(args: argparse.Namespace) -> int:
    from planes.documents.crank_slider import run

    check_needs(args, ["phi"])
    return run(_scene(args), args, args.lang)
