"""The options of ``planes check``, ``blank``, ``cycle`` and ``course`` on the command line."""

from __future__ import annotations

import argparse
from argparse import Namespace
from collections.abc import Callable, Iterable, Mapping

from planes.scene import Scene
from planes.scene.ranges import read_range
from planes.words import Phrase
from planes.words.errors import PlanesError


def add_check_options(parser: argparse.ArgumentParser, told: Callable[[str], str]) -> None:
    """What ``planes check`` takes beside the scene."""
    parser.add_argument("drawing", nargs="?", metavar="DRAWING", help=told("help_drawing"))
    parser.add_argument("--plan", required=True, metavar="PLAN", help=told("help_plan"))
    parser.add_argument("--mu", metavar="MU", help=told("help_mu"))
    parser.add_argument(
        "--with", dest="others", action="append", default=[], metavar="PLAN=FILE", help=told("help_with")
    )
    parser.add_argument("--pole", metavar="X,Y", help=told("help_pole"))
    parser.add_argument("--mark", action="append", default=[], metavar="NAME=X,Y", help=told("help_mark"))
    parser.add_argument("--format", choices=("A4", "A3", "A2", "A1"), help=told("help_picture_format"))
    parser.add_argument("--work", choices=("hand", "cad"), help=told("help_work"))
    parser.add_argument("--trace", action="store_true", help=told("help_trace"))
    parser.add_argument("-o", "--output", metavar="FILE", help=told("help_check_output"))
    parser.add_argument("--json", action="store_true", help=told("help_json"))


def add_blank_options(parser: argparse.ArgumentParser, told: Callable[[str], str]) -> None:
    """What ``planes blank`` takes beside the scene."""
    parser.add_argument("--plan", default="velocity", metavar="PLAN", help=told("help_plan"))
    parser.add_argument("--mu", metavar="MU", help=told("help_mu"))
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help=told("help_blank_output"))


def add_cycle_options(parser: argparse.ArgumentParser, told: Callable[[str], str]) -> None:
    """What ``planes cycle`` takes beside the scene and its positions."""
    parser.add_argument("-o", "--output", metavar="FILE", help=told("help_cycle_output"))
    parser.add_argument("--show", metavar="NAMES", help=told("help_cycle_show"))
    parser.add_argument("--hodograph", metavar="NAMES", help=told("help_hodograph"))
    parser.add_argument("--path", metavar="POINTS", help=told("help_path"))
    parser.add_argument("--listing", action="store_true", help=told("help_listing"))
    parser.add_argument("--graphical", metavar="N", type=int, nargs="?", const=12, help=told("help_graphical"))
    parser.add_argument("--pole", metavar="H", type=float, help=told("help_pole_distance"))
    parser.add_argument("--omega", metavar="ω", type=float, help=told("help_omega"))
    parser.add_argument("--epsilon", metavar="ε", type=float, help=told("help_epsilon"))
    parser.add_argument("--json", action="store_true", help=told("help_cycle_json"))
    parser.add_argument("--errors", action="store_true", help=told("help_cycle_errors"))
    parser.add_argument("--plain", action="store_true", help=told("help_slow"))


def add_course_options(parser: argparse.ArgumentParser, told: Callable[[str], str]) -> None:
    """What ``planes course`` takes."""
    parser.add_argument("folder", metavar="DIR", help=told("help_course_folder"))
    parser.add_argument("-o", "--output", metavar="FOLDER", help=told("help_course_output"))
    workers = parser.add_mutually_exclusive_group()
    workers.add_argument("--jobs", type=int, metavar="N", help=told("help_jobs"))
    workers.add_argument("--scheduler", metavar="ADDRESS", help=told("help_scheduler"))
    parser.add_argument("--lang", choices=("ru", "en"), help=told("help_lang"))


def add_solve_options(solve: argparse.ArgumentParser, help_of: Callable[[str], str]) -> None:
    """What ``planes solve`` also tells."""
    solve.add_argument("--json", action="store_true", help=help_of("help_json"))
    solve.add_argument("--pencil", action="store_true", help=help_of("help_pencil"))
    solve.add_argument("--seed", type=int, help=help_of("help_seed"))
    solve.add_argument("--explain", action="store_true", help=help_of("help_explain"))
    solve.add_argument("--errors", action="store_true", help=help_of("help_errors"))
    solve.add_argument("--remedy", action="store_true", help=help_of("help_remedy"))


def add_crank_slider_options(crank: argparse.ArgumentParser, help_of: Callable[[str], str]) -> None:
    """What ``planes crank-slider`` writes."""
    crank.add_argument("-o", "--output", metavar="FILE", help=help_of("help_report"))
    crank.add_argument("--json", action="store_true", help=help_of("help_object"))
    crank.add_argument("--sheet", metavar="FILE", help=help_of("help_force_sheet"))
    crank.add_argument("--phi", type=float, metavar="A", help=help_of("help_sheet_phi"))


TAKES: Mapping[str, Mapping[str, str]] = {
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
        "curves": "phi s show omega epsilon",
        "picture": "phi s show hodograph path omega epsilon",
        "graphical": "graphical pole omega json",
        "graphical_picture": "graphical pole omega",
    },
    "check": {
        "trace": "phi s mu trace",
        "numbers": "phi s mu others work json",
        "lines": "phi s mu others work json pole mark",
        "photograph": "phi s mu others work json pole mark format",
    },
}
"""Of each command its answers, with the options each of them heeds; the others are those of every answer."""

NEEDS = {"seed": "pencil", "pole": "graphical", "phi": "sheet"}
"""Options that change nothing without another one."""

FLAGS = {"others": "with"}


def check_options(args: Namespace, command: str, answer: str) -> None:
    """Refuse the first option given that this answer does not heed."""
    answers = {name: heeded.split() for name, heeded in TAKES[command].items()}
    for option in dict.fromkeys(option for heeded in answers.values() for option in heeded):
        if given(args, option) and option not in answers[answer]:
            places = tuple(Phrase(f"answer_{name}") for name, heeded in answers.items() if option in heeded)
            where = Phrase(f"answer_{answer}")
            raise PlanesError(Phrase("option_idle", option=FLAGS.get(option, option), where=where, places=places))


def check_needs(args: Namespace, options: Iterable[str]) -> None:
    """Refuse an option given without the one it belongs to."""
    for option in options:
        if given(args, option) and not given(args, NEEDS[option]):
            raise PlanesError(Phrase("option_needs", option=option, other=NEEDS[option]))


def given(args: Namespace, option: str) -> bool:
    """Whether an option was written."""
    return getattr(args, option, None) not in (None, False, [])


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
