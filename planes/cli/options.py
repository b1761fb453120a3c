"""Commands and options of the command line: those of ``commands.json`` and of packs; and the requested positions."""

import json
from argparse import Namespace
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from planes.scene import Scene
from planes.scene.mechanism import nothing
from planes.scene.packs import PACKS
from planes.scene.ranges import driver_coordinate_asked, read_range
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import field, frozen

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
    answers: Mapping[str, str] = field(default_factory=nothing)


def _read_commands() -> dict[str, Command]:
    """Every command by name, that of a pack after the one it names."""
    written = json.loads(Path(__file__).with_name("commands.json").read_text("utf-8"))
    commands: dict[str, Command] = {}
    for name, own in written.items():
        commands[name] = Command(**own)
        for pack in PACKS:
            if pack.command_after == name:
                commands |= {key: Command(**more) for key, more in pack.command.items()}
    return commands


COMMANDS = _read_commands()
SCENE_OPTIONS: Sequence[Option] = (("scene", "scene", {"metavar": "SCENE"}), ("--variant", "variant", {}))
POSITION_OPTIONS: Sequence[Option] = (
    ("--phi", "phi", {"metavar": "A[:B:STEP]"}),
    ("--s", "s", {"metavar": "A[:B:STEP]"}),
)
_FILE_COMPLETIONS = {"bash": "_shtab_compgen_files", "zsh": "_files", "tcsh": "f"}  # as shtab's FILE and DIRECTORY
_FOLDER_COMPLETIONS = {"bash": "_shtab_compgen_dirs", "zsh": "_files -/", "tcsh": "d"}
COMPLETIONS_BY_METAVAR = dict.fromkeys(("FILE", "SCENE", "DRAWING", "PLAN=FILE"), _FILE_COMPLETIONS) | dict.fromkeys(
    ("DIR", "FOLDER"), _FOLDER_COMPLETIONS
)
"""Completions of a shell for a word of the usage."""
FLAG_NAMES_BY_OPTION = {"others": "with"}


def check_options(args: Namespace, answer: str) -> None:
    """Refuse the first option that this answer of the command does not use."""
    answers = {name: heeded.split() for name, heeded in COMMANDS[args.command].answers.items()}
    for option in dict.fromkeys(option for heeded in answers.values() for option in heeded):
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
