"""The home language of the command line: what its own reader of options says, in Russian or in English."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from itertools import pairwise
from typing import Any, NoReturn

from planes.words import say, table
from planes.words.options import home_lang


def at_home(text: str) -> str:
    """A text of the reader of options, its own words replaced piece by piece."""
    lang = home_lang()
    for key in table("en", "usage") if lang != "en" else ():
        text = text.replace(say(key), say(key, lang))
    return text


def help_of(key: str) -> str:
    """A help text in the home language."""
    return say(key, home_lang())


class Parser(argparse.ArgumentParser):
    """A reader of the command line that speaks the home language."""

    def format_help(self) -> str:
        """The help, translated."""
        return at_home(super().format_help())

    def format_usage(self) -> str:
        """The usage line, translated."""
        return at_home(super().format_usage())

    def error(self, message: str) -> NoReturn:
        """Usage and what is wrong, and the end."""
        self.exit(2, self.format_usage() + at_home(f"{self.prog}: error: {message}\n"))


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
