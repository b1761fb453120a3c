"""Corrupted files: a scene or a drawing with one to three of its lines, words or numbers changed at random.

In any case a command ends in a result or in sentences: no traceback, no NaN, a known exit status.
"""

from __future__ import annotations

import io
import random
import re
import traceback
from contextlib import redirect_stderr, redirect_stdout
from pathlib import Path

from planes.cli import main

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")
STRANGE = (
    "0",
    "-1",
    "1e308",
    "1e-308",
    "-0",
    "nan",
    ".inf",
    "1,5",
    "180",
    "90",
    "1/0",
    "phi_1",
    "[]",
    "{}",
    "",
    '"',
    "ω",
    "~",
)
NOTHING = re.compile(r"\b(?:nan|inf)\b")
KNOWN = {0, 1, 2, 3}
"""The exit statuses."""


def spoiled(text: str, rng: random.Random) -> str:
    """The text with one to three typing errors."""
    for _ in range(rng.randint(1, 3)):
        text = rng.choice((_number, _number, _number, _word, _line_lost, _line_twice, _swapped, _letter, _cut))(
            text, rng
        )
    return text


def _number(text: str, rng: random.Random) -> str:
    places = list(NUMBER.finditer(text))
    if not places:
        return text
    at = rng.choice(places)
    own = (f"{float(at[0]) * rng.choice((-1, 10, 0.1, 1.0001, 2)):g}", rng.choice(places)[0])
    return text[: at.start()] + rng.choice((*own, rng.choice(STRANGE))) + text[at.end() :]


def _word(text: str, rng: random.Random) -> str:
    words = list(re.finditer(r"\w+", text))
    one, other = rng.choice(words), rng.choice(words)
    return text[: one.start()] + other[0] + text[one.end() :]


def _line_lost(text: str, rng: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    del lines[rng.randrange(len(lines))]
    return "".join(lines) or text


def _line_twice(text: str, rng: random.Random) -> str:
    lines = text.splitlines(keepends=True)
    lines.insert(rng.randrange(len(lines)), rng.choice(lines))
    return "".join(lines)


def _swapped(text: str, rng: random.Random) -> str:
    places = list(NUMBER.finditer(text))
    if len(places) < 2:
        return text
    one, other = sorted(rng.sample(places, 2), key=lambda m: m.start())
    return text[: one.start()] + other[0] + text[one.end() : other.start()] + one[0] + text[other.end() :]


def _letter(text: str, rng: random.Random) -> str:
    at = rng.randrange(len(text))
    return text[:at] + rng.choice(("", "x", ":", "\t", "}", "-", "А", "\N{COMBINING ACUTE ACCENT}")) + text[at + 1 :]


def _cut(text: str, rng: random.Random) -> str:
    return text[: rng.randrange(len(text) // 2, len(text))] or text


def fault(words: list[str]) -> str:
    """The fault in how a command ends; "" for none."""
    out, err = io.StringIO(), io.StringIO()
    try:
        with redirect_stdout(out), redirect_stderr(err):
            status = main(words)
    except SystemExit as stop:
        status = int(stop.code or 0)
    except BaseException:
        return traceback.format_exc()
    said = out.getvalue() + err.getvalue()
    if status not in KNOWN:
        return f"exit status {status}"
    if status == 2 and not said.strip():
        return "refused without a word"
    named = any(NOTHING.search(Path(word).read_text("utf-8")) for word in words if word.endswith((".yaml", ".csv")))
    if "Traceback" in said or (NOTHING.search(out.getvalue()) and not named):  # unless a link has that name
        return said[-300:]
    return ""


def made(folder: Path, text: str, suffix: str) -> Path:
    """A file with a text."""
    file = folder / f"spoiled{suffix}"
    file.write_text(text, "utf-8")
    return file
