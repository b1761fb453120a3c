"""Questions of a course in the import formats of learning platforms: Moodle XML, numerical and calculated questions,
and STACK.

Formats: https://docs.moodle.org/en/Moodle_XML_format; STACK questions use the same file format. Numbers have a decimal
point, tolerances are the errors of a student's pencil; every picture is in the file.
"""

import base64
import html
import itertools
import re
from collections.abc import Mapping, Sequence
from xml.etree.ElementTree import Element, SubElement, indent, tostring

from numpy import uint32
from numpy.random import RandomState

from planes.course.quiz import LEAST, Pool, Quiz, QuizItem, by_assignment
from planes.words import Lang, say
from planes.words.naming import Naming

PICTURE = "scheme.png"
STACK_VERSION = "2023121100"
GRADE = "1.0000000"
UNITLESS = {"unitgradingtype": "0", "unitpenalty": "0.1", "showunits": "3", "unitsleft": "0"}


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
    quiz = Element("quiz")
    for one in quizzes:
        _category(quiz, course, one.place)
        for item in one.questions:
            _numerical(quiz, one, item, lang)
    for name, group in by_assignment(quizzes).items():
        _category(quiz, course, say("quiz_pool", lang, name=name))
        for number in range(len(group[0].questions)):
            _calculated(quiz, group, number, lang)
    return xml_file(quiz)


def stack(quizzes: Sequence[Quiz], course: str, lang: Lang) -> bytes:
    """A STACK question for each assignment: a variant has one student's numbers, every answer has its own input."""
    quiz = Element("quiz")
    _category(quiz, course, "STACK")
    for name, group in by_assignment(quizzes).items():
        _stack(quiz, name, group, lang)
    return xml_file(quiz)


def xml_file(root: Element) -> bytes:
    """A file of an element, one line for each child."""
    indent(root, " ")
    return b'<?xml version="1.0" encoding="UTF-8"?>\n' + tostring(root, "unicode").encode() + b"\n"


def _text(parent: Element, tag: str, text: str, **how: str) -> Element:
    """An element whose words are in a <text>, as Moodle requires."""
    element = SubElement(parent, tag, how)
    SubElement(element, "text").text = text
    return element


def _fields(parent: Element, fields: Mapping[str, str]) -> None:
    """Elements that contain only text."""
    for tag, text in fields.items():
        SubElement(parent, tag).text = text


def _category(quiz: Element, course: str, name: str) -> None:
    plain = "/".join(part.replace("/", "//") for part in ("top", course or "planes", name))
    _text(SubElement(quiz, "question", type="category"), "category", f"$course$/{plain}")


def _question(quiz: Element, kind: str, name: str, text: str, picture: bytes) -> Element:
    """The common head of all questions, with the picture in the file."""
    question = SubElement(quiz, "question", type=kind)
    _text(question, "name", name)
    shown = f'{text}<p><img src="@@PLUGINFILE@@/{PICTURE}" alt="" style="max-width: 100%"/></p>'
    body = _text(question, "questiontext", shown, format="html")
    held = SubElement(body, "file", name=PICTURE, path="/", encoding="base64")
    held.text = base64.b64encode(picture).decode()
    _text(question, "generalfeedback", "", format="html")
    _fields(question, {"defaultgrade": GRADE, "penalty": "0.3333333", "hidden": "0"})
    return question


def asked(item: QuizItem, lang: Lang) -> str:
    """The question, with the unit."""
    return f"<p>{say('quiz_find', lang, name=signed(item.name, lang), unit=say(item.unit, lang))}</p>"


def _numerical(quiz: Element, one: Quiz, item: QuizItem, lang: Lang) -> None:
    text = stem(Pool([one], lang), "", "") + asked(item, lang)
    question = _question(quiz, "numerical", f"{one.assignment}: {item.name}", text, one.picture)
    answer = _text(question, "answer", f"{item.value:.10g}", fraction="100", format="moodle_auto_format")
    SubElement(answer, "tolerance").text = f"{item.tolerance:.6g}"
    _text(answer, "feedback", "", format="html")
    _fields(question, UNITLESS)


def _calculated(quiz: Element, group: Sequence[Quiz], number: int, lang: Lang) -> None:
    """One answer of an assignment, with numbers drawn from those of the students."""
    first, item = group[0], group[0].questions[number]
    pool = Pool(group, lang)
    text = stem(pool, "{", "}") + asked(item, lang)
    question = _question(quiz, "calculated", f"{first.assignment}: {item.name}", text, first.picture)
    _fields(question, {"synchronize": "1", "single": "0", "answernumbering": "abc", "shuffleanswers": "0"})
    for tag in ("correctfeedback", "partiallycorrectfeedback", "incorrectfeedback"):
        _text(question, tag, "")
    answer = SubElement(question, "answer", fraction="100")
    SubElement(answer, "text").text = f"{{{item.key}}}"
    asked_of = [q.questions[number] for q in group]
    share = max(LEAST, *(one.tolerance / abs(one.value) for one in asked_of))  # so that nobody's right drawing fails
    fields = {"tolerance": f"{share:.6g}", "tolerancetype": "1", "correctanswerformat": "2", "correctanswerlength": "4"}
    _fields(answer, fields)  # relative; significant figures
    _text(answer, "feedback", "", format="html")
    _fields(question, UNITLESS)
    rows = pool.varied | {item.key: [one.value for one in asked_of]}
    definitions = SubElement(question, "dataset_definitions")
    for name, values in rows.items():
        _dataset(definitions, name, values)


def _dataset(definitions: Element, name: str, values: Sequence[float]) -> None:
    """The values of a wildcard, one for each student."""
    own = SubElement(definitions, "dataset_definition")
    _text(own, "status", "private")
    _text(own, "name", name)
    SubElement(own, "type").text = "calculated"
    for tag, text in {
        "distribution": "uniform",
        "minimum": f"{min(values):.10g}",
        "maximum": f"{max(values):.10g}",
    }.items():
        _text(own, tag, text)
    _text(own, "decimals", "4")
    SubElement(own, "itemcount").text = str(len(values))
    items = SubElement(own, "dataset_items")
    for number, one in enumerate(values, 1):
        _fields(SubElement(items, "dataset_item"), {"number": str(number), "value": f"{one:.10g}"})
    SubElement(own, "number_of_items").text = str(len(values))


def _stack(quiz: Element, name: str, group: Sequence[Quiz], lang: Lang) -> None:
    first, pool = group[0], Pool(group, lang)
    numbers = range(1, len(first.questions) + 1)
    inputs = [
        f"{asked(item, lang)}<p>[[input:ans{k}]] [[validation:ans{k}]]</p>" for k, item in enumerate(first.questions, 1)
    ]
    text = stem(pool, "{@d_", "@}") + "".join(inputs)
    question = _question(quiz, "stack", name, text, first.picture)
    _text(question, "stackversion", STACK_VERSION)
    _text(question, "questionvariables", _variables(pool))
    feedback = "".join(f"[[feedback:prt{k}]]" for k in numbers)
    _text(question, "specificfeedback", feedback, format="html")
    _text(question, "questionnote", "{@k@}")
    _fields(question, {"questionsimplify": "1", "assumepositive": "0", "multiplicationsign": "dot", "sqrtsign": "1"})
    for k in numbers:
        _input(question, k)
    for k in numbers:
        _tree(question, k, 1.0 / len(numbers), lang)
    for seed in seeds(len(group)):
        _fields(question, {"deployedseed": str(seed)})


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


def _input(question: Element, k: int) -> None:
    fields = {
        "name": f"ans{k}",
        "type": "numerical",
        "tans": f"ta{k}",
        "boxsize": "12",
        "strictsyntax": "1",
        "insertstars": "0",
        "forbidfloat": "0",
        "requirelowestterms": "0",
        "checkanswertype": "0",
        "mustverify": "0",
        "showvalidation": "1",
    }
    _fields(SubElement(question, "input"), fields)


def _tree(question: Element, k: int, share: float, lang: Lang) -> None:
    """Right within the tolerance."""
    tree = SubElement(question, "prt")
    _fields(tree, {"name": f"prt{k}", "value": f"{share:.7f}", "autosimplify": "1", "feedbackstyle": "1"})
    _text(tree, "feedbackvariables", f"near{k}: is(abs(ans{k} - ta{k}) <= tol{k});")
    node = SubElement(tree, "node")
    fields = {
        "name": "0",
        "answertest": "AlgEquiv",
        "sans": f"near{k}",
        "tans": "true",
        "testoptions": "",
        "quiet": "1",
    }
    _fields(node, fields)
    for side, score, key in (("true", "1", "quiz_right"), ("false", "0", "quiz_wrong")):
        note = f"prt{k}-1-{side[0].upper()}"
        fields = {"scoremode": "=", "score": score, "penalty": "", "nextnode": "-1", "answernote": note}
        _fields(node, {f"{side}{tag}": text for tag, text in fields.items()})
        _text(node, f"{side}feedback", say(key, lang), format="html")
