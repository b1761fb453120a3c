"""``planes check`` and ``planes blank``: a file or a folder read by its suffix, checked, and the outcome printed."""

from argparse import Namespace
from pathlib import Path

from planes.check.grading.prepared_plan import Asked, known_plans
from planes.check.handed_in import (
    EXERCISE_SUFFIX,
    PICTURE_SUFFIXES,
    TABLE_SUFFIXES,
    VECTOR_SUFFIXES,
    HandedSheet,
    read_paper,
    sheets_in,
)
from planes.check.outcome import check as judge
from planes.cli.asking import (
    drawing_data_from_options,
    judge_table,
    question_from_options,
    report_outcome,
    requested_scale,
)
from planes.cli.class_check import check_class
from planes.cli.commands import scene_of
from planes.cli.options import check_options, requested_drive_position
from planes.course.handed_out import is_course, scenes_handed_out
from planes.course.ledger import MANIFEST_FILE_NAME
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.words import Phrase
from planes.words.errors import PlanesError


def check(args: Namespace) -> int:
    """Check, print, and return the exit status: 0 right, 1 wrong, 2 unreadable, 3 right as far as seen."""
    if is_course(Path(args.scene)) and not args.trace:
        return check_class(args, scenes_handed_out(Path(args.scene)), _sheets_handed_in(args))
    table = not args.trace and (args.drawing or "").lower().endswith(TABLE_SUFFIXES)
    scene = scene_of(args)
    if args.plan is None and not table and (args.trace or not _identifies_plan(args.drawing)):
        raise _no_plan_error(args, scene)
    value = requested_drive_position(args, scene)
    check_options(args, _answer_kind(args))
    if table:
        if outcome := judge_table(args, scene, value):
            return report_outcome(args, outcome)
        if args.plan is None:
            raise _no_plan_error(args, scene)
    if args.drawing and not args.trace:
        sheets = _sheets_handed_in(args)
        if args.plan is None or Path(args.drawing).is_dir() or sheets[0].is_exercise:
            return check_class(args, scenes_handed_out(Path(args.scene)), sheets)
    asked = question_from_options(args, scene, args.plan, value, requested_scale(args, args.plan))
    if args.trace:
        return _write_tracing_page(args, asked)
    if args.drawing is None:
        raise PlanesError(Phrase("check_no_drawing"))
    if len(sheets) > 1:
        return check_class(args, scenes_handed_out(Path(args.scene)), sheets, alone=True)
    return report_outcome(
        args, judge(asked, read_paper(args.drawing, asked, sheets[0].known_with_page(drawing_data_from_options(args))))
    )


def _no_plan_error(args: Namespace, scene: Scene) -> PlanesError:
    """The error that lists the plans to choose from."""
    plans = tuple(known_plans(scene_plans(scene)))
    return PlanesError(Phrase("check_say_plan", file=args.drawing or args.scene, plans=plans))


def _sheets_handed_in(args: Namespace) -> list[HandedSheet]:
    """The sheets that were handed in."""
    if args.drawing is None:
        raise PlanesError(Phrase("check_no_drawing"))
    return sheets_in(Path(args.drawing), args.page is not None, MANIFEST_FILE_NAME)


def _answer_kind(args: Namespace) -> str:
    """The kind of answer requested, by the input to be read."""
    files = [Path(args.drawing or ""), *(Path(pair.partition("=")[2]) for pair in args.others)]
    suffixes = {file.suffix.lower() for file in files}
    if args.trace:
        return "trace"
    if (args.drawing and files[0].is_dir()) or suffixes & {*PICTURE_SUFFIXES}:
        return "photograph"
    return "lines" if suffixes & {*VECTOR_SUFFIXES} else "numbers"


def _write_tracing_page(args: Namespace, asked: Asked) -> int:
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
    plan = args.plan or _default_plan(scene)
    write_blank(
        Asked(scene, plan, requested_drive_position(args, scene), requested_scale(args, plan)), args.output, args.lang
    )
    return 0


def _default_plan(scene: Scene) -> str:
    """The velocity plan, or the first one of a scene without it."""
    plans = known_plans(scene_plans(scene))
    return "velocity" if "velocity" in plans else next(iter(plans), "velocity")


def _identifies_plan(drawing: str | None) -> bool:
    """Whether the input may identify the plan: by the marks of sheets, or a practice by its code."""
    return bool(drawing) and (
        Path(str(drawing)).is_dir() or str(drawing).lower().endswith((*PICTURE_SUFFIXES, EXERCISE_SUFFIX))
    )
