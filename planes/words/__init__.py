"""The one table of words: every sentence and label meant for people, a folder per language and a file per room.

A language is nothing but a folder: its ``language.json`` holds its name, its decimal sign and the fallback language for
missing words. The system's own error messages are translated too.
"""

import errno
import json
import locale
import os
import re
from collections.abc import Callable, Iterable, Mapping
from functools import cache
from pathlib import Path
from string import Formatter
from typing import Any

Lang = str
"""A language: the name of its folder."""


class Sentences(dict[str, str]):
    """The sentences of a language by key; missing ones come from the fallback language and are counted."""

    def __init__(self, own: dict[str, str], other: Lang) -> None:
        super().__init__(own)
        self.other = other
        self.borrowed = set[str]()

    def __missing__(self, key: str) -> str:
        if not self.other:
            raise KeyError(key)
        self.borrowed.add(key)
        return sentence_table(self.other)[key]


@cache
def _load_sentences(lang: Lang, file: str) -> dict[str, str]:
    files = sorted((Path(__file__).parent / lang).glob(f"{file}.json"))
    return {key: text for one in files for key, text in json.loads(one.read_text("utf-8")).items()}


@cache
def sentence_table(lang: Lang, file: str = "*") -> Sentences:
    """Every sentence of a language by its key, or those of one file of its folder."""
    return Sentences(_load_sentences(lang, file), _load_sentences(lang, "language")["language_stand_in"])


def sentences_with_prefix(prefix: str, lang: Lang, file: str = "*") -> dict[str, str]:
    """The sentences whose keys share a prefix, by the rest of the key."""
    sentences: dict[str, str] = {}
    for one in reversed(fallback_languages(lang)):
        sentences |= {
            key.removeprefix(prefix): text for key, text in sentence_table(one, file).items() if key.startswith(prefix)
        }
    return sentences


def text_in(lang: Lang, texts: Mapping[Lang, str]) -> str:
    """A text in the language asked for; where it is missing, in the first language that has it."""
    return texts.get(lang) or next(iter(texts.values()), "")


def fallback_languages(lang: Lang) -> tuple[Lang, ...]:
    """The language itself, then its fallback languages in order."""
    other = sentence_table(lang, "language").other
    return (lang, *fallback_languages(other)) if other else (lang,)


@cache
def available_languages(file: str = "language") -> tuple[Lang, ...]:
    """The languages that have a file of words; those without a fallback come first."""
    names = [one.parent.name for one in Path(__file__).parent.glob(f"*/{file}.json")]
    return tuple(sorted(names, key=lambda lang: (len(fallback_languages(lang)), lang == "en", lang)))


@cache
def _system_error_messages(lang: Lang) -> dict[str, str]:
    """Each system error message in a language."""
    sentences = sentences_with_prefix("system_", lang, "system")
    return {os.strerror(getattr(errno, name)): words for name, words in sentences.items() if hasattr(errno, name)}


def home_lang() -> Lang:
    """The language of the system, or one that its speakers read; otherwise English."""
    said = next((os.environ[k] for k in ("LC_ALL", "LC_MESSAGES", "LANG") if os.environ.get(k)), "")
    home = (said or locale.getlocale()[0] or "").lower()
    own = [one for one in available_languages() if home.startswith(one)]
    read = [
        one
        for one in available_languages()
        if home.startswith(tuple(sentence_table(one, "language")["language_homes"].split()))
    ]
    return next(iter(own + read), "en")


class Phrase:
    """A sentence, or a part of one, not yet put into a language: a key of the table with its names and numbers.

    A part may itself be a phrase or a tuple of phrases. The members of a tuple are joined by the text after the colon
    of its placeholder: ``{offers: or }``. A Russian noun with two forms, "звено 2|звена 2", takes the second where its
    placeholder is ``{what:of}``.
    """

    __slots__ = ("key", "parts")

    def __init__(self, key: str, /, **parts: object) -> None:
        self.key = key
        self.parts = parts

    def told(self, lang: Lang = "en", form: str = "") -> str:
        """The text in a language."""
        forms = sentence_table(lang)[self.key].split("|")
        return _Teller(lang).vformat(forms[-1 if form else 0], (), self.parts)

    __str__ = told

    def for_python_scene(self) -> "Phrase":
        """The same sentence for a scene built in Python: a call instead of lines of a file."""
        key = f"{self.key}_in_python"
        return Phrase(
            key if key in sentence_table("en") else self.key,
            **{name: _for_python_scene(p) for name, p in self.parts.items()},
        )

    def __repr__(self) -> str:
        return f"Phrase({self.key!r}, {self.parts!r})"


def _for_python_scene(part: object) -> object:
    if isinstance(part, tuple):
        return tuple(map(_for_python_scene, part))
    return part.for_python_scene() if isinstance(part, Phrase) else part


class Written:
    """A printed number, or a quantity with its unit in each language, written with the decimal sign of the language."""

    __slots__ = ("text",)

    def __init__(self, text: str | Callable[[Lang], str]) -> None:
        self.text = text

    def told(self, lang: Lang = "en", form: str = "") -> str:
        """The number as written in a language."""
        return with_decimal_sign(self.text if isinstance(self.text, str) else self.text(lang), lang)

    __str__ = told


Told = Phrase | str
"""A phrase, or words that are the same in every language: a name, a number, a key of the file."""


class _Teller(Formatter):
    index = re.compile(r"([_^])\{([^{}]*)\}")  # _{…} and ^{…} in a sentence are not placeholders

    def __init__(self, lang: Lang) -> None:
        self.lang = lang

    def parse(self, format_string: Any) -> Iterable[Any]:
        return super().parse(self.index.sub(r"\1{{\2}}", format_string))

    def format_field(self, value: object, format_spec: str) -> str:
        if isinstance(value, Phrase | Written):
            return value.told(self.lang, format_spec)
        if isinstance(value, tuple):
            return (format_spec or ", ").join(self.format_field(v, "") for v in value)
        if isinstance(value, str):
            return _system_error_messages(self.lang).get(value, value)
        number = format(value, format_spec or (".4g" if isinstance(value, float) else ""))
        if isinstance(value, float):
            return with_decimal_sign(number, self.lang)
        return number


def with_decimal_sign(number: str, lang: Lang) -> str:
    """A printed number with the decimal sign of the language."""
    return number.replace(".", sentence_table(lang)["decimal_sign"])


def put_decimal_signs(text: str, lang: Lang) -> str:
    """Put that decimal sign into every number of a text for people: a table or a line of results."""
    return re.sub(r"(?<=\d)\.(?=\d)", sentence_table(lang)["decimal_sign"], text)


def say(key: str, lang: Lang = "en", **numbers: object) -> str:
    """The sentence ``key`` in a language, with its names and numbers filled in."""
    return Phrase(key, **numbers).told(lang)


def join_sentences(texts: Iterable[str]) -> str:
    """Texts one after another, with a full stop after each but the last unless it has its own."""
    *before, last = [text for text in texts if text] or [""]
    return " ".join([*(text if text[-1] in ".!?" else f"{text}." for text in before), last])


def capitalize_first_letter(text: str) -> str:
    """A text with the capital letter of a sentence or a title."""
    return text[:1].upper() + text[1:]
