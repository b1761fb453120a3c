"""Floor 0: μ in both conventions, the standard series, numbers for people, sines in degrees."""

import math

import pytest

from planes.geometry.arithmetic import acos_deg, asin_deg, atan2_deg, atan_deg, cos_deg, sin_deg, tan_deg
from planes.words import available_languages, say
from planes.words.read_off import fixed_decimals_text, read_off_text
from planes.words.units import (
    PLANS_WITH_MU,
    UnitError,
    mu_text,
    number_text,
    plan_and_convention_of_mu,
    read_mu,
    significant_digits_text,
    standard_mu,
    standard_scale,
    suitable_unit_multiple,
)

READ = [
    ("250 mm/m", "position", 250.0),
    ("250mm/m", "position", 250.0),
    ("0.004 m/mm", "position", 250.0),
    ("2.5 mm/cm", "position", 250.0),
    ("0.25 mm/mm", "position", 250.0),
    ("250 мм/м", "position", 250.0),
    ("1:4", "position", 250.0),
    ("2.5 : 1", "position", 2500.0),
    ("1 мм/см", "position", 100.0),
    ("30 mm/(m/s)", "velocity", 30.0),
    ("0.04 (m/s)/mm", "velocity", 25.0),
    ("25 мм/(м/с)", "velocity", 25.0),
    ("25 мм/(м·с⁻¹)", "velocity", 25.0),
    ("25 mm·s/m", "velocity", 25.0),
    ("0.025 mm/(mm/s)", "velocity", 25.0),
    ("0.04 м·с⁻¹/мм", "velocity", 25.0),
    ("0.04 м/(с·мм)", "velocity", 25.0),
    ("40 (mm/s)/mm", "velocity", 25.0),
    ("0.04 m/s/mm", "velocity", 25.0),
    ("25 mm/(m s^-1)", "velocity", 25.0),
    ("2 mm/(m/s²)", "acceleration", 2.0),
    ("2 mm/(m/s^2)", "acceleration", 2.0),
    ("2 mm/(m/s2)", "acceleration", 2.0),
    ("2 мм/(м·с⁻²)", "acceleration", 2.0),
    ("2 мм·с²/м", "acceleration", 2.0),
    ("0.5 (m/s²)/mm", "acceleration", 2.0),
    ("0.5 м·с^-2/мм", "acceleration", 2.0),
    ("2e0 mm/(m·s−2)", "acceleration", 2.0),
    ("0.01 mm/N", "force", 0.01),
    ("100 N/mm", "force", 0.01),
    ("10 mm/kN", "force", 0.01),
    ("0.1 kN/mm", "force", 0.01),
    ("0.01 мм/Н", "force", 0.01),
    ("0.1 кН/мм", "force", 0.01),
    ("1e-2 mm/N", "force", 0.01),
    (".01 mm / N", "force", 0.01),
    ("25 mm/(m/s)", "vectors", 25.0),
]
BAD = [
    ("30 mm/m", "velocity", "position plan); write it in mm/(m/s) or (m/s)/mm"),
    ("0 mm/m", "position", "positive"),
    ("30 mm/m/s", "velocity", "does not fit"),
    ("30 mm", "velocity", "does not fit"),
    ("30", "force", "no unit"),
    ("-2 mm/m", "position", "positive"),
    ("nan mm/m", "position", "positive finite"),
    ("inf mm/m", "position", "positive finite"),
    ("1e999 mm/m", "position", "finite"),
    ("1e-320 m/mm", "position", "finite"),
    ("0,5 mm/m", "position", "decimal point: 0.5 mm/m"),
    ("", "force", "a number"),
    ("mm/m", "position", "a number"),
    ("30 mm/(m/s", "velocity", "fit"),
    ("30 mm//m", "position", "fit"),
    ("30 mm/m)", "position", "fit"),
    ("30 kgf/mm", "force", "mm/N or N/mm"),
    ("1:0", "position", "positive"),
    ("1:4", "velocity", "only the scale of the position plan"),
    ("9" * 100 + " mm/m", "position", "not a number with a unit"),
    ("30 mm/m", "volume", "no plan named volume"),
    ("5 N", "vectors", "mm/(m/s)"),
    ("30 m m", "position", "fit"),
    ("30 /mm", "position", "fit"),
    ("30 mm/()m", "position", "fit"),
]


@pytest.mark.parametrize(("text", "plan", "mu"), READ)
def test_mu_is_read(text, plan, mu):
    assert read_mu(text, plan) == pytest.approx(mu, rel=1e-15)


@pytest.mark.parametrize(("text", "plan", "piece"), BAD)
def test_mu_is_refused_in_words(text, plan, piece):
    with pytest.raises(UnitError) as caught:
        read_mu(text, plan)
    assert piece in str(caught.value) and "\n" not in str(caught.value) and len(str(caught.value)) < 300


def test_mu_is_written_in_both_conventions():
    assert [mu_text(mu, plan) for mu, plan in ((250, "position"), (30, "velocity"), (2, "acceleration"))] == [
        "250 mm/m",
        "30 mm/(m/s)",
        "2 mm/(m/s²)",
    ]
    assert mu_text(30.0, "velocity", "ru") == "30 мм·с/м"
    assert mu_text(2.5, "acceleration", "ru") == "2.5 мм·с²/м"
    assert mu_text(30.0, "velocity", "en", "unit_per_mm") == "0.0333 (m/s)/mm"
    assert mu_text(0.01, "force", "ru", "unit_per_mm") == "100 Н/мм"
    assert mu_text(25.0, "velocity", "ru", "unit_per_mm") == "0.04 м/(с·мм)"
    assert read_mu("0.04 м/(с·мм)", "velocity") == pytest.approx(25.0)
    assert mu_text(250.0, "position", "en", "unit_per_mm") == "0.004 m/mm"
    assert mu_text(160.0, "position", "en", "unit_per_mm") == "0.00625 m/mm"
    assert mu_text(1e-5, "force") == "0.00001 mm/N"


@pytest.mark.parametrize("plan", PLANS_WITH_MU)
@pytest.mark.parametrize("lang", ["en", "ru"])
@pytest.mark.parametrize("mu", [30.0, 1 / 3, 2.5e-5, 1e-9, 1e15, 123456.789, 1 / 0.0333])
def test_what_is_written_reads_back_exactly(plan, lang, mu):
    assert read_mu(mu_text(mu, plan, lang), plan) == mu
    assert plan_and_convention_of_mu(mu_text(mu, plan, lang)) == (plan, "mm_per_unit")
    assert read_mu(mu_text(mu, plan, lang, "unit_per_mm"), plan) == pytest.approx(mu, rel=5e-3)


@pytest.mark.parametrize(
    ("largest", "fit", "mu"),
    [
        (0.1, 30, 250),
        (3, 70, 20),
        (2, 60, 25),
        (1, 1, 1),
        (1, 0.999, 0.5),
        (6000, 60, 0.01),
        (7, 49, 5),
        (7, 48.9, 5),
        (-2, 60, 25),
        (0, 50, 1),
        (math.inf, 50, 1),
        (math.nan, 50, 1),
        (1, 0, 1),
        (0.3, 0.3, 1),
        (1, 249, 200),
    ],
)
def test_standard_mu(largest, fit, mu):
    assert standard_mu(largest, fit) == mu


@pytest.mark.parametrize(
    ("largest", "fit", "scale"),
    [
        (0.1, 100, 1000),
        (1, 200, 200),
        (1, 260, 250),
        (0.01, 100, 10000),
        (0.04, 100, 2500),
        (0.3, 50, 1000 / 10),
        (0, 100, 1000),
        (1e9, 100, 1e-7),
        (0.001, 100, 1e5),
        (0.0001, 79, 7e5),
        (2, 100, 50),
        (3, 199, 1000 / 20),
    ],
)
def test_standard_scale(largest, fit, scale):
    assert standard_scale(largest, fit) == pytest.approx(scale, rel=1e-12)


@pytest.mark.parametrize(
    ("args", "text"),
    [
        ((2.34567,), "2.346"),
        ((6000.0,), "6000"),
        ((12345.6,), "12346"),
        ((0.0,), "0"),
        ((-0.0,), "0"),
        ((-2.5,), "-2.5"),
        ((0.00012345,), "0.0001234"),
        ((1e9,), "1·10⁹"),
        ((1.5e-7,), "1.5·10⁻⁷"),
        ((9.9999, 3), "10"),
        ((math.nan,), "—"),
        ((-math.inf,), "-∞"),
        ((0.99996,), "1"),
    ],
)
def test_quantity(args, text):
    assert significant_digits_text(*args) == text


def test_a_number_has_a_true_minus_and_the_sign_of_its_language():
    assert [number_text(x, "en") for x in (-2.5, -1e-13, -0.0, None)] == ["−2.5", "−1·10⁻¹³", "0", "—"]
    assert number_text(-12.3456, "ru", 3) == "−12,3"


def test_sines_are_exact_where_the_answer_is_round():
    for turns in range(-8, 9):
        for angle, sine in ((0, 0), (30, 0.5), (90, 1), (150, 0.5), (180, 0), (210, -0.5), (270, -1), (330, -0.5)):
            assert sin_deg(angle + 360.0 * turns) == sine
            assert cos_deg(angle + 90.0 + 360.0 * turns) == -sine
    assert [tan_deg(x) for x in (0, 45, 135, 180, 225, -45)] == [0, 1, -1, 0, 1, -1]
    assert [asin_deg(0.5), asin_deg(-0.5), acos_deg(0.5), acos_deg(-0.5), acos_deg(1.0), atan_deg(1.0)] == [
        30,
        -30,
        60,
        120,
        0,
        45,
    ]
    assert atan2_deg(1.0, -1.0) == 135.0
    with pytest.raises(ValueError, match="90"):
        tan_deg(90.0)


def test_sines_agree_with_radians_elsewhere():
    for step in range(-720, 721, 7):
        angle = step * 0.77
        assert sin_deg(angle) == pytest.approx(math.sin(math.radians(angle)), abs=3e-15)
        assert cos_deg(angle) == pytest.approx(math.cos(math.radians(angle)), abs=3e-15)
        assert tan_deg(angle) == pytest.approx(math.tan(math.radians(angle)), rel=1e-11, abs=1e-13)


@pytest.mark.parametrize(
    ("value", "told"),
    [
        (1.2, "1,20"),
        (0.92791, "0,928"),
        (120.0, "120"),
        (198257.0, "198000"),
        (-9.996, "−10,0"),
        (0.00060194, "0,000602"),
        (0.0, "0"),
        (1e-6, "1·10⁻⁶"),
        (2.5e7, "2,5·10⁷"),
        (None, "—"),
    ],
)
def test_a_result_has_the_three_digits_a_ruler_tells(value, told):
    assert read_off_text(value, "ru") == told
    assert read_off_text(value, "en") == told.replace(",", ".")


def test_millimetres_and_degrees_have_one_digit_after_the_comma():
    assert [fixed_decimals_text(z, 1, "ru") for z in (60, 73.149, -0.04, -34.74)] == ["60,0", "73,1", "0,0", "−34,7"]


@pytest.mark.parametrize(
    ("unit", "most", "size", "key"),
    [
        ("N", 2e7, 1e6, "MN"),
        ("N·m", 1e4, 1e3, "kN·m"),
        ("N", 9999.0, 1.0, "N"),
        ("W", 0.1, 1.0, "W"),
        ("N", 0.0023, 1e-3, "mN"),
        ("N·m", 2.3e-6, 1e-6, "µN·m"),
        ("N", 0.0, 1.0, "N"),
        ("m/s", 2e7, 1.0, "m/s"),
    ],
)
def test_a_unit_has_the_prefix_that_suits_its_values(unit: str, most: float, size: float, key: str) -> None:
    assert suitable_unit_multiple(unit, most) == (size, key)
    assert all(say(key, lang) for lang in available_languages())
