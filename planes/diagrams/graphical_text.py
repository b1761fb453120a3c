"""The results of a graphical construction beside the exact values: a table for the terminal, with scales and errors."""

import math

from planes.diagrams.graphical import Construction, Stage, differentiated, integrated
from planes.diagrams.motion import motion_of
from planes.drafting.drawing import Drawing
from planes.drafting.instruments import Exact, Pencil
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.solving.text_tables import table
from planes.words import Lang, Phrase, decimals, say
from planes.words.errors import PlanesError
from planes.words.frozen import frozen
from planes.words.naming import Naming
from planes.words.records import Json
from planes.words.units import RATES, quantity

PENCILS = 400
LETTERS = {True: ("s", "v", "a"), False: ("φ", "ω", "ε")}


@frozen
class MeasuredDiagram:
    """One measured diagram: at every point the reading, the exact value, and a pencil's standard deviation."""

    stage: Stage
    found: list[float]
    exact: list[float]
    pencil: list[float]

    @property
    def rows(self) -> list[tuple[int, str, float, float, float]]:
        """Half sections, label, reading, exact value, deviation; the last middle is not repeated."""
        rows = zip(self.stage.points, self.found, self.exact, self.pencil, strict=True)
        return [(half, label, measured, exact, spread) for (half, label), measured, exact, spread in rows if half >= 0]

    @property
    def worst(self) -> float:
        """The largest error of the method itself, relative to the largest exact value."""
        size = max(map(abs, self.exact)) or 1.0
        return max(abs(f - e) for f, e in zip(self.found, self.exact, strict=True)) / size


def constructed(scene: Scene, sections: int, pole_mm: float | None = None) -> list[Construction]:
    """Both graphical constructions of the driven link's motion."""
    if pole_mm is not None and not 1.0 <= pole_mm <= 500.0:
        raise PlanesError(Phrase("graphical_pole", pole=pole_mm))
    motion = motion_of(scene_plans(scene), sections, scene.file)
    return [differentiated(motion, pole_mm), integrated(motion, pole_mm)]


def readings(c: Construction, pencil: Pencil | None = None) -> list[MeasuredDiagram]:
    """The readings of every diagram of a construction: drawn without hand errors, and by many draughtsmen."""
    import numpy

    drawing: Drawing = c.drawn(Exact())
    crowd = c.drawn(pencil or Pencil(), {"mu_paper": numpy.ones(PENCILS)})
    diagrams = []
    for stage in c.stages:
        spread = [float(numpy.std(v)) if numpy.ndim(v) else 0.0 for v in c.measured(crowd, stage)]
        diagrams.append(MeasuredDiagram(stage, [float(v) for v in c.measured(drawing, stage)], c.exact(stage), spread))
    return diagrams


def scales(c: Construction, lang: Lang) -> list[str]:
    """The scales of the diagrams, each with its formula; μ in mm per unit."""
    letters, units, mm = LETTERS[c.motion.slides], RATES[c.motion.slides], say("mm", lang)
    lines = [f"μ_t = {quantity(c.mu_t)} {mm}/{say('s', lang)}"]
    previous: Stage | None = None
    for stage in c.stages:
        letter, unit = letters[stage.rank], say(units[stage.rank], lang)
        text = f"μ_{letter} = "
        if previous:
            other = letters[previous.rank]
            text += f"H·μ_{other}/μ_t = " if c.kind == "differentiation" else f"μ_{other}·μ_t/H = "
        text += f"{quantity(stage.mu)} {mm}/{'(' + unit + ')' if '/' in unit else unit}"
        pole = stage if c.kind == "differentiation" else previous
        if previous and pole and pole.pole_mm:
            text += f", H = {quantity(pole.pole_mm)} {mm}"
        lines.append(text)
        previous = stage
    return lines


def as_json(constructions: list[Construction]) -> Json:
    """The constructions as plain data: scales, poles, and every point with its reading and exact value, SI."""
    rows = []
    for c in constructions:
        diagrams = [_diagram(c, r) for r in readings(c)]
        rows.append({"kind": c.kind, "link": c.motion.link, "mu_t": c.mu_t, "diagrams": diagrams})
    return {"planes": 1, "constructions": rows}


def _diagram(c: Construction, r: MeasuredDiagram) -> Json:
    stage, keys = r.stage, ("point", "phi_deg", "found", "exact", "pencil")
    points = [dict(zip(keys, (label, _angle(c, half), *numbers), strict=True)) for half, label, *numbers in r.rows]
    letter, unit = (names[c.motion.slides][stage.rank] for names in (LETTERS, RATES))
    scale = {"mu": stage.mu, "pole_mm": stage.pole_mm, "given": stage.given}
    return {"quantity": letter, "unit": unit, **scale, "points": points}


def report(constructions: list[Construction], lang: Lang) -> str:
    """Tables of the constructions, one after the other."""
    lines = list[str]()
    for c in constructions:
        lines += ["", say(f"graphical_{c.kind}", lang, link=c.motion.link, count=c.motion.sections)]
        lines += [f"  {line}" for line in scales(c, lang)]
        for reading in readings(c):
            if not reading.stage.given:
                lines += _reading(c, reading, lang)
    return decimals("\n".join(lines[1:]), lang) + "\n"


def _reading(c: Construction, r: MeasuredDiagram, lang: Lang) -> list[str]:
    rank, slides = r.stage.rank, c.motion.slides
    unit = say(RATES[slides][rank], lang)
    point, found_head, exact_head, pencil = (say(f"graphical_{k}", lang) for k in ("point", "found", "exact", "pencil"))
    size = max(map(abs, r.exact)) or 1.0
    rows = []
    for half, label, measured, exact, spread in r.rows:
        cells = (quantity(0.0 if abs(x) < 1e-12 * size else x) for x in (measured, exact))
        shares = (f"{100 * x / size:.2f}" for x in (measured - exact, spread))
        rows.append([label, quantity(_angle(c, half), 5), *cells, *shares])
    title = f"{LETTERS[slides][rank]}{c.motion.link}, {unit}"
    lines = table(title, [point, f"{Naming().plain(c.motion.driver)}, °", found_head, exact_head, "Δ, %", pencil], rows)
    return [*lines, "  " + say("graphical_worst", lang, error=f"{100 * r.worst:.2f}")]


def _angle(c: Construction, half: int) -> float:
    """The driver's angle at a point, within one turn."""
    a, b = c.motion.angles[:2]
    return math.fmod(a + (b - a) * half / 2, 360.0) % 360.0
