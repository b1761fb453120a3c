"""``planes check`` and ``planes blank``: what is read by the suffix of a file, checked and printed; a folder too."""

from __future__ import annotations

import json
import re
from argparse import Namespace
from dataclasses import replace
from pathlib import Path

from planes.check import STATUS, Outcome
from planes.check import check as judge
from planes.check.grading.paper import Known
from planes.check.grading.perturbing import HAND, cad
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.handed_in import LINES, PICTURES, read_paper
from planes.check.pages import checked_pages, page_count
from planes.check.report import ClassWork, as_json, chance_told, class_heads, heads, numbers_of, rows_of
from planes.cli.commands import scene_of
from planes.cli.options import check_options, value_of
from planes.scene import Scene
from planes.solving.tables import table
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.names import kind_of
from planes.words.records import as_csv
from planes.words.units import read_mu

_PLACE = re.compile(r"\s*(?:([^=]+)=)?\s*([-+]?{0})\s*[,;]\s*([-+]?{0})\s*".format(r"(?:\d+\.?\d*|\.\d+)"))


def check(args: Namespace) -> int:
    """Check, print, and give the exit status: 0 right, 1 wrong, 2 unreadable, 3 right as far as seen."""
    scene = scene_of(args)
    value = value_of(args, scene)
    check_options(args, "check", _answer(args))
    asked, known = ask(args, scene, value), known_of(args)
    if args.trace:
        return _trace(args, asked)
    if args.drawing is None:
        raise PlanesError(Phrase("check_no_drawing"))
    if Path(args.drawing).is_dir():
        return check_class(args, asked, known)
    if known.page is None and page_count(args.drawing) > 1:
        pages = checked_pages(args.drawing, asked, known)
        if len(pages) > 1 or pages[0].found is None:
            return tell_class(args, ClassWork(Path(args.drawing).name, pages))
        found = pages[0].found
    else:
        found = judge(asked, read_paper(args.drawing, asked, known))
    if args.output:
        from planes.documents.check import write_report

        write_report(found, args.output, args.lang)
    if args.json:
        print(json.dumps(as_json(found, args.lang), ensure_ascii=False, allow_nan=False))
    else:
        print(told(found, args.lang))
    return STATUS[found.verdict]


def _answer(args: Namespace) -> str:
    """Which of the answers is asked for, by what has to be read."""
    files = [Path(args.drawing or ""), *(Path(pair.partition("=")[2]) for pair in args.others)]
    suffixes = {file.suffix.lower() for file in files}
    if args.trace:
        return "trace"
    if (args.drawing and files[0].is_dir()) or suffixes & {*PICTURES}:
        return "photograph"
    return "lines" if suffixes & {*LINES} else "numbers"


def _trace(args: Namespace, asked: Asked) -> int:
    """The tracing-paper page."""
    from planes.documents.check import write_trace

    if args.drawing or not args.output or Path(args.output).suffix.lower() not in (".html", ".htm"):
        raise PlanesError(Phrase("check_trace"))
    write_trace(asked, args.output, args.lang)
    return 0


def ask(args: Namespace, scene: Scene, value: float | None) -> Asked:
    """The question of the command line."""
    from planes.documents.check import spelling

    asked = Asked(scene, args.plan, value, _mu(args), spelt=spelling(scene, args.lang))
    others = {}
    for pair in args.others:
        name, _, file = pair.partition("=")
        if not file:
            raise PlanesError(Phrase("check_option", option="--with", text=pair, form="velocity=FILE", hint=""))
        others[name] = read_paper(file, replace(asked, plan=name, mu=None), replace(known_of(args), page=None))
    skill = HAND
    if args.work == "cad":
        from planes.drafting.drawing import run
        from planes.plans.scales import extent

        bench = prepare(asked)
        skill = cad(max(extent(run(bench.program, bench.given), asked.plan), 10.0))
    return replace(asked, skill=skill, others=others)


def _mu(args: Namespace) -> float | None:
    return None if args.mu is None else read_mu(args.mu, kind_of(args.plan))


def known_of(args: Namespace) -> Known:
    """What the command line tells of the drawing."""
    pole = place(args.pole, "--pole")[1] if args.pole else None
    page = None if args.page is None else args.page - 1
    return Known(pole, dict(place(m, "--mark") for m in args.mark), args.format, page)


def place(text: str, option: str) -> tuple[str, complex]:
    """NAME=X,Y or X,Y of the command line."""
    match = _PLACE.fullmatch(text)
    if not match:
        hint = Phrase("decimal_no_comma") if text.count(",") > 1 else ""
        raise PlanesError(Phrase("check_option", option=option, text=text, form="X,Y", hint=hint))
    return (match[1] or "").strip(), complex(float(match[2]), float(match[3]))


def told(found: Outcome, lang: Lang) -> str:
    """The outcome for people: the sentence, then the tables."""
    lines = [" ".join(filter(None, (found.sentence.told(lang), chance_told(found, lang))))]
    marks, numbers = heads(lang)
    lines += table(say("check_marks", lang), marks, [row for _, *row in rows_of(found, lang)])
    lines += table(say("check_numbers", lang), numbers, [row for _, *row in numbers_of(found, lang)])
    return "\n".join(lines + [f"! {n.told(lang)}" for n in found.notes])


def blank(args: Namespace) -> int:
    """``planes blank``: a sheet to draw a plan on."""
    from planes.documents.check import write_blank

    scene = scene_of(args)
    write_blank(Asked(scene, args.plan, value_of(args, scene), _mu(args)), args.output, args.lang)
    return 0


NO_DRAWINGS = (".html", ".htm", ".yaml", ".yml", ".md", ".py", ".db", ".ini", ".lnk", ".tmp")  # lie beside the drawings


def check_class(args: Namespace, asked: Asked, known: Known) -> int:
    """Every drawing of a folder: a row for each, on the terminal and in the file of ``-o``."""
    from planes.documents.lesson import bar

    folder = Path(args.drawing)
    files = [f for f in sorted(folder.iterdir()) if f.is_file() and not f.name.startswith((".", "~$"))]
    files = [f for f in files if f.suffix.lower() not in NO_DRAWINGS]
    if not files:
        raise PlanesError(Phrase("check_empty_folder", file=args.drawing))
    group = ClassWork(folder.name)
    with bar() as step:
        for done, file in enumerate(files, 1):
            name = file.name.encode("utf-8", "replace").decode()  # any bytes at all may be the name of a file
            group.all += checked_pages(str(file), asked, known, name)
            if step:
                step(done, len(files))
    return tell_class(args, group)


def tell_class(args: Namespace, group: ClassWork) -> int:
    """Several drawings, on the terminal and in the file of ``-o``."""
    if args.output:
        _write_class(group, args.output, args.lang)
    print(_json(group, args.lang) if args.json else "\n".join(_class_table(group, args.lang)).lstrip())
    return group.status


def _class_table(group: ClassWork, lang: Lang) -> list[str]:
    rows = [class_heads(lang), *(one.row(lang) for one in group.all)]
    widths = [max(len(row[i]) for row in rows) for i in range(3)]
    aligned = ("  ".join([*(c.ljust(w) for c, w in zip(row, widths, strict=False)), row[3]]) for row in rows)
    return [say("check_class", lang), *(f"  {line.rstrip()}" for line in aligned)]


def _json(group: ClassWork, lang: Lang) -> str:
    return json.dumps([one.as_json(lang) for one in group.all], ensure_ascii=False, allow_nan=False)


def _write_class(group: ClassWork, output: str, lang: Lang) -> None:
    """The table as a page, a spreadsheet or objects; a folder gets a report for each drawing and the page."""
    from planes.documents.check import write_class, write_text

    suffix = Path(output).suffix.lower()
    if suffix == ".json":
        write_text(_json(group, lang), output)
    elif suffix == ".csv":
        rows = [class_heads(lang), *(one.row(lang) for one in group.all)]
        write_text(f"\ufeff{as_csv(rows)}", output)  # begun so that a spreadsheet knows the letters
    elif suffix in (".html", ".htm", ""):
        write_class(group, output, lang)
    else:
        raise PlanesError(Phrase("check_class_output", file=output))
