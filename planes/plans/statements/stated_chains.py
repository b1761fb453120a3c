"""The sides of an equation as two chains of vectors on its plan: known ones first, from mark to mark."""

from collections.abc import Callable
from itertools import pairwise, permutations

from planes.drafting.equations import Chain, Term
from planes.drafting.steps import Image, Similar
from planes.plans.statements.stated_vectors import StatedVectors
from planes.scene.vector_equations import Side, SideTerm, rate_vector_end_marks, term_end_marks
from planes.scene.vectors import Similarity
from planes.words.names import NO_MARK, NO_PLAN, POLE_LABEL, Mark, PlanId, vector_end_label

MOST_REORDERED_VECTORS = 5  # vectors that are tried in every order


class Chains:
    """Lays off the terms of equations one after another; ``stated`` are the terms by their names on the plan."""

    def __init__(self, vectors: StatedVectors) -> None:
        self.vectors = vectors
        self.draft = vectors.draft
        self.labels: dict[str, set[str]] = {}
        self.plan = NO_PLAN
        self.stated: dict[str, SideTerm] = {}

    def plan_and_chains(
        self, plan: PlanId, one: Side, two: Side, total: str | None
    ) -> tuple[PlanId, tuple[Chain, Chain]]:
        """The plan and both chains of an equation; in a closed polygon one open vector is drawn from the far end.
        Vectors that already lie end to end on a plan are read there."""
        lying = self._known_vectors_end_to_end(one + two)
        self.plan = lying[0].plan if lying else plan
        self.stated = {}
        self.labels.setdefault(self.plan, {POLE_LABEL})
        self.draft.draw_pole(self.plan)
        if lying:
            one, two = (tuple(sorted(side, key=self._place_among_lying_vectors(lying))) for side in (one, two))
        start = lying[0].label if lying else self._start_mark(one, two)
        return self.plan, self._both_chains(one, two, total, start)

    def _known_vectors_end_to_end(self, terms: Side) -> list[Mark]:
        """The start of the known vectors, if they lie end to end on one plan; else None."""
        known = [t for t in terms if not self.has_unknown_part(t)]
        spans = [self.vectors.states[t.name].span for t in known]
        if not 1 <= len(known) <= MOST_REORDERED_VECTORS or not all(spans) or any(t.times != 1 for t in known):
            return []
        for way in permutations(s for s in spans if s):
            if all(a[1] == b[0] for a, b in pairwise(way)):
                return [start for start, _ in way]
        return []

    def _place_among_lying_vectors(self, lying: list[Mark]) -> Callable[[SideTerm], int]:
        """The place of a vector among those; the others come after them."""

        def place(term: SideTerm) -> int:
            span = self.vectors.states[term.name].span
            if span and span[0] in lying:
                return lying.index(span[0])
            return len(lying)

        return place

    def _both_chains(self, one: Side, two: Side, total: str | None, start: str) -> tuple[Chain, Chain]:
        if one and two:
            first, second = (one, two) if not any(map(self.has_unknown_part, one)) else (two, one)
            first_chain = self.chain_of_side(first, start, self._end_mark(first, second, total))
            other = self.chain_of_side(second, start, first_chain[-1].end)
            if first is one:
                return (first_chain, other)
            return (other, first_chain)
        terms = tuple(sorted(one or two, key=self.has_unknown_part))
        if total:
            return self.chain_of_side(terms, start, self._end_mark(terms, (), total)), ()
        if len(terms) < 2 or not self.has_unknown_part(terms[-2]):
            return self.chain_of_side(terms, start, start), ()
        forth = self.chain_of_side(terms[:-1], start, self.unused_label(vector_end_label(terms[-2].name)))
        (back,) = self.chain_of_side((SideTerm(terms[-1].name, -terms[-1].times),), start, forth[-1].end)
        return forth, (back,)

    def has_unknown_part(self, term: SideTerm) -> bool:
        """Whether some part of a vector is still unknown."""
        return None in self.vectors.length_and_direction_names(term.name)

    def _start_mark(self, one: Side, two: Side) -> str:
        """The start mark of the sides: that of a vector drawn before, or by the names, else the pole."""
        for side in (s for s in (one, two) if s):
            first = side[0]
            span = self.vectors.states[first.name].span
            if span and span[0].plan == self.plan and first.times == 1:
                return span[0].label
            named = rate_vector_end_marks(first.name)
            if named and first.times == 1 and named[0] in self.labels[self.plan]:
                return named[0]
        return POLE_LABEL

    def _end_mark(self, first: Side, second: Side, total: str | None) -> str:
        """The end mark of both sides: by the name of their sum."""
        alone = next((s[0].name for s in (second, first) if len(s) == 1 and s[0].times == 1), None)
        named = rate_vector_end_marks(total or alone or first[-1].name)
        if named and named[1] not in self.labels[self.plan]:
            return self.unused_label(named[1])
        return self.unused_label(vector_end_label(sorted(first, key=self.has_unknown_part)[-1].name))

    def chain_of_side(self, side: Side, start: str, target: str) -> Chain:
        """The terms of a side, known ones first, from a mark to the target, or to the end of a vector drawn before."""
        terms = list[Term]()
        mark = start
        ordered = sorted(side, key=self.has_unknown_part)
        for i, stated in enumerate(ordered):
            if self.vectors.given_data(stated.name).like:  # drawn from the end of the others
                for before in terms:
                    self.draft.lay_off_known_vector(self.plan, before)
            terms.append(self.term_from_mark(stated, mark, target if i == len(ordered) - 1 else ""))
            mark = terms[-1].end
            self.stated[terms[-1].name] = stated
        return tuple(terms)

    def term_from_mark(self, stated: SideTerm, mark: str, target: str) -> Term:
        """A vector from a mark on: drawn before, divided or made similar there, laid off, or unknown."""
        v = self.vectors
        name = stated.name
        sign = 1 if stated.times > 0 else -1
        state = v.states[name]
        like = v.given_data(name).like
        span = state.span or (NO_MARK, NO_MARK)
        here = self.plan.mark(mark)
        if abs(stated.times) == 1 and here == span[0 if sign > 0 else 1]:
            return Term(name, mark, span[1 if sign > 0 else 0].label, drawn=True, sign=sign)
        end = target or self._end_label(stated, mark)
        if here == span[0]:
            self._draw_similar_vector(end, *span, complex(stated.times), f"ratio_{stated.term_text}")
            return Term(stated.term_text, mark, end, drawn=True)
        if like and not state.span and self._draws_by_similarity(stated, like, mark, end):
            return Term(name, mark, end, drawn=True)
        open_ = self.has_unknown_part(stated)
        length = state.length if open_ else v.length_name(name)
        direction = state.direction if open_ else v.direction_name(name)
        if length and abs(stated.times) != 1:
            length = self.draft.add_product(f"{stated.term_text}", abs(stated.times), **{length: 1})
        return Term(
            stated.term_text,
            mark,
            end,
            length,
            direction,
            self._line_of_action_text(direction),
            sign=sign,
            means=v.end_mark_meaning(name),
        )

    def _line_of_action_text(self, direction: str | None) -> str:
        """The line of action as written beneath; for a given angle the direction itself."""
        means = self.draft.steps[direction].means if direction else None
        if means:
            return means.written_action or direction or ""
        return direction or ""

    def _draws_by_similarity(self, stated: SideTerm, like: Similarity, mark: str, end: str) -> bool:
        """Whether a vector is drawn by similarity from a mark; otherwise its length and direction are found."""
        v = self.vectors
        name = stated.name
        v.used |= {like.of, *(like.shape or ())}
        drawn = stated.times == 1 and all(map(v.is_drawn, (like.of, *(like.shape or ()))))
        ends = v.end_marks(like.of) if drawn else (NO_MARK, NO_MARK)
        if drawn and like.shape:
            one, two = map(v.end_marks, like.shape)
            v.leaned |= dict.fromkeys(like.shape, name)
            self.draft.add_step(Image(*self.plan.marks(end, mark), one, two, ends))
            return True
        if drawn and ends[0] == self.plan.mark(mark):
            self._draw_similar_vector(end, *ends, like.ratio, f"ratio_{name}")
            return True
        v.transfer_by_similarity(name, like)
        return False

    def _draw_similar_vector(self, end: str, start: Mark, stop: Mark, ratio: complex, name: str) -> None:
        self.draft.add_step(Similar(self.plan.mark(end), start, stop, self.draft.add_given(name, ratio)))

    def _end_label(self, stated: SideTerm, mark: str) -> str:
        """The end mark of a vector: by its name, else a mark of the vector's name."""
        marks = term_end_marks(stated)
        return self.unused_label(marks[1] if marks and marks[0] == mark else vector_end_label(stated.name))

    def unused_label(self, label: str) -> str:
        """The label, with a prime while another mark has it."""
        taken = self.labels[self.plan]
        while label in taken:
            label += "′"
        taken.add(label)
        return label
