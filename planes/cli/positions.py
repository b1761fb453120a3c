"""Which values of the drive are asked for on the command line."""

from __future__ import annotations

import argparse
from collections.abc import Callable

from planes.scene import Scene
from planes.scene.ranges import read_range
from planes.words import Phrase
from planes.words.errors import PlanesError


def add_positions(parser: argparse.ArgumentParser, told: Callable[[str], str]) -> None:
    """The options that name positions."""
    parser.add_argument("--phi", metavar="A[:B:STEP]", help=told("help_phi"))
    parser.add_argument("--s", metavar="A[:B:STEP]", help=told("help_s"))


def values_of(args: argparse.Namespace, scene: Scene) -> list[float] | None:
    """The values of the drive asked for on the command line."""
    kind, text = range_of(args, scene)
    return None if text is None else read_range(text, f"--{kind}")


def range_of(args: argparse.Namespace, scene: Scene) -> tuple[str, str | None]:
    """The kind of the drive, and its values as they were written."""
    kind = scene.mechanism.drive.kind if scene.mechanism else None
    asked = {"phi": args.phi, "s": args.s}
    for option, text in asked.items():
        if text is not None and option != kind:
            why = Phrase("driver_by", kind=kind) if kind else Phrase("no_driver")
            raise PlanesError(Phrase("option_misfit", option=option, file=scene.file, why=why))
    return kind or "", asked.get(kind or "")


def value_of(args: argparse.Namespace, scene: Scene) -> float | None:
    """The one value of the drive asked for."""
    values = values_of(args, scene)
    if values and len(values) > 1:
        raise PlanesError(Phrase("one_value", count=len(values)))
    return values[0] if values else None
