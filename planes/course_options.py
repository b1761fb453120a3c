"""The options of ``planes course`` on the command line."""

from __future__ import annotations

import argparse
from collections.abc import Callable


def add_course_options(parser: argparse.ArgumentParser, told: Callable[[str], str]) -> None:
    """What ``planes course`` takes."""
    parser.add_argument("folder", metavar="DIR", help=told("help_course_folder"))
    parser.add_argument("-o", "--output", metavar="FOLDER", help=told("help_course_output"))
    parser.add_argument("--jobs", type=int, metavar="N", help=told("help_jobs"))
    parser.add_argument("--scheduler", metavar="ADDRESS", help=told("help_scheduler"))
    parser.add_argument("--lang", choices=("ru", "en"), help=told("help_lang"))
