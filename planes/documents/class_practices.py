"""Practices in the work of a class: their owners, and a row for each in the common table."""

from collections.abc import Iterator
from dataclasses import asdict, dataclass, field

from planes.check.handed_in import HandedSheet
from planes.check.report.class_rows import RIGHT, UNREADABLE, ClassRow
from planes.course.handed_out import HandedOut, Task, variant_named
from planes.lesson.handed_practice import HandedPractice, PracticeJudge, read_code
from planes.words import Lang, Phrase, langs
from planes.words.errors import PlanesError, guarded
from planes.words.records import Json


@dataclass
class PracticeSorter:
    """Judges practices by the scenes handed out: by the one that the name of the file or of the student means, else by
    the only one whose numbers fit the answers."""

    handed: HandedOut
    lang: Lang
    variant: str | None = None
    known: dict[tuple[Task, str | None], PracticeJudge] = field(default_factory=dict)

    def row(self, sheet: HandedSheet) -> tuple[ClassRow, Task | None]:
        """The row of a practice; a damaged or altered one, or one of another scene, says so."""
        try:
            with guarded("check_broken", sheet.name):
                task, practice = self._judged(sheet)
        except PlanesError as error:
            return practice_row(sheet, "unreadable", error, self.lang), None
        result = Phrase("practice_told", **{name: str(value) for name, value in asdict(practice).items()})
        return practice_row(sheet, "confirmed", result, self.lang, asdict(practice)), task

    def _judged(self, sheet: HandedSheet) -> tuple[Task, HandedPractice]:
        tasks = [*self._tasks(sheet)]
        if len(tasks) == 1:
            return tasks[0], self._judge(sheet, tasks[0]).judged(str(sheet.file))
        fits = []
        for task in tasks:
            try:
                fits.append((task, self._judge(sheet, task).judged(str(sheet.file))))
            except PlanesError:
                continue
        if len(fits) != 1:
            raise PlanesError(Phrase("check_whose_is_it", file=sheet.name, suffix=sheet.file.suffix))
        return fits[0]

    def _tasks(self, sheet: HandedSheet) -> Iterator[Task]:
        """The scenes it may belong to."""
        name = str(read_code(str(sheet.file))["name"])
        named = self.handed.named(sheet.file.stem) or self.handed.named(name)
        yield from (named,) if named else self.handed.tasks

    def _judge(self, sheet: HandedSheet, task: Task) -> PracticeJudge:
        from planes.lesson.told import Told

        variant = variant_named(sheet.file.stem, task.variant(None).variants) or self.variant
        if (task, variant) not in self.known:
            self.known[task, variant] = PracticeJudge(Told.of(task.variant(variant)))
        return self.known[task, variant]


def practice_row(
    sheet: HandedSheet, verdict: str, result: Phrase | PlanesError, lang: Lang, more: Json | None = None
) -> ClassRow:
    """The row of a practice: the student's name as entered, how many answers were right at once or why it is
    refused."""
    place, more = f"{sheet.file}: ", more or {}
    said = {one: result.told(one).removeprefix(place) for one in {*langs("check"), lang}}
    whose = str(more.get("name", ""))
    return ClassRow(
        file=sheet.name,
        verdict=verdict,
        rank=RIGHT if verdict == "confirmed" else UNREADABLE,
        said=said[lang],
        whose=whose,
        object={"file": sheet.name, "verdict": verdict, **more, "sentence": {one: said[one] for one in langs("check")}},
    )
