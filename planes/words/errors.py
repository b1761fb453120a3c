"""All error classes, and how a message lists the valid choices. The texts are in the table of words."""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from difflib import get_close_matches
from itertools import islice
from pathlib import Path
from typing import Any

from planes.words import Lang, Phrase, Told, sentence_table
from planes.words.frozen import frozen
from planes.words.names import with_latin_letters

# letters of what is quoted of a file; letters of a name that is offered, and how many
MOST_QUOTED_LETTERS = 60
MOST_OFFERED_NAMES = 40
# how like two words of other lengths are, of 1, one of which is a misspelling of the other
LEAST_SPELLING_SIMILARITY = 0.65
_GREEK_LETTER_NAMES = "alpha beta gamma delta epsilon theta lambda mu rho tau phi psi omega"
_GREEK_SPELLINGS = dict(zip("αβγδεθλμρτφψω", _GREEK_LETTER_NAMES.split(), strict=True))
_SYNONYM_PAIRS = """
название=title заголовок=title примечание=note параметры=parameters варианты=variants стойка=frame
звенья=links звено=link сборка=assembly привод=drive ведущее=drive нагрузки=loads нагрузка=loads
силы=loads сила=force момент=moment трение=friction планы=plans масштаб=mu найти=find лист=sheet
векторы=vectors уравнения=equations точки=points точка=point направляющие=guides скользит=slides
масса=mass инерция=inertia центр=centre угол=angle направление=direction гравитация=gravity
forces=loads opposite=against opposing=against n=omega rpm=omega angular_velocity=omega
front=ahead forward=ahead forwards=ahead back=behind backward=behind backwards=behind rear=behind
"""
_KEY_BY_SYNONYM = dict(pair.split("=") for pair in _SYNONYM_PAIRS.split())
"""Keys and words of a scene by what people write for them whose spelling does not lead there."""
_LETTERS_OF_OTHER_BOOKS = {"alpha": "epsilon", "theta": "phi", "w": "omega"}
"""Letters of this program by those of other books."""


def error_place_prefix(file: str, line: int | None) -> str:
    """The place that precedes a sentence; a scene built in Python, <Slider-crank>, has no line numbers."""
    if line and file[:1] != "<":
        return f"{file}:{line}: "
    if file:
        return f"{file}: "
    return ""


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
    def phrase_parts(self) -> dict[str, Any]:
        """The phrase behind the sentence; None for plain text."""
        return self.phrase.parts if isinstance(self.phrase, Phrase) else {}


class UnknownName(PlanesError, KeyError):
    """There is no result of this name; the message lists the valid names."""

    __str__ = Exception.__str__  # KeyError would print the message in quotes


class SceneError(PlanesError, ValueError):
    """The scene file contains something that makes no sense."""

    def __init__(self, phrase: Told, file: str = "", line: int | None = None) -> None:
        self.place = error_place_prefix(file, line)
        self.file = file
        self.line = line
        super().__init__(phrase.for_python_scene() if file[:1] == "<" and isinstance(phrase, Phrase) else phrase)


@frozen
class Doubt:
    """A warning with its place: something in a scene that is possible but probably not meant."""

    phrase: Phrase
    file: str
    line: int

    def told(self, lang: Lang = "en") -> str:
        """The place and the sentence in a language."""
        phrase = self.phrase.for_python_scene() if self.file[:1] == "<" else self.phrase
        return f"{error_place_prefix(self.file, self.line)}{phrase.told(lang)}"


class StructureError(SceneError):
    """The links and pairs do not make a mechanism this method can draw."""


class EquationError(PlanesError, ValueError):
    """A vector equation that cannot be drawn: a broken chain, or a number of unknowns other than two."""


class ProgramError(PlanesError, ValueError):
    """A program whose steps do not fit together."""


class _Reasoned(PlanesError, ArithmeticError):
    """``reason`` is a key of the table of words, with names and ``numbers``."""

    def __init__(self, reason: str, **numbers: object) -> None:
        self.reason = reason
        self.numbers = numbers
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


def _suggest_name(given: str, known: list[str]) -> Told:
    """Words that suggest a name that is nearly the same, or looks the same in other letters."""
    meant = _KEY_BY_SYNONYM.get(given.casefold(), _spell_greek_letters(given))
    letter, _, index = meant.partition("_")
    ways = (meant, f"{_LETTERS_OF_OTHER_BOOKS.get(letter, letter)}_{index}")
    if same := next((name for way in ways for name in known if _spell_greek_letters(name) == way), None):
        return Phrase(key if (key := f"meant_{given}") in sentence_table("en") else "near_name", name=same)
    if twin := next((name for name in known if with_latin_letters(name) == with_latin_letters(given)), None):
        return Phrase("near_alike", name=twin)
    alike = [name for name in known if len(name) == len(given)]
    known = [name for name in known if given in name or len(name) < 2 * len(given)]  # A5 does not mean A4x5
    matches = get_close_matches(given, known, n=1, cutoff=LEAST_SPELLING_SIMILARITY) or get_close_matches(
        given, alike, n=1, cutoff=0.5
    )
    return Phrase("near_name", name=matches[0]) if matches else ""


def suggest_file(path: str | Path) -> Told:
    """Words that suggest a file of nearly the same name in the same folder."""
    with suppress(OSError):
        return _suggest_name(
            Path(path).name[:MOST_OFFERED_NAMES], [one.name for one in islice(Path(path).parent.iterdir(), 2000)]
        )
    return ""


def closest_name(given: str, names: Iterable[str]) -> str:
    """The known name closest in spelling to the given one; empty where none is close."""
    near = _suggest_name(given[:MOST_OFFERED_NAMES], [*islice(names, 2000)])
    return str(near.parts["name"]) if isinstance(near, Phrase) else ""


def _spell_greek_letters(name: str) -> str:
    """The name with Greek letters spelled: phi_1 for φ_1."""
    return "".join(_GREEK_SPELLINGS.get(letter, letter) for letter in name)


def quoted_excerpt(text: str) -> str:
    """A piece of the user's file as quoted in a sentence: on one line, cut when long."""
    short = text if len(text) <= MOST_QUOTED_LETTERS else text[: MOST_QUOTED_LETTERS - 1] + "…"
    return '"' + "".join(c if c.isprintable() else f"\\u{ord(c):04x}" for c in short) + '"'


def list_valid_choices(given: str, names: Iterable[str], what: str = "valid") -> Told:
    """Words that list the valid choices: "; valid: a, b; did you mean a?". Time and length are bounded whatever the
    list and its names. ``what`` is their key."""
    known = [name for name in islice(names, 2000) if len(name) <= MOST_OFFERED_NAMES]
    given = given[:MOST_OFFERED_NAMES]
    if not known:
        return ""
    near = _suggest_name(given, known)
    if len(known) <= MOST_OFFERED_NAMES:
        return Phrase(what, names=tuple(known), near=near)
    meant = [near.parts["name"]] if isinstance(near, Phrase) else []
    some = tuple(dict.fromkeys((*meant, *get_close_matches(given, known, 12), *known)))[:12]
    return Phrase("valid_some", names=some, near=near)


@contextmanager
def reporting_library_errors(key: str, file: str | Path) -> Iterator[None]:
    """Turn any library exception raised while a file is read or processed into the sentence ``key`` about the file."""
    try:
        yield
    except PlanesError:
        raise
    except Exception as error:  # on broken files libraries fail in every possible way
        why = str(error).partition("\n")[0][:80] or type(error).__name__
        raise PlanesError(Phrase(key, file=str(file), why=why)) from None
