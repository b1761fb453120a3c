"""Questions of a course in the import formats of learning platforms: Moodle XML, numerical and calculated questions,
and STACK.

Formats: https://docs.moodle.org/en/Moodle_XML_format; STACK questions use the same file format. Numbers have a decimal
point, tolerances are the errors of a student's pencil; every picture is in the file. The elements are in
``platforms.txt``, with a dollar sign before what is filled in.
"""

import base64
import html
import itertools
import re
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from string import Template
from xml.etree.ElementTree import fromstring, indent, tostring

from numpy import uint32
from numpy.random import RandomState

from planes.course.quiz import LEAST_TOLERANCE_SHARE, Pool, Quiz, QuizItem, quizzes_by_assignment
from planes.words import Lang, say
from planes.words.naming import Naming

PICTURE_FILE_NAME = "scheme.png"


def html_with_indices(text: str) -> str:
    """Text with indices in braces as HTML."""
    return re.sub(r"\^\{(.*?)\}", r"<sup>\1</sup>", re.sub(r"_\{(.*?)\}", r"<sub>\1</sub>", html.escape(text, False)))


def question_stem(pool: Pool, opened: str, closed: str) -> str:
    """Title, task and numbers; the placeholder of an individual number is between two signs."""
    text = html_with_indices(pool.task_text(lambda key: f"⟦{key}⟧")).replace("⟦", opened).replace("⟧", closed)
    return f"<p>{html.escape(pool.group[0].title)}</p><p>{text}</p>"


def moodle_xml(quizzes: Sequence[Quiz], course: str, lang: Lang) -> bytes:
    """Numerical questions for every student, a category each; and a calculated question for each answer of an
    assignment, with everybody's numbers as its data set."""
    made = []
    for one in quizzes:
        made += [
            _category_element(course, one.place),
            *(_numerical_question(one, item, lang) for item in one.questions),
        ]
    for name, group in quizzes_by_assignment(quizzes).items():
        calculated = (_calculated_question(group, number, lang) for number in range(len(group[0].questions)))
        made += [_category_element(course, say("quiz_pool", lang, name=name)), *calculated]
    return _quiz_file_bytes(made)


def stack_xml(quizzes: Sequence[Quiz], course: str, lang: Lang) -> bytes:
    """A STACK question for each assignment: a variant has one student's numbers, every answer has its own input."""
    asked_of = (_stack_question(name, group, lang) for name, group in quizzes_by_assignment(quizzes).items())
    return _quiz_file_bytes([_category_element(course, "STACK"), *asked_of])


class Xml(str):
    """Elements that are written already."""


@cache
def _template_elements() -> dict[str, Template]:
    """The elements of ``platforms.txt`` by name."""
    text = Path(__file__).with_name("platforms.txt").read_text("utf-8")
    named = (part.partition("]\n") for part in text.removeprefix("[").split("\n["))
    return {name: Template(body) for name, _, body in named}


def filled_element(part: str, **values: object) -> Xml:
    """An element with its values; whatever is not an element itself is text."""
    texts = {name: v if isinstance(v, Xml) else html.escape(str(v), quote=False) for name, v in values.items()}
    return Xml(_template_elements()[part].substitute(texts))


def _joined_elements(elements: Iterable[str]) -> Xml:
    return Xml("".join(elements))


def _quiz_file_bytes(questions: Iterable[Xml]) -> bytes:
    root = fromstring(f"<quiz>{_joined_elements(questions)}</quiz>")
    indent(root, " ")
    return element_as_file(tostring(root, "unicode"))


def element_as_file(element: str) -> bytes:
    """A file of an element."""
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{element.rstrip()}\n'.encode()


def _category_element(course: str, name: str) -> Xml:
    plain = "/".join(part.replace("/", "//") for part in ("top", course or "planes", name))
    return filled_element("category", path=plain)


def _question_head(name: str, text: str, picture: bytes) -> Xml:
    """The common head of all questions, with the picture in the file."""
    shown = f'{text}<p><img src="@@PLUGINFILE@@/{PICTURE_FILE_NAME}" alt="" style="max-width: 100%"/></p>'
    return filled_element(
        "head", name=name, text=shown, file=PICTURE_FILE_NAME, picture=base64.b64encode(picture).decode()
    )


def question_html(item: QuizItem, lang: Lang) -> str:
    """The question, with the unit."""
    name = html_with_indices(Naming(lang).lettered_vector(item.name))
    return f"<p>{say('quiz_find', lang, name=name, unit=say(item.unit, lang))}</p>"


def _numerical_question(one: Quiz, item: QuizItem, lang: Lang) -> Xml:
    text = question_stem(Pool([one], lang), "", "") + question_html(item, lang)
    head = _question_head(f"{one.assignment}: {item.name}", text, one.picture)
    value = f"{item.value:.10g}"
    tolerance = f"{item.tolerance:.6g}"
    return filled_element("numerical", head=head, value=value, tolerance=tolerance, unitless=filled_element("unitless"))


def _calculated_question(group: Sequence[Quiz], number: int, lang: Lang) -> Xml:
    """One answer of an assignment, with numbers drawn from those of the students."""
    first = group[0]
    item = first.questions[number]
    pool = Pool(group, lang)
    text = question_stem(pool, "{", "}") + question_html(item, lang)
    head = _question_head(f"{first.assignment}: {item.name}", text, first.picture)
    asked_of = [q.questions[number] for q in group]
    share = max(
        LEAST_TOLERANCE_SHARE, *(one.tolerance / abs(one.value) for one in asked_of)
    )  # so that nobody's right drawing fails
    rows = pool.varied_numbers | {item.platform_key: [one.value for one in asked_of]}
    return filled_element(
        "calculated",
        head=head,
        key=item.platform_key,
        share=f"{share:.6g}",
        unitless=filled_element("unitless"),
        datasets=_joined_elements(_dataset_element(name, values) for name, values in rows.items()),
    )


def _dataset_element(name: str, values: Sequence[float]) -> Xml:
    """The values of a wildcard, one for each student."""
    items = (filled_element("dataset item", number=number, value=f"{one:.10g}") for number, one in enumerate(values, 1))
    least = f"{min(values):.10g}"
    most = f"{max(values):.10g}"
    return filled_element(
        "dataset", name=name, least=least, most=most, count=len(values), items=_joined_elements(items)
    )


def _stack_question(name: str, group: Sequence[Quiz], lang: Lang) -> Xml:
    first = group[0]
    pool = Pool(group, lang)
    numbers = range(1, len(first.questions) + 1)
    inputs = [
        f"{question_html(item, lang)}<p>[[input:ans{k}]] [[validation:ans{k}]]</p>"
        for k, item in enumerate(first.questions, 1)
    ]
    right, wrong = (say(key, lang) for key in ("quiz_right", "quiz_wrong"))
    share = f"{1.0 / len(numbers):.7f}"
    return filled_element(
        "stack",
        head=_question_head(name, question_stem(pool, "{@d_", "@}") + "".join(inputs), first.picture),
        variables=_maxima_variables(pool),
        feedback="".join(f"[[feedback:prt{k}]]" for k in numbers),
        inputs=_joined_elements(filled_element("input", k=k) for k in numbers),
        trees=_joined_elements(filled_element("tree", k=k, share=share, right=right, wrong=wrong) for k in numbers),
        seeds=_joined_elements(filled_element("seed", seed=seed) for seed in stack_seeds(len(group))),
    )


def stack_seeds(count: int) -> list[int]:
    """For each student the least seed with which STACK's ``rand`` draws that student's number.

    It is Maxima's ``random``, the first number of a Mersenne twister of that seed, modulo the count.
    """
    seed_of: dict[int, int] = {}
    for seed in itertools.count(1):
        seed_of.setdefault(int(RandomState(seed).randint(0, 2**32, dtype=uint32)) % count, seed)
        if len(seed_of) == count:
            return [seed_of[k] for k in range(count)]
    raise AssertionError


def _maxima_variables(pool: Pool) -> str:
    """Maxima code: the student's index, numbers, answers and tolerances."""
    group = pool.group
    lines = [f"k: rand({len(group)}) + 1;"]
    for name, values in pool.varied_numbers.items():
        lines += _indexed_variable(f"d_{name}", [f"{value:.6g}" for value in values])
    for k in range(len(group[0].questions)):
        for letter, part in (("ta", "value"), ("tol", "tolerance")):
            lines += _indexed_variable(f"{letter}{k + 1}", [f"{getattr(q.questions[k], part):.10g}" for q in group])
    return "\n".join(lines)


def _indexed_variable(name: str, numbers: Sequence[str]) -> list[str]:
    """A variable with one student's number out of all."""
    return [f"{name}_all: [{', '.join(numbers)}];", f"{name}: {name}_all[k];"]
