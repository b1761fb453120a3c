"""What the command line's own reader of options says, in the language asked for or that of the system."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from functools import cache
from itertools import pairwise
from typing import Any, NoReturn

from planes.words import Lang, say, table
from planes.words.system import home_lang

HEADS = ("usage_line", "usage_given", "usage_options", "usage_help", "usage_version")


def lang_of(argv: Sequence[str]) -> Lang:
    """The language asked for, wherever it stands among the arguments; else the home language."""
    said: list[Lang] = re.findall(r"(?<=\0)--lang?(?:=|\0)(ru|en)(?=\0)", "\0".join(("", *argv, "")))
    return said[-1] if said else home_lang()


@cache
def _refusals() -> dict[str, re.Pattern[str]]:
    """What the reader refuses with, by the key of its words."""
    english = {key: re.escape(text) for key, text in table("en", "usage").items() if key not in HEADS}
    return {key: re.compile(re.sub(r"\\{(\w+)\\}", r"(?P<\1>.*?)", text), re.DOTALL) for key, text in english.items()}


def refusal(text: str, lang: Lang) -> str:
    """What the reader of options refuses with, in a language."""
    for key, pattern in _refusals().items():
        if match := pattern.fullmatch(text):
            return say(key, lang, **{name: refusal(part, lang) for name, part in match.groupdict().items()})
    return text


class Parser(argparse.ArgumentParser):
    """A reader of the command line that speaks a language."""

    def __init__(self, *args: Any, lang: Lang = "en", **more: Any) -> None:
        self.lang = lang
        super().__init__(*args, **more)

    def headed(self, text: str) -> str:
        """The help or the usage with its heads in the language."""
        for key in HEADS:
            text = text.replace(say(key), say(key, self.lang))
        return text

    def format_help(self) -> str:
        """The help, translated."""
        return self.headed(super().format_help())

    def format_usage(self) -> str:
        """The usage line, translated."""
        return self.headed(super().format_usage())

    def error(self, message: str) -> NoReturn:
        """Usage and what is wrong, and the end."""
        self.exit(2, f"{self.format_usage()}{self.prog}: {refusal(f'error: {message}', self.lang)}\n")


class CommandParser(Parser):
    """The reader of one command, whose options stand anywhere between its files."""

    _mixing = False

    def parse_known_args(self, args: Sequence[str] | None = None, namespace: Any = None) -> Any:  # type: ignore[override]
        """Options are taken out first, then what is left is read in order; after ``--`` there are files alone."""
        line = self._ended(args or ())
        if self._mixing or "--" in line:
            return super().parse_known_args(line, namespace)
        self.usage = argparse.ArgumentParser.format_usage(self).removeprefix("usage: ")  # before it is read in two
        self._mixing = True
        try:
            return self.parse_known_intermixed_args(line, namespace)
        finally:
            self._mixing = False

    def _ended(self, args: Sequence[str]) -> list[str]:
        """The line with the number an option has by itself, where the word after it is none."""
        lone = {name: one for one in self._actions if one.nargs == "?" for name in one.option_strings}
        return [
            f"{word}={lone[word].const}" if word in lone and not _is_whole(after) else word
            for word, after in pairwise([*args, ""])
        ]


def _is_whole(word: str) -> bool:
    return word.lstrip("-").isdecimal()
