"""Packages of learning platforms: a lesson for SCORM 1.2, an assignment as a PrairieLearn question."""

import io
import json
import uuid
import zipfile
from collections.abc import Callable, Mapping, Sequence

from planes.course.quiz import Pool, Quiz, quizzes_by_assignment
from planes.documents.platforms import (
    PICTURE_FILE_NAME,
    element_as_file,
    filled_element,
    moodle_xml,
    question_html,
    question_stem,
    stack_xml,
)
from planes.words import Lang

ARCHIVE_DATE = (2020, 1, 1, 0, 0, 0)  # date of every file in an archive, so that the same lesson gives the same bytes
UUID_NAMESPACE = uuid.UUID("6f2b1d5e-6d4b-5d0e-9b0e-8a3f0c0d1e2f")


def scorm_archive(page: bytes, name: str, title: str) -> bytes:
    """A lesson with its manifest, as an archive; the page itself reports its score to the platform."""
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED) as archive:
        for file, data in (("imsmanifest.xml", scorm_manifest(name, title)), ("index.html", page)):
            archive.writestr(zipfile.ZipInfo(file, ARCHIVE_DATE), data, zipfile.ZIP_DEFLATED)
    return held.getvalue()


def scorm_manifest(name: str, title: str) -> bytes:
    """imsmanifest.xml of one lesson (SCORM 1.2, Content Aggregation Model)."""
    return element_as_file(filled_element("manifest", identifier=uuid.uuid5(UUID_NAMESPACE, name), title=title))


SERVER_SCRIPT = '''"""One student's numbers, drawn by the variant."""

import json
import os
import random


def generate(data):
    """Put the numbers and the answers of one of the sets into the question."""
    with open(os.path.join(os.path.dirname(__file__), "numbers.json"), encoding="utf-8") as file:
        sets = json.load(file)
    chosen = random.Random(data["variant_seed"]).choice(sets)
    data["params"].update(chosen["given"])
    data["params"].update({f"tolerance_{name}": one["tolerance"] for name, one in chosen["answers"].items()})
    data["correct_answers"].update({name: one["value"] for name, one in chosen["answers"].items()})
'''


def prairielearn_files(name: str, group: Sequence[Quiz], lang: Lang) -> dict[str, bytes]:
    """The files of a question folder: info.json, question.html, server.py, numbers.json and the picture."""
    first = group[0]
    pool = Pool(group, lang)
    inputs = "".join(
        f'{question_html(q, lang)}<pl-number-input answers-name="{q.platform_key}" comparison="relabs" rtol="0" '
        f'atol="{{{{params.tolerance_{q.platform_key}}}}}" suffix="{q.unit}"></pl-number-input>\n'
        for q in first.questions
    )
    text = f"<pl-question-panel>\n{question_stem(pool, '{{params.', '}}')}\n"
    text += f'<pl-figure file-name="{PICTURE_FILE_NAME}" directory="clientFilesQuestion"></pl-figure>\n'
    text += f"</pl-question-panel>\n{inputs}"
    sets = [
        {
            "given": {key: values[k] for key, values in pool.varied_numbers.items()},
            "answers": {i.platform_key: {"value": i.value, "tolerance": i.tolerance} for i in q.questions},
        }
        for k, q in enumerate(group)
    ]
    info = {
        "uuid": str(uuid.uuid5(UUID_NAMESPACE, f"prairielearn {name}")),
        "title": first.title,
        "topic": "Mechanisms",
        "tags": ["numeric"],
        "type": "v3",
    }
    return {
        "info.json": _json_bytes(info),
        "question.html": text.encode(),
        "server.py": SERVER_SCRIPT.encode(),
        "numbers.json": _json_bytes(sets),
        f"clientFilesQuestion/{PICTURE_FILE_NAME}": first.picture,
    }


WRITERS_BY_PLATFORM: Mapping[str, Callable[[Sequence[Quiz], str, Lang], Mapping[str, bytes]]] = {
    "moodle": lambda quizzes, title, lang: {".xml": moodle_xml(quizzes, title, lang)},
    "stack": lambda quizzes, title, lang: {".xml": stack_xml(quizzes, title, lang)},
    "prairielearn": lambda quizzes, title, lang: {
        f"/{name}/{inner}": data
        for name, group in quizzes_by_assignment(quizzes).items()
        for inner, data in prairielearn_files(name, group, lang).items()
    },
}
"""For each platform of ``planes.course`` the files with everybody's questions, by what follows its name."""


def _json_bytes(thing: object) -> bytes:
    return (json.dumps(thing, ensure_ascii=False, indent=1, allow_nan=False) + "\n").encode()
