"""``planes check``: what is read by the file's suffix, checked and printed."""

from __future__ import annotations

import argparse
import json
import re
from dataclasses import replace
from pathlib import Path

from planes.check import STATUS, Outcome, check
from planes.check.grading.paper import Known
from planes.check.grading.perturbing import HAND, cad
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.handed_in import LINES, PICTURES, read_paper
from planes.check.report import heads, numbers_of, rows_of
from planes.check.report.rows import as_json
from planes.cli.classes import check_class
from planes.cli.idle import check_options
from planes.scene import Scene
from planes.solving.tables import table
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.names import kind_of
from planes.words.units import read_mu

_PLACE = re.compile(r"\s*(?:([^=]+)=)?\s*([-+]?{0})\s*[,;]\s*([-+]?{0})\s*".format(r"(?:\d+\.?\d*|\.\d+)"))


def run(args: argparse.Namespace, scene: Scene, value: float | None) -> int:
    """Check, print, and give the exit status: 0 right, 1 wrong, 2 unreadable."""
    check_options(args, "check", _answer(args))
    asked, known = ask(args, scene, value), known_of(args)
    if args.trace:
        return _trace(args, asked)
    if args.drawing is None:
        raise PlanesError(Phrase("check_no_drawing"))
    if Path(args.drawing).is_dir():
        return check_class(args, asked, lambda file: read_paper(file, asked, known))
    found = check(asked, read_paper(args.drawing, asked, known))
    if args.output:
        from planes.documents.check import write_report

        write_report(found, args.output, args.lang)
    if args.json:
        print(json.dumps(as_json(found, args.lang), ensure_ascii=False, allow_nan=False))
    else:
        print(told(found, args.lang))
    return STATUS[found.verdict]


def _answer(args: argparse.Namespace) -> str:
    """Which of the answers is asked for, by what has to be read."""
    files = [Path(args.drawing or ""), *(Path(pair.partition("=")[2]) for pair in args.others)]
    suffixes = {file.suffix.lower() for file in files}
    if args.trace:
        return "trace"
    if (args.drawing and files[0].is_dir()) or suffixes & {*PICTURES}:
        return "photograph"
    return "lines" if suffixes & {*LINES} else "numbers"


def _trace(args: argparse.Namespace, asked: Asked) -> int:
    """The tracing-paper page."""
    from planes.documents.check import write_trace

    if args.drawing or not args.output or Path(args.output).suffix.lower() not in (".html", ".htm"):
        raise PlanesError(Phrase("check_trace"))
    write_trace(asked, args.output, args.lang)
    return 0


def ask(args: argparse.Namespace, scene: Scene, value: float | None) -> Asked:
    """The question of the command line."""
    from planes.documents.check import spelling

    asked = Asked(scene, args.plan, value, _mu(args), spelt=spelling(scene, args.lang))
    others = {}
    for pair in args.others:
        name, _, file = pair.partition("=")
        if not file:
            raise PlanesError(Phrase("check_option", option="--with", text=pair, form="velocity=FILE", hint=""))
        others[name] = read_paper(file, asked, known_of(args))
    skill = HAND
    if args.work == "cad":
        skill = cad(_size(asked))
    return replace(asked, skill=skill, others=others)


def _mu(args: argparse.Namespace) -> float | None:
    return None if args.mu is None else read_mu(args.mu, kind_of(args.plan))


def _size(asked: Asked) -> float:
    """How large the plan is, mm."""
    from planes.drafting.drawing import run as draw
    from planes.plans.scales import extent

    bench = prepare(asked)
    return max(extent(draw(bench.program, bench.given), asked.plan), 10.0)


def known_of(args: argparse.Namespace) -> Known:
    """What the command line tells of the drawing."""
    pole = place(args.pole, "--pole")[1] if args.pole else None
    return Known(pole, dict(place(m, "--mark") for m in args.mark), args.format)


def place(text: str, option: str) -> tuple[str, complex]:
    """NAME=X,Y or X,Y of the command line."""
    match = _PLACE.fullmatch(text)
    if not match:
        hint = Phrase("decimal_no_comma") if text.count(",") > 1 else ""
        raise PlanesError(Phrase("check_option", option=option, text=text, form="X,Y", hint=hint))
    return (match[1] or "").strip(), complex(float(match[2]), float(match[3]))


def told(found: Outcome, lang: Lang) -> str:
    """The outcome for people: the sentence, then the tables."""
    lines = [found.sentence.told(lang)]
    marks, numbers = heads(lang)
    lines += table(say("check_marks", lang), marks, [row for _, *row in rows_of(found, lang)])
    lines += table(say("check_numbers", lang), numbers, [row for _, *row in numbers_of(found, lang)])
    return "\n".join(lines + [f"! {n.told(lang)}" for n in found.notes])


def write_blank(args: argparse.Namespace, scene: Scene, value: float | None) -> int:
    """``planes blank``: a sheet to draw a plan on."""
    from planes.documents.check import write_blank as write

    write(Asked(scene, args.plan, value, _mu(args)), args.output, args.lang)
    return 0
