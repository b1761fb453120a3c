"""The question of a check command, and how the outcome is reported."""

import json
import re
from argparse import Namespace
from dataclasses import replace

from planes.check.grading.paper import Known, read_table
from planes.check.grading.prepared_plan import Asked, known_plans, prepare
from planes.check.handed_in import read_paper
from planes.check.outcome import EXIT_STATUS_OF_VERDICT, Outcome
from planes.check.outcome import check as judge
from planes.check.report import as_json, certainty_text, mark_table_rows, result_table_rows, table_headings
from planes.course.numbers import main_answer_names
from planes.drafting.skill import STUDENT_SKILL, cad_skill
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.solving.text_tables import aligned_table
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.names import PlanId
from planes.words.units import read_mu

_PLACE_PATTERN = re.compile(r"\s*(?:([^=]+)=)?\s*([-+]?{0})\s*[,;]\s*([-+]?{0})\s*".format(r"(?:\d+\.?\d*|\.\d+)"))


def question_from_options(args: Namespace, scene: Scene, plan: str, value: float | None, mu: float | None) -> Asked:
    """The question of the command line."""
    asked = Asked(scene, plan, value, mu)
    others = {}
    for pair in args.others:
        name, _, file = pair.partition("=")
        if not file:
            raise PlanesError(Phrase("check_option", option="--with", text=pair, form="velocity=FILE", hint=""))
        others[PlanId.read(name)] = read_paper(
            file, replace(asked, plan=name, mu=None), replace(drawing_data_from_options(args), page=None)
        )
    skill = STUDENT_SKILL
    if args.work == "cad":
        from planes.drafting.drawing import draw_program
        from planes.plans.extents import plan_extent

        bench = prepare(asked)
        skill = cad_skill(max(plan_extent(draw_program(bench.program, bench.given), bench.plan), 10.0))
    return replace(asked, skill=skill, others=others)


def requested_scale(args: Namespace, plan: str) -> float | None:
    """The scale given on the command line."""
    return None if args.mu is None else read_mu(args.mu, PlanId.read(plan).kind)


def drawing_data_from_options(args: Namespace) -> Known:
    """The data about the drawing given on the command line."""
    pole = parse_named_place(args.pole, "--pole")[1] if args.pole else None
    page = None if args.page is None else args.page - 1
    return Known(pole, dict(parse_named_place(m, "--mark") for m in args.mark), args.format, page)


def judge_table(args: Namespace, scene: Scene, value: float | None) -> Outcome | None:
    """The judgement of a table with results only, which needs no plan; None for any other table."""
    plan = args.plan or known_plans(scene_plans(scene))[0]
    asked = question_from_options(args, scene, plan, value, requested_scale(args, plan))
    paper = read_table(args.drawing)
    if not paper.results or paper.spots or paper.segments:
        return None
    return judge(replace(asked, answers=main_answer_names(scene, value, args.plan or "")), paper)


def parse_named_place(text: str, option: str) -> tuple[str, complex]:
    """NAME=X,Y or X,Y of the command line."""
    match = _PLACE_PATTERN.fullmatch(text)
    if not match:
        hint = Phrase("decimal_no_comma") if text.count(",") > 1 else ""
        raise PlanesError(Phrase("check_option", option=option, text=text, form="X,Y", hint=hint))
    return (match[1] or "").strip(), complex(float(match[2]), float(match[3]))


def outcome_text(outcome: Outcome, lang: Lang) -> str:
    """The outcome for people: the sentence, then the tables."""
    lines = [
        " ".join(filter(None, (outcome.text_as_typed(outcome.sentence.told(lang)), certainty_text(outcome, lang))))
    ]
    for key, head, rows in zip(
        ("marks", "numbers"), table_headings(lang), (mark_table_rows, result_table_rows), strict=True
    ):
        shown = [[outcome.text_as_typed(cell) for cell in row] for _, *row in rows(outcome, lang)]
        lines += aligned_table(say(f"check_{key}", lang), head, shown, even=False)
    return "\n".join(lines + [f"! {outcome.text_as_typed(n.told(lang))}" for n in outcome.notes])


def report_outcome(args: Namespace, outcome: Outcome) -> int:
    """Write the report and print the outcome."""
    if args.output:
        from planes.documents.check import write_report

        write_report(outcome, args.output, args.lang)
    if args.json:
        print(json.dumps(as_json(outcome, args.lang), ensure_ascii=False, allow_nan=False))
    else:
        print(outcome_text(outcome, args.lang))
    return EXIT_STATUS_OF_VERDICT[outcome.verdict]
