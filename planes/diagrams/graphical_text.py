"""The results of a graphical construction beside the exact values: a table for the terminal, with scales and errors."""

import math

from planes.diagrams.graphical import Construction, Stage, differentiate_graphically, integrate_graphically
from planes.diagrams.motion import motion_of_driven_link
from planes.drafting.drawing import Drawing
from planes.drafting.instruments import Exact, Pencil
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.solving.text_tables import aligned_table
from planes.words import Lang, Phrase, put_decimal_signs, say
from planes.words.errors import PlanesError
from planes.words.frozen import frozen
from planes.words.naming import Naming
from planes.words.records import Json
from planes.words.units import UNITS_OF_PLACE_AND_RATES, significant_digits_text

DRAUGHTSMEN_COUNT = 400
MOTION_LETTERS = {True: ("s", "v", "a"), False: ("φ", "ω", "ε")}


@frozen
class MeasuredDiagram:
    """One measured diagram: at every point the reading, the exact value, and a pencil's standard deviation."""

    stage: Stage
    found: list[float]
    exact: list[float]
    pencil: list[float]

    @property
    def reading_rows(self) -> list[tuple[int, str, float, float, float]]:
        """Half sections, label, reading, exact value, deviation; the last middle is not repeated."""
        rows = zip(self.stage.points, self.found, self.exact, self.pencil, strict=True)
        return [(half, label, measured, exact, spread) for (half, label), measured, exact, spread in rows if half >= 0]

    @property
    def largest_method_error(self) -> float:
        """The largest error of the method itself, relative to the largest exact value."""
        size = max(map(abs, self.exact)) or 1.0
        return max(abs(f - e) for f, e in zip(self.found, self.exact, strict=True)) / size


def both_graphical_constructions(scene: Scene, sections: int, pole_mm: float | None = None) -> list[Construction]:
    """Both graphical constructions of the driven link's motion."""
    if pole_mm is not None and not 1.0 <= pole_mm <= 500.0:
        raise PlanesError(Phrase("graphical_pole", pole=pole_mm))
    motion = motion_of_driven_link(scene_plans(scene), sections, scene.file)
    return [differentiate_graphically(motion, pole_mm), integrate_graphically(motion, pole_mm)]


def diagram_readings(c: Construction, pencil: Pencil | None = None) -> list[MeasuredDiagram]:
    """The readings of every diagram of a construction: drawn without hand errors, and by many draughtsmen."""
    import numpy

    drawing: Drawing = c.draw_construction(Exact())
    crowd = c.draw_construction(pencil or Pencil(), {"mu_paper": numpy.ones(DRAUGHTSMEN_COUNT)})
    diagrams = []
    for stage in c.stages:
        spread = [float(numpy.std(v)) if numpy.ndim(v) else 0.0 for v in c.measured_values(crowd, stage)]
        diagrams.append(
            MeasuredDiagram(stage, [float(v) for v in c.measured_values(drawing, stage)], c.exact_values(stage), spread)
        )
    return diagrams


def scale_formulas(c: Construction, lang: Lang) -> list[str]:
    """The scales of the diagrams, each with its formula; μ in mm per unit."""
    letters = MOTION_LETTERS[c.motion.slides]
    units = UNITS_OF_PLACE_AND_RATES[c.motion.slides]
    mm = say("mm", lang)
    lines = [f"μ_t = {significant_digits_text(c.time_scale)} {mm}/{say('s', lang)}"]
    previous: Stage | None = None
    for stage in c.stages:
        letter = letters[stage.rank]
        unit = say(units[stage.rank], lang)
        text = f"μ_{letter} = "
        if previous:
            other = letters[previous.rank]
            text += f"H·μ_{other}/μ_t = " if c.kind == "differentiation" else f"μ_{other}·μ_t/H = "
        text += f"{significant_digits_text(stage.mu)} {mm}/{'(' + unit + ')' if '/' in unit else unit}"
        pole = stage if c.kind == "differentiation" else previous
        if previous and pole and pole.pole_mm:
            text += f", H = {significant_digits_text(pole.pole_mm)} {mm}"
        lines.append(text)
        previous = stage
    return lines


def constructions_json(constructions: list[Construction]) -> Json:
    """The constructions as plain data: scales, poles, and every point with its reading and exact value, SI."""
    rows = []
    for c in constructions:
        diagrams = [_diagram_json(c, r) for r in diagram_readings(c)]
        rows.append({"kind": c.kind, "link": c.motion.link, "mu_t": c.time_scale, "diagrams": diagrams})
    return {"planes": 1, "constructions": rows}


def _diagram_json(c: Construction, r: MeasuredDiagram) -> Json:
    stage = r.stage
    keys = ("point", "phi_deg", "found", "exact", "pencil")
    points = [
        dict(zip(keys, (label, _driver_angle_at_point(c, half), *numbers), strict=True))
        for half, label, *numbers in r.reading_rows
    ]
    letter, unit = (names[c.motion.slides][stage.rank] for names in (MOTION_LETTERS, UNITS_OF_PLACE_AND_RATES))
    scale = {"mu": stage.mu, "pole_mm": stage.pole_mm, "given": stage.given}
    return {"quantity": letter, "unit": unit, **scale, "points": points}


def constructions_report(constructions: list[Construction], lang: Lang) -> str:
    """Tables of the constructions, one after the other."""
    lines = []
    for c in constructions:
        lines += ["", say(f"graphical_{c.kind}", lang, link=c.motion.link, count=c.motion.section_count)]
        lines += [f"  {line}" for line in scale_formulas(c, lang)]
        for reading in diagram_readings(c):
            if not reading.stage.given:
                lines += _diagram_table(c, reading, lang)
    return put_decimal_signs("\n".join(lines[1:]), lang) + "\n"


def _diagram_table(c: Construction, r: MeasuredDiagram, lang: Lang) -> list[str]:
    rank = r.stage.rank
    slides = c.motion.slides
    unit = say(UNITS_OF_PLACE_AND_RATES[slides][rank], lang)
    point, found_head, exact_head, pencil = (say(f"graphical_{k}", lang) for k in ("point", "found", "exact", "pencil"))
    size = max(map(abs, r.exact)) or 1.0
    rows = []
    for half, label, measured, exact, spread in r.reading_rows:
        cells = (significant_digits_text(0.0 if abs(x) < 1e-12 * size else x) for x in (measured, exact))
        shares = (f"{100 * x / size:.2f}" for x in (measured - exact, spread))
        rows.append([label, significant_digits_text(_driver_angle_at_point(c, half), 5), *cells, *shares])
    title = f"{MOTION_LETTERS[slides][rank]}{c.motion.link}, {unit}"
    lines = aligned_table(
        title,
        [point, f"{Naming().terminal_vector_name(c.motion.driver)}, °", found_head, exact_head, "Δ, %", pencil],
        rows,
    )
    return [*lines, "  " + say("graphical_worst", lang, error=f"{100 * r.largest_method_error:.2f}")]


def _driver_angle_at_point(c: Construction, half: int) -> float:
    """The driver's angle at a point, within one turn."""
    a, b = c.motion.angles[:2]
    return math.fmod(a + (b - a) * half / 2, 360.0) % 360.0
