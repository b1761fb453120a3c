"""The command line: ``planes solve · structure · sheet``. Bad input is one sentence and exit status 2."""

from __future__ import annotations

import argparse
import io
import sys
from collections.abc import Sequence
from contextlib import suppress
from importlib import import_module

from planes.cli.options import EITHER, OF_SCENE, OPTIONS, POSITIONED, POSITIONS, Option
from planes.cli.parser import CommandParser, Parser, lang_of
from planes.words import Lang, Phrase, say
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
        parser.set_defaults(command=name)
        asked: Option = ("--lang", "lang", {"choices": ("ru", "en"), "default": None if name == "course" else lang})
        of_scene = (*OF_SCENE, asked, *(POSITIONS if name in POSITIONED else ()))
        options = (*own, asked) if name == "course" else (*of_scene, *own)
        one_of = parser.add_mutually_exclusive_group() if name in EITHER else parser
        for flags, key, how in options:
            holder = one_of if flags in EITHER.get(name, ()) else parser
            holder.add_argument(*flags.split(), help=help_of(key), **how)
    return reader
