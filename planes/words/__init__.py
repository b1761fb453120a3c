"""The one table of words: every sentence and label meant for people, a folder a language, a file a room.

What the operating system says of a failure is told in Russian too; the language it speaks is the home language.
"""

import errno
import json
import locale
import os
import re
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from string import Formatter
from typing import Any, Literal

Lang = Literal["ru", "en"]
RUSSIAN = ("ru", "be", "uk", "kk")


@cache
def table(lang: Lang, file: str = "*") -> dict[str, str]:
    """Every sentence of a language by its key, or those of one file of its folder."""
    folder = Path(__file__).parent / lang
    return {k: v for one in sorted(folder.glob(f"{file}.json")) for k, v in json.loads(one.read_text("utf-8")).items()}


def under(prefix: str, lang: Lang, file: str = "*") -> dict[str, str]:
    """Sentences whose keys begin alike, by the rest of the key."""
    return {key.removeprefix(prefix): text for key, text in table(lang, file).items() if key.startswith(prefix)}


@cache
def _of_system() -> dict[str, str]:
    """The Russian of each sentence of the system; ``system.json`` has it by the name of the failure."""
    named = json.loads(Path(__file__).with_name("system.json").read_text("utf-8"))
    return {os.strerror(getattr(errno, name)): words for name, words in named.items() if hasattr(errno, name)}


def home_lang() -> Lang:
    """Russian where the system speaks Russian, Belarusian, Ukrainian or Kazakh; else English."""
    said = next((os.environ[k] for k in ("LC_ALL", "LC_MESSAGES", "LANG") if os.environ.get(k)), "")
    return "ru" if (said or locale.getlocale()[0] or "").lower().startswith(RUSSIAN) else "en"


class Phrase:
    """A sentence, or a part of one, not yet told in a language: a key of the table, its names and numbers.

    A part may be a phrase itself, or a tuple of them; a tuple is told with what stands after the colon of its
    place between its members: ``{offers: or }``. A Russian noun of two forms, "звено 2|звена 2", takes the
    second where its place is ``{what:of}``.
    """

    __slots__ = ("key", "parts")

    def __init__(self, key: str, /, **parts: object) -> None:
        self.key, self.parts = key, parts

    def told(self, lang: Lang = "en", form: str = "") -> str:
        """The words in a language."""
        forms = table(lang)[self.key].split("|")
        return _Teller(lang).vformat(forms[-1 if form else 0], (), self.parts)

    __str__ = told

    def __repr__(self) -> str:
        return f"Phrase({self.key!r}, {self.parts!r})"


class Written:
    """A printed number, or a quantity with its unit in both languages, told with the decimal sign of the language."""

    __slots__ = ("en", "ru")

    def __init__(self, en: str, ru: str | None = None) -> None:
        self.en, self.ru = en, decimal(en if ru is None else ru, "ru")

    def told(self, lang: Lang = "en", form: str = "") -> str:
        """The number in a language."""
        return self.ru if lang == "ru" else self.en

    __str__ = told


Told = Phrase | str
"""A phrase, or words that are the same in both languages: a name, a number, a key of the file."""


class _Teller(Formatter):
    index = re.compile(r"([_^])\{([^{}]*)\}")  # _{…} and ^{…} in a sentence are no places to fill

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
            return _of_system().get(value, value) if self.lang == "ru" else value
        return format(value, format_spec or (".4g" if isinstance(value, float) else ""))


def decimal(number: str, lang: Lang) -> str:
    """A printed number with the decimal sign of the language."""
    return number.replace(".", ",") if lang == "ru" else number


def say(key: str, lang: Lang = "en", **numbers: object) -> str:
    """The sentence ``key`` in a language, with its names and numbers filled in."""
    return Phrase(key, **numbers).told(lang)
