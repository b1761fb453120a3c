"""The outcome of a check: the judged work as an object for programs and as text for people."""

from dataclasses import dataclass, field, replace

from planes.check.grading.evidence import (
    LEAST_VERDICT_PROBABILITY,
    MOST_CHANCE_OF_RANDOM_LENGTHS,
    chance_of_random_lengths,
)
from planes.check.grading.figures import WrittenNumber, name_suggestions, read_results, segment_figures
from planes.check.grading.grading import Grading, grade
from planes.check.grading.judging import Judgement
from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import Asked, PreparedPlan, mistake_variants, prepare
from planes.check.grading.readable import doubtful_marks_question, other_plan_message, unreadable_reason
from planes.check.grading.remedies import phrase_for_reader, phrase_with_remedy
from planes.check.grading.sign_faults import SignFault
from planes.check.grading.signs import STANDARD_SCALE_DIFFERENCE, grading_with_swapped_letters, plan_scale_fault
from planes.check.grading.ways import mistakes_before_results, true_plan_with_errors
from planes.check.grading.written_numbers import Account, judge_figures
from planes.plans.quantities import quantities_by_name
from planes.words import Phrase, Written, sentences_with_prefix
from planes.words.errors import PlanesError
from planes.words.lettering import plan_phrase
from planes.words.names import POLE_LABEL, NamesByName
from planes.words.records import Described

# a mark at this distance, and half its length, from the constructed point is not called right if errors may be as large
MOST_RIGHT_DEVIATION_MM = 4.0
# of 339 pictures called right 332 were; of 99 right as far as seen 94 had no mistake, or one where they say so
MOST_CHANCE_OF_RIGHT_PICTURE = {"right": 0.98, "right_as_seen": 0.95}
EXIT_STATUS_OF_VERDICT = {"confirmed": 0, "right": 0, "right_as_seen": 3, "wrong": 1, "unreadable": 2}  # best first


@dataclass
class Outcome(Described):
    """All findings in one drawing."""

    bench: PreparedPlan
    paper: ReadPaper
    notes: list[Phrase]
    grading: Grading | None = None
    segments: Account | None = None
    results: Account | None = None
    unreadable: Phrase | None = None
    unknown: NamesByName = field(default_factory=dict)  # unknown names in tables, with the nearest known name
    missing: list[str] = field(default_factory=list)  # results that were asked for and are missing
    unread: list[str] = field(default_factory=list)  # results in unknown units

    def __repr__(self) -> str:
        return f"<Outcome {self.verdict}: {self.sentence.told()}>"

    @property
    def verdict(self) -> str:
        """right, wrong or unreadable; right_as_seen if some of the marks were not verified."""
        if self.unreadable:
            return "unreadable"
        if self.wrong:
            return "wrong"
        if self.unseen:
            return "right_as_seen"
        return "right"

    @property
    def wrong(self) -> Grading | SignFault | Account | None:
        """The part that is wrong: the drawing, its letters and arrows, otherwise the lengths or the results."""
        drawn = None if self._is_likelier_right else self.grading
        every = (drawn, *self.paper.signs, self.segments, self.results)
        return next((one for one in every if one and one.fault), None)

    @property
    def _is_likelier_right(self) -> bool:
        """Whether the drawing is more likely right than wrong, though part of it would be called wrong."""
        return bool(self.grading and self.grading.fault and self.grading.chance_wrong < LEAST_VERDICT_PROBABILITY)

    @property
    def chance(self) -> float | None:
        """The probability that the verdict is true; None without one."""
        if self.unreadable:
            return None
        every = [t.first_wrong_figure.chance_wrong for t in (self.segments, self.results) if t and t.first_wrong_figure]
        every += [one.chance_wrong for one in self.paper.signs]
        wrong = max(self.grading.chance_wrong if self.grading else 0.0, *every, 0.0)
        if self.verdict == "wrong":
            return wrong
        return min(1 - wrong, MOST_CHANCE_OF_RIGHT_PICTURE[self.verdict] if self.paper.picture else 1.0)

    @property
    def cause(self) -> float:
        """The probability of the named cause, once the work is wrong."""
        judged = self.wrong.judgement if isinstance(self.wrong, Grading) else self.wrong
        if isinstance(judged, Judgement | Account) and judged.named:
            return judged.cause
        return 1.0

    @property
    def first_wrong(self) -> str | None:
        """The mark (or segment, or result) where the work goes wrong."""
        return self.wrong.first_wrong if self.wrong else None

    @property
    def mistake(self) -> str | None:
        """The named mistake; None if none explains the work best."""
        said = self.sentence.key
        return next((name for name in sentences_with_prefix("mistake_", "en") if said == f"mistake_{name}"), None)

    @property
    def runner_up(self) -> str | None:
        """The second most likely mistake."""
        if self.wrong and not self.unreadable:
            return self.wrong.runner_up
        return None

    @property
    def sentence(self) -> Phrase:
        """The error and its correction."""
        wrong = self.wrong.fault if self.wrong else None
        return self.unreadable or wrong or self.right_sentence(self._unjudged_notes())

    def _unjudged_notes(self) -> tuple[Phrase, ...]:
        """Notes on marks not judged, parts missing, and unknown names."""
        known = tuple(name for name in self.unseen if name not in self.unknown and name not in self.missing)
        left = {"judged": known, "given": tuple(self.missing), "known": name_suggestions(self.unknown)}
        return tuple(Phrase(f"check_not_{key}", names=names) for key, names in left.items() if names)

    @property
    def unseen(self) -> list[str]:
        """Marks of the plan that were not verified, or that a mistake explains as well, and unknown names and columns.

        Marks far from their constructed point count too, if the steps before them hardly determine that point.
        """
        if self.unreadable:
            return []
        left = [*self.unread, *self.unknown, *self.missing, *self.paper.left]
        left[:0] = [s.figure.name for s in self.results.scored if s.verdict == "too_near"] if self.results else ()
        if self.grading is None:
            return left
        misses = {} if self.wrong else self.grading.judgement.misses
        far = (
            m.label
            for m, miss in misses.items()
            if abs(miss.off) > max(MOST_RIGHT_DEVIATION_MM, self.grading.laid_off_length_mm(m) / 2)
        )
        untold = () if self.wrong else self.paper.untold
        polygon = self.grading.rebuilt
        closing = polygon.unseen_long_vectors({POLE_LABEL: 0j, **self.bench.true_marks}) if polygon else ()
        hidden = (n for n in self.grading.unverified_marks if n not in self.paper.named)
        doubted = [self.grading.first_wrong] if self._is_likelier_right and not self.wrong else []
        return list(dict.fromkeys(filter(None, [*doubted, *hidden, *untold, *closing, *far, *left])))

    def text_as_typed(self, text: str) -> str:
        """A text about the work, with names as people type them."""
        scored = (s.figure.name for t in (self.segments, self.results) if t for s in t.scored)
        return self.bench.naming.retell_in_typed_names(text, {*(m.label for m in self.bench.marks), *scored})

    @property
    def has_only_results(self) -> bool:
        """Whether there are results but no drawing."""
        return bool(self.results) and not (self.grading or self.segments)

    def right_sentence(self, left: tuple[Phrase, ...]) -> Phrase:
        """The sentence for a right drawing, or for right results alone; ``left`` lists what is not judged."""
        key = "check_right_as_seen" if left else "check_right_results" if self.has_only_results else "check_right"
        what = Phrase("check_results") if self.has_only_results else plan_phrase(self.bench.plan)
        return Phrase(key, plan=what, left=left)


def check(asked: Asked, paper: ReadPaper) -> Outcome:
    """Checks one paper. :class:`PlanesError` if the scene or the question is wrong."""
    bench = prepare(asked)
    bench = bench if asked.mu else bench.at_scale(paper.mu)
    out = Outcome(bench, paper, list(paper.notes))
    try:
        _judge_paper(out)
        if paper.mu and not asked.mu and not (out.mistake or paper.signs):
            out = _outcome_at_common_scale(asked, out) or out
    except PlanesError as error:
        out.unreadable = (
            error.phrase if isinstance(error.phrase, Phrase) else phrase_with_remedy("check_nothing_read", names="")
        )
    return out


def _outcome_at_common_scale(asked: Asked, out: Outcome) -> Outcome | None:
    """The outcome at the scale common to all vectors, if the drawing is right at that scale but not at its sheet's."""
    free = grade(prepare(asked), out.paper) if out.paper.spots and out.verdict in ("wrong", "unreadable") else None
    if (
        free is None
        or abs(free.mu / out.bench.said_mu - 1) <= STANDARD_SCALE_DIFFERENCE
        or free.fault
        or unreadable_reason(free)
    ):
        return None
    paper = replace(out.paper, signs=[plan_scale_fault(out.bench, free.mu)])
    scaled = Outcome(out.bench.at_scale(free.mu), paper, list(paper.notes))
    _judge_paper(scaled)
    if scaled.unreadable or (scaled.grading and scaled.grading.fault):
        return None
    return scaled


def _judge_paper(out: Outcome) -> None:
    bench = out.bench
    paper = out.paper
    if other := other_plan_message(bench, paper):
        out.unreadable = other
        return
    if paper.scale_mark and all(n.key != "check_scale_vector" for n in out.notes):
        out.notes.append(Phrase("check_scale_vector", mark=paper.scale_mark))
    if paper.spots:
        out.grading = grade(bench, paper)
    if out.grading and (mended := grading_with_swapped_letters(bench, paper, out.grading)):
        out.grading = mended[0]
        paper.signs = [mended[1]]
    if out.grading:
        out.unreadable = unreadable_reason(out.grading, paper.named)
        out.notes += out.grading.notes + _scale_notes(out)
    if paper.segments:
        _judge_segments(out)
    if paper.results:
        _judge_results(out)
    if not (out.grading or (out.segments and out.segments.scored) or (out.results and out.results.scored)):
        out.unreadable = _nothing_read_reason(out)
    elif not paper.pole_told and out.grading and not out.grading.is_certain_without_pole:
        out.unreadable = out.unreadable or phrase_with_remedy("check_unsure", "pole")
    elif out.grading:
        out.unreadable = out.unreadable or doubtful_marks_question(out.grading)


def _nothing_read_reason(out: Outcome) -> Phrase:
    """Why no mark could be read; a report offers corrections of marks only where it has a picture."""
    said = out.paper.reason or phrase_with_remedy(
        "check_nothing_read", names=", ".join(m.label for m in out.bench.marks)
    )
    return said if out.paper.picture else phrase_for_reader("table", said)


def _scale_notes(out: Outcome) -> list[Phrase]:
    g = out.grading
    bench = out.bench
    if g is None or g.said_mu:
        return []
    mu_text = bench.written_scale(float(f"{g.mu:.3g}"))
    said = bench.asked.scene.mu.get(bench.kind)
    return [
        Phrase("check_mu", mu=mu_text, said=bench.written_scale(said)) if said else Phrase("check_mu_found", mu=mu_text)
    ]


def _judge_segments(out: Outcome) -> None:
    bench = out.bench
    read = segment_figures(bench, out.paper.segments)
    out.notes += read.notes
    out.unknown |= read.unknown
    if not (figures := read.figures):
        return
    tried = []
    for k, mu in enumerate(_segment_scales(bench, figures)):
        free = true_plan_with_errors(bench, [], mu, {})
        reckoned = judge_figures(
            figures, free, None, mistake_variants(bench, free.taken, mu), bench.asked.skill.ruler_mm
        )
        wrong = sum(s.verdict == "wrong" for s in reckoned.scored) + (
            reckoned.first_wrong_figure is not None and not reckoned.named
        )
        tried.append((wrong, k > 0, reckoned))
    _, rescaled, out.segments = min(tried, key=lambda one: one[:2])
    if out.segments.first_wrong_figure is None and not out.grading:
        out.unreadable = _too_few_lengths_reason(out.segments, rescaled)


def _too_few_lengths_reason(lengths: Account, free: bool) -> Phrase | None:
    """None if right lengths prove the plan right, otherwise a sentence that they are too few or too short."""
    longest = max(s.figure.given for s in lengths.scored)
    shares = (6 * s.sigma / longest if longest else 1.0 for s in lengths.scored)
    if chance_of_random_lengths(shares, free) <= MOST_CHANCE_OF_RANDOM_LENGTHS:
        return None
    return Phrase("check_by_chance", count=len(lengths.scored), size=Written(f"{longest:.1f}"))


def _segment_scales(bench: PreparedPlan, figures: list[WrittenNumber]) -> list[float]:
    """The stated scale and those implied by the lengths."""
    scales = [bench.said_mu]
    free = true_plan_with_errors(bench, [], bench.said_mu, {})
    for f in () if bench.asked.mu else figures:
        true = float(abs(f.read(free.things)[0]))
        mu = bench.said_mu * f.given / true if true > 5 else 0.0
        if mu > 0 and all(abs(mu / m - 1) > 0.01 for m in scales):
            scales.append(mu)
    return scales[:6]


def _judge_results(out: Outcome) -> None:
    bench = out.bench
    known = quantities_by_name(bench.plans)
    asked = () if out.paper.spots or out.paper.segments else bench.asked.answers or bench.asked.scene.find or ()
    read = read_results(known, bench.naming.name_finder(known, poles=False), out.paper.results, asked)
    out.notes += read.notes
    out.unknown |= read.unknown
    out.missing += [name for name in read.missing if name not in (*out.paper.left, *read.strange)]
    out.unread += read.strange
    if not (figures := read.figures):
        return
    wanted = [n for q in known.values() for n in q.needed_names if any(f.name == q.name for f in figures)]
    mu = out.grading.mu if out.grading else bench.said_mu
    free = true_plan_with_errors(bench, wanted, mu, {})
    own = true_plan_with_errors(bench, wanted, mu, dict(out.grading.hand.taken)) if out.grading else None
    out.results = judge_figures(
        figures, free, own, [] if own else mistakes_before_results(bench, free, {f.plan for f in figures})
    )
