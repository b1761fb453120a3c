"""The report of a calculation as a document, and its numbers as an object for programs."""

from __future__ import annotations

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.pages import ChapterWriter
from planes.crank_slider.pages_balance import write_balance
from planes.crank_slider.pages_forces import write_forces
from planes.crank_slider.pages_kinematics import write_given, write_kinematics
from planes.crank_slider.pages_rod import write_rod, write_summary
from planes.crank_slider.pages_shaft import write_shaft
from planes.solving.document import Block, DocumentTable, Heading
from planes.solving.tables import table
from planes.words import Lang

CHAPTERS = (write_given, write_kinematics, write_forces, write_balance, write_shaft, write_rod, write_summary)


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
    lines = [c.scene.title.get(lang, "")]
    lines += [
        f"{writer.say('l_mean')} M = {writer.number(c.work.mean)} {writer.say('N·m')}; "
        f"{writer.number(c.work.power / 1e3)} {writer.say('kW')}"
    ]
    checked = [b for b in writer.blocks if isinstance(b, DocumentTable)][:-1]  # the last lists the text's errors
    for block in checked:
        lines += table(writer.say("t_summary"), block.rows[0], block.rows[1:])
    return "\n".join(lines) + "\n"
