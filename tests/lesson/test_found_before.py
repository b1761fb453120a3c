"""No number of a note is used before it is found, in any sample; and what the manuals tell on the way is told."""

from __future__ import annotations

import re
from itertools import product
from math import prod

import pytest

from planes.drafting.steps.reckoning import Calculate, Drop, Measure
from planes.lesson import Teller
from planes.lesson.formulas import SLOT_PATTERN, fill_slots
from planes.lesson.note import Note
from planes.lesson.told import SceneLesson
from planes.plans.force.loads import names_of_loads
from planes.scene import load
from planes.solving import solve
from planes.solving.document import DocumentTable, Formula, Paragraph
from planes.words.units import number_text
from tests.helpers import ROOT

SCENES = sorted(p for f in ("", "assignments") for p in (ROOT / "samples" / f).glob("*.yaml") if p.stem != "vectors")


@pytest.mark.few(8)
@pytest.mark.parametrize("path", SCENES, ids=lambda p: p.stem)
def test_every_number_is_found_before_it_is_used(path):
    position = solve(load(path)).positions[0]
    plans = position.plans
    teller = Teller(plans, position.drawing)
    zero = {m.unknown for m in plans.moments if m.arm}  # told by its equation, a number or nothing
    told = {*plans.given, *names_of_loads(plans.mechanism)}
    for frame in teller.lesson_frames():
        own = {row.name for row in frame.rows}
        for how, name in frame.numbers:
            value, step = name.strip("|‖"), teller.made.get(name)
            used = how != "s" and isinstance(step, Calculate | Drop | Measure)
            assert not used or value in told | own or (frame.key == "found" and value in zero), (
                value,
                frame.words_with_rows,
            )
        told |= {name.strip("|‖") for _, name in frame.numbers} | own
        for text in frame.words_with_rows.values():  # each language tells all of them and no other
            assert {(how, name) for how, name, _ in SLOT_PATTERN.findall(text)} == {*frame.numbers}, (frame.key, text)


def sentences(name: str) -> str:
    scene = load(ROOT / "samples" / f"{name}.yaml")
    blocks = Note(scene, solve(scene).positions[0], "en").document_blocks()
    return "\n".join(
        b.text if isinstance(b, Paragraph) else b.tex_source for b in blocks if isinstance(b, Paragraph | Formula)
    )


def test_the_second_example_has_its_printed_numbers():
    told = sentences("bntu-2")
    assert r"N_{30}=\dfrac{37.3 \ \mathrm{mm}}{0.05}={-746.7}\ \mathrm{N}" in told
    assert r"T_{30}=\dfrac{5.6 \ \mathrm{mm}}{0.05}=112\ \mathrm{N}" in told
    assert r"P_{T30}=T_{30} \cdot v_{3}=112 \cdot ({-2.1})={-235.2}\ \mathrm{W}" in told


def test_relations_by_segments_the_self_aligning_variant_and_the_remark_are_told():
    scene = load(ROOT / "samples" / "six-link.yaml")
    blocks = Note(scene, solve(scene).positions[0], "en").document_blocks()
    rows = [row for b in blocks if isinstance(b, DocumentTable) for row in b.rows]
    assert ("v_{qC}", "pc·l_{AB}/pb", "0.120", "m") in rows
    assert ("u_{31}", "pc·l_{AB}/(pb·l_{DC})", "0.801", "") in rows
    told = sentences("six-link")
    assert "W = 6n − 5p_{1} − 4p_{2} − 3p_{3} = 30 − 10 − 16 − 3 = 1, q = 0" in told and "C (2–3): spherical 3S" in told
    assert "D (6–3)" in told
    assert " ".join(scene.note["en"].split()) in told


def test_inertia_arms_and_single_links_are_told():
    told = sentences("six-link")
    assert r"M_{Φ2}={-J_{2} \cdot ε_{2}}={-2 \cdot 125.1}={-250.3}\ \mathrm{N·m}" in told
    assert r"h_{G2}=\dfrac{20.5 \ \mathrm{mm}}{250}=0.08218\ \mathrm{m}" in told
    assert "Link 3 by itself: ⟨F_30⟩ + ⟨G_3⟩ + ⟨F_32⟩ = 0" in told
    assert "Link 4 by itself: ⟨F_42⟩ + ⟨F_45⟩ = 0" in told
    assert "passes through ⟨H⟩ and has no moment" in told


@pytest.mark.parametrize("name", ["six-link", "kind-1-rrr", "kind-3-rpr", "folding-boom", "hinge-motor", "excavator"])
def test_the_polygon_of_a_single_link_is_lit_on_the_plan_of_its_group_and_closes(name):
    scene = load(ROOT / "samples" / f"{name}.yaml")
    here = solve(scene).positions[0]
    told = [f for f in Teller(here.plans, here.drawing).lesson_frames() if f.key == "apart"]
    assert told
    for frame in told:
        ends = {s.name: (s.start, s.end) for s in here.plans.segments if s.plan == frame.plan}
        place = {n: complex(here.drawing[frame.plan.mark(n)]) for pair in ends.values() for n in pair}
        vectors = [place[ends[n][1]] - place[ends[n][0]] for n in frame.terms]
        signs = product((1, -1), repeat=len(vectors))  # a reaction is drawn as it acts on one of two links
        assert min(abs(sum(s * v for s, v in zip(way, vectors, strict=True))) for way in signs) < 1e-9


@pytest.mark.parametrize("name", ["six-link", "class-three/rods", "class-four/tray"])
def test_no_balancing_moment_is_told_to_be_nothing_that_is_not(name):
    told = SceneLesson.of(load(ROOT / "samples" / f"{name}.yaml"))
    found = {f.terms[-1] for f in told.frames if f.key.startswith("moments_zero")}
    assert not {n for n in found if abs(complex(told.drawing[n])) > 1e-6}
    assert not found or told.plans.balancing not in found


DYADS = ("six-link", "kind-2-rrp", "kind-4-prp", "folding-boom", "hinge-motor", "carriage", "excavator")
MOMENTS = [ROOT / "samples" / f"{name}.yaml" for name in DYADS]
MOMENTS += [*(ROOT / "samples" / "class-three").glob("*.yaml"), ROOT / "samples" / "class-four" / "tray.yaml"]


@pytest.mark.few(6)
@pytest.mark.parametrize("path", sorted(MOMENTS), ids=lambda p: p.stem)
def test_terms_of_moments_have_the_signs_they_are_told_with(path):
    """Signs and sizes as the sentence has them add up to what is found; a letter told with a minus stands in bars."""
    here = solve(load(path)).positions[0]
    value = lambda name: float(here.drawing[name])  # noqa: E731
    told = [f for f in Teller(here.plans, here.drawing).lesson_frames() if f.key == "moments"]
    assert told
    for frame in told:
        equation = frame.words_with_rows["en"].partition(": ")[2].split(";")[0]
        head, letters, numbers = (part.strip() for part in equation.split(" = ")[:3])
        unknown, *over = re.findall("⟨([^⟩]+)⟩", head)
        assert " / " not in numbers
        sizes = [name for how, name, _ in SLOT_PATTERN.findall(numbers) if how == "a"]
        for (bar, letter), name in zip(re.findall("(∣?)⟨([^⟩]+)⟩", letters), sizes, strict=True):
            assert bool(bar) == (value(name) < 0 and name[0] not in "hH"), letter
        total = 0.0
        terms = re.findall(r"⟦(?:join|lead)¦[^⟧]+⟧|(?:(?!⟦(?:join|lead)).)+", numbers)
        for join, term in zip(terms[::2], terms[1::2], strict=True):
            sign = -1.0 if "−" in fill_slots(join, value, "en") else 1.0
            total += sign * prod(abs(value(name)) for how, name, _ in SLOT_PATTERN.findall(term) if how == "a")
        by = prod(abs(value(n)) if n.startswith("h_") else value(n) for n in over)
        found = abs(value(unknown)) if unknown.startswith("F") else value(unknown)  # a force as it acts
        assert found * by == pytest.approx(total, rel=1e-9, abs=1e-9), frame.words_with_rows["en"]


def test_a_motor_in_a_hinge_is_told_by_how_one_link_turns_on_the_other():
    """The given turning is of link 2 on link 1: across its arm, with Coriolis by link 1; and ω₂ is their sum."""
    told, here = sentences("hinge-motor"), solve(load(ROOT / "samples/hinge-motor.yaml")).positions[0]
    first, second = (number_text(here.omega[x], "en").replace("−", "-") for x in "12")
    assert r"v_{BB1}=ω_{2{,}1} \cdot l_{AB}=({-0.6}) \cdot 0.45={-0.27}\ \mathrm{m/s}" in told
    assert rf"ω_{{2}}=ω_{{1}}+ω_{{2{{,}}1}}={first}+({{-0.6}})={{{second}}}\ \mathrm{{rad/s}}" in told
    coriolis = number_text(2 * here.omega["1"] * -0.27, "en").replace("−", "-")
    product = rf"2 \cdot ω_{{1}} \cdot v_{{BB1}}=2 \cdot {first} \cdot ({{-0.27}})"
    assert rf"a_{{BB1}}^{{k}}={product}={{{coriolis}}}\ \mathrm{{m/s²}}" in told
