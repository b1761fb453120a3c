"""What a scene of vectors states, as one program: its equations in whatever order they can be drawn, and their unit."""

import re
from collections.abc import Iterable
from dataclasses import dataclass, field, replace

from planes.drafting.draft import Draft
from planes.drafting.equations import Equation, Term, unknown
from planes.scene import Scene
from planes.scene.vectors import Sides, ends, read_equation
from planes.words import Phrase, Told, table
from planes.words.errors import EquationError, PlanFailure, SceneError, choices
from planes.words.lettering import name_in_words
from planes.words.names import POLE, at, label_of, mu_of

PLAN = "vectors"
_LETTERS = {"position": r"[rl]_", "velocity": "v_", "acceleration": "a_", "force": r"[FRGNTPQΦФ][_\d]"}


@dataclass
class VectorPlan:
    """The equations of a scene as one program; ``spans`` are the marks each vector runs between."""

    scene: Scene
    draft: Draft = field(default_factory=Draft)
    spans: dict[str, tuple[str, str]] = field(default_factory=dict)
    known: dict[str, tuple[str | None, str | None]] = field(default_factory=dict)  # name -> (length, direction)
    choices: list[tuple[str, tuple[str, ...]]] = field(default_factory=list)  # given ±1, whose directions it decides
    solved: dict[str, tuple[int, str]] = field(default_factory=dict)  # mark -> number and text of its equation
    labels: set[str] = field(default_factory=lambda: {POLE})

    def error(self, index: int, phrase: Told) -> SceneError:
        return SceneError(phrase, self.scene.file, self.scene.equation_lines[index])

    def build(self) -> None:
        """Draw every equation, each as soon as it has but two unknowns."""
        self.draft.give(mu_of(PLAN), 1.0)
        self.draft.pole(PLAN)
        for name, given in self.scene.vectors.items():
            length = None if given.value is None else self.draft.give(f"|{name}|", given.value)
            direction = None if given.direction_deg is None else self.draft.aim(f"∠{name}", given.direction_deg)
            self.known[name] = length, direction
        left = {i: self._read(i, text) for i, text in enumerate(self.scene.equations)}
        while left:
            done = self._solve_one(left) or self._solve_pair(left)
            if not done:
                index, sides = next(iter(left.items()))
                listed = tuple(self.unknowns(sides)) or Phrase("none")
                raise self.error(index, Phrase("unknowns_are", text=str(sides), listed=listed))
            for index in done:
                del left[index]
        self._check_used()

    def _check_used(self) -> None:
        """Whatever is said of a vector must have an effect."""
        chosen = {name for _, names in self.choices for name in names}
        for name, given in self.scene.vectors.items():
            key = "vector_idle" if name not in self.spans else "near_idle"
            if key == "vector_idle" or (given.near_deg is not None and name not in chosen):
                line = self.scene.where.get(("vectors", name))
                raise SceneError(Phrase(key, name=name), self.scene.file, line)

    def _read(self, index: int, text: str) -> Sides:
        for name in re.findall(r"[^\W\d][\w^'′]*", text):
            if name not in self.known:
                valid = choices(name, self.known)
                raise self.error(index, Phrase("no_vector", text=text, name=name, valid=valid))
        try:
            return read_equation(text)
        except EquationError as error:
            raise self.error(index, error.phrase) from None

    def unknowns(self, sides: Sides) -> list[Phrase]:
        """What the equation does not know, in words."""
        found = []
        for name in sides.left + sides.right:
            parts = zip(("length", "direction"), self.known[name], strict=True)
            found += [unknown(name, part) for part, given in parts if given is None]
        return found

    def _solve_one(self, left: dict[int, Sides]) -> list[int]:
        for index, sides in left.items():
            if len(self.unknowns(sides)) == 2:
                self._draw(index, sides.text, sides.left, sides.right)
                return [index]
        return []

    def _solve_pair(self, left: dict[int, Sides]) -> list[int]:
        """Two equations with one unknown vector alone on a side each: their other sides are equal."""
        for i, one in left.items():
            for j, two in left.items():
                if i < j and len(one.left) == 1 and one.left == two.left:
                    both = Sides(f"{one.text}, {two.text}", one.right, two.right)
                    if len(self.unknowns(both)) == 2:
                        self._draw(i, both.text, one.right, two.right, one.left[0])
                        return [i, j]
        return []

    def failure(self, failure: PlanFailure) -> SceneError:
        """What an equation cannot be drawn for, in words of vectors."""
        index, text = self.solved.get(str(failure.numbers.get("makes")), (0, self.scene.equations[0]))
        key = f"vectors_{failure.reason}"
        if key not in table("en"):
            return self.error(index, Phrase("about", what=text, why=failure.phrase))
        return self.error(index, Phrase(key, **{**failure.numbers, "text": text}))

    def _draw(
        self, index: int, text: str, left: tuple[str, ...], right: tuple[str, ...], total: str | None = None
    ) -> None:
        chains = self._chains(index, left, right, total)
        free = tuple(t.name for c in chains for t in c if t.direction is None and t.length is not None and not t.drawn)
        side = self.draft.give(f"side_{index + 1}", 1.0) if free else None
        if side:
            self.choices.append((side, free))
        try:
            equation = Equation(PLAN, chains, total, side)
        except EquationError as error:
            raise self.error(index, error.phrase) from None
        for term in equation.terms:
            self.solved.setdefault(str(name_in_words(term.end)), (index, text))
        self.draft.draw(equation)
        for term in equation.terms:
            self._learn(term.name, *((term.start, term.end) if term.sign > 0 else (term.end, term.start)))
        if total:
            self._learn(total, POLE, chains[0][-1].end)

    def _chains(
        self, index: int, left: tuple[str, ...], right: tuple[str, ...], total: str | None
    ) -> tuple[tuple[Term, ...], tuple[Term, ...]]:
        """Both sides from the pole to one mark; of a closed polygon one open vector comes to meet the others."""
        named = ends(total or (right or left)[-1])
        target = named[1] if named and named[1] not in self.labels else f"e{index + 1}"
        if left and right:
            first, second = (left, right) if not any(map(self._open, left)) else (right, left)
            one = self._chain(first, self._fresh(target))
            other = self._chain(second, one[-1].end)
            return (one, other) if first is left else (other, one)
        whole = sorted(left or right, key=self._open)
        if not self._open(whole[-2] if len(whole) > 1 else ""):
            return self._chain(whole, POLE), ()
        forth = self._chain(whole[:-1], self._fresh(f"e{index + 1}"))
        back = self._chain(whole[-1:], forth[-1].end)
        return forth, (replace(back[0], sign=-1),)

    def _open(self, name: str) -> bool:
        """Whether something of a vector is not known yet."""
        return None in self.known.get(name, ())

    def _chain(self, names: Iterable[str], target: str) -> tuple[Term, ...]:
        """The side's terms, known ones first, from the pole to the target, or where a vector drawn before ends."""
        ordered = sorted(names, key=self._open)
        terms, mark = [], POLE
        for i, name in enumerate(ordered):
            there = self.spans.get(name)
            if there and there[0] == at(PLAN, mark):
                terms.append(Term(name, mark, label_of(there[1]), drawn=True))
            else:
                end = target if i == len(ordered) - 1 else self._label(name, mark)
                length, direction = self.known[name]
                terms.append(Term(name, mark, end, length, direction, direction or ""))
            mark = terms[-1].end
        return tuple(terms)

    def _label(self, name: str, mark: str) -> str:
        """Where a vector laid off from a mark ends: as its name says, else a mark of its own."""
        span = ends(name)
        return self._fresh(span[1] if span and span[0] == mark else name)

    def _fresh(self, label: str) -> str:
        """The label, primed while another mark has it."""
        while label in self.labels:
            label += "′"
        self.labels.add(label)
        return label

    def _learn(self, name: str, start: str, end: str) -> None:
        """From now on the vector is known: it is on the drawing."""
        marks = at(PLAN, start), at(PLAN, end)
        if None in self.known[name]:
            length = self.draft.measure(f"‖{name}‖", *marks)
            self.known[name] = length, self.draft.through(f"→{name}", *marks)
        self.spans.setdefault(name, marks)


def quantity_of(scene: Scene) -> str:
    """The plan whose unit the vectors have, by their names or by μ; "vectors" where neither tells.

    :class:`SceneError` where they tell of several: one plan has one μ.
    """
    first: dict[str, str] = {}
    for name in scene.vectors:
        kind = next((kind for kind, letters in _LETTERS.items() if re.match(letters, name)), "")
        first.setdefault(kind, name)
    kinds = [kind for kind in first if kind]
    if len(kinds) > 1:
        one, other = kinds[:2]
        told = {"one": Phrase(f"scale_{one}"), "other": Phrase(f"scale_{other}")}
        why = Phrase("vectors_mixed", name=first[one], other_name=first[other], **told)
        raise SceneError(why, scene.file, scene.where.get(("vectors", first[other])))
    if kinds and scene.quantity not in (None, kinds[0]):
        units, told_plan = Phrase(f"units_{kinds[0]}"), Phrase(f"scale_{kinds[0]}")
        why = Phrase("vectors_mu", name=first[kinds[0]], plan=told_plan, units=units)
        raise SceneError(why, scene.file, scene.where.get(("mu",)))
    return scene.quantity or (kinds[0] if kinds else PLAN)
