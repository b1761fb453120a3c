"""The command ``planes cycle`` and the choice of its answer: a table, a picture or a summary."""

import math
import sys
from argparse import Namespace
from dataclasses import replace
from pathlib import Path

from planes.cli.commands import as_json, scene_of
from planes.cli.options import check_needs, check_options, range_of
from planes.scene import Scene
from planes.scene.ranges import Span, read_span
from planes.words import Phrase
from planes.words.errors import PlanesError

PICTURES = (".png", ".svg", ".pdf", ".dxf")
FILMS = (".gif", ".mp4")
LISTED = 24  # longest listing, in positions


def cycle(args: Namespace) -> int:
    """One of the answers; returns the exit status."""
    scene = scene_of(args)
    kind, text = range_of(args, scene)
    span = None if text is None else read_span(text, f"--{kind}")
    answer = _answer(args, span)
    if not scene.drive:
        raise PlanesError(Phrase("cycle_no_mechanism", file=scene.file))
    scene = driven_otherwise(scene, args.omega, args.epsilon)
    check_options(args, "cycle", answer)
    check_needs(args, ["pole", "film"])
    match answer:
        case "table" | "curves":
            return _table(args, scene, span)
        case "picture":
            return _picture(args, scene, span)
        case "film":
            return _film(args, scene)
        case "graphical" | "graphical_picture":
            return _graphical(args, scene)
        case "listing":
            return _listing(args, scene, span)
    return _summary(args, scene, span)


def _answer(args: Namespace, span: Span | None) -> str:
    """The kind of answer requested."""
    if args.film or (args.output and Path(args.output).suffix.lower() in FILMS):
        return "film"
    if args.output and Path(args.output).suffix.lower() not in PICTURES:
        return "curves" if args.show is not None else "table"
    if args.graphical is not None:
        return "graphical_picture" if args.output else "graphical"
    if args.output:
        return "picture"
    return "listing" if args.listing or (span is not None and span.count == 1) else "summary"


def driven_otherwise(scene: Scene, velocity: float | None, acceleration: float | None) -> Scene:
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


def asked(text: str | None, option: str) -> list[str] | None:
    """Names separated by commas."""
    names = None if text is None else [name.strip() for name in text.split(",") if name.strip()]
    if names == []:
        raise PlanesError(Phrase("option_names", option=option))
    return names


def _names(args: Namespace) -> list[str] | None:
    """The curves requested by name; None: all."""
    names = asked(args.show, "--show")
    return None if names is None or names == ["all"] else [n for name in names for n in name.split("+")]


def _picture(args: Namespace, scene: Scene, span: Span | None) -> int:
    from planes.documents.cycle import cycle_page

    show, loops, paths = (asked(getattr(args, option), f"--{option}") for option in ("show", "hodograph", "path"))
    cycle_page(scene, span, show, loops, paths, args.lang).write(args.output)
    return 0


def _film(args: Namespace, scene: Scene) -> int:
    from planes.documents.animation import animate

    animate(scene, args.output, args.lang)
    return 0


def _table(args: Namespace, scene: Scene, span: Span | None) -> int:

    from planes.diagrams.long_run import write_table
    from planes.diagrams.turn import WholeTurn, turn_of
    from planes.plans.curves import curves_meant
    from planes.plans.statements.of_scene import scene_plans

    plans = scene_plans(scene)
    if args.show is None:
        turn = WholeTurn(plans, curves_meant(plans, scene.find), slopes=False)
    else:
        turn = turn_of(plans, _names(args), file=scene.file, slopes=False)
    return write_table(turn, span, args.output, args.lang, False if args.plain else None, args.errors)


def _listing(args: Namespace, scene: Scene, span: Span | None) -> int:
    from planes.diagrams.long_run import listed_json, listing, unsolved
    from planes.diagrams.turn import turn_of
    from planes.plans.statements.of_scene import scene_plans

    plans = scene_plans(scene)
    chosen = span or Span(plans.drive.position, 0.0, 1)
    if chosen.count > LISTED:
        raise PlanesError(Phrase("listing_long", count=chosen.count, most=LISTED))
    turn = turn_of(plans, _names(args), file=scene.file, slopes=False)
    refused = unsolved(turn, chosen[:], args.lang)
    print(*refused, sep="\n", end="\n" if refused else "", file=sys.stderr)
    if len(refused) == chosen.count:
        return 2
    print(as_json(listed_json(turn, chosen[:])) if args.json else listing(turn, chosen[:], args.lang).rstrip())
    return 0


def _summary(args: Namespace, scene: Scene, span: Span | None) -> int:
    from planes.diagrams.summary import of_cycle
    from planes.diagrams.text import as_json as plain
    from planes.diagrams.text import report

    cycle = of_cycle(scene, span.ends if span else None, _names(args))
    print(as_json(plain(cycle)) if args.json else report(cycle, args.lang), end="\n" if args.json else "")
    return 0


def _graphical(args: Namespace, scene: Scene) -> int:
    from planes.diagrams.graphical_text import as_json as plain
    from planes.diagrams.graphical_text import constructed, report

    if args.output:
        from planes.documents.drawn import draw_constructions

        draw_constructions(scene, args.graphical, args.pole, args.output, args.lang)
        return 0
    graphs = constructed(scene, args.graphical, args.pole)
    print(as_json(plain(graphs)) if args.json else report(graphs, args.lang).rstrip())
    return 0
