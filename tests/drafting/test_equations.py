"""Vector equations: the chain check, the count of unknowns, the four kinds, and what they say when refused."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from planes.drafting.equations import Equation, Term
from planes.words.errors import EquationError, PlanesError
from planes.words.names import SCHEME_PLAN, VELOCITY_PLAN, PlanId

V_B = Term("v_B", "p", "b", length="v_B", direction="⊥AB")
V_CB = Term("v_CB", "b", "c", direction="⊥CB", action="⊥CB")
V_C = Term("v_C", "p", "c", direction="∥x-x")


def circle(name: str, start: str, end: str) -> Term:
    return Term(name, start, end, length=f"l_{name}")


@pytest.mark.parametrize(
    "given, known",
    [
        ({}, 0),
        ({"length": "l"}, 1),
        ({"direction": "u"}, 1),
        ({"length": "l", "direction": "u"}, 2),
        ({"drawn": True}, 2),
    ],
)
def test_the_underlines_of_a_term(given: dict[str, Any], known: int) -> None:
    assert Term("v", "p", "a", **given).known_part_count == known


def test_two_lines_cross() -> None:
    e = Equation(VELOCITY_PLAN, ((V_B, V_CB), (V_C,)), "v_C")
    assert e.construction_kind == "cross"
    assert e.unknown_parts == (("v_CB", "length"), ("v_C", "length"))
    assert e.equation_text == "v_C = v_B + v_CB = v_C"
    assert [t.name for t in e.all_terms] == ["v_B", "v_CB", "v_C"]


def test_one_unknown_vector_closes_the_polygon() -> None:
    e = Equation(VELOCITY_PLAN, ((V_B, replace(V_CB, length="v_CB")), ()), "v_C")
    assert e.construction_kind == "close"
    assert e.unknown_parts == (("v_C", "length"), ("v_C", "direction"))
    assert e.equation_text == "v_C = v_B + v_CB"
    polygon = Equation(PlanId("force"), ((V_B, Term("F", "b", "p")), ()))
    assert polygon.construction_kind == "close" and polygon.unknown_parts == (("F", "length"), ("F", "direction"))


def test_a_line_and_an_arc() -> None:
    e = Equation(SCHEME_PLAN, ((circle("AB", "a", "b"),), (Term("CB", "a", "b", direction="u"),)), "r_B", "side")
    assert e.construction_kind == "arc"
    turned = Equation(SCHEME_PLAN, ((Term("CB", "a", "b", direction="u"),), (circle("AB", "a", "b"),)))
    assert turned.construction_kind == "arc"


def test_two_arcs() -> None:
    e = Equation(SCHEME_PLAN, ((circle("AB", "a", "b"),), (circle("DB", "a", "b"),)))
    assert e.construction_kind == "arcs"
    assert e.unknown_parts == (("AB", "direction"), ("DB", "direction"))


def test_both_unknowns_in_one_chain() -> None:
    e = Equation(
        "velocity", ((V_B, replace(V_CB, end="n"), Term("w", "n", "c", direction="u")), (replace(V_C, drawn=True),))
    )
    assert e.construction_kind == "cross" and e.unknown_parts == (("v_CB", "length"), ("w", "length"))


@pytest.mark.parametrize(
    ("other", "text"),
    [
        (1, "v_B + v_CB = v_C"),  # two ways from one place to another
        (-1, "v_B + v_CB + v_C = 0"),  # what the other side takes away adds up to nothing with the first
    ],
)
def test_without_a_total_only_what_is_taken_away_closes_a_polygon(other: int, text: str) -> None:
    e = Equation(VELOCITY_PLAN, ((V_B, V_CB), (replace(V_C, sign=other),)))
    assert e.equation_text == text and e.is_closed_polygon == (other < 0)
    assert [len(side) for side in e.sides_as_written] == ([3] if other < 0 else [2, 1])
    assert not replace(e, total="v_C").is_closed_polygon


def test_a_broken_chain_is_told_by_its_names() -> None:
    with pytest.raises(EquationError) as caught:
        Equation(VELOCITY_PLAN, ((V_B, replace(V_CB, start="c")), (V_C,)), "v_C")
    assert str(caught.value) == "v_C = v_B + v_CB = v_C: v_CB starts at c, but the drawing has reached b"
    assert isinstance(caught.value, PlanesError)


@pytest.mark.parametrize(
    "other, says",
    [
        (replace(V_C, end="d"), "one side leads from p to c, the other from p to d"),
        (replace(V_C, start="a"), "one side leads from p to c, the other from a to c"),
    ],
)
def test_sides_must_start_and_end_together(other: Term, says: str) -> None:
    with pytest.raises(EquationError, match=says):
        Equation(VELOCITY_PLAN, ((V_B, V_CB), (other,)), "v_C")


@pytest.mark.parametrize(
    "chains, count, listed",
    [
        (((V_B,), (replace(V_C, end="b", length="l"),)), 0, "none"),
        (((V_B, V_CB), (replace(V_C, length="l"),)), 1, "length of v_CB"),
        (((V_B, V_CB), (replace(V_C, direction=None),)), 3, "length of v_CB; length of v_C; direction of v_C"),
        (
            ((replace(V_B, length=None, direction=None), replace(V_CB, direction=None)), (replace(V_C, drawn=True),)),
            4,
            "length of v_B; direction of v_B; length of v_CB; direction of v_CB",
        ),
    ],
)
def test_any_other_number_of_unknowns_is_refused(chains: Any, count: int, listed: str) -> None:
    with pytest.raises(EquationError) as caught:
        Equation(VELOCITY_PLAN, chains)
    assert f"has {count} unknowns ({listed}); a plane vector equation gives exactly two" in str(caught.value)


def test_an_unknown_sum_counts_for_two() -> None:
    with pytest.raises(EquationError, match=r"has 3 unknowns.*length of v_CB; length of v_C; direction of v_C"):
        Equation(VELOCITY_PLAN, ((V_B, V_CB), ()), "v_C")


def test_equations_and_terms_are_frozen() -> None:
    e = Equation(VELOCITY_PLAN, ((V_B, V_CB), (V_C,)))
    for thing, name in ((e, "plan"), (V_B, "name")):
        with pytest.raises(AttributeError):
            setattr(thing, name, "x")
    assert hash(e) == hash(Equation(VELOCITY_PLAN, ((V_B, V_CB), (V_C,))))
