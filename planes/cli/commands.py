"""The commands without their own module: each imports what it needs when it is run."""

import json
import os
import sys
from argparse import Namespace
from collections.abc import Iterable
from dataclasses import replace
from importlib import import_module
from pathlib import Path

from planes.cli.options import COMMANDS, check_needed_options, check_options, requested_drive_positions
from planes.drafting.instruments import Exact, Pencil
from planes.scene import Scene, load
from planes.words import Lang, Phrase, home_lang, say
from planes.words.errors import PlanesError
from planes.words.formats import suffixes_with_option

PRELOADED_MODULES = ("planes.documents.course", "render.report.pdf", "reportlab.platypus", "numpy", "shapely")
"""Modules that the workers of a course import once."""


def json_text(thing: object) -> str:
    """JSON in letters the output can encode."""
    wide = (getattr(sys.stdout, "encoding", "") or "").lower().startswith("utf")
    return json.dumps(thing, ensure_ascii=not wide, allow_nan=False)


def scene_of(args: Namespace) -> Scene:
    """The requested scene; its doubts are printed to stderr."""
    scene = load(args.scene, args.variant)
    said = [doubt.told(args.lang) for doubt in scene.doubts]
    said += [fault.told(args.lang) for fault in _sheet_errors(scene) if args.command != "sheet"]
    print_warnings(said, args.lang)
    return scene


def print_warnings(said: Iterable[str], lang: Lang) -> None:
    """Sentences on stderr that stop nothing and do not look like an error."""
    for sentence in said:
        print(say("warning", lang, of=sentence), file=sys.stderr)


def _sheet_errors(scene: Scene) -> tuple[PlanesError, ...]:
    """The errors of a sheet of the scene, reported before one is drawn."""
    if not scene.sheet.keys() & {"diagrams", "hodographs", "paths", "font"}:
        return ()
    from planes.documents.cycle import sheet_entry_errors

    return tuple(sheet_entry_errors(scene))


def solve(args: Namespace) -> int:
    """Results of every position, or of the scenes of a folder, as tables or JSON; failures on stderr."""
    from planes.solving import solve as solved_at
    from planes.solving.tables import solve_report_text

    if os.path.isdir(args.scene):
        return _survey_folder(args)
    scene = scene_of(args)
    values = requested_drive_positions(args, scene)
    check_options(args, "steps" if args.explain else "positions" if scene.drive else "vectors")
    check_needed_options(args)
    if (args.seed or 0) < 0:
        raise PlanesError(Phrase("seed_negative", seed=args.seed))
    instrument = Pencil(seed=1 if args.seed is None else args.seed) if args.pencil else Exact()
    if args.explain:
        from planes.solving.explaining import explain_steps

        print(explain_steps(scene, args.lang), end="")
        return 0
    solved = solved_at(scene, values, instrument, args.lang)
    if args.remedy:
        from planes.solving.remedies import remedy_positions

        remedy_positions(solved)
    if args.errors:
        from planes.accuracy.errors import add_errors_to_results

        add_errors_to_results(solved, instrument)
    for failure in solved.failed:
        print(f"{scene.file}: {failure['error']}", file=sys.stderr)
    if args.json:
        if solved.positions or solved.failed:
            print(json_text(solved.json()))
    elif solved.positions:
        print(solve_report_text(solved, args.lang), end="")
    return 0 if solved.positions else 2


def _survey_folder(args: Namespace) -> int:
    """Every scene of a folder in every variant; exit status 0 if all are solved and balancing loads agree, else 1."""
    from planes.course.survey import scene_files_of, survey_report, survey_rows
    from planes.course.workers import start_workers
    from planes.words.waiting import progress_bar

    check_options(args, "folder")
    tasks = [(str(path), args.lang, args.variant) for path in scene_files_of(args.scene)]
    rows_of = {}
    with start_workers(ready=("planes.course.survey",)) as each, progress_bar() as step:
        for k, lines in each(survey_rows, tasks):
            rows_of[k] = lines
            if step:
                step(len(rows_of), len(tasks))
    rows = [row for k in sorted(rows_of) for row in rows_of[k]]
    print(
        json_text([row.json() for row in rows]) if args.json else survey_report(rows, args.lang), end="\n" * args.json
    )
    return 0 if all(row.is_right for row in rows) else 1


def structure(args: Namespace) -> int:
    """Links, pairs, Assur groups, and the self-aligning variant."""
    from planes.plans import structure_of
    from planes.plans.assur.alignment import self_aligning_variant
    from planes.plans.statements.of_scene import scene_plans
    from planes.solving.structure_text import alignment_report, structure_report_text
    from planes.words.lettering import without_index_markup

    scene = scene_of(args)
    if scene.mechanism is None:
        if not (figure := scene_plans(scene).figure):
            raise PlanesError(Phrase("no_structure", file=args.scene))
        print(*(x.told(args.lang) for x in figure.counted), sep="\n")
        return 0
    links = structure_of(scene.mechanism, scene.file)
    try:
        variant = self_aligning_variant(scene_plans(scene), scene.file)
    except PlanesError as error:  # the structure is known all the same
        print_warnings([error.told(args.lang)], args.lang)
        variant = None
    if args.json:
        print(json_text({**links.json(), "self_aligning": variant and variant.json()}))
    else:
        reports = [structure_report_text(links, args.lang, scene.frame_number)]
        if variant:
            reports.append(without_index_markup(alignment_report(variant, args.lang)))
        print(*reports, sep="\n\n")
    return 0


def sheet(args: Namespace) -> int:
    """The sheet of a scene, a sheet of its project, or one view."""
    from planes.documents.drawn import draw_sheet

    scene = scene_of(args)
    values = requested_drive_positions(args, scene)
    check_options(args, "positions" if scene.drive else "vectors")
    if args.colour:
        scene = replace(scene, sheet={**scene.sheet, "colour": True})
    if args.text and not args.output.lower().endswith(suffixes_with_option("text")):
        raise PlanesError(Phrase("text_dxf"))
    if args.remedy:
        from planes.solving.remedies import position_for_sheet

        scene, values, said = position_for_sheet(scene, values, args.lang)
        print_warnings(said, args.lang)
    drawn = draw_sheet(scene, values, args.output, args.lang, args.sheet, args.view, args.text or "text")
    print_warnings(drawn.said, args.lang)
    args.made = drawn.size and f"{drawn.size}, "
    args.remarks = drawn.remarks
    return 0


def lesson(args: Namespace) -> int:
    """The construction step by step, as a page."""
    from planes.documents.lesson import write_lesson

    write_lesson(scene_of(args), args.output, args.lang, args.centres)
    return 0


def essay(args: Namespace) -> int:
    """The method in ten live pages."""
    from planes.documents.lesson import write_essay

    write_essay(args.output, args.lang)
    return 0


def note(args: Namespace) -> int:
    """The explanatory note."""
    from planes.documents.lesson import write_note

    scene = scene_of(args)
    write_note(scene, requested_drive_positions(args, scene), args.output, args.lang)
    return 0


def questions(args: Namespace) -> int:
    """The questions of a defence with their answers: a document, or text."""
    from planes.documents.lesson import position_questions, questions_as_text, write_questions

    scene = scene_of(args)
    asked = position_questions(scene, requested_drive_positions(args, scene), args.lang)
    if args.output:
        write_questions(asked, args.output)
    else:
        print(questions_as_text(asked))
    return 0


def chart(args: Namespace) -> int:
    """Speed, accuracy and stability of the methods."""
    from planes.documents.charts import draw_chart

    draw_chart(scene_of(args), args.output, args.table, args.lang, length=args.length)
    return 0


def command_of_pack(args: Namespace) -> int:
    """The command of a pack."""
    check_needed_options(args)
    status: int = import_module(COMMANDS[args.command].pack).run(scene_of(args), args, args.lang)
    return status


def course(args: Namespace) -> int:
    """Make the course; exit status 0 if everything succeeded, 1 if a document is missing, 2 if it could not begin."""
    from planes.course.handed_out import OUTPUT_FOLDER_NAME
    from planes.course.reading import read_course
    from planes.course.workers import start_workers
    from planes.documents.course_run import conduct_course
    from planes.words.waiting import progress_bar

    said: Lang | None = args.lang
    args.lang = said or home_lang()
    if args.jobs is not None and args.jobs < 1:
        raise PlanesError(Phrase("course_jobs", count=args.jobs))
    plan_of_course = read_course(args.folder)
    lang = said or plan_of_course.lang or args.lang
    print_warnings((doubt.told(lang) for assignment in plan_of_course.assignments for doubt in assignment.doubts), lang)
    if plan_of_course.unread:
        print_warnings([say("course_two_lists", lang, file=plan_of_course.file, other=plan_of_course.unread)], lang)
    folder = Path(args.output) if args.output else Path(plan_of_course.file).parent / OUTPUT_FOLDER_NAME
    with start_workers(args.jobs, args.scheduler, PRELOADED_MODULES) as each, progress_bar() as step:
        report = conduct_course(plan_of_course, folder, each, lang, step, bool(args.scheduler))
    for place, file, sentence in (*report.faults, *report.said):
        print(f"{place}{f'/{file}' if file else ''}: {sentence}", file=sys.stderr)
    counts = {
        "students": len(plan_of_course.students),
        "made": report.made,
        "kept": report.kept,
        "faults": len(report.faults),
    }
    print(say("course_done", args.lang, folder=str(folder), **counts))
    return 1 if report.faults else 0
