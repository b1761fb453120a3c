"""The report of a calculation as a document, and its numbers as an object for programs: SI, full precision, stresses in
MPa."""

import math
from dataclasses import is_dataclass

import numpy as np

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.forces import printed
from planes.crank_slider.pages import ChapterWriter
from planes.crank_slider.pages_mechanics import write_forces, write_given, write_kinematics
from planes.crank_slider.pages_strength import checks, write_balance, write_strength, write_summary
from planes.solving.document import Block, DocumentTable, Heading
from planes.solving.text_tables import table
from planes.words import Lang
from planes.words.records import Json

CHAPTERS = (write_given, write_kinematics, write_forces, write_balance, write_strength, write_summary)


def document(c: Calculation, lang: Lang) -> list[Block]:
    """The whole report in one language."""
    title = c.scene.title.get(lang) or next(iter(c.scene.title.values()), c.scene.file)
    writer = ChapterWriter(lang, [Heading(title, 0)])
    for chapter in CHAPTERS:
        chapter(writer, c)
    return writer.blocks


def summary(c: Calculation, lang: Lang) -> str:
    """The checks and the torque as lines for a terminal."""
    writer = ChapterWriter(lang)
    write_summary(writer, c)
    mean, power = (writer.number(x) for x in (c.work.mean, c.work.power / 1e3))
    torque = f"{writer.say('l_mean')} M = {mean} {writer.say('N·m')}"
    lines = [c.scene.title.get(lang, ""), f"{torque}; {power} {writer.say('kW')}"]
    checked = [b for b in writer.blocks if isinstance(b, DocumentTable)][:-1]  # the last lists the text's errors
    for block in checked:
        lines += table(writer.say("t_summary"), block.rows[0], block.rows[1:])
    return "\n".join(lines) + "\n"


def as_json(c: Calculation) -> Json:
    """The output of ``planes crank-slider --json``."""
    report: Json = {
        "planes": 1,
        "scene": c.scene.file,
        "variant": c.scene.variant,
        "agreement": c.agreement,
        "kinematics": _kinematics(c),
        "replacement": {**vars(c.parts), "percent": c.parts.percent},
        "forces": _forces(c),
        "torque": _but_curve(c.work),
    }
    if c.balance:
        report["balance"] = {**vars(c.balance), "cases": list(map(_but_curve, c.balance.cases))}
    if c.supports:
        report |= {"shaft": _shaft(c), "fatigue": c.fatigue}
    report |= {"rod": c.rod} if c.rod else {}
    report |= {"piston_pin": c.pin} if c.pin else {}
    report["checks"] = [dict(zip(("name", "found", "low", "high", "holds"), one, strict=True)) for one in checks(c)]
    texts = [(k, printed(c.given.shape, c.motion, c.plane, c.forces, k)) for k in map(c.at, c.given.positions)]
    report["source_text"] = [{"phi_deg": c.motion.phi_deg[k], "printed": text} for k, text in texts]
    return {key: _plain(value) for key, value in report.items()}


def _plain(value: object) -> object:
    """Data for a program; a number that is not finite becomes null."""
    match value:
        case dict():
            return {k: _plain(v) for k, v in value.items()}
        case list() | tuple():
            return [_plain(v) for v in value]
        case np.ndarray():
            return _plain(value.tolist())
        case complex():
            return [value.real, value.imag]
        case float():
            return float(value) if math.isfinite(value) else None
    return _plain(vars(value)) if is_dataclass(value) else value


def _but_curve(thing: object) -> Json:
    return {k: v for k, v in vars(thing).items() if k != "curve"}


def _kinematics(c: Calculation) -> Json:
    p = c.points
    return {
        **{name: getattr(c.motion, name) for name in ("phi_deg", "omega", "epsilon")},
        "points": {n: {"r": p.r[n], "v": p.v[n], "a": p.a[n]} for n in ("A", "B", "C")},
        "omega_AB": c.plane.omega,
        "epsilon_AB": c.plane.epsilon,
    }


def _forces(c: Calculation) -> Json:
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


def _shaft(c: Calculation) -> Json:
    assert c.supports
    s = c.supports
    return {
        **{name: getattr(s, name) for name in ("A1", "A2", "B1", "B2", "web")},
        "counterweights": [s.left_weight, s.right_weight],
        "sections": {x.name: {"sigma": x.sigma, "tau": x.tau, "equivalent": x.equivalent} for x in c.sections.values()},
    }
