"""Formulas as equations of Word: fractions, roots, powers and brackets are things; numbers and units hold together."""

from __future__ import annotations

import sys
from typing import Any

import pytest

pytest.importorskip("docx", reason="python-docx is not installed")
pytest.importorskip("mathml2omml", reason="mathml2omml is not installed")

from planes.words.errors import PlanesError
from planes.words.naming import Naming
from render.report import render_document
from render.report.omml import word_equation


def told(tex: str) -> str:
    """An equation by the names of its things: ``f(num(…)den(…))``, texts as they are."""

    def one(node: Any) -> str:
        name = node.tag.rpartition("}")[2]
        inner = "".join(map(one, node))
        if name in ("t", "oMath", "r", "box") or (name == "e" and node.getparent().tag.endswith("box")):
            return (node.text or "") + inner
        return "" if name.endswith("Pr") else f"{name}({inner})"

    return one(word_equation(tex))


@pytest.mark.parametrize(
    ("tex", "expected"),
    [
        (r"\dfrac{a}{b}", "f(num(a)den(b))"),
        (r"F_{21}^{t}", "sSubSup(e(F)sub(21)sup(t))"),
        (r"0{,}21^2", "sSup(e(0,21)sup(2))"),
        (r"(-5{,}0)^2", "sSup(e(d(e(−5,0)))sup(2))"),
        (r"|\cos\varphi|", "d(e(cosφ))"),
        (r"\left[x\right]", "d(e(x))"),
        (r"\sqrt{x+1}", "rad(deg()e(x+1))"),
        (r"1{,}5\,\mathrm{кг}", "1,5кг"),
        (r"x,\quady", "x,y"),
    ],
)
def test_a_formula_is_made_of_what_it_is(tex: str, expected: str) -> None:
    assert told(tex) == expected


@pytest.mark.parametrize("package", ["docx", "mathml2omml"])
def test_a_missing_package_is_one_sentence(package: str, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in [
        name for name in sys.modules if name.startswith(("render.report.word", "render.report.omml", package))
    ]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(PlanesError, match=f"pip install.*{package}"):
        render_document([], ".docx", Naming("en"))
