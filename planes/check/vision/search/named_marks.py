"""Letters where they decide: on marks whose own ink cannot be told, as a mass centre's in the middle of another vector,
and on mistakes that leave the ink of a right plan.

A name tells a mark only if it stands by the place where that should be, on ink that leads there, and by none where a
mistake of the catalogue would have it, with ink that leads there. How far off its mark a name stands nobody can
measure, so no place is read.
"""

from collections.abc import Collection, Mapping, Sequence
from typing import Any

from planes.check.grading.prepared_plan import redrawn, variants_of
from planes.check.grading.variants import Variant
from planes.check.vision.marks.handwritten import AROUND_MM, HandWord, HandWords, words_on
from planes.check.vision.marks.places import HEADED_MM
from planes.check.vision.search.costs import slip
from planes.check.vision.search.ink_cover import COVERED
from planes.check.vision.search.laid_plan import LaidPlan
from planes.check.vision.search.plan_search import EVEN_MM, Search
from planes.drafting.steps import Step
from planes.words.names import POLE, label_of

# what a mark costs at the least whose name stands elsewhere, and by how much more a right plan must than a mistake
PRICED, SURELY = 1.2, 1.0
BESIDE_MM = 7.0  # how far off its mark a name stands, at the most
NEARER_MM, APART_MM = 3.0, 2.5  # than to where a mistake has the mark, if that is so far from where it should be
LIKELY, ELSEWHERE = 0.5, 0.3  # how surely a name is read there, and at the most anywhere else


def names_on(search: Search) -> HandWords:
    """The names on a sheet (remembered)."""
    if not search.ink.words.words:
        search.ink.words = words_on(search.seen, [POLE, *(label_of(m) for m in search.bench.marks)])
    return search.ink.words


def by_names(search: Search, plain: LaidPlan) -> LaidPlan:
    """A plan rightly laid, or what a mistake leaves of nearly the same ink, if names stand where that has its marks;
    looked for where not every mark shows a head of its own."""
    if _each_headed(search, plain):
        return plain
    said, variants = _said(search, plain), variants_of(search.bench, {}, search.bench.said_mu)
    if max(said, default=0.0) < PRICED:
        return plain
    best, least = plain, plain.cost + sum(said) - SURELY
    for variant in variants:
        rival = search.settled(variant, slip(len(variants)), least)
        if rival and (cost := rival.cost + sum(_said(search, rival))) < least:
            best, least = rival, cost
    return best


def _each_headed(search: Search, way: LaidPlan) -> bool:
    """Whether there are as many heads as places where longer vectors should end."""
    ends = way.ends(search.pole.z)
    true, heads, goals = {label_of(m): z for m, z in search.true.items()}, 0, list[complex]()
    read = [(a, b) for a, b in search.vectors if a in ends and b in ends]
    for a, b in ((a, b) for a, b in read if abs(ends[b] - ends[a]) > 2 * HEADED_MM):
        heads |= search.ink.along(ends[a], ends[b])[1]
        goals += [true[b]] if all(abs(true[b] - z) > EVEN_MM for z in goals) else []
    return search.ink.headed and heads.bit_count() >= len(goals)


def _said(search: Search, way: LaidPlan) -> list[float]:
    """What it costs to believe in each of the marks of a plan for where its name stands."""
    words = names_on(search)
    return [words.price(label_of(m), p.z, p.z) for m, p in way.found.items()]


def named(search: Search, way: LaidPlan, unread: Collection[str]) -> tuple[str, ...]:
    """Which of some marks that are not read (labels) have their names where they should be."""
    if not unread:
        return ()
    words = names_on(search)
    right, routes = _places(search, way, None, unread), search.routes(way)
    about = [w for w in words.words if any(w.off(a, b) < AROUND_MM for a, b in routes)]
    ends = way.ends(search.pole.z)
    found = [n for n, z in right.items() if _led(search, ends, n, z) and _by(about, n, z)]
    if not found:
        return ()
    for variant in variants_of(search.bench, {}, search.bench.said_mu):
        wrong = _places(search, way, variant, found)
        drawn = {n: z for n, z in wrong.items() if _led(search, ends, n, z)}
        found = [n for n in found if not _rivals(words, n, right[n], drawn.get(n, right[n]))]
    return tuple(found)


def traceless(search: Search, way: LaidPlan) -> set[str]:
    """Marks (labels) that nothing of their own shows, where a mistake leaves no ink of its own either: it has them at
    the pole, no name tells it, and ink leads to where one should be, too; or rightly they are upon another mark."""
    pole, ends = search.pole.z, way.ends(search.pole.z)
    if way.variant:
        rightly = {POLE: pole, **{label_of(m): pole + z for m, z in search.true.items()}}
        gone = {label_of(m): z for m, z in search.true.items() if way.found.get(m) is search.pole and abs(z) > EVEN_MM}
        right = _places(search, way, None, gone) if gone and not _stands_apart(ends, rightly) else {}
        if not any(_led(search, {**ends, **right}, n, z) for n, z in right.items()):
            return set()
        return {n for n, z in gone.items() if abs(z) < APART_MM or not _told(names_on(search), n, pole, pole + z)}
    doubled = {n: z for n, z in ends.items() if n != POLE and _upon_another(n, z, ends)}
    found = set[str]()
    for variant in variants_of(search.bench, {}, search.bench.said_mu) if doubled else ():
        if (n := variant.blames) in doubled and n not in found:
            moved = _places(search, way, variant, ends)
            if abs(moved.get(n, doubled[n]) - doubled[n]) > APART_MM and not _own_ink(search, n, moved, ends):
                found.add(n)
    return found


def _own_ink(search: Search, name: str, moved: Mapping[str, complex], ends: Mapping[str, complex]) -> bool:
    """Whether a mistake in a mark would have ink that is not there: a head at an end that lies on others' lines."""
    others = {n: z for n, z in moved.items() if n != name}
    if _stands_apart(others, ends):
        return True
    if not _stands_apart({name: moved[name]}, ends):
        return False
    starts = (ends[a] for a, b in search.vectors if b == name and a in ends)
    return not (_led(search, ends, name, moved[name]) and any(search.ink.pointed(a, moved[name]) for a in starts))


def _stands_apart(moved: Mapping[str, complex], ends: Mapping[str, complex]) -> bool:
    """Whether a mark that two drawings have at different places stands, in the first, where the other has none."""
    return any(n in ends and abs(z - ends[n]) > APART_MM and not _upon_another(n, z, ends) for n, z in moved.items())


def _told(words: HandWords, name: str, z: complex, other: complex) -> bool:
    """Whether a name tells that its mark is at one place and not at another one."""
    return _by(words.words, name, z) and not _rivals(words, name, z, other)


def _upon_another(name: str, z: complex, ends: Mapping[str, complex]) -> bool:
    """Whether a place is that of another mark, or of the pole."""
    return any(n != name and abs(z - other) < EVEN_MM for n, other in ends.items())


def _places(search: Search, way: LaidPlan, variant: Variant | None, labels: Collection[str]) -> dict[str, complex]:
    """Where marks that are not read should be, drawn rightly or with a mistake from those that are."""
    read = {m: p.z - search.pole.z for m, p in way.found.items() if label_of(m) not in labels}
    found = dict[str, complex]()

    def snap(step: Step, drawn: Any) -> Any:
        if step.makes in search.own and label_of(step.makes) in labels and drawn == drawn:
            found[label_of(step.makes)] = search.pole.z + complex(drawn)
        return read.get(step.makes, drawn)

    return found if redrawn(search.bench, variant, snap) is not None else {}


def _led(search: Search, ends: Mapping[str, complex], label: str, z: complex) -> bool:
    """Whether there is ink all along the vectors that should lead to a place."""
    starts = [a for a, b in search.vectors if b == label]
    return bool(starts) and all(a in ends and search.seen.covered(ends[a], z) >= COVERED for a in starts)


def _by(words: Sequence[HandWord], name: str, z: complex) -> bool:
    """Whether a name stands by a place, and nowhere else."""
    told = [(w.likely.get(name, 0.0), w.off(z, z) < BESIDE_MM) for w in words]
    near, away = (sum(p for p, by in told if by is k) for k in (True, False))
    return near > LIKELY and away < ELSEWHERE


def _rivals(words: HandWords, name: str, right: complex, wrong: complex) -> bool:
    """Whether a name may as well stand by the place where a mistake has its mark."""
    if abs(wrong - right) < APART_MM:
        return False
    word = max(words.words, key=lambda w: w.likely.get(name, 0.0))
    return word.off(wrong, wrong) < word.off(right, right) + NEARER_MM
