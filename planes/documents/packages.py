"""Packages of learning platforms: a lesson for SCORM 1.2, an assignment as a PrairieLearn question."""

import io
import json
import uuid
import zipfile
from collections.abc import Sequence

from planes.course.quiz import Pool, Quiz
from planes.documents.platforms import PICTURE, asked, filled, in_file, stem
from planes.words import Lang

MOMENT = (2020, 1, 1, 0, 0, 0)  # date of every file in an archive, so that the same lesson gives the same bytes
NAMES = uuid.UUID("6f2b1d5e-6d4b-5d0e-9b0e-8a3f0c0d1e2f")


def scorm(page: bytes, name: str, title: str) -> bytes:
    """A lesson with its manifest, as an archive; the page itself reports its score to the platform."""
    held = io.BytesIO()
    with zipfile.ZipFile(held, "w", zipfile.ZIP_DEFLATED) as archive:
        for file, data in (("imsmanifest.xml", manifest(name, title)), ("index.html", page)):
            archive.writestr(zipfile.ZipInfo(file, MOMENT), data, zipfile.ZIP_DEFLATED)
    return held.getvalue()


def manifest(name: str, title: str) -> bytes:
    """imsmanifest.xml of one lesson (SCORM 1.2, Content Aggregation Model)."""
    return in_file(filled("manifest", identifier=uuid.uuid5(NAMES, name), title=title))


SERVER = '''"""One student's numbers, drawn by the variant."""

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


def prairielearn(name: str, group: Sequence[Quiz], lang: Lang) -> dict[str, bytes]:
    """The files of a question folder: info.json, question.html, server.py, numbers.json and the picture."""
    first, pool = group[0], Pool(group, lang)
    inputs = "".join(
        f'{asked(q, lang)}<pl-number-input answers-name="{q.key}" comparison="relabs" rtol="0" '
        f'atol="{{{{params.tolerance_{q.key}}}}}" suffix="{q.unit}"></pl-number-input>\n'
        for q in first.questions
    )
    text = f"<pl-question-panel>\n{stem(pool, '{{params.', '}}')}\n"
    text += (
        f'<pl-figure file-name="{PICTURE}" directory="clientFilesQuestion"></pl-figure>\n</pl-question-panel>\n{inputs}'
    )
    sets = [
        {
            "given": {key: values[k] for key, values in pool.varied.items()},
            "answers": {i.key: {"value": i.value, "tolerance": i.tolerance} for i in q.questions},
        }
        for k, q in enumerate(group)
    ]
    info = {
        "uuid": str(uuid.uuid5(NAMES, f"prairielearn {name}")),
        "title": first.title,
        "topic": "Mechanisms",
        "tags": ["numeric"],
        "type": "v3",
    }
    return {
        "info.json": _json(info),
        "question.html": text.encode(),
        "server.py": SERVER.encode(),
        "numbers.json": _json(sets),
        f"clientFilesQuestion/{PICTURE}": first.picture,
    }


def _json(thing: object) -> bytes:
    return (json.dumps(thing, ensure_ascii=False, indent=1, allow_nan=False) + "\n").encode()
