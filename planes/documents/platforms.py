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

from planes.course.quiz import LEAST, Pool, Quiz, QuizItem, by_assignment
from planes.words import Lang, say
from planes.words.naming import Naming

PICTURE = "scheme.png"


def indexed(text: str) -> str:
    """Text with indices in braces as HTML."""
    return re.sub(r"\^\{(.*?)\}", r"<sup>\1</sup>", re.sub(r"_\{(.*?)\}", r"<sub>\1</sub>", html.escape(text, False)))


def signed(name: str, lang: Lang) -> str:
    """A name as lettered on a page: v_C as v with a subscript."""
    return indexed(Naming(lang).vector(name))


def stem(pool: Pool, opened: str, closed: str) -> str:
    """Title, task and numbers; the placeholder of an individual number is between two signs."""
    text = indexed(pool.text(lambda key: f"⟦{key}⟧")).replace("⟦", opened).replace("⟧", closed)
    return f"<p>{html.escape(pool.group[0].title)}</p><p>{text}</p>"


def moodle(quizzes: Sequence[Quiz], course: str, lang: Lang) -> bytes:
    """Numerical questions for every student, a category each; and a calculated question for each answer of an
    assignment, with everybody's numbers as its data set."""
    made = []
    for one in quizzes:
        made += [_category(course, one.place), *(_numerical(one, item, lang) for item in one.questions)]
    for name, group in by_assignment(quizzes).items():
        calculated = (_calculated(group, number, lang) for number in range(len(group[0].questions)))
        made += [_category(course, say("quiz_pool", lang, name=name)), *calculated]
    return _quiz_file(made)


def stack(quizzes: Sequence[Quiz], course: str, lang: Lang) -> bytes:
    """A STACK question for each assignment: a variant has one student's numbers, every answer has its own input."""
    asked_of = (_stack(name, group, lang) for name, group in by_assignment(quizzes).items())
    return _quiz_file([_category(course, "STACK"), *asked_of])


class Xml(str):
    """Elements that are written already."""


@cache
def _parts() -> dict[str, Template]:
    """The elements of ``platforms.txt`` by name."""
    text = Path(__file__).with_name("platforms.txt").read_text("utf-8")
    named = (part.partition("]\n") for part in text.removeprefix("[").split("\n["))
    return {name: Template(body) for name, _, body in named}


def filled(part: str, **values: object) -> Xml:
    """An element with its values; whatever is not an element itself is text."""
    texts = {name: v if isinstance(v, Xml) else html.escape(str(v), quote=False) for name, v in values.items()}
    return Xml(_parts()[part].substitute(texts))


def _all(elements: Iterable[str]) -> Xml:
    return Xml("".join(elements))


def _quiz_file(questions: Iterable[Xml]) -> bytes:
    root = fromstring(f"<quiz>{_all(questions)}</quiz>")
    indent(root, " ")
    return in_file(tostring(root, "unicode"))


def in_file(element: str) -> bytes:
    """A file of an element."""
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{element.rstrip()}\n'.encode()


def _category(course: str, name: str) -> Xml:
    plain = "/".join(part.replace("/", "//") for part in ("top", course or "planes", name))
    return filled("category", path=plain)


def _head(name: str, text: str, picture: bytes) -> Xml:
    """The common head of all questions, with the picture in the file."""
    shown = f'{text}<p><img src="@@PLUGINFILE@@/{PICTURE}" alt="" style="max-width: 100%"/></p>'
    return filled("head", name=name, text=shown, file=PICTURE, picture=base64.b64encode(picture).decode())


def asked(item: QuizItem, lang: Lang) -> str:
    """The question, with the unit."""
    return f"<p>{say('quiz_find', lang, name=signed(item.name, lang), unit=say(item.unit, lang))}</p>"


def _numerical(one: Quiz, item: QuizItem, lang: Lang) -> Xml:
    text = stem(Pool([one], lang), "", "") + asked(item, lang)
    head = _head(f"{one.assignment}: {item.name}", text, one.picture)
    value, tolerance = f"{item.value:.10g}", f"{item.tolerance:.6g}"
    return filled("numerical", head=head, value=value, tolerance=tolerance, unitless=filled("unitless"))


def _calculated(group: Sequence[Quiz], number: int, lang: Lang) -> Xml:
    """One answer of an assignment, with numbers drawn from those of the students."""
    first, item = group[0], group[0].questions[number]
    pool = Pool(group, lang)
    text = stem(pool, "{", "}") + asked(item, lang)
    head = _head(f"{first.assignment}: {item.name}", text, first.picture)
    asked_of = [q.questions[number] for q in group]
    share = max(LEAST, *(one.tolerance / abs(one.value) for one in asked_of))  # so that nobody's right drawing fails
    rows = pool.varied | {item.key: [one.value for one in asked_of]}
    return filled(
        "calculated",
        head=head,
        key=item.key,
        share=f"{share:.6g}",
        unitless=filled("unitless"),
        datasets=_all(_dataset(name, values) for name, values in rows.items()),
    )


def _dataset(name: str, values: Sequence[float]) -> Xml:
    """The values of a wildcard, one for each student."""
    items = (filled("dataset item", number=number, value=f"{one:.10g}") for number, one in enumerate(values, 1))
    least, most = f"{min(values):.10g}", f"{max(values):.10g}"
    return filled("dataset", name=name, least=least, most=most, count=len(values), items=_all(items))


def _stack(name: str, group: Sequence[Quiz], lang: Lang) -> Xml:
    first, pool = group[0], Pool(group, lang)
    numbers = range(1, len(first.questions) + 1)
    inputs = [
        f"{asked(item, lang)}<p>[[input:ans{k}]] [[validation:ans{k}]]</p>" for k, item in enumerate(first.questions, 1)
    ]
    right, wrong = (say(key, lang) for key in ("quiz_right", "quiz_wrong"))
    share = f"{1.0 / len(numbers):.7f}"
    return filled(
        "stack",
        head=_head(name, stem(pool, "{@d_", "@}") + "".join(inputs), first.picture),
        variables=_variables(pool),
        feedback="".join(f"[[feedback:prt{k}]]" for k in numbers),
        inputs=_all(filled("input", k=k) for k in numbers),
        trees=_all(filled("tree", k=k, share=share, right=right, wrong=wrong) for k in numbers),
        seeds=_all(filled("seed", seed=seed) for seed in seeds(len(group))),
    )


def seeds(count: int) -> list[int]:
    """For each student the least seed with which STACK's ``rand`` draws that student's number.

    It is Maxima's ``random``, the first number of a Mersenne twister of that seed, modulo the count.
    """
    seed_of: dict[int, int] = {}
    for seed in itertools.count(1):
        seed_of.setdefault(int(RandomState(seed).randint(0, 2**32, dtype=uint32)) % count, seed)
        if len(seed_of) == count:
            return [seed_of[k] for k in range(count)]
    raise AssertionError


def _variables(pool: Pool) -> str:
    """Maxima code: the student's index, numbers, answers and tolerances."""
    group = pool.group
    lines = [f"k: rand({len(group)}) + 1;"]
    for name, values in pool.varied.items():
        lines += _one_of(f"d_{name}", [f"{value:.6g}" for value in values])
    for k in range(len(group[0].questions)):
        for letter, part in (("ta", "value"), ("tol", "tolerance")):
            lines += _one_of(f"{letter}{k + 1}", [f"{getattr(q.questions[k], part):.10g}" for q in group])
    return "\n".join(lines)


def _one_of(name: str, numbers: Sequence[str]) -> list[str]:
    """A variable with one student's number out of all."""
    return [f"{name}_all: [{', '.join(numbers)}];", f"{name}: {name}_all[k];"]
