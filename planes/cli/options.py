"""Commands and options of the command line: those of ``commands.json`` and of packs; and the requested positions."""

import json
from argparse import Namespace
from collections.abc import Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import Any

from planes.scene import Scene
from planes.scene.mechanism import nothing
from planes.scene.packs import PACKS
from planes.scene.ranges import driver_coordinate_asked, read_range
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import field, frozen
from planes.words.records import Json

Option = tuple[str, str, Mapping[str, Any]]
"""Its spelling, the key of its help, the arguments of its parser."""


@frozen
class Command:
    """A command: its ``options`` beside its scene, ``--variant``, ``--lang`` and, if it ``has_positions``, those of
    positions; the module of ``planes/cli`` it is in, or the module of a ``pack``.

    ``exclusive`` options exclude each other; those that ``needs`` names have no effect without another one. ``answers``
    are its kinds of answers with the options each of them uses; the others are common to all. A command that makes one
    document and ends is faster ``without_collector`` of reference cycles: that took a twentieth of a note or a sheet.
    """

    options: Sequence[Option]
    module: str = "commands"
    pack: str = ""
    has_scene: bool = True
    has_positions: bool = False
    without_collector: bool = False
    exclusive: Sequence[str] = ()
    needs: Mapping[str, str] = field(default_factory=nothing)
    answers: Mapping[str, Sequence[str]] = field(default_factory=nothing)


_WRITTEN: Json = json.loads(Path(__file__).with_name("commands.json").read_text("utf-8"))
SCENE_OPTIONS: Sequence[Option] = _WRITTEN["scene_options"]
POSITION_OPTIONS: Sequence[Option] = _WRITTEN["position_options"]
COMPLETIONS_BY_METAVAR: Json = _WRITTEN["completions"]
"""Completions of a shell for a word of the usage, as shtab's FILE and DIRECTORY."""
COMMANDS: dict[str, Command] = {}
"""Every command by name, that of a pack after the one it names."""
for _name, _own in _WRITTEN["commands"].items():
    COMMANDS[_name] = Command(**_own)
    for _pack in PACKS.values():
        if _pack.command_after == _name:
            COMMANDS |= {key: Command(**own) for key, own in _pack.command.items()}
FLAG_NAMES_BY_OPTION = {"others": "with"}


def check_options(args: Namespace, answer: str) -> None:
    """Refuse the first option that this answer of the command does not use."""
    answers = COMMANDS[args.command].answers
    for option in dict.fromkeys(chain(*answers.values())):
        if is_option_given(args, option) and option not in answers[answer]:
            places = tuple(Phrase(f"answer_{name}") for name, heeded in answers.items() if option in heeded)
            where = Phrase(f"answer_{answer}")
            raise PlanesError(
                Phrase("option_idle", option=FLAG_NAMES_BY_OPTION.get(option, option), where=where, places=places)
            )


def check_needed_options(args: Namespace) -> None:
    """Refuse an option given without the one it needs."""
    for option, other in COMMANDS[args.command].needs.items():
        if is_option_given(args, option) and not is_option_given(args, other):
            raise PlanesError(Phrase("option_needs", option=option, other=other))


def is_option_given(args: Namespace, option: str) -> bool:
    """Whether an option was given."""
    return getattr(args, option, None) not in (None, False, [])


def requested_drive_positions(args: Namespace, scene: Scene) -> list[float] | None:
    """The positions of the drive requested on the command line."""
    kind, text = requested_drive_range(args, scene)
    return None if text is None else read_range(text, f"--{kind}")


def requested_drive_range(args: Namespace, scene: Scene) -> tuple[str, str | None]:
    """The kind of the drive, and its values as they were written."""
    return scene.drive.kind if scene.drive else "", driver_coordinate_asked(scene, args.phi, args.s, "--")


def requested_drive_position(args: Namespace, scene: Scene) -> float | None:
    """The one position of the drive requested."""
    values = requested_drive_positions(args, scene)
    if values and len(values) > 1:
        raise PlanesError(Phrase("one_value", count=len(values)))
    return values[0] if values else None
