"""The sides of an equation as two chains of vectors on its plan: known ones first, from mark to mark."""

from collections.abc import Callable
from itertools import pairwise, permutations

from planes.drafting.equations import Term
from planes.drafting.steps import Image, Similar
from planes.plans.statements.stated_vectors import StatedVectors
from planes.scene.vector_equations import Side, SideTerm, ends, span
from planes.scene.vectors import Similarity
from planes.words.names import POLE, at, end_of, label_of, plan_of

Chain = tuple[Term, ...]
MOST_LYING = 5  # vectors that are tried in every order


class Chains:
    """Lays off the terms of equations one after another; ``stated`` are the terms by their names on the plan."""

    def __init__(self, vectors: StatedVectors) -> None:
        self.vectors, self.draft = vectors, vectors.draft
        self.labels: dict[str, set[str]] = {}
        self.plan = ""
        self.stated: dict[str, SideTerm] = {}

    def of(self, plan: str, one: Side, two: Side, total: str | None) -> tuple[str, tuple[Chain, Chain]]:
        """The plan and both chains of an equation; in a closed polygon one open vector is drawn from the far end.
        Vectors that already lie end to end on a plan are read there."""
        lying = self._lying(one + two)
        self.plan, self.stated = plan_of(lying[0]) if lying else plan, {}
        self.labels.setdefault(self.plan, {POLE})
        self.draft.pole(self.plan)
        if lying:
            one, two = (tuple(sorted(side, key=self._place(lying))) for side in (one, two))
        start = label_of(lying[0]) if lying else self._start(one, two)
        return self.plan, self._sides(one, two, total, start)

    def _lying(self, terms: Side) -> list[str]:
        """The start of the known vectors, if they lie end to end on one plan; else None."""
        known = [t for t in terms if not self.open(t)]
        spans = [self.vectors.states[t.name].span for t in known]
        if not 1 <= len(known) <= MOST_LYING or not all(spans) or any(t.times != 1 for t in known):
            return []
        for way in permutations(s for s in spans if s):
            if all(a[1] == b[0] for a, b in pairwise(way)):
                return [start for start, _ in way]
        return []

    def _place(self, lying: list[str]) -> Callable[[SideTerm], int]:
        """The place of a vector among those; the others come after them."""

        def place(term: SideTerm) -> int:
            span = self.vectors.states[term.name].span
            return lying.index(span[0]) if span and span[0] in lying else len(lying)

        return place

    def _sides(self, one: Side, two: Side, total: str | None, start: str) -> tuple[Chain, Chain]:
        if one and two:
            first, second = (one, two) if not any(map(self.open, one)) else (two, one)
            first_chain = self.chain(first, start, self._target(first, second, total))
            other = self.chain(second, start, first_chain[-1].end)
            return (first_chain, other) if first is one else (other, first_chain)
        terms = tuple(sorted(one or two, key=self.open))
        if total:
            return self.chain(terms, start, self._target(terms, (), total)), ()
        if len(terms) < 2 or not self.open(terms[-2]):
            return self.chain(terms, start, start), ()
        forth = self.chain(terms[:-1], start, self.fresh(end_of(terms[-2].name)))
        (back,) = self.chain((SideTerm(terms[-1].name, -terms[-1].times),), start, forth[-1].end)
        return forth, (back,)

    def open(self, term: SideTerm) -> bool:
        """Whether some part of a vector is still unknown."""
        return None in self.vectors.parts(term.name)

    def _start(self, one: Side, two: Side) -> str:
        """The start mark of the sides: that of a vector drawn before, or by the names, else the pole."""
        for side in (s for s in (one, two) if s):
            first = side[0]
            span = self.vectors.states[first.name].span
            if span and span[0].startswith(at(self.plan, "")) and first.times == 1:
                return label_of(span[0])
            named = ends(first.name)
            if named and first.times == 1 and named[0] in self.labels[self.plan]:
                return named[0]
        return POLE

    def _target(self, first: Side, second: Side, total: str | None) -> str:
        """The end mark of both sides: by the name of their sum."""
        alone = next((s[0].name for s in (second, first) if len(s) == 1 and s[0].times == 1), None)
        named = ends(total or alone or first[-1].name)
        if named and named[1] not in self.labels[self.plan]:
            return self.fresh(named[1])
        return self.fresh(end_of(sorted(first, key=self.open)[-1].name))

    def chain(self, side: Side, start: str, target: str) -> Chain:
        """The terms of a side, known ones first, from a mark to the target, or to the end of a vector drawn before."""
        terms, mark = list[Term](), start
        ordered = sorted(side, key=self.open)
        for i, stated in enumerate(ordered):
            if self.vectors.given(stated.name).like:  # drawn from the end of the others
                for before in terms:
                    self.draft.lay(self.plan, before)
            terms.append(self.term(stated, mark, target if i == len(ordered) - 1 else ""))
            mark = terms[-1].end
            self.stated[terms[-1].name] = stated
        return tuple(terms)

    def term(self, stated: SideTerm, mark: str, target: str) -> Term:
        """A vector from a mark on: drawn before, divided or made similar there, laid off, or unknown."""
        v, name, sign = self.vectors, stated.name, 1 if stated.times > 0 else -1
        state, like = v.states[name], v.given(name).like
        span = state.span or ("", "")
        here = at(self.plan, mark)
        if abs(stated.times) == 1 and here == span[0 if sign > 0 else 1]:
            return Term(name, mark, label_of(span[1 if sign > 0 else 0]), drawn=True, sign=sign)
        end = target or self._label(stated, mark)
        if here == span[0]:
            self._similar(end, *span, complex(stated.times), f"ratio_{stated.text}")
            return Term(stated.text, mark, end, drawn=True)
        if like and not state.span and self._alike(stated, like, mark, end):
            return Term(name, mark, end, drawn=True)
        open_ = self.open(stated)
        length = state.length if open_ else v.length(name)
        direction = state.direction if open_ else v.direction(name)
        if length and abs(stated.times) != 1:
            length = self.draft.product(f"{stated.text}", abs(stated.times), **{length: 1})
        return Term(
            stated.text, mark, end, length, direction, self._action(direction), sign=sign, means=v.mark_of(name)
        )

    def _action(self, direction: str | None) -> str:
        """The line of action as written beneath; for a given angle the direction itself."""
        means = self.draft.steps[direction].means if direction else None
        return (means.action or direction or "") if means else direction or ""

    def _alike(self, stated: SideTerm, like: Similarity, mark: str, end: str) -> bool:
        """Whether a vector is drawn by similarity from a mark; otherwise its length and direction are found."""
        v, name = self.vectors, stated.name
        v.used |= {like.of, *(like.shape or ())}
        drawn = stated.times == 1 and all(map(v.spanned, (like.of, *(like.shape or ()))))
        ends = v.span(like.of) if drawn else ("", "")
        if drawn and like.shape:
            one, two = map(v.span, like.shape)
            v.leaned |= dict.fromkeys(like.shape, name)
            self.draft.step(Image(at(self.plan, end), at(self.plan, mark), one, two, ends))
            return True
        if drawn and ends[0] == at(self.plan, mark):
            self._similar(end, *ends, like.ratio, f"ratio_{name}")
            return True
        v.transfer(name, like)
        return False

    def _similar(self, end: str, start: str, stop: str, ratio: complex, name: str) -> None:
        self.draft.step(Similar(at(self.plan, end), start, stop, self.draft.give(name, ratio)))

    def _label(self, stated: SideTerm, mark: str) -> str:
        """The end mark of a vector: by its name, else a mark of the vector's name."""
        marks = span(stated)
        return self.fresh(marks[1] if marks and marks[0] == mark else end_of(stated.name))

    def fresh(self, label: str) -> str:
        """The label, with a prime while another mark has it."""
        taken = self.labels[self.plan]
        while label in taken:
            label += "′"
        taken.add(label)
        return label
