"""Every error class, and the sentence each one says. Text for people is kept in one table per language."""

from __future__ import annotations

from collections.abc import Iterable
from difflib import get_close_matches
from itertools import islice

from planes.words import Lang, say


class PlanesError(Exception):
    """Base of every refusal: its text is one sentence with names, numbers, the place and what to do."""


class SceneError(PlanesError, ValueError):
    """The scene file says something that cannot be meant."""

    def __init__(self, sentence: str, file: str = "", line: int | None = None) -> None:
        place = f"{file}:{line}: " if line else (f"{file}: " if file else "")
        super().__init__(place + sentence)
        self.sentence, self.file, self.line = sentence, file, line


class StructureError(SceneError):
    """The links and pairs do not make a mechanism this method can draw."""


class EquationError(PlanesError, ValueError):
    """A vector equation that cannot be drawn: a broken chain, or not exactly two unknowns."""


class ProgramError(PlanesError, ValueError):
    """A program of steps that does not hang together."""


class PlanFailure(PlanesError, ArithmeticError):
    """A construction that cannot be drawn in this position; ``reason`` is a key of the table of words."""

    def __init__(self, reason: str, **numbers: object) -> None:
        self.reason, self.numbers = reason, numbers
        super().__init__(self.sentence())

    def sentence(self, lang: Lang = "en") -> str:
        """What went wrong, in words of a language."""
        return say(self.reason, lang, **self.numbers)


def valid_names(given: str, names: list[str] | tuple[str, ...], what: str = "valid") -> str:
    """Words that name what would have been valid, the nearest first: "; valid: a, b (did you mean a?)"."""
    if not names:
        return ""
    near = get_close_matches(given, names, n=1)
    hint = f"; did you mean {near[0]}?" if near else ""
    return f"; {what}: {', '.join(names)}{hint}"


class ExpressionError(PlanesError, ValueError):
    """An expression that has no value; ``parameter`` names the parameter it belongs to, if it is one."""

    def __init__(self, sentence: str, parameter: str = "") -> None:
        super().__init__(sentence)
        self.sentence, self.parameter = sentence, parameter


def shown(text: str, limit: int = 60) -> str:
    """A piece of somebody's file as it is quoted in a sentence: on one line, cut when long."""
    short = text if len(text) <= limit else text[: limit - 1] + "…"
    return '"' + "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in short) + '"'


def choices(given: str, names: Iterable[str], what: str = "valid", limit: int = 40) -> str:
    """``valid_names`` for lists of any length, of names of any length: bounded in time and in words."""
    known = [name for name in islice(names, 2000) if len(name) <= limit]
    if not known:
        return ""
    near = get_close_matches(given[:limit], known, n=1, cutoff=0.5)
    if len(known) > limit:
        what, known = f"{what} (some of them)", [*near, *(name for name in known[:12] if name not in near)]
    return f"; {what}: {', '.join(known)}" + (f"; did you mean {near[0]}?" if near else "")
