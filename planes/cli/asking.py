"""The question of a check command, and how the outcome is reported."""

import json
import re
from argparse import Namespace
from dataclasses import replace

from planes.check.grading.paper import Known, read_table
from planes.check.grading.prepared_plan import Asked, known_plans, prepare
from planes.check.handed_in import read_paper
from planes.check.outcome import STATUS, Outcome
from planes.check.outcome import check as judge
from planes.check.report import as_json, chance_told, heads, numbers_of, rows_of
from planes.course.numbers import answers_of
from planes.drafting.skill import HAND, cad
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.solving.text_tables import table
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.names import kind_of
from planes.words.units import read_mu

_PLACE = re.compile(r"\s*(?:([^=]+)=)?\s*([-+]?{0})\s*[,;]\s*([-+]?{0})\s*".format(r"(?:\d+\.?\d*|\.\d+)"))


def ask(args: Namespace, scene: Scene, plan: str, value: float | None, mu: float | None) -> Asked:
    """The question of the command line."""
    asked = Asked(scene, plan, value, mu)
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


def mu_asked(args: Namespace, plan: str) -> float | None:
    """The scale given on the command line."""
    return None if args.mu is None else read_mu(args.mu, kind_of(plan))


def known_of(args: Namespace) -> Known:
    """The data about the drawing given on the command line."""
    pole = place(args.pole, "--pole")[1] if args.pole else None
    page = None if args.page is None else args.page - 1
    return Known(pole, dict(place(m, "--mark") for m in args.mark), args.format, page)


def judge_table(args: Namespace, scene: Scene, value: float | None) -> Outcome | None:
    """The judgement of a table with results only, which needs no plan; None for any other table."""
    plan = args.plan or known_plans(scene_plans(scene))[0]
    asked, paper = ask(args, scene, plan, value, mu_asked(args, plan)), read_table(args.drawing)
    if not paper.results or paper.spots or paper.segments:
        return None
    return judge(replace(asked, answers=answers_of(scene, value, args.plan or "")), paper)


def place(text: str, option: str) -> tuple[str, complex]:
    """NAME=X,Y or X,Y of the command line."""
    match = _PLACE.fullmatch(text)
    if not match:
        hint = Phrase("decimal_no_comma") if text.count(",") > 1 else ""
        raise PlanesError(Phrase("check_option", option=option, text=text, form="X,Y", hint=hint))
    return (match[1] or "").strip(), complex(float(match[2]), float(match[3]))


def told(outcome: Outcome, lang: Lang) -> str:
    """The outcome for people: the sentence, then the tables."""
    lines = [" ".join(filter(None, (outcome.typed(outcome.sentence.told(lang)), chance_told(outcome, lang))))]
    for key, head, rows in zip(("marks", "numbers"), heads(lang), (rows_of, numbers_of), strict=True):
        shown = [[outcome.typed(cell) for cell in row] for _, *row in rows(outcome, lang)]
        lines += table(say(f"check_{key}", lang), head, shown, even=False)
    return "\n".join(lines + [f"! {outcome.typed(n.told(lang))}" for n in outcome.notes])


def said(args: Namespace, outcome: Outcome) -> int:
    """Write the report and print the outcome."""
    if args.output:
        from planes.documents.check import write_report

        write_report(outcome, args.output, args.lang)
    if args.json:
        print(json.dumps(as_json(outcome, args.lang), ensure_ascii=False, allow_nan=False))
    else:
        print(told(outcome, args.lang))
    return STATUS[outcome.verdict]
