"""All error classes, and how a message lists the valid choices. The texts are in the table of words."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from difflib import get_close_matches
from itertools import islice
from pathlib import Path
from typing import Any

from planes.words import Lang, Phrase, Told, table
from planes.words.frozen import frozen
from planes.words.names import latin

QUOTED, OFFERED = 60, 40  # letters of what is quoted of a file; letters of a name that is offered, and how many
LIKE = 0.65  # how like two words of other lengths are, of 1, one of which is a misspelling of the other
_SPELLED = "alpha beta gamma delta epsilon theta lambda mu rho tau phi psi omega"
_GREEK = dict(zip("αβγδεθλμρτφψω", _SPELLED.split(), strict=True))
_SYNONYMS = """
название=title заголовок=title примечание=note параметры=parameters варианты=variants стойка=frame
звенья=links звено=link сборка=assembly привод=drive ведущее=drive нагрузки=loads нагрузка=loads
силы=loads сила=force момент=moment трение=friction планы=plans масштаб=mu найти=find лист=sheet
векторы=vectors уравнения=equations точки=points точка=point направляющие=guides скользит=slides
масса=mass инерция=inertia центр=centre угол=angle направление=direction гравитация=gravity
forces=loads opposite=against opposing=against n=omega rpm=omega angular_velocity=omega
front=ahead forward=ahead forwards=ahead back=behind backward=behind backwards=behind rear=behind
"""
_MEANT = dict(pair.split("=") for pair in _SYNONYMS.split())
"""Keys and words of a scene by what people write for them whose spelling does not lead there."""
_ELSEWHERE = {"alpha": "epsilon", "theta": "phi", "w": "omega"}
"""Letters of this program by those of other books."""


def place_of(file: str, line: int | None) -> str:
    """The place that precedes a sentence; a scene built in Python, <Slider-crank>, has no line numbers."""
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
        """The phrase behind the sentence; None for plain text."""
        return self.phrase.parts if isinstance(self.phrase, Phrase) else {}


class UnknownName(PlanesError, KeyError):
    """There is no result of this name; the message lists the valid names."""

    __str__ = Exception.__str__  # KeyError would print the message in quotes


class SceneError(PlanesError, ValueError):
    """The scene file contains something that makes no sense."""

    def __init__(self, phrase: Told, file: str = "", line: int | None = None) -> None:
        self.place = place_of(file, line)
        self.file, self.line = file, line
        super().__init__(phrase.in_python() if file[:1] == "<" and isinstance(phrase, Phrase) else phrase)


@frozen
class Doubt:
    """A warning with its place: something in a scene that is possible but probably not meant."""

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
    """A vector equation that cannot be drawn: a broken chain, or a number of unknowns other than two."""


class ProgramError(PlanesError, ValueError):
    """A program whose steps do not fit together."""


class _Reasoned(PlanesError, ArithmeticError):
    """``reason`` is a key of the table of words, with names and ``numbers``."""

    def __init__(self, reason: str, **numbers: object) -> None:
        self.reason, self.numbers = reason, numbers
        super().__init__(Phrase(reason, **numbers))


class PlanFailure(_Reasoned):
    """A construction that cannot be drawn in this position."""


class Contradiction(_Reasoned):
    """A drawing that contradicts itself: the program is at fault, so no result is given."""


class ExpressionError(PlanesError, ValueError):
    """An expression that has no value; ``parameter`` names the parameter it belongs to, if it is one."""

    def __init__(self, phrase: Told, parameter: str = "") -> None:
        super().__init__(phrase)
        self.parameter = parameter


def _near(given: str, known: list[str]) -> Told:
    """Words that suggest a name that is nearly the same, or looks the same in other letters."""
    meant = _MEANT.get(given.casefold(), _spelled(given))
    letter, _, index = meant.partition("_")
    ways = (meant, f"{_ELSEWHERE.get(letter, letter)}_{index}")
    if same := next((name for way in ways for name in known if _spelled(name) == way), None):
        return Phrase(key if (key := f"meant_{given}") in table("en") else "near_name", name=same)
    if twin := next((name for name in known if latin(name) == latin(given)), None):
        return Phrase("near_alike", name=twin)
    alike = [name for name in known if len(name) == len(given)]
    known = [name for name in known if given in name or len(name) < 2 * len(given)]  # A5 does not mean A4x5
    matches = get_close_matches(given, known, n=1, cutoff=LIKE) or get_close_matches(given, alike, n=1, cutoff=0.5)
    return Phrase("near_name", name=matches[0]) if matches else ""


def near_file(path: str | Path) -> Told:
    """Words that suggest a file of nearly the same name in the same folder."""
    with suppress(OSError):
        return _near(Path(path).name[:OFFERED], [one.name for one in islice(Path(path).parent.iterdir(), 2000)])
    return ""


def nearest(given: str, names: Iterable[str]) -> str:
    """The known name closest in spelling to the given one; empty where none is close."""
    near = _near(given[:OFFERED], [*islice(names, 2000)])
    return str(near.parts["name"]) if isinstance(near, Phrase) else ""


def _spelled(name: str) -> str:
    """The name with Greek letters spelled: phi_1 for φ_1."""
    return "".join(_GREEK.get(letter, letter) for letter in name)


def shown(text: str) -> str:
    """A piece of the user's file as quoted in a sentence: on one line, cut when long."""
    short = text if len(text) <= QUOTED else text[: QUOTED - 1] + "…"
    return '"' + "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in short) + '"'


def choices(given: str, names: Iterable[str], what: str = "valid") -> Told:
    """Words that list the valid choices: "; valid: a, b; did you mean a?". Time and length are bounded whatever the
    list and its names. ``what`` is their key."""
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
    """Turn any library exception raised while a file is read or processed into the sentence ``key`` about the file."""
    try:
        yield
    except PlanesError:
        raise
    except Exception as error:  # on broken files libraries fail in every possible way
        why = str(error).partition("\n")[0][:80] or type(error).__name__
        raise PlanesError(Phrase(key, file=str(file), why=why)) from None
