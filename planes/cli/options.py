"""Options of the command line: those of each command, those each of its answers uses, and the requested positions."""

from argparse import Namespace
from collections.abc import Mapping, Sequence
from typing import Any

from planes.scene import Scene
from planes.scene.packs import COMMANDS_OF_PACKS
from planes.scene.ranges import driver_coordinate_asked, read_range
from planes.words import Phrase
from planes.words.errors import PlanesError

Option = tuple[str, str, Mapping[str, Any]]
"""Its spelling, the key of its help, its parser."""

FLAG_ARGUMENTS = {"action": "store_true"}
FILE_ARGUMENTS = {"metavar": "FILE"}
OUTPUT_ARGUMENTS = {"metavar": "FILE", "required": True}
REAL_ARGUMENTS = {"type": float}
SCENE_OPTIONS: Sequence[Option] = (("scene", "scene", {"metavar": "SCENE"}), ("--variant", "variant", {}))
POSITION_OPTIONS: Sequence[Option] = (
    ("--phi", "phi", {"metavar": "A[:B:STEP]"}),
    ("--s", "s", {"metavar": "A[:B:STEP]"}),
)
COMMANDS_WITH_POSITIONS = ("solve", "sheet", "note", "questions", "cycle", "check", "blank", "equations")
"""Commands with options for positions."""
EXCLUSIVE_OPTIONS = {"sheet": ("--sheet", "--view"), "course": ("--jobs", "--scheduler")}
"""Options that exclude each other."""

COMMANDS_WITHOUT_SCENE = ("essay", "studio", "course", "new", "schema", "completion")
SHELLS = ("bash", "zsh", "tcsh")
_FILE_COMPLETIONS = {"bash": "_shtab_compgen_files", "zsh": "_files", "tcsh": "f"}  # as shtab's FILE and DIRECTORY
_FOLDER_COMPLETIONS = {"bash": "_shtab_compgen_dirs", "zsh": "_files -/", "tcsh": "d"}
COMPLETIONS_BY_METAVAR = dict.fromkeys(("FILE", "SCENE", "DRAWING", "PLAN=FILE"), _FILE_COMPLETIONS) | dict.fromkeys(
    ("DIR", "FOLDER"), _FOLDER_COMPLETIONS
)
"""Completions of a shell for a word of the usage."""

OPTIONS_BY_COMMAND: Mapping[str, Sequence[Option]] = {
    "solve": (
        ("--json", "json", FLAG_ARGUMENTS),
        ("--pencil", "pencil", FLAG_ARGUMENTS),
        ("--seed", "seed", {"type": int}),
        ("--explain", "explain", FLAG_ARGUMENTS),
        ("--errors", "errors", FLAG_ARGUMENTS),
        ("--remedy", "remedy", FLAG_ARGUMENTS),
    ),
    "structure": (("--json", "object", FLAG_ARGUMENTS),),
    "sheet": (
        ("-o --output", "output", OUTPUT_ARGUMENTS),
        ("--remedy", "remedy", FLAG_ARGUMENTS),
        ("--text", "dxf_text", {"choices": ("text", "pieces", "strokes")}),
        ("--sheet", "sheet_number", {"type": int, "choices": (1, 2)}),
        ("--view", "view", {"metavar": "NAME"}),
        ("--colour", "colour", FLAG_ARGUMENTS),
    ),
    "lesson": (("-o --output", "lesson_output", OUTPUT_ARGUMENTS), ("--centres", "centres", FLAG_ARGUMENTS)),
    "essay": (("-o --output", "essay_output", {"metavar": "FOLDER", "required": True}),),
    "note": (("-o --output", "note_output", OUTPUT_ARGUMENTS),),
    "questions": (("-o --output", "questions_output", FILE_ARGUMENTS),),
    "studio": (
        ("scene", "studio_scene", {"nargs": "?", "metavar": "SCENE"}),
        ("-o --output", "studio_output", {"metavar": "FOLDER"}),
        ("--pyodide", "pyodide", {"metavar": "FOLDER|ADDRESS"}),
        ("--scenes", "studio_scenes", {"action": "append", "default": [], "metavar": "FOLDER"}),
        ("--port", "port", {"type": int, "metavar": "N"}),
        ("--no-browser", "no_browser", FLAG_ARGUMENTS),
    ),
    "cycle": (
        ("-o --output", "cycle_output", FILE_ARGUMENTS),
        ("--show", "cycle_show", {"metavar": "NAMES"}),
        ("--hodograph", "hodograph", {"metavar": "NAMES"}),
        ("--path", "path", {"metavar": "POINTS"}),
        ("--film", "film", FLAG_ARGUMENTS),
        ("--listing", "listing", FLAG_ARGUMENTS),
        ("--graphical", "graphical", {"metavar": "N", "type": int, "nargs": "?", "const": 12}),
        ("--pole", "pole_distance", REAL_ARGUMENTS | {"metavar": "H"}),
        ("--omega", "omega", REAL_ARGUMENTS | {"metavar": "ω"}),
        ("--epsilon", "epsilon", REAL_ARGUMENTS | {"metavar": "ε"}),
        ("--json", "cycle_json", FLAG_ARGUMENTS),
        ("--errors", "cycle_errors", FLAG_ARGUMENTS),
        ("--plain", "slow", FLAG_ARGUMENTS),
    ),
    "chart": (
        ("-o --output", "chart_output", OUTPUT_ARGUMENTS),
        ("--table", "table", FILE_ARGUMENTS),
        ("--length", "chart_length", {"metavar": "NAME"}),
    ),
    **{name: command.options for name, command in COMMANDS_OF_PACKS.items()},
    "check": (  # its scene may be a course too
        ("drawing", "drawing", {"nargs": "?", "metavar": "DRAWING"}),
        ("--plan", "plan", {"metavar": "PLAN"}),
        ("--mu", "mu", {"metavar": "MU"}),
        ("--with", "with", {"dest": "others", "action": "append", "default": [], "metavar": "PLAN=FILE"}),
        ("--pole", "pole", {"metavar": "X,Y"}),
        ("--mark", "mark", {"action": "append", "default": [], "metavar": "NAME=X,Y"}),
        ("--format", "picture_format", {"choices": ("A4", "A3", "A2", "A1")}),
        ("--page", "page", {"type": int, "metavar": "N"}),
        ("--work", "work", {"choices": ("hand", "cad")}),
        ("--trace", "trace", FLAG_ARGUMENTS),
        ("-o --output", "check_output", FILE_ARGUMENTS),
        ("--json", "json", FLAG_ARGUMENTS),
    ),
    "blank": (
        ("--plan", "plan", {"metavar": "PLAN"}),
        ("--mu", "mu", {"metavar": "MU"}),
        ("-o --output", "blank_output", OUTPUT_ARGUMENTS),
    ),
    "equations": (("-o --output", "new_output", FILE_ARGUMENTS),),
    "course": (
        ("folder", "course_folder", {"metavar": "DIR"}),
        ("-o --output", "course_output", {"metavar": "FOLDER"}),
        ("--jobs", "jobs", {"type": int, "metavar": "N"}),
        ("--scheduler", "scheduler", {"metavar": "ADDRESS"}),
    ),
    "new": (("kind", "new_kind", {"nargs": "?", "metavar": "KIND"}), ("-o --output", "new_output", FILE_ARGUMENTS)),
    "schema": (
        ("kind", "schema_kind", {"choices": ("scene", "course", "table")}),
        ("-o --output", "schema_output", FILE_ARGUMENTS),
    ),
    "completion": (("shell", "completion_shell", {"choices": SHELLS}),),
}
"""The options of each command beside its scene, ``--variant`` and ``--lang``."""

OPTIONS_BY_ANSWER: Mapping[str, Mapping[str, str]] = {
    "solve": {
        "positions": "phi s json pencil seed errors remedy",
        "vectors": "json pencil seed errors",
        "steps": "explain",
        "folder": "json",
    },
    "sheet": {"positions": "phi s remedy text sheet view", "vectors": "text view"},
    "cycle": {
        "summary": "phi s show omega epsilon json",
        "listing": "phi s show omega epsilon json listing",
        "table": "phi s omega epsilon errors plain",
        "curves": "phi s show omega epsilon errors plain",
        "picture": "phi s show hodograph path omega epsilon",
        "film": "film omega epsilon",
        "graphical": "graphical pole omega json",
        "graphical_picture": "graphical pole omega",
    },
    "check": {
        "trace": "phi s mu trace",
        "numbers": "phi s mu others work json",
        "lines": "phi s mu others work json pole mark",
        "photograph": "phi s mu others work json pole mark format page",
    },
}
"""For each command its answers, with the options each of them uses; the others are common to all answers."""

OPTIONS_NEEDED_BY_OPTION = {"seed": "pencil", "pole": "graphical", "film": "output"}
"""Options without effect unless another one is given."""

FLAG_NAMES_BY_OPTION = {"others": "with"}


def check_options(args: Namespace, command: str, answer: str) -> None:
    """Refuse the first option that this answer does not use."""
    answers = {name: heeded.split() for name, heeded in OPTIONS_BY_ANSWER[command].items()}
    for option in dict.fromkeys(option for heeded in answers.values() for option in heeded):
        if is_option_given(args, option) and option not in answers[answer]:
            places = tuple(Phrase(f"answer_{name}") for name, heeded in answers.items() if option in heeded)
            where = Phrase(f"answer_{answer}")
            raise PlanesError(
                Phrase("option_idle", option=FLAG_NAMES_BY_OPTION.get(option, option), where=where, places=places)
            )


def check_needed_options(args: Namespace, needs: Mapping[str, str] = OPTIONS_NEEDED_BY_OPTION) -> None:
    """Refuse an option given without the one it needs."""
    for option, other in needs.items():
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
