"""``planes check`` and ``planes blank``: a file or a folder read by its suffix, checked, and the outcome printed."""

from argparse import Namespace
from pathlib import Path

from planes.check.grading.prepared_plan import Asked, known_plans
from planes.check.handed_in import LINES, PICTURES, PRACTICE, TABLES, HandedSheet, read_paper, sheets_in
from planes.check.outcome import check as judge
from planes.cli.asking import ask, judge_table, known_of, mu_asked, said
from planes.cli.class_check import check_class
from planes.cli.commands import scene_of
from planes.cli.options import check_options, value_of
from planes.course.handed_out import handed_out, is_course
from planes.course.ledger import MANIFEST
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.words import Phrase
from planes.words.errors import PlanesError


def check(args: Namespace) -> int:
    """Check, print, and return the exit status: 0 right, 1 wrong, 2 unreadable, 3 right as far as seen."""
    if is_course(Path(args.scene)) and not args.trace:
        return check_class(args, handed_out(Path(args.scene)), _sheets(args))
    table = not args.trace and (args.drawing or "").lower().endswith(TABLES)
    scene = scene_of(args)
    if args.plan is None and not table and (args.trace or not _told_by_itself(args.drawing)):
        raise _no_plan(args, scene)
    value = value_of(args, scene)
    check_options(args, "check", _answer(args))
    if table:
        if outcome := judge_table(args, scene, value):
            return said(args, outcome)
        if args.plan is None:
            raise _no_plan(args, scene)
    if args.drawing and not args.trace:
        sheets = _sheets(args)
        if args.plan is None or Path(args.drawing).is_dir() or sheets[0].practised:
            return check_class(args, handed_out(Path(args.scene)), sheets)
    asked = ask(args, scene, args.plan, value, mu_asked(args, args.plan))
    if args.trace:
        return _trace(args, asked)
    if args.drawing is None:
        raise PlanesError(Phrase("check_no_drawing"))
    if len(sheets) > 1:
        return check_class(args, handed_out(Path(args.scene)), sheets, alone=True)
    return said(args, judge(asked, read_paper(args.drawing, asked, sheets[0].known(known_of(args)))))


def _no_plan(args: Namespace, scene: Scene) -> PlanesError:
    """The error that lists the plans to choose from."""
    plans = tuple(known_plans(scene_plans(scene)))
    return PlanesError(Phrase("check_say_plan", file=args.drawing or args.scene, plans=plans))


def _sheets(args: Namespace) -> list[HandedSheet]:
    """The sheets that were handed in."""
    if args.drawing is None:
        raise PlanesError(Phrase("check_no_drawing"))
    return sheets_in(Path(args.drawing), args.page is not None, MANIFEST)


def _answer(args: Namespace) -> str:
    """The kind of answer requested, by the input to be read."""
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


def blank(args: Namespace) -> int:
    """``planes blank``: a sheet to draw a plan on."""
    from planes.documents.check import write_blank

    scene = scene_of(args)
    plan = args.plan or _first_plan(scene)
    write_blank(Asked(scene, plan, value_of(args, scene), mu_asked(args, plan)), args.output, args.lang)
    return 0


def _first_plan(scene: Scene) -> str:
    """The velocity plan, or the first one of a scene without it."""
    plans = known_plans(scene_plans(scene))
    return "velocity" if "velocity" in plans else next(iter(plans), "velocity")


def _told_by_itself(drawing: str | None) -> bool:
    """Whether the input may identify the plan: by the marks of sheets, or a practice by its code."""
    return bool(drawing) and (Path(str(drawing)).is_dir() or str(drawing).lower().endswith((*PICTURES, PRACTICE)))
