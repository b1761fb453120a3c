"""Pictures of a whole cycle: diagrams of chosen curves, hodographs and paths, read off the one program and drawn."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from planes.diagrams.curves import Curve, curves_of, output_curves
from planes.diagrams.driven import FULL
from planes.diagrams.extremes import Extreme, extremes
from planes.diagrams.motion import Runs, ends_of
from planes.diagrams.turn import Grid, WholeTurn, grid, turn_of
from planes.geometry.arrays import Array
from planes.plans import Plans, mechanism_plans
from planes.plans.measuring import lettering
from planes.scene import Scene
from planes.scene.files import sayable
from planes.scene.ranges import Span
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError
from planes.words.lettering import Naming
from planes.words.names import index_of, letter_of
from render.charts.cycle_charts import DriveAxis, Loop, Panel, draw


def draw_cycle(
    scene: Scene,
    span: Span | None,
    output: str,
    show: Sequence[str] | None,
    hodographs: Sequence[str] | None,
    paths: Sequence[str] | None,
    lang: Lang,
) -> None:
    """Draw the diagrams into a file by its suffix; what is asked for is found before the file is touched."""
    if span is not None and span.count < 2:
        raise PlanesError(Phrase("cycle_one_place", file=scene.file))
    plans = mechanism_plans(scene)
    panels = [name.split("+") for name in (show if show is not None else default_curves(plans, hodographs, paths))]
    loops = [*(hodographs or ()), *(f"r_{index_of(p) if letter_of(p) == 'r' else p}" for p in paths or ())]
    turned = Turned(scene, plans, span, [n for names in panels for n in names], loops)
    naming, title = Naming(lang, **lettering(scene, plans)), scene.title.get(lang, "")
    curves, circles = [turned.panel(names) for names in panels], [turned.loop(n) for n in loops]
    with sayable(output):
        draw(Path(output), title, curves, circles, turned.drawn(), naming)


def default_curves(plans: Plans, hodographs: object = None, paths: object = None) -> tuple[str, ...]:
    """What is drawn when nothing is named: the driven link's motion, and what balances the driver."""
    if hodographs or paths:
        return ()
    letter = "M" if plans.mechanism.drive.kind == "phi" else "Fb"
    return (*output_curves(plans), f"{letter}_{plans.mechanism.drive.link}")


class Turned:
    """A cycle from the extreme position of the driven link on, with the curves and vectors that are to be drawn."""

    def __init__(
        self, scene: Scene, plans: Plans, span: Span | None, names: Sequence[str], loops: Sequence[str]
    ) -> None:
        self.plans = plans
        self.turn: WholeTurn = turn_of(plans, names, loops, scene.file)
        self.runs = Runs(plans, *(ends_of(plans)[:2] if span is None else sorted(span.ends)))
        self.pieces = [(places, self.turn.sample(places)) for places in self.runs.pieces()]
        self.grid: Grid = grid(self.turn, self.runs.start, self.runs.end)
        self.extremes = {c.name: e for c, e in zip(self.turn.curves, extremes(self.grid), strict=True)}

    def panel(self, names: Sequence[str]) -> Panel:
        """The curves of one pair of axes."""
        named = {curve.name: curve for curve in self.turn.curves}
        curves, drawn = [named[curves_of(self.plans)[n].name] for n in names], []
        for curve in curves:
            read = [(places, curve.read(sample) + np.zeros(len(places))) for places, sample in self.pieces]
            drawn.append((curve.name, [(p, self._joined(curve, p, y)) for p, y in read], self._marked(curve)))
        return Panel(curves[0].unit, curves[0].group == "place", drawn)

    def _joined(self, curve: Curve, places: Array, y: Array) -> Array:
        """Angles told as on the grid, where they are unwound."""
        if not curve.angular:
            return y
        whole = self.grid.values(curve)
        good = np.isfinite(whole)
        near = np.interp(places, self.grid.places[good], whole[good])
        return y + FULL * np.round((near - y) / FULL)

    def _marked(self, curve: Curve) -> list[Extreme]:
        """The least and the greatest value, where they are finite."""
        some = [e for e in self.extremes[curve.name] if np.isfinite(e.value)]
        return [max(some, key=lambda e: sense * e.value) for sense in (-1, 1)] if some else []

    def loop(self, name: str) -> Loop:
        """A hodograph, or a path."""
        arrow = next(a for a in self.turn.arrows if a.name == name)
        stations = arrow.read(self.turn.sample(self.runs.read_stations()))
        return Loop(name, arrow.unit, [arrow.read(s) for _, s in self.pieces], stations, self.runs.closed)

    def drawn(self) -> DriveAxis:
        """What the axes say."""
        drive = self.plans.mechanism.drive
        return DriveAxis(drive.kind == "phi", drive.link, self.runs.start, self.runs.end, self.runs.stations())
