"""The home language of the command line: what its own reader of options says, in Russian or in English."""

from __future__ import annotations

import argparse
from typing import NoReturn

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
