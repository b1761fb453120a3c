"""Floor 1: expressions and parameters made of one another."""

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from planes.scene.expressions import evaluate_expression, is_parameter_name, names_in_expression
from planes.scene.parameters import resolve_parameters
from planes.words.errors import ExpressionError
from tests.helpers.counting import at_most

NAMES = {"l_AB": 0.1, "φ": 30.0, "длина": 2.0, "x'": 5.0}

GOOD = [
    ("1", 1),
    ("1e-3", 1e-3),
    ("-2.5E+2", -250),
    (".5", 0.5),
    ("5.", 5),
    ("+3", 3),
    ("−3", -3),
    ("2+3*4", 14),
    ("(2+3)*4", 20),
    ("2^3^2", 512),
    ("2**3**2", 512),
    ("-2^2", -4),
    ("-2**2", -4),
    ("2^-1", 0.5),
    ("2^--1", 2),
    ("(-2)^2", 4),
    ("(-8)^3", -512),
    ("8/2/2", 2),
    ("8-2-1", 5),
    ("2*-3", -6),
    ("--2", 2),
    ("1 + 2 ", 3),
    ("l_AB*3", 0.1 * 3),
    ("sin(φ)", 0.5),
    ("длина^2", 4),
    ("x' - 1", 4),
    ("pi", math.pi),
    ("sqrt(2)^2", 2.0),
    ("hypot(3, 4)", 5),
    ("min(3, 1, 2)", 1),
    ("max(3, 1, 2)", 3),
    ("abs(-3)", 3),
    ("cos(60)", 0.5),
    ("sin(180)", 0),
    ("cos(90)", 0),
    ("tan(45)", 1),
    ("tan(-135)", 1),
    ("asin(1)", 90),
    ("acos(0)", 90),
    ("atan(-1)", -45),
    ("atan2(1, -1)", 135),
    ("asin(0.5)", 30),
    ("atan2(0, -1)", 180),
    ("0^0", 1),
    ("1\n+1", 2),
    ("((((((1))))))", 1),
    ("l_AB/sin(30)", 0.2),
    ("hypot(1,2,2)", 3),
]
BAD = [
    ("0,5", "decimal point: 0.5"),
    ("1 + 0,25", "decimal point: 0.25"),
    ("sqrt(0,5)", "one number"),
    ("", "missing"),
    ("   ", "missing"),
    ("1+", "missing at the end"),
    ("*2", "not expected"),
    ("(1", "a ) is missing"),
    ("1)", "not expected"),
    ("()", "not expected"),
    ("2(3)", "not expected"),
    ("2 3", "operator missing"),
    ("2φ", "write 2*φ"),
    ("l_AC", "did you mean l_AB?"),
    ("foo", "l_AB, φ, длина, x', pi, sqrt"),
    ("sinus(3)", 'no function "sinus"'),
    ("sin 30", "sin(...)"),
    ("sin", "brackets"),
    ("sin()", "not expected"),
    ("hypot(3)", "two or more"),
    ("atan2(1)", "takes 2 numbers"),
    ("atan2(1,2,3)", "takes 2 numbers"),
    ("sqrt(-1)", "sqrt(-1) has no value"),
    ("asin(2)", "asin(2)"),
    ("acos(-1.01)", "no value"),
    ("tan(90)", "tan(90)"),
    ("1/0", "division by zero"),
    ("1/(2-2)", "division by zero"),
    ("0^-1", "no value"),
    ("(-8)^(1/3)", "no value"),
    ("9**9**9", "too large"),
    ("1e400", "too large"),
    ("1e308*10", "too large"),
    ("1e308*10-1e308*10", "too large"),
    ("10^309", "too large"),
    (".inf", "finite"),
    ("-.inf", "finite"),
    (".nan", "finite"),
    ("nan", "finite"),
    ("Infinity", "finite"),
    ("1:2", '":"'),
    ("1_000", "not expected"),
    ("0x10", "not expected"),
    ("30°", "degrees already"),
    ("2×3", "write *"),
    ("60 rpm", "; for rpm write *pi/30"),
    ("-3 об/мин + 1", "; for об/мин write *pi/30"),
    ("60*rpm", "add rpm: pi/30 to parameters"),
    ("2 furlong", "angles in degrees"),
    ("2;3", '";"'),
    ("a.b", "is not allowed"),
    ("__import__('os')", "is not allowed"),
    ("[1]", "is not allowed"),
    ("true", "not defined"),
    ("1e", "not expected"),
    ("x'''''''", "not defined"),
    ("lambda: 1", "is not allowed"),
    ("1 if 1 else 2", "operator missing"),
    ("(" * 300 + "1" + ")" * 300, "40 levels"),
    ("-" * 900 + "1", "40 levels"),
    ("2^" * 300 + "1", "40 levels"),
    ("1+" * 600 + "1", "1000 characters"),
    ("٣", "is not allowed"),
    ("2**", "missing at the end"),
    ("5 % 2", '"%"'),
    ("exp(1)", "no function"),
    ("min(1,)", "not expected"),
    ("1,,2", "not expected"),
    ("²", "is not allowed"),
]


@pytest.mark.parametrize(("text", "value"), GOOD)
def test_value(text, value):
    assert evaluate_expression(text, NAMES) == pytest.approx(value, rel=1e-15, abs=0)


@pytest.mark.parametrize(("text", "piece"), BAD)
def test_refusal(text, piece):
    with pytest.raises(ExpressionError) as caught:
        evaluate_expression(text, NAMES)
    assert piece in str(caught.value)
    assert "\n" not in str(caught.value) and len(str(caught.value)) < 400


def test_names_are_compared_composed():
    assert evaluate_expression("и\u0306", {"й": 3.0}) == 3.0
    assert (
        is_parameter_name("й")
        and is_parameter_name("φ_1'")
        and not is_parameter_name("y-y")
        and not is_parameter_name("1a")
        and not is_parameter_name("")
    )


def test_names_in_leaves_out_what_is_known():
    assert names_in_expression("l_AB*sin(phi) + pi") == ["l_AB", "phi"]


def test_parameters_of_one_another():
    assert resolve_parameters({"c": "a*b", "a": "b+1", "b": "2"}) == {"c": 6.0, "a": 3.0, "b": 2.0}
    assert list(resolve_parameters({"c": "a", "a": "1"})) == ["c", "a"]


@pytest.mark.parametrize(
    ("texts", "piece", "parameter"),
    [
        ({"a": "a"}, "a refers to itself", "a"),
        ({"a": "b", "b": "c+1", "c": "a"}, "a -> b -> c -> a", "c"),
        ({"x": "1", "a": "x+q", "q": "a"}, "a -> q -> a", "q"),
        ({"a": "2", "b": "a+zz"}, "valid: a, b, pi", "b"),
        ({"a": "b", "b": "1/0"}, "division by zero", "b"),
        ({"a": "0,5"}, "decimal point", "a"),
    ],
)
def test_parameters_refused(texts, piece, parameter):
    with pytest.raises(ExpressionError) as caught:
        resolve_parameters(texts)
    assert piece in str(caught.value) and caught.value.parameter == parameter


@pytest.mark.slow
def test_long_chains_and_circles_take_no_time():
    chain = {f"a{i}": f"a{i + 1}" for i in range(20_000)} | {"a20000": "1"}
    with at_most(10_000_000), pytest.raises(ExpressionError, match=r"circle: a0 -> a1 .* … -> a0"):
        assert resolve_parameters(chain)["a0"] == 1.0
        resolve_parameters(chain | {"a20000": "a0"})


@settings(max_examples=400)
@given(st.text(alphabet="0123456789.+-*/^()eE ,lφ_'sincoqrtpa²\n", max_size=40))
def test_any_text_is_a_finite_number_or_a_sentence(text):
    try:
        assert math.isfinite(evaluate_expression(text, NAMES))
    except ExpressionError as error:
        assert str(error)
