"""The command ``planes cycle``: which of its answers is asked for: a table, a picture or a summary."""

from __future__ import annotations

import argparse
import math
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from planes.angles import Span
from planes.scene import Scene
from planes.wording import PlanesError
from planes.words import Phrase

PICTURES = (".png", ".svg", ".pdf")
LISTED = 24  # positions a listing may have


def run(args: argparse.Namespace, scene: Scene, span: Span | None, as_json: Callable[[object], str]) -> int:
    """One of the answers; the exit status."""
    if scene.mechanism is None:
        raise PlanesError(Phrase("cycle_no_mechanism", file=scene.file))
    scene = driven_otherwise(scene, args.omega, args.epsilon)
    if args.errors and (args.show or not args.output or Path(args.output).suffix.lower() in PICTURES):
        raise PlanesError(Phrase("cycle_errors_table"))
    if args.output and Path(args.output).suffix.lower() not in PICTURES:
        return _table(args, scene, span)
    if args.output:
        from planes.roof.cycle import draw_cycle

        draw_cycle(scene, span, args.output, asked(args.show), asked(args.hodograph), asked(args.path), args.lang)
        return 0
    if args.graphical is not None:
        return _graphical(args, scene, as_json)
    if args.listing or (span is not None and span.count == 1):
        return _listing(args, scene, span, as_json)
    return _summary(args, scene, span, as_json)


def driven_otherwise(scene: Scene, velocity: float | None, acceleration: float | None) -> Scene:
    """The scene with another law of motion of its driver (rad/s and rad/s², or m/s and m/s²)."""
    mechanism = scene.mechanism
    if mechanism is None or (velocity is None and acceleration is None):
        return scene
    if not all(x is None or math.isfinite(x) for x in (velocity, acceleration)):
        raise PlanesError(Phrase("drive_not_finite"))
    drive = mechanism.drive
    v = drive.velocity if velocity is None else velocity
    a = drive.acceleration if acceleration is None else acceleration
    return replace(scene, mechanism=replace(mechanism, drive=replace(drive, velocity=v, acceleration=a)))


def asked(text: str | None) -> list[str] | None:
    """Names with commas between them."""
    return None if text is None else [name.strip() for name in text.split(",") if name.strip()]


def _names(args: argparse.Namespace) -> list[str] | None:
    """The curves asked for one by one; None: all."""
    names = asked(args.show)
    return None if names is None or names == ["all"] else [n for name in names for n in name.split("+")]


def _table(args: argparse.Namespace, scene: Scene, span: Span | None) -> int:
    from planes.cycle.long_run import write_curves, write_cycle

    fast = False if args.plain else None
    if args.show is None:
        return write_cycle(scene, span, args.output, args.lang, fast, args.errors)
    from planes.diagrams.turn import turn_of
    from planes.plans import state

    assert scene.mechanism
    turn = turn_of(state(scene.mechanism, scene.file), _names(args), file=scene.file)
    return write_curves(turn, span, args.output, args.lang)


def _listing(
    args: argparse.Namespace, scene: Scene, span: Span | None, as_json: Callable[[object], str]
) -> int:
    from planes.diagrams.text import listed_json, listing, unsolved
    from planes.diagrams.turn import turn_of
    from planes.plans import state

    assert scene.mechanism
    chosen = span or Span(scene.mechanism.drive.position, 0.0, 1)
    if chosen.count > LISTED:
        raise PlanesError(Phrase("listing_long", count=chosen.count, most=LISTED))
    turn = turn_of(state(scene.mechanism, scene.file), _names(args), file=scene.file)
    refused = unsolved(turn, chosen[:], args.lang)
    print(*refused, sep="\n", end="\n" if refused else "", file=sys.stderr)
    if len(refused) == chosen.count:
        return 2
    print(as_json(listed_json(turn, chosen[:])) if args.json else listing(turn, chosen[:], args.lang).rstrip())
    return 0


def _summary(args: argparse.Namespace, scene: Scene, span: Span | None, as_json: Callable[[object], str]) -> int:
    from planes.diagrams.summary import summary
    from planes.diagrams.text import as_json as plain
    from planes.diagrams.text import report
    from planes.diagrams.turn import reach
    from planes.plans import state
    from planes.working import FULL

    assert scene.mechanism
    plans = state(scene.mechanism, scene.file)
    if span is not None:
        ends = span.start, span.start + span.step * (span.count - 1)
    elif scene.mechanism.drive.kind == "phi":
        ends = 0.0, FULL
    else:
        ends = reach(plans)
    found = summary(scene, plans, *ends, _names(args))
    if not found.grid.works.any():
        first, last = (f"{x:g}" for x in ends)
        raise PlanesError(Phrase("cycle_never", first=first, last=last))
    print(as_json(plain(found)) if args.json else report(found, args.lang), end="\n" if args.json else "")
    return 0


def _graphical(args: argparse.Namespace, scene: Scene, as_json: Callable[[object], str]) -> int:
    from planes.diagrams.graphical_text import as_json as plain
    from planes.diagrams.graphical_text import report
    from planes.diagrams.motion import constructed

    found = constructed(scene, args.graphical, args.pole)
    print(as_json(plain(found)) if args.json else report(found, args.lang).rstrip())
    return 0
