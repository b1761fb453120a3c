"""Options that would change nothing in the answer asked for are refused, with the answers they are for."""

from __future__ import annotations

from argparse import Namespace
from collections.abc import Iterable, Mapping

from planes.words import Phrase
from planes.words.errors import PlanesError

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
