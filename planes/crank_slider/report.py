"""The report of a calculation as a document, and its numbers as an object for programs."""

from __future__ import annotations

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.pages import Document, TableBlock, Writer
from planes.crank_slider.pages_balance import write_balance
from planes.crank_slider.pages_forces import write_forces
from planes.crank_slider.pages_kinematics import write_given, write_kinematics
from planes.crank_slider.pages_rod import write_rod, write_summary
from planes.crank_slider.pages_shaft import write_shaft
from planes.solving.tables import table
from planes.words import Lang
from planes.words.crank_slider_balance import BALANCE
from planes.words.crank_slider_forces import FORCES
from planes.words.crank_slider_report import GENERAL, KINEMATICS
from planes.words.crank_slider_rod import ROD
from planes.words.crank_slider_strength import STRENGTH

CHAPTERS = (write_given, write_kinematics, write_forces, write_balance, write_shaft, write_rod, write_summary)

WORDS = {**GENERAL, **KINEMATICS, **FORCES, **BALANCE, **STRENGTH, **ROD}


def document(c: Calculation, lang: Lang) -> Document:
    """The whole report in one language."""
    writer = Writer(lang, WORDS)
    for chapter in CHAPTERS:
        chapter(writer, c)
    title = c.scene.title.get(lang) or next(iter(c.scene.title.values()), c.scene.file)
    return Document(title, lang, tuple(writer.blocks))


def summary(c: Calculation, lang: Lang) -> str:
    """The checks and the torque as lines for a terminal."""
    writer = Writer(lang, WORDS)
    write_summary(writer, c)
    lines = [c.scene.title.get(lang, "")]
    lines += [f"{writer.say('l_mean')} M = {writer.number(c.work.mean)} {writer.say('u_Nm')}; "
              f"{writer.number(c.work.power / 1e3)} {writer.say('u_kW')}"]  # fmt: skip
    checked = [b for b in writer.blocks if isinstance(b, TableBlock)][:-1]  # the last lists the text's errors
    for block in checked:
        lines += table(writer.say("t_summary"), block.head, block.rows)
    return "\n".join(lines) + "\n"
