"""Every scene of a folder in every variant: the results, the agreement of the two balancing loads, and the failures."""

from collections import defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path

from planes.course.ledger import Sentences
from planes.course.reading import scene_files_in
from planes.diagrams.summary import summarise_cycle
from planes.plans import Plans
from planes.plans.curves import FULL_TURN_DEG
from planes.scene import Scene, load
from planes.solving import Position, drive_position_in_words, solve
from planes.solving.tables import relative_difference
from planes.solving.text_tables import aligned_table
from planes.words import Lang, Phrase, say, with_decimal_sign
from planes.words.errors import PlanesError, reporting_library_errors
from planes.words.frozen import frozen, replace
from planes.words.records import Json

LOAD_AGREEMENT_SHARE = 1e-9  # relative: allowed difference of the two balancing loads


@frozen
class SurveyRow:
    """One variant of one scene. ``balancing`` and ``lever`` are N·m (N for a sliding driver), None without forces;
    ``remarks`` are sentences: missing data, where it does not assemble, why it could not be solved."""

    scene: str
    variant: str
    drive: str
    solved: bool
    balancing: float | None = None
    lever: float | None = None
    remarks: Sentences = ()

    @property
    def difference(self) -> float | None:
        """The difference of the two loads, relative to the larger."""
        if self.balancing is None or self.lever is None:
            return None
        return relative_difference(self.balancing, self.lever)

    @property
    def is_right(self) -> bool:
        """Whether it is solved and the loads agree."""
        return self.solved and (self.difference is None or self.difference <= LOAD_AGREEMENT_SHARE)

    def json(self) -> Json:
        """The row as a JSON object."""
        plain = {key: getattr(self, key) for key in ("solved", "balancing", "lever", "difference")}
        return {"scene": self.scene, "variant": self.variant or None, **plain, "remarks": list(self.remarks)}


def scene_files_of(folder: str | Path) -> list[Path]:
    """The scene files of a folder; an error if there are none."""
    files = scene_files_in(Path(folder))
    if not files:
        raise PlanesError(Phrase("survey_empty", folder=str(folder)))
    return files


def survey_rows(task: tuple[str, Lang, str | None]) -> tuple[SurveyRow, ...]:
    """The rows of one file (path, language, the one variant requested): its variants, or the scene itself."""
    path, lang, only = task
    name = Path(path).stem
    try:
        with reporting_library_errors("check_broken", path):  # one scene must not stop the others
            variants = load(path).variants
            if only and only not in variants:
                return ()
            return tuple(
                _survey_row(load(path, v), name, v or "", lang) for v in ([only] if only else variants or (None,))
            )
    except PlanesError as error:
        return (SurveyRow(name, "", "", False, remarks=(error.told(lang),)),)


def _survey_row(scene: Scene, name: str, variant: str, lang: Lang) -> SurveyRow:
    """One variant solved."""
    missing = tuple(text for text in (scene.missing.get(lang, ""), *(d.told(lang) for d in scene.doubts)) if text)
    if scene.mechanism is None:
        solve(scene, lang=lang)
        return SurveyRow(name, variant, "", True, remarks=missing)
    drive = scene.mechanism.drive
    at = f"{'φ' if drive.rotates else 's'} = {drive_position_in_words(drive.position, drive.kind, lang)}"
    solved = solve(scene, lang=lang)
    if not solved.positions:
        return SurveyRow(name, variant, at, False, remarks=(*missing, solved.failed[0]["error"]))
    remarks = (*missing, *_incomplete_turn_sentence(scene, solved.plans, lang))
    balancing, lever = _balancing_loads(solved.positions[0], solved.plans)
    row = SurveyRow(name, variant, at, True, balancing, lever, remarks)
    apart = Phrase("survey_apart", balancing=row.balancing, lever=row.lever, most=LOAD_AGREEMENT_SHARE)
    if row.is_right:
        return row
    return replace(row, remarks=(*remarks, apart.told(lang)))


def _balancing_loads(position: Position, plans: Plans) -> tuple[float | None, float | None]:
    """The balancing load by the force plans and by the lever, None where there are no forces at all."""
    forces = any(abs(complex(position.drawing[r.end] - position.drawing[r.start])) for r in plans.reactions.values())
    if not forces:
        return None, None
    return float(position.drawing[plans.balancing]), float(position.drawing[plans.zhukovsky])


def _incomplete_turn_sentence(scene: Scene, plans: Plans, lang: Lang) -> Iterator[str]:
    """A sentence where a turning driver cannot go all the way round."""
    drive = plans.drive
    if not drive.rotates:
        return
    ranges = summarise_cycle(scene, plans).grid.assembly_ranges
    starts = [*(low for low, _ in ranges[1:]), ranges[0][0] + FULL_TURN_DEG]
    pairs = zip([high for _, high in ranges], starts, strict=True)
    gaps = [(high % FULL_TURN_DEG, high % FULL_TURN_DEG + low - high) for high, low in pairs if low > high + 1e-9]
    if not gaps:
        return
    angles = ([with_decimal_sign(f"{x:.1f}".removesuffix(".0"), lang) + "°" for x in gap] for gap in gaps)
    said = tuple(Phrase("survey_gap", low=low, high=high) for low, high in angles)
    yield say("survey_no_turn", lang, link=drive.link, ranges=said)


def survey_report(lines: Sequence[SurveyRow], lang: Lang) -> str:
    """A line for every variant, then the remarks, then the count."""
    yes_or_no = {True: say("survey_yes", lang), False: say("survey_no", lang)}
    rows = []
    for x in lines:
        loads = (f"{load:.6g}" if load is not None else "—" for load in (x.balancing, x.lever))
        apart = "—" if x.difference is None else f"{x.difference:.1e}"
        numbers = (with_decimal_sign(cell, lang) for cell in (x.drive, *loads, apart))
        rows.append([x.scene, x.variant, next(numbers), yes_or_no[x.solved], *numbers])
    heads = ("scene", "variant", "drive", "solved", "balancing", "lever", "difference")
    report_lines = aligned_table(say("survey_title", lang), [say(f"survey_{k}", lang) for k in heads], rows)
    said = [
        f"{scene} ({', '.join(v)}): {text}" if any(v) else f"{scene}: {text}"
        for (scene, text), v in remarks_with_variants(lines).items()
    ]
    if said:
        report_lines += ["", say("survey_exceptions", lang), *said]
    worst = max((x.difference for x in lines if x.difference is not None), default=0.0)
    counts = {"solved": sum(x.solved for x in lines), "forces": sum(x.balancing is not None for x in lines)}
    counts |= {"count": len(lines), "said": len(said)}
    count = say("survey_count", lang, **counts, worst=with_decimal_sign(f"{worst:.1e}", lang))
    return "\n".join([*report_lines, "", count]).lstrip("\n") + "\n"


def remarks_with_variants(lines: Sequence[SurveyRow]) -> dict[tuple[str, str], list[str]]:
    """The sentences, each with its variants."""
    variants_of = defaultdict(list)
    for line in lines:
        for text in line.remarks:
            variants_of[(line.scene, text)].append(line.variant)
    return variants_of
