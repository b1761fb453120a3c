"""A person's own equations beside a mechanism: what they give, whether they close, and what is wrong with them."""

from __future__ import annotations

import pytest

from planes.scene import load, loads
from planes.solving import solve
from planes.solving.tables import solve_report_text
from planes.words.errors import SceneError
from tests.helpers import ROOT

SIX = (ROOT / "samples" / "six-link.yaml").read_text("utf-8")


def told(*equations: str) -> list[dict[str, object]]:
    """The equations as the JSON has them, beside the six-link mechanism."""
    text = SIX + "equations:\n" + "".join(f'  - "{e}"\n' for e in equations)
    found: list[dict[str, object]] = solve(loads(text)).json()["positions"][0]["equations"]
    return found


def test_true_equations_close() -> None:
    every = told("v_C = v_B + v_CB", "a_C = a_B + a_CB^n + a_CB^t", "F_21 + F_12 = 0", "v_CB + v_BC = 0")
    assert all(e["closes"] for e in every)


def test_a_new_vector_is_given() -> None:
    (e,) = told("v_X = v_B + 2*v_CB")
    (p,) = solve(load(ROOT / "samples" / "six-link.yaml")).positions
    z = p.v["B"] + 2 * (p.v["C"] - p.v["B"])
    assert e["gives"]["v_X"]["xy"] == pytest.approx([z.real, z.imag])  # type: ignore[index]


@pytest.mark.parametrize(
    ("equation", "said"),
    [
        ("a_C = a_B + a_CB^t", "a_CB^n is missing"),
        ("v_C = v_B - v_CB", "v_CB has the wrong sign"),
        ("v_C = v_B + v_CB + v_H", "v_H is one too many"),
        ("v_C = v_B + v_HB", "v_CB should replace v_HB"),
    ],
)
def test_what_is_wrong_with_an_equation_is_named(equation: str, said: str) -> None:
    (e,) = told(equation)
    assert not e["closes"] and e["change"] == said and e["gap"] > 0.01  # type: ignore[operator]


def test_a_coriolis_part_left_out_is_named() -> None:
    """In the six-link the slider 4 moves on link 2: its acceleration has a part 2ωv."""
    solved = solve(load(ROOT / "samples" / "six-link.yaml"))
    names = {s.name for s in solved.plans.segments if s.plan == "acceleration"}
    coriolis = next(n for n in names if n.endswith("^k"))
    (equation,) = [
        e for e in solved.plans.equations if coriolis in {t.name for t in e.all_terms} and e.plan == "acceleration"
    ][:1]
    first = [t.name for t in equation.chains[0]]
    last = [t.name for t in equation.chains[1]]
    left = equation.total or " + ".join(last)
    (true, false) = told(f"{left} = {' + '.join(first)}", f"{left} = {' + '.join(n for n in first if n != coriolis)}")
    assert true["closes"] and false["change"] == f"{coriolis} is missing"


def test_tables_and_refusals() -> None:
    scene = loads(SIX + 'equations: ["v_C = v_B + v_CB", "a_C = a_B + a_CB^t"]\n')
    text = solve_report_text(solve(scene), "ru")
    assert "Свои уравнения" in text and "замыкается" in text and "не хватает a_CB^n" in text
    with pytest.raises(SceneError) as refusal:
        solve(loads(SIX + 'equations: ["v_Y = v_B + v_Z"]\n'))
    assert "the mechanism has no vector v_Z" in refusal.value.told("en")
