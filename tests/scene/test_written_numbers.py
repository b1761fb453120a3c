"""What is known of how a scene's numbers were written: the decimal where one stands, nothing of what is reckoned."""

from planes.scene import loads
from planes.scene.written_numbers import WrittenNumbers

SCENE = """\
planes: 1
parameters: {l: 0.1234567890123456789, twice: 2*l, same: l}
frame: {points: {A: [0, 0], D: {r: 0.7, angle: -12.3}}}
links:
  1: {points: {A: 0, B: l}}
  2: {points: {B: 0, C: twice}}
  3: {points: {C: 0, D: 0.7, S: −0.31}}
assembly: {C: left}
drive: {link: 1, phi: 60.1, omega: same}
"""


def test_a_decimal_is_known_where_it_stands_and_no_reckoned_number_is() -> None:
    mechanism = loads(SCENE).mechanism
    assert mechanism
    written = mechanism.written
    assert written.decimal_of_number(mechanism.links["1"].points["B"].real) == "0.1234567890123456789"
    assert written.decimal_of_number(-mechanism.drive.velocity) == "-0.1234567890123456789"
    assert written.decimal_of_number(mechanism.links["2"].points["C"].real) == ""
    assert written.decimal_of_number(mechanism.links["3"].points["S"].real) == "-0.31"
    assert written.places[mechanism.frame.points["D"]] == (0.7, -12.3)


def test_two_decimals_of_one_double_are_none() -> None:
    written = WrittenNumbers()
    for text in ("0.1", "0.10", "-1e-1"):
        written.remember_number_text(float(text), text)
    assert written.decimal_of_number(0.1) == "0.1"
    written.remember_number_text(0.1, "0.1000000000000000055")
    assert written.decimal_of_number(0.1) == ""


def test_a_place_written_both_ways_is_not_known() -> None:
    written = WrittenNumbers()
    written.remember_number_text(0.3, "0.3")
    written.remember_polar_place(0.3 + 0.4j, 0.5, 53.13)
    written.remember_polar_place(0.3 + 0.4j)
    assert written.places[0.3 + 0.4j] == () and written.decimal_of_number(0.3) == ""
    assert written.decimal_of_number(0.5) == "0.5"  # a sum of halves is its own double
