"""Practices in the work of a class: their owners, and a row for each in the common table."""

from collections.abc import Iterator
from dataclasses import asdict, dataclass, field

from planes.check.handed_in import HandedSheet
from planes.check.report.class_rows import RIGHT_RANK, UNREADABLE_RANK, ClassRow
from planes.course.handed_out import HandedOut, Task, variant_in_file_name
from planes.lesson.handed_practice import HandedPractice, PracticeJudge, read_practice_file
from planes.words import Lang, Phrase, available_languages
from planes.words.errors import PlanesError, reporting_library_errors
from planes.words.records import Json


@dataclass
class PracticeSorter:
    """Judges practices by the scenes handed out: by the one that the name of the file or of the student means, else by
    the only one whose numbers fit the answers."""

    handed: HandedOut
    lang: Lang
    variant: str | None = None
    known: dict[tuple[Task, str | None], PracticeJudge] = field(default_factory=dict)

    def sheet_row(self, sheet: HandedSheet) -> tuple[ClassRow, Task | None]:
        """The row of a practice; a damaged or altered one, or one of another scene, says so."""
        try:
            with reporting_library_errors("check_broken", sheet.name):
                task, practice = self._judge_handed_practice(sheet)
        except PlanesError as error:
            return practice_row(sheet, "unreadable", error, self.lang), None
        result = Phrase("practice_told", **{name: str(value) for name, value in asdict(practice).items()})
        return practice_row(sheet, "confirmed", result, self.lang, asdict(practice)), task

    def _judge_handed_practice(self, sheet: HandedSheet) -> tuple[Task, HandedPractice]:
        tasks = [*self._candidate_tasks(sheet)]
        if len(tasks) == 1:
            return tasks[0], self._judge_of_task(sheet, tasks[0]).judge_file(str(sheet.file))
        fits = []
        for task in tasks:
            try:
                fits.append((task, self._judge_of_task(sheet, task).judge_file(str(sheet.file))))
            except PlanesError:
                continue
        if len(fits) != 1:
            raise PlanesError(Phrase("check_whose_is_it", file=sheet.name, suffix=sheet.file.suffix))
        return fits[0]

    def _candidate_tasks(self, sheet: HandedSheet) -> Iterator[Task]:
        """The scenes it may belong to."""
        name = str(read_practice_file(str(sheet.file))["name"])
        named = self.handed.task_of_file_name(sheet.file.stem) or self.handed.task_of_file_name(name)
        yield from (named,) if named else self.handed.tasks

    def _judge_of_task(self, sheet: HandedSheet, task: Task) -> PracticeJudge:
        from planes.lesson.told import SceneLesson

        variant = variant_in_file_name(sheet.file.stem, task.scene_in_variant(None).variants) or self.variant
        if (task, variant) not in self.known:
            self.known[task, variant] = PracticeJudge(SceneLesson.of(task.scene_in_variant(variant)))
        return self.known[task, variant]


def practice_row(
    sheet: HandedSheet, verdict: str, result: Phrase | PlanesError, lang: Lang, more: Json | None = None
) -> ClassRow:
    """The row of a practice: the student's name as entered, how many answers were right at once or why it is
    refused."""
    place = f"{sheet.file}: "
    more = more or {}
    said = {one: result.told(one).removeprefix(place) for one in {*available_languages("check"), lang}}
    whose = str(more.get("name", ""))
    return ClassRow(
        file=sheet.name,
        verdict=verdict,
        rank=RIGHT_RANK if verdict == "confirmed" else UNREADABLE_RANK,
        said=said[lang],
        whose=whose,
        object={
            "file": sheet.name,
            "verdict": verdict,
            **more,
            "sentence": {one: said[one] for one in available_languages("check")},
        },
    )
