"""The report of a calculation as a document, and its numbers as an object for programs: SI, full precision, stresses in
MPa."""

import math
from dataclasses import is_dataclass

import numpy as np

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.forces import equations_as_printed
from planes.crank_slider.pages import ChapterWriter
from planes.crank_slider.pages_mechanics import write_forces, write_given, write_kinematics
from planes.crank_slider.pages_strength import checks_with_bounds, write_balance, write_strength, write_summary
from planes.solving.document import Block, DocumentTable, Heading
from planes.solving.text_tables import aligned_table
from planes.words import Lang
from planes.words.records import Json

CHAPTER_WRITERS = (write_given, write_kinematics, write_forces, write_balance, write_strength, write_summary)


def report_document(c: Calculation, lang: Lang) -> list[Block]:
    """The whole report in one language."""
    title = c.scene.title.get(lang) or next(iter(c.scene.title.values()), c.scene.file)
    writer = ChapterWriter(lang, [Heading(title, 0)])
    for chapter in CHAPTER_WRITERS:
        chapter(writer, c)
    return writer.blocks


def summary_lines(c: Calculation, lang: Lang) -> str:
    """The checks and the torque as lines for a terminal."""
    writer = ChapterWriter(lang)
    write_summary(writer, c)
    mean, power = map(writer.number, (c.work.mean, c.work.power / 1e3))
    torque = f"{writer.say('l_mean')} M = {mean} {writer.say('N·m')}"
    lines = [c.scene.title.get(lang, ""), f"{torque}; {power} {writer.say('kW')}"]
    checked = [b for b in writer.blocks if isinstance(b, DocumentTable)][:-1]  # the last lists the text's errors
    for block in checked:
        lines += aligned_table(writer.say("t_summary"), block.rows[0], block.rows[1:])
    return "\n".join(lines) + "\n"


def as_json(c: Calculation) -> Json:
    """The output of ``planes crank-slider --json``."""
    report: Json = {
        "planes": 1,
        "scene": c.scene.file,
        "variant": c.scene.variant,
        "agreement": c.agreement,
        "kinematics": _kinematics_json(c),
        "replacement": {**vars(c.parts), "percent": c.parts.percent},
        "forces": _forces_json(c),
        "torque": _fields_without_curve(c.work),
    }
    if c.balance:
        report["balance"] = {**vars(c.balance), "cases": list(map(_fields_without_curve, c.balance.cases))}
    if c.supports:
        report |= {"shaft": _shaft_json(c), "fatigue": c.fatigue}
    if c.rod:
        report["rod"] = c.rod
    if c.pin:
        report["piston_pin"] = c.pin
    report["checks"] = [
        dict(zip(("name", "found", "low", "high", "holds"), one, strict=True)) for one in checks_with_bounds(c)
    ]
    texts = [
        (k, equations_as_printed(c.given.shape, c.motion, c.plane, c.forces, k)) for k in map(c.at, c.given.positions)
    ]
    report["source_text"] = [{"phi_deg": c.motion.phi_deg[k], "printed": text} for k, text in texts]
    return {key: _json_value(value) for key, value in report.items()}


def _json_value(value: object) -> object:
    """Data for a program; a number that is not finite becomes null."""
    match value:
        case dict():
            return {k: _json_value(v) for k, v in value.items()}
        case list() | tuple():
            return [_json_value(v) for v in value]
        case np.ndarray():
            return _json_value(value.tolist())
        case complex():
            return [value.real, value.imag]
        case float():
            return float(value) if math.isfinite(value) else None
    return _json_value(vars(value)) if is_dataclass(value) else value


def _fields_without_curve(thing: object) -> Json:
    return {k: v for k, v in vars(thing).items() if k != "curve"}


def _kinematics_json(c: Calculation) -> Json:
    p = c.points
    return {
        **{name: getattr(c.motion, name) for name in ("phi_deg", "omega", "epsilon")},
        "points": {n: {"r": p.r[n], "v": p.v[n], "a": p.a[n]} for n in ("A", "B", "C")},
        "omega_AB": c.plane.omega,
        "epsilon_AB": c.plane.epsilon,
    }


def _forces_json(c: Calculation) -> Json:
    f = c.forces
    return {
        "pressure": c.pressure,
        "gas": c.motion.gas,
        **{name: getattr(f, name) for name in ("P", "N", "S", "T", "K")},
        "friction": f.rubbing,
        "F_on_crank_from_rod": f.on_pin,
        "F_on_crank_from_frame": f.on_crank_from_frame,
        "M": f.torque,
    }


def _shaft_json(c: Calculation) -> Json:
    assert c.supports
    s = c.supports
    return {
        **{name: getattr(s, name) for name in ("A1", "A2", "B1", "B2", "web")},
        "counterweights": [s.left_weight, s.right_weight],
        "sections": {x.name: {"sigma": x.sigma, "tau": x.tau, "equivalent": x.equivalent} for x in c.sections.values()},
    }
