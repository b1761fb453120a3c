"""The options of ``planes check`` on the command line."""

from __future__ import annotations

import argparse
from collections.abc import Callable


def add_options(parser: argparse.ArgumentParser, told: Callable[[str], str]) -> None:
    """What ``planes check`` takes beside the scene."""
    parser.add_argument("drawing", nargs="?", metavar="DRAWING", help=told("help_drawing"))
    parser.add_argument("--plan", required=True, metavar="PLAN", help=told("help_plan"))
    parser.add_argument("--mu", metavar="MU", help=told("help_mu"))
    parser.add_argument("--with", dest="others", action="append", default=[], metavar="PLAN=FILE",
                        help=told("help_with"))  # fmt: skip
    parser.add_argument("--pole", metavar="X,Y", help=told("help_pole"))
    parser.add_argument("--mark", action="append", default=[], metavar="NAME=X,Y", help=told("help_mark"))
    parser.add_argument("--format", choices=("A4", "A3", "A2", "A1"), help=told("help_picture_format"))
    parser.add_argument("--work", choices=("hand", "cad"), default="hand", help=told("help_work"))
    parser.add_argument("--trace", action="store_true", help=told("help_trace"))
    parser.add_argument("-o", "--output", metavar="FILE", help=told("help_check_output"))
    parser.add_argument("--json", action="store_true", help=told("help_json"))


def add_blank_options(parser: argparse.ArgumentParser, told: Callable[[str], str]) -> None:
    """What ``planes blank`` takes beside the scene."""
    parser.add_argument("--plan", default="velocity", metavar="PLAN", help=told("help_plan"))
    parser.add_argument("--mu", metavar="MU", help=told("help_mu"))
    parser.add_argument("-o", "--output", required=True, metavar="FILE", help=told("help_blank_output"))
