"""Many drawings with one mistake or none, checked, and counted in a confusion table.

`python -m tests.confusion [DRAWINGS OF EACH]` prints the table of all samples.
"""

from __future__ import annotations

import math
import random
import statistics
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache, partial

from planes.check.grading.grading import grade
from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.grading.prepared_plan import Asked, PreparedPlan, prepare
from planes.check.grading.readable import unreadable_reason
from planes.scene import load
from planes.words.names import PlanId
from tests import sample_oracle
from tests.helpers import ROOT, drawings, drawings_force
from tests.helpers.drawings import NONE, SHAKY, Care, Hand, Mistake

SAMPLES = ROOT / "samples"
PAPER_MM = 500.0  # what leads off the paper is noticed by its maker


@dataclass(frozen=True)
class Easel:
    """One plan of one sample, ready to be drawn many times."""

    sample: str
    plan: PlanId
    mu: float
    mu_v: float
    mu_a: float

    def draw(self, mistake: Mistake | None, hand: Hand) -> tuple[dict[str, complex], list[tuple[str, str]]]:
        """Marks from the pole (of a force plan: vectors in their order), and mistakes it could hold."""
        scheme_mu = bench(self.sample, self.plan).given["mu_position"]
        m = motion(self.sample)
        scheme = drawings.draw_scheme(m, hand, scheme_mu)
        if self.plan.startswith("force"):
            f = forces(self.sample)
            f.begin(scheme, scheme_mu, self.accelerations(hand, scheme), self.mu_a, hand)
            for g in reversed(f.model.groups):
                if self.plan == f"force:{'-'.join(g)}":
                    break
                mu = bench(self.sample, self.plan).given[f"mu_force:{'-'.join(g)}"]
                f.drawn |= drawings_force.draw_group(f, g, mu, hand).found
            group = next((g for g in f.model.groups if self.plan == f"force:{'-'.join(g)}"), None)
            if group:
                sheet = drawings_force.draw_group(f, group, self.mu, hand, mistake)
            else:
                sheet = drawings_force.draw_driver(f, self.mu, hand, mistake)
            return dict(sheet.vectors), sheet.made
        if self.plan == "velocity":
            drawn = drawings.draw_velocity(m, hand, self.mu, scheme, mistake)
        else:
            velocity = drawings.draw_velocity(m, hand, self.mu_v, scheme)
            drawn = drawings.draw_acceleration(m, hand, self.mu, scheme, velocity, self.mu_v, mistake)
        return drawn.marks, drawn.made

    def accelerations(self, hand: Hand, scheme: drawings.Scheme) -> dict[str, complex]:
        """A person's own acceleration plan by points, mm, for the forces of inertia."""
        m = motion(self.sample)
        if not any("mass" in b for _, b in m.links()) or not float(m.scene["drive"].get("omega", 1)):
            return {}
        velocity = drawings.draw_velocity(m, hand, self.mu_v, scheme)
        drawn = drawings.draw_acceleration(m, hand, self.mu_a, scheme, velocity, self.mu_v)
        return {n: drawn.marks[n.lower() + "'"] for n in m.sol.points if n.lower() + "'" in drawn.marks}


# driven from inside; friction in hinges
UNDRAWN = ("lift", "hinge-motor", "carriage", "folding-boom", "excavator", "friction-circles")


@cache
def motion(sample: str) -> drawings.Motion:
    return drawings.Motion(sample_oracle.numeric(sample), sample_oracle.truth(sample))


@cache
def forces(sample: str) -> drawings_force.Forces:
    return drawings_force.Forces(sample_oracle.numeric(sample), sample_oracle.truth(sample))


@cache
def bench(sample: str, plan: str, told: bool = True) -> PreparedPlan:
    """The checker ready for a plan, its scale told or for it to find."""
    free = prepare(Asked(load(SAMPLES / f"{sample}.yaml"), plan))
    return prepare(Asked(free.asked.scene, plan, mu=free.said_mu)) if told else free


def easels() -> Iterator[Easel]:
    """Every plan of every sample that is more than a point, and that the hand of these drawings can draw."""
    for sample in (s for s in sample_oracle.SKETCHES if s not in (*UNDRAWN, *sample_oracle.HIGHER)):
        f = forces(sample)
        drive = f.scene["drive"]
        moving = float(drive.get("omega", drive.get("velocity", 0))) != 0
        plans = ["velocity", "acceleration"] if moving else []
        order = [str(link) for link in f.scene["links"]]  # by which the program calls a group
        plans += [f"force:{'-'.join(sorted(g, key=order.index))}" for g in f.model.groups]
        plans += [f"force:{f.model.driver}"]
        yield from (easel(sample, plan) for plan in plans)


def easel(sample: str, plan: str) -> Easel:
    """A plan of a sample, at the scales the checker knows."""
    b = bench(sample, plan)
    return Easel(sample, PlanId.read(plan), b.said_mu, b.given["mu_velocity"], b.given["mu_acceleration"])


@dataclass
class Tally:
    """What came of the drawings."""

    right: int = 0
    accepted: int = 0
    mistakes: int = 0
    found: int = 0
    blamed: int = 0
    named: int = 0
    innocent: int = 0
    innocent_blamed: int = 0
    table: Counter[tuple[str, str]] = field(default_factory=Counter)
    failures: list[str] = field(default_factory=list)


def possible(easel: Easel) -> list[Mistake]:
    """The mistakes this drawing could hold, each in its variants."""
    _, made = easel.draw(None, Hand(NONE, random.Random(0)))
    found = []
    for name, where in dict.fromkeys(made):
        kinds = (0, 1) if name in TWOFOLD else (0,)
        found += [Mistake(name, where, k) for k in kinds]
    return [m for m in found if size(easel, m) > 3]


TWOFOLD = (
    "along_link",
    "wrong_link",
    "across_guide",
    "tangential_along_link",
    "weight_missing",
    "force_missing",
    "mass_for_weight",
    "force_doubled",
    "inertia_along_acceleration",
    "reaction_not_reversed",
)


@cache
def spread(easel: Easel) -> dict[str, float]:
    """Standard deviation of every mark over shaky hands, mm."""
    drawn = [easel.draw(None, Hand(SHAKY, random.Random(k)))[0] for k in range(40)]
    names = set.intersection(*(set(d) for d in drawn))
    return {
        n: max(statistics.pstdev([d[n].real for d in drawn]), statistics.pstdev([d[n].imag for d in drawn]), 0.1)
        for n in names
    }


@cache
def alike(easel: Easel, mistake: Mistake) -> frozenset[tuple[str, str]]:
    """Other mistakes that give the very same drawing: nobody could tell them apart."""
    _, made = easel.draw(None, Hand(NONE, random.Random(0)))
    mine, sigma = easel.draw(mistake, Hand(NONE, random.Random(0)))[0], spread(easel)
    found = set()
    for name, where in dict.fromkeys(made):
        for k in (0, 1):
            try:
                other = easel.draw(Mistake(name, where, k), Hand(NONE, random.Random(0)))[0]
            except ZeroDivisionError:
                continue
            near = (abs(other.get(n, 1e9) - z) < 0.5 * sigma.get(n, 0.3) for n, z in mine.items())
            if other.keys() == mine.keys() and all(near):
                found.add((name.partition(":")[0], where))
    return frozenset(found - {(mistake.name.partition(":")[0], mistake.where)})


@cache
def size(easel: Easel, mistake: Mistake, reading: float = 0.0) -> float:
    """By how many standard deviations of a shaky hand, and of reading both ends, a mistake moves what it moves most."""
    right, _ = easel.draw(None, Hand(NONE, random.Random(0)))
    try:
        wrong, _ = easel.draw(mistake, Hand(NONE, random.Random(0)))
    except ZeroDivisionError:
        return 0.0  # the lines never meet: nobody can make this mistake here
    if max(map(abs, wrong.values())) > PAPER_MM or len([z for z in wrong.values() if abs(z) > 1e-9]) < 2:
        return 0.0
    sigma, found = spread(easel), [0.0]
    for name, z in right.items():
        if name in sigma:
            moved = abs(wrong.get(name, 0j if easel.plan.startswith("force") else z) - z)
            found.append(moved / math.hypot(sigma[name], math.sqrt(2) * reading))
    return max(found)


def hand_in(easel: Easel, mistake: Mistake | None, care: Care, rng: random.Random) -> ReadPaper:
    """One drawing as a table, its pole anywhere, numbers to a tenth of a millimetre."""
    marks, _ = easel.draw(mistake, Hand(care, rng))
    origin = complex(rng.uniform(20, 200), rng.uniform(20, 200))
    if easel.plan.startswith("force"):
        rows, z = [("p", origin)], origin
        for name, vector in marks.items():
            z += vector
            rows.append((name, z))
    else:
        rows = [("p", origin), *((n, origin + z) for n, z in marks.items())]
    spots = [ReadMark(n, complex(round(z.real, 1), round(z.imag, 1)), 0.03) for n, z in rows]
    return ReadPaper("drawn", spots)


def rescaling(easel: Easel, mistake: Mistake) -> bool:
    """Whether the mistake only draws the right plan at another scale: without μ nobody could tell it."""
    right, wrong = (easel.draw(m, Hand(NONE, random.Random(0)))[0] for m in (None, mistake))
    if wrong.keys() != right.keys():
        return False
    longest = max(right, key=lambda n: abs(right[n]))
    ratio = wrong[longest] / right[longest]
    near = (abs(wrong[n] - ratio * right[n]) < 0.5 * spread(easel).get(n, 0.3) for n in right)
    return abs(ratio.imag) < 1e-6 < ratio.real and all(near)


def try_one(
    easel: Easel, mistake: Mistake | None, care: Care, rng: random.Random, tally: Tally, told: bool = True
) -> None:
    """Draw, check, count; the scale is told, or is for the checker to find."""
    paper = hand_in(easel, mistake, care, rng)
    graded = grade(bench(easel.sample, easel.plan, told), paper)
    assert graded is not None
    judged, why = graded.judgement, unreadable_reason(graded)
    gap = graded.wrong_closing_error_mm
    out = graded.missing_force
    blamed = judged.first_wrong or out or (graded.rebuilt.closing if gap and graded.rebuilt else None)
    name = judged.named.mistake if judged.named else ("not_closed" if gap and not judged.wrong else None)
    name = name or (("weight_missing" if out.startswith("G") else "force_missing") if out else None)
    said = "unreadable" if why else name or ("right" if not blamed else "unclear")
    tally.table[mistake.name.partition(":")[0] if mistake else "right", said] += 1
    where = f"{easel.sample} {easel.plan} {mistake} -> {said} at {blamed}"
    if mistake is None:
        tally.right += 1
        tally.accepted += said == "right"
        if said != "right":
            tally.failures.append(where)
        return
    tally.mistakes += 1
    tally.found += said != "right"
    tally.blamed += blamed == mistake.where
    tally.named += name == mistake.name.partition(":")[0]
    others = [v for m, v in graded.verdicts.items() if m.rpartition(":")[2] != mistake.where and v != "unread"]
    tally.innocent += len(others)
    tally.innocent_blamed += others.count("wrong")
    same = alike(easel, mistake)
    tally.blamed += blamed != mistake.where and (name or "", blamed) in same
    tally.named += (name or "") != mistake.name.partition(":")[0] and (name or "", blamed) in same
    if (name or "", blamed) in same:
        return
    if name != mistake.name.partition(":")[0] or blamed != mistake.where:
        tally.failures.append(where)


def run_all(each: int, care: Care, chosen: list[Easel] | None = None, told: bool = True) -> Tally:
    """Every mistake of every plan ``each`` times, and a third as many right drawings; the scale told or not."""
    tally, rng = Tally(), random.Random(1)
    for easel in chosen or easels():
        mistakes = [m for m in possible(easel) if told or not rescaling(easel, m)]
        for k in range(each):
            for mistake in mistakes:
                try_one(easel, mistake, care, rng, tally, told)
            for _ in range(max(3, len(mistakes) // 3)):
                try_one(easel, None, care, rng, tally, told)
            rng.seed(k + 2)
    return tally


def told(tally: Tally) -> str:
    """The confusion table and the shares as text."""
    share = partial(lambda a, b: f"{a}/{b} = {100 * a / max(b, 1):.2f} %")
    lines = [
        f"right accepted   {share(tally.accepted, tally.right)}",
        f"mistakes found   {share(tally.found, tally.mistakes)}",
        f"right step blamed {share(tally.blamed, tally.mistakes)}",
        f"named            {share(tally.named, tally.mistakes)}",
        f"right steps not blamed {share(tally.innocent - tally.innocent_blamed, tally.innocent)}",
        "",
    ]
    for name in sorted({n for n, _ in tally.table}):
        row = sorted(((c, t) for (n, t), c in tally.table.items() if n == name), reverse=True)
        lines.append(f"{name:28}" + "  ".join(f"{t} {c}" for c, t in row))
    return "\n".join(lines)


if __name__ == "__main__":
    EACH = int(sys.argv[1]) if len(sys.argv) > 1 else 2
    for CARE, TOLD in ((Care(), True), (SHAKY, True), (Care(), False), (SHAKY, False)):
        FOUND = run_all(EACH, CARE, told=TOLD)
        print(CARE, "μ told" if TOLD else "μ to be found")
        print(told(FOUND))
        if len(sys.argv) > 2:
            print("\n".join(FOUND.failures))
