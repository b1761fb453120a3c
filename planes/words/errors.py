"""Every error class, and how a refusal offers what would have been valid. The words are in the table of words."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from difflib import get_close_matches
from itertools import islice
from pathlib import Path
from typing import Any

from planes.words import Lang, Phrase, Told
from planes.words.frozen import frozen
from planes.words.names import latin

QUOTED, OFFERED = 60, 40  # letters of what is quoted of a file; letters of a name that is offered, and how many
_SPELLED = "alpha beta gamma delta epsilon theta lambda mu rho tau phi psi omega"
_GREEK = dict(zip("αβγδεθλμρτφψω", _SPELLED.split(), strict=True))
_RUSSIAN = """
название=title заголовок=title примечание=note параметры=parameters варианты=variants стойка=frame
звенья=links звено=link сборка=assembly привод=drive ведущее=drive нагрузки=loads нагрузка=loads
силы=loads сила=force момент=moment трение=friction планы=plans масштаб=mu найти=find лист=sheet
векторы=vectors уравнения=equations точки=points точка=point направляющие=guides скользит=slides
масса=mass инерция=inertia центр=centre угол=angle направление=direction гравитация=gravity
"""
_MEANT = dict(pair.split("=") for pair in _RUSSIAN.split())
"""Keys of a scene by the Russian words for them."""
_ELSEWHERE = {"alpha": "epsilon", "theta": "phi", "w": "omega"}
"""Letters of other books by those of this one."""


def place_of(file: str, line: int | None) -> str:
    """Where something is said, before its sentence; what was built in Python, <Slider-crank>, has no lines."""
    return f"{file}:{line}: " if line and file[:1] != "<" else (f"{file}: " if file else "")


class PlanesError(Exception):
    """Base class of all errors of planes. The message is one sentence with names, numbers, the place and the remedy.

    ``str`` gives it in English, :meth:`told` in other languages.
    """

    place = ""

    def __init__(self, phrase: Told) -> None:
        self.phrase = phrase
        super().__init__(self.told())

    def told(self, lang: Lang = "en") -> str:
        """The place and the sentence in a language."""
        return self.place + (self.phrase.told(lang) if isinstance(self.phrase, Phrase) else self.phrase)

    @property
    def parts(self) -> dict[str, Any]:
        """What its sentence is made of; nothing where that is plain text."""
        return self.phrase.parts if isinstance(self.phrase, Phrase) else {}


class UnknownName(PlanesError, KeyError):
    """There is no result of this name; the message lists the names there are."""

    __str__ = Exception.__str__  # a KeyError would put it in quotes


class SceneError(PlanesError, ValueError):
    """The scene file says something that cannot be meant."""

    def __init__(self, phrase: Told, file: str = "", line: int | None = None) -> None:
        self.place = place_of(file, line)
        self.file, self.line = file, line
        super().__init__(phrase.in_python() if file[:1] == "<" and isinstance(phrase, Phrase) else phrase)


@frozen
class Doubt:
    """Something a scene says that can be meant, but hardly is: a warning with its place."""

    phrase: Phrase
    file: str
    line: int

    def told(self, lang: Lang = "en") -> str:
        """The place and the sentence in a language."""
        phrase = self.phrase.in_python() if self.file[:1] == "<" else self.phrase
        return f"{place_of(self.file, self.line)}{phrase.told(lang)}"


class StructureError(SceneError):
    """The links and pairs do not make a mechanism this method can draw."""


class EquationError(PlanesError, ValueError):
    """A vector equation that cannot be drawn: a broken chain, or not exactly two unknowns."""


class ProgramError(PlanesError, ValueError):
    """A program of steps that does not hang together."""


class _Reasoned(PlanesError, ArithmeticError):
    """``reason`` is a key of the table of words, with names and ``numbers``."""

    def __init__(self, reason: str, **numbers: object) -> None:
        self.reason, self.numbers = reason, numbers
        super().__init__(Phrase(reason, **numbers))


class PlanFailure(_Reasoned):
    """A construction that cannot be drawn in this position."""


class Contradiction(_Reasoned):
    """A drawing that contradicts itself: the fault is the program's, so nothing of it is given."""


class ExpressionError(PlanesError, ValueError):
    """An expression that has no value; ``parameter`` names the parameter it belongs to, if it is one."""

    def __init__(self, phrase: Told, parameter: str = "") -> None:
        super().__init__(phrase)
        self.parameter = parameter


def _near(given: str, known: list[str]) -> Told:
    """Words with the name that is meant, if one is near, or looks the same in other letters."""
    meant = _MEANT.get(given.casefold(), _spelled(given))
    letter, _, index = meant.partition("_")
    ways = (meant, f"{_ELSEWHERE.get(letter, letter)}_{index}")
    if same := next((name for way in ways for name in known if _spelled(name) == way), None):
        return Phrase("near_name", name=same)
    if alike := next((name for name in known if latin(name) == latin(given)), None):
        return Phrase("near_alike", name=alike)
    matches = get_close_matches(given, known, n=1, cutoff=0.5)
    return Phrase("near_name", name=matches[0]) if matches else ""


def nearest(given: str, names: Iterable[str]) -> str:
    """The name that is written most like the given one; empty where none is."""
    near = _near(given[:OFFERED], [*islice(names, 2000)])
    return str(near.parts["name"]) if isinstance(near, Phrase) else ""


def _spelled(name: str) -> str:
    """The name with Greek letters spelled: phi_1 for φ_1."""
    return "".join(_GREEK.get(letter, letter) for letter in name)


def shown(text: str) -> str:
    """A piece of somebody's file as it is quoted in a sentence: on one line, cut when long."""
    short = text if len(text) <= QUOTED else text[: QUOTED - 1] + "…"
    return '"' + "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in short) + '"'


def choices(given: str, names: Iterable[str], what: str = "valid") -> Told:
    """Words that name what would have been valid: "; valid: a, b; did you mean a?", for lists of any length, of names
    of any length: bounded in time and in words. ``what`` is their key."""
    known, given = [name for name in islice(names, 2000) if len(name) <= OFFERED], given[:OFFERED]
    if not known:
        return ""
    near = _near(given, known)
    if len(known) <= OFFERED:
        return Phrase(what, names=tuple(known), near=near)
    meant = [near.parts["name"]] if isinstance(near, Phrase) else []
    some = tuple(dict.fromkeys((*meant, *get_close_matches(given, known, 12), *known)))[:12]
    return Phrase("valid_some", names=some, near=near)


@contextmanager
def guarded(key: str, file: str | Path) -> Iterator[None]:
    """Whatever a library breaks on while a file is read or worked on, as the sentence ``key`` about the file."""
    try:
        yield
    except PlanesError:
        raise
    except Exception as error:  # on broken files libraries break in every way there is
        why = str(error).partition("\n")[0][:80] or type(error).__name__
        raise PlanesError(Phrase(key, file=str(file), why=why)) from None
