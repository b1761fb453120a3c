"""The command ``planes cycle`` and the choice of its answer: a table, a picture or a summary."""

import math
import sys
from argparse import Namespace
from dataclasses import replace
from pathlib import Path

from planes.cli.commands import json_text, scene_of
from planes.cli.options import check_needed_options, check_options, requested_drive_range
from planes.scene import Scene
from planes.scene.ranges import Span, read_span
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.formats import DRAWING_SUFFIXES

FILM_SUFFIXES = (".gif", ".mp4")
MOST_LISTED_POSITIONS = 24  # longest listing, in positions


def cycle(args: Namespace) -> int:
    """One of the answers; returns the exit status."""
    scene = scene_of(args)
    kind, text = requested_drive_range(args, scene)
    span = None if text is None else read_span(text, f"--{kind}")
    answer = _answer_kind(args, span)
    if not scene.drive:
        raise PlanesError(Phrase("cycle_no_mechanism", file=scene.file))
    scene = with_driver_motion(scene, args.omega, args.epsilon)
    check_options(args, answer)
    check_needed_options(args)
    match answer:
        case "table" | "curves":
            return _write_table(args, scene, span)
        case "picture":
            return _write_picture(args, scene, span)
        case "film":
            return _write_film(args, scene)
        case "graphical" | "graphical_picture":
            return _answer_graphical(args, scene)
        case "listing":
            return _print_listing(args, scene, span)
    return _print_summary(args, scene, span)


def _answer_kind(args: Namespace, span: Span | None) -> str:
    """The kind of answer requested."""
    if args.film or (args.output and Path(args.output).suffix.lower() in FILM_SUFFIXES):
        return "film"
    if args.output and Path(args.output).suffix.lower() not in DRAWING_SUFFIXES:
        return "curves" if args.show is not None else "table"
    if args.graphical is not None:
        return "graphical_picture" if args.output else "graphical"
    if args.output:
        return "picture"
    if args.listing or (span is not None and span.count == 1):
        return "listing"
    return "summary"


def with_driver_motion(scene: Scene, velocity: float | None, acceleration: float | None) -> Scene:
    """The scene with another law of motion for its driver (rad/s and rad/s², or m/s and m/s²)."""
    rates = {k: x for k, x in (("velocity", velocity), ("acceleration", acceleration)) if x is not None}
    if scene.mechanism is None or not rates:
        return scene
    if not all(map(math.isfinite, rates.values())):
        raise PlanesError(Phrase("drive_not_finite"))
    said = {"omega": "velocity", "epsilon": "acceleration"}
    laws = {p: law for p, law in scene.mechanism.laws.items() if p[0] != "drive" or said.get(p[1], p[1]) not in rates}
    v, a = (rates.get(k, getattr(scene.mechanism.drive, k)) for k in ("velocity", "acceleration"))
    drive = replace(scene.mechanism.drive, velocity=v, acceleration=a)
    return replace(scene, mechanism=replace(scene.mechanism, drive=drive, laws=laws))


def names_in_option(text: str | None, option: str) -> list[str] | None:
    """Names separated by commas."""
    names = None if text is None else [name.strip() for name in text.split(",") if name.strip()]
    if names == []:
        raise PlanesError(Phrase("option_names", option=option))
    return names


def _requested_curve_names(args: Namespace) -> list[str] | None:
    """The curves requested by name; None: all."""
    names = names_in_option(args.show, "--show")
    if names is None or names == ["all"]:
        return None
    return [n for name in names for n in name.split("+")]


def _write_picture(args: Namespace, scene: Scene, span: Span | None) -> int:
    from planes.documents.cycle import cycle_page

    show, loops, paths = (
        names_in_option(getattr(args, option), f"--{option}") for option in ("show", "hodograph", "path")
    )
    cycle_page(scene, span, show, loops, paths, args.lang).write(args.output)
    return 0


def _write_film(args: Namespace, scene: Scene) -> int:
    from planes.documents.animation import animate

    animate(scene, args.output, args.lang)
    return 0


def _write_table(args: Namespace, scene: Scene, span: Span | None) -> int:

    from planes.diagrams.long_run import write_table
    from planes.diagrams.turn import WholeTurn, whole_turn_of
    from planes.plans.curves import curves_meant_by_names
    from planes.plans.statements.of_scene import scene_plans

    plans = scene_plans(scene)
    if args.show is None:
        turn = WholeTurn(plans, curves_meant_by_names(plans, scene.find), slopes=False)
    else:
        turn = whole_turn_of(plans, _requested_curve_names(args), file=scene.file, slopes=False)
    return write_table(turn, span, args.output, args.lang, False if args.plain else None, args.errors)


def _print_listing(args: Namespace, scene: Scene, span: Span | None) -> int:
    from planes.diagrams.long_run import curve_listing_text, curves_at_positions_json, failed_position_sentences
    from planes.diagrams.turn import whole_turn_of
    from planes.plans.statements.of_scene import scene_plans

    plans = scene_plans(scene)
    chosen = span or Span(plans.drive.position, 0.0, 1)
    if chosen.count > MOST_LISTED_POSITIONS:
        raise PlanesError(Phrase("listing_long", count=chosen.count, most=MOST_LISTED_POSITIONS))
    turn = whole_turn_of(plans, _requested_curve_names(args), file=scene.file, slopes=False)
    refused = failed_position_sentences(turn, chosen[:], args.lang)
    print(*refused, sep="\n", end="\n" if refused else "", file=sys.stderr)
    if len(refused) == chosen.count:
        return 2
    print(
        json_text(curves_at_positions_json(turn, chosen[:]))
        if args.json
        else curve_listing_text(turn, chosen[:], args.lang).rstrip()
    )
    return 0


def _print_summary(args: Namespace, scene: Scene, span: Span | None) -> int:
    from planes.diagrams.summary import summary_of_scene
    from planes.diagrams.text import summary_json as plain
    from planes.diagrams.text import summary_report

    cycle = summary_of_scene(scene, span.first_and_last if span else None, _requested_curve_names(args))
    print(json_text(plain(cycle)) if args.json else summary_report(cycle, args.lang), end="\n" if args.json else "")
    return 0


def _answer_graphical(args: Namespace, scene: Scene) -> int:
    from planes.diagrams.graphical_text import both_graphical_constructions, constructions_report
    from planes.diagrams.graphical_text import constructions_json as plain

    if args.output:
        from planes.documents.drawn import draw_constructions

        draw_constructions(scene, args.graphical, args.pole, args.output, args.lang)
        return 0
    graphs = both_graphical_constructions(scene, args.graphical, args.pole)
    print(json_text(plain(graphs)) if args.json else constructions_report(graphs, args.lang).rstrip())
    return 0
