"""The command line: its reader of options, in the language asked for, and the one way a command is run.

Bad input is one sentence and exit status 2.
"""

import argparse
import io
import re
import sys
from collections.abc import Sequence
from contextlib import suppress
from functools import cache
from importlib import import_module
from itertools import pairwise
from typing import Any, NoReturn

from planes.cli.options import EITHER, OF_SCENE, OPTIONS, POSITIONED, POSITIONS, Option
from planes.words import Lang, Phrase, home_lang, say, table
from planes.words.errors import PlanesError

APART = {"check": "check", "blank": "check", "cycle": "cycle"}
"""Commands with a module of their own; the others are together in ``commands``."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # a terminal without Cyrillic still gets the numbers
    argv = sys.argv[1:] if argv is None else argv
    lang = lang_of(argv)
    args = _parser(lang).parse_args(argv)
    try:
        module = import_module(f"planes.cli.{APART.get(args.command, 'commands')}")
        status = int(getattr(module, args.command.replace("-", "_"))(args))
        if sys.stdout:
            sys.stdout.flush()
        return status
    except PlanesError as error:
        refused: PlanesError = error
    except BrokenPipeError:
        return 0
    except OSError as error:
        file = error.filename or Phrase("standard_output")
        refused = PlanesError(Phrase("system_refuses", file=file, reason=error.strerror or str(error)))
    except KeyboardInterrupt:
        return 130
    with suppress(OSError):
        print(refused.told(lang), file=sys.stderr)
    return 2


def _parser(lang: Lang) -> argparse.ArgumentParser:
    def help_of(key: str) -> str:
        return say(f"help_{key}", lang)

    reader = Parser(prog="planes", description=help_of("planes"), lang=lang)
    reader.add_argument("--version", action="version", version=f"planes {sys.modules['planes'].__version__}")
    commands = reader.add_subparsers(required=True, metavar="COMMAND", parser_class=CommandParser)
    for name, own in OPTIONS.items():
        text = help_of(name.replace("-", "_"))
        parser = commands.add_parser(name, help=text, description=text, lang=lang)
        parser.set_defaults(command=name, refuse=parser.error)
        asked: Option = ("--lang", "lang", {"choices": ("ru", "en"), "default": None if name == "course" else lang})
        of_scene = (*OF_SCENE, asked, *(POSITIONS if name in POSITIONED else ()))
        options = (*own, asked) if name == "course" else (*of_scene, *own)
        one_of = parser.add_mutually_exclusive_group() if name in EITHER else parser
        for flags, key, how in options:
            holder = one_of if flags in EITHER.get(name, ()) else parser
            holder.add_argument(*flags.split(), help=help_of(key), **how)
    return reader


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
        """The line with the number an option has by itself, where the word after it is none; and a value that begins
        with a minus (``--phi -90:270:1``) held to its option, or it would be taken for one."""
        valued = {name for one in self._actions if one.nargs is None for name in one.option_strings}
        words: list[str] = []
        for word in args:
            if words and words[-1] in valued and re.match(r"-[.\d]", word):
                words[-1] += f"={word}"
            else:
                words.append(word)
        lone = {name: one for one in self._actions if one.nargs == "?" for name in one.option_strings}
        return [
            f"{word}={lone[word].const}" if word in lone and not after.lstrip("-").isdecimal() else word
            for word, after in pairwise([*words, ""])
        ]
