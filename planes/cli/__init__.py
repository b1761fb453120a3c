"""The command line: its option parser, in the user's language, and the single way to run a command.

Bad input gives one sentence and exit status 2.
"""

import argparse
import gc
import io
import math
import os
import re
import sys
from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager, suppress
from difflib import get_close_matches
from functools import partial
from gettext import NullTranslations
from importlib import import_module
from itertools import pairwise
from typing import Any, NoReturn

from planes.cli.options import COMMANDS, COMPLETIONS_BY_METAVAR, POSITION_OPTIONS, SCENE_OPTIONS, Option
from planes.words import Lang, Phrase, available_languages, home_lang, say, sentence_table, sentences_with_prefix
from planes.words.errors import PlanesError
from planes.words.formats import DRAWING_SUFFIXES, SUFFIXES_WITH_PICTURE

MISSPELLING_LIKENESS = 0.8  # how like two words are, of 1, one of which is a misspelling of the other


def main(argv: Sequence[str] | None = None) -> int:
    """Run one command; returns the exit status."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # on a terminal without Cyrillic the numbers still print
    argv = sys.argv[1:] if argv is None else argv
    lang = requested_lang(argv)
    with option_parser_in_language(lang):
        args = command_line_parser(lang, argv).parse_args(with_command_first(argv))
        try:
            return _run_command(args)
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


def _run_command(args: argparse.Namespace) -> int:
    """Run the command; during long work a user at a terminal sees progress."""
    from planes.words.waiting import waiting_clock

    command = COMMANDS[args.command]
    module = import_module(f"planes.cli.{command.module}")
    if not command.without_collector:
        gc.enable()  # the program begins with the collector off
    with waiting_clock():
        status = int(getattr(module, "command_of_pack" if command.pack else args.command)(args))
    if sys.stdout:
        sys.stdout.flush()
    if args.lang and (borrowed := sentence_table(args.lang).borrowed):
        other = sentence_table(sentence_table(args.lang).other)["language_name"]
        print(say("words_borrowed", args.lang, of=args.lang, count=len(borrowed), other=other), file=sys.stderr)
    _report_written_file(args)
    return status


def _report_written_file(args: argparse.Namespace) -> None:
    """Which file was written, and how large it is, a sheet with its format; then what must be known of it."""
    output = getattr(args, "output", None)
    lang = args.lang or home_lang()
    if output and sys.stderr and os.path.isfile(output):
        words = {"file": output, "size": math.ceil(os.path.getsize(output) / 1000), "made": getattr(args, "made", "")}
        remarks = (say("note_warning", lang, text=text) for text in getattr(args, "remarks", ()))
        print(say("file_written", lang, **words), *remarks, sep="\n", file=sys.stderr)


def command_line_parser(lang: Lang, named: Collection[str] = COMMANDS) -> argparse.ArgumentParser:
    """The parser of the command line; commands not ``named`` on it are added without their options."""

    def help_of(key: str) -> str:
        return say(f"help_{key}", lang, drawings=DRAWING_SUFFIXES, pictures=SUFFIXES_WITH_PICTURE)

    reader = Parser(prog="planes", description=help_of("planes"), lang=lang)
    version = f"planes {sys.modules['planes'].__version__}"
    reader.add_argument("--version", action="version", version=version, help=say("usage_version", lang))
    reader.add_argument(
        "--lang", choices=available_languages(), metavar="LANG", help=help_of("lang")
    )  # `lang_of` has read it
    commands = reader.add_subparsers(required=True, metavar="COMMAND", parser_class=CommandParser)
    for name, command in COMMANDS.items():
        text = help_of(name.replace("-", "_"))
        parser = commands.add_parser(name, help=text, description=text, lang=lang)
        parser.set_defaults(command=name, refuse=parser.error)
        asked: Option = (
            "--lang",
            "lang",
            {"choices": available_languages(), "default": None if name == "course" else lang},
        )
        of_scene = (*SCENE_OPTIONS, asked, *(POSITION_OPTIONS if command.has_positions else ()))
        options = (*of_scene, *command.options) if command.has_scene else (*command.options, asked)
        one_of = parser.add_mutually_exclusive_group() if command.exclusive else parser
        for flags, key, how in options if name in named else ():
            holder = one_of if flags in command.exclusive else parser
            action = holder.add_argument(*flags.split(), help=help_of(key), **how)
            if action.metavar in COMPLETIONS_BY_METAVAR:
                action.complete = COMPLETIONS_BY_METAVAR[action.metavar]  # type: ignore[attr-defined]  # shtab asks for it
    return reader


def requested_lang(argv: Sequence[str]) -> Lang:
    """The language option, anywhere among the arguments; otherwise the home language."""
    known = "|".join(available_languages())
    said: list[Lang] = re.findall(rf"(?<=\0)--lang?(?:=|\0)({known})(?=\0)", "\0".join(("", *argv, "")))
    return said[-1] if said else home_lang()


def with_command_first(argv: Sequence[str]) -> Sequence[str]:
    """The line with its command moved before any options written ahead of it."""
    at = next((k for k, word in enumerate(argv) if word in COMMANDS), 0)
    ahead = argv[:at] if argv and argv[0].startswith("--") else ()
    return [argv[at], *ahead, *argv[at + 1 :]] if ahead else argv


class UsageWords(NullTranslations):
    """The messages of the option parser in a language: its English ones are replaced by those of the table."""

    def __init__(self, lang: Lang) -> None:
        super().__init__()
        own = sentences_with_prefix("usage_", lang, "usage")
        self.known = {text: own[key] for key, text in sentences_with_prefix("usage_", "en", "usage").items()}

    def gettext(self, message: str) -> str:
        """The message, in gettext's role."""
        return self.known.get(message, message)


@contextmanager
def option_parser_in_language(lang: Lang) -> Iterator[None]:
    """The option parser in a language: it calls gettext under the name ``_``."""
    own = vars(argparse)["_"]
    vars(argparse)["_"] = UsageWords(lang).gettext
    try:
        yield
    finally:
        vars(argparse)["_"] = own


class Parser(argparse.ArgumentParser):
    """A command line parser with number errors in a language."""

    def __init__(self, *args: Any, lang: Lang = "en", **more: Any) -> None:
        self.lang = lang
        super().__init__(*args, **more)
        for kind, key in ((int, "whole_needed"), (float, "number_needed_here")):
            for name in (kind, kind.__name__):  # commands.json has the name
                self.register("type", name, partial(self._parse_number, kind, key))

    def _parse_number(self, kind: type[float], key: str, text: str) -> float:
        try:
            return kind(text)
        except ValueError:
            raise argparse.ArgumentTypeError(say(key, self.lang, value=repr(text))) from None

    def error(self, message: str) -> NoReturn:
        """The sentence, and the option or choice of nearly the same spelling, if a word of it is unknown."""
        word = (re.findall(r"(?<=')[\w-]+(?=')|--[\w-]+", message) or [""])[0]
        every = (SCENE_OPTIONS, POSITION_OPTIONS, *(command.options for command in COMMANDS.values()))
        options = " ".join(flags for own in every for flags, *_ in own)
        if word and word not in options.split():
            names = re.findall(r"[\w-]+", message.partition(word)[2] + options)
            for near in get_close_matches(word, names, 1, MISSPELLING_LIKENESS):
                message += say("near_name", self.lang, name=near)
        super().error(message)


class CommandParser(Parser):
    """The parser of one command, whose options may be anywhere between its files."""

    _mixing = False

    def parse_known_args(self, args: Sequence[str] | None = None, namespace: Any = None) -> Any:  # type: ignore[override]
        """Options are removed first, then the rest is read in order; after ``--`` there are only files."""
        line = self._with_default_numbers(args or ())
        if self._mixing or "--" in line:
            return super().parse_known_args(line, namespace)
        self.usage = self.format_usage().removeprefix(say("usage_line", self.lang))  # before it is split
        self._mixing = True
        try:
            return self.parse_known_intermixed_args(line, namespace)
        finally:
            self._mixing = False

    def _with_default_numbers(self, args: Sequence[str]) -> list[str]:
        """The line with the default number after an option without one; and a value that begins with a minus (``--phi
        -90:270:1``) attached to its option, otherwise it would be taken for an option."""
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
