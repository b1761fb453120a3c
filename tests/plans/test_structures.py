"""Bodies and trusses in equilibrium: reactions and members against linear equations that know no plan, and refusals."""

from __future__ import annotations

import math
import random
from dataclasses import replace
from itertools import pairwise

import pytest
from shapely import Point
from shapely.ops import polygonize

from planes.scene import load, loads
from planes.solving import solve
from planes.words.errors import SceneError
from tests.helpers import ROOT
from tests.helpers.equilibrium import members, reactions

TINY = 1e-12


def places(**points: complex) -> str:
    return "points: {" + ", ".join(f"{n}: [{z.real!r}, {z.imag!r}]" for n, z in points.items()) + "}\n"


def agrees(text: str) -> None:
    """Every reaction as the independent solver has it, to twelve digits of the largest."""
    (position,) = solve(loads("planes: 1\n" + text)).positions
    found, truth = position.of("vectors"), reactions(text)
    values = position.of("values")
    most = max(abs(z) for n, z in truth.items() if not n.startswith("M_"))
    for name, z in truth.items():
        own = values[name].number if name.startswith("M_") else found[name].vector
        assert abs(own - z) <= TINY * max(most, abs(z)), (name, own, z)


def beam(r: random.Random, method: str) -> str:
    """A hinge, a roller at any angle, and one to five forces at any angles."""
    count = 1 if method == "three-forces" else r.randint(1, 5)
    loaded = {f"P{k}": complex(r.uniform(0.3, 5.7), r.uniform(-1, 1)) for k in range(count)}
    text = places(A=0j, B=complex(6, r.uniform(-1, 1)), **loaded)
    text += f"supports: {{A: hinge, B: {{roller: {r.uniform(50, 130)!r}}}}}\nloads:\n"
    text += "".join(
        f"  - {{point: {p}, force: {r.uniform(1, 9)!r}, direction: {r.uniform(-150, -30)!r}}}\n" for p in loaded
    )
    return text + f"method: {method}\n"


def three_rods(r: random.Random, method: str) -> str:
    """A body on three rods that are far from one point."""
    ways = [cmath_rect(r.uniform(1, 2), t + r.uniform(-0.3, 0.3)) for t in (1.9, 3.6, -1.2)]
    text = places(A=0j, B=3 + 0j, C=1.5 + 1j, D=complex(r.uniform(1, 2), 0.5), E=ways[0], F=ways[1], G=3 + ways[2])
    text += "bodies: {1: [A, B, C, D]}\nsupports: {A: [{rod: E}, {rod: F}], B: {rod: G}}\n"
    text += f"loads: [{{point: D, force: {r.uniform(1, 9)!r}, direction: {r.uniform(-120, -60)!r}}}]\n"
    return text + f"method: {method}\n"


def cmath_rect(size: float, angle: float) -> complex:
    return complex(size * math.cos(angle), size * math.sin(angle))


def clamped(r: random.Random, method: str) -> str:
    """A clamp under a force, a distributed load and a couple."""
    text = places(A=0j, B=complex(r.uniform(1, 4), 0), C=complex(r.uniform(1, 4), r.uniform(-2, 2)))
    force, turn, angle, first, last = (r.uniform(*x) for x in ((1, 9), (-180, 180), (-120, -60), (0, 3), (1, 5)))
    text += f"supports: {{A: clamp}}\nloads:\n  - {{point: C, force: {force!r}, direction: {turn!r}}}\n"
    text += f"  - {{from: A, to: B, intensity: [{first!r}, {last!r}], direction: {angle!r}}}\n"
    return text + f"  - {{moment: {r.uniform(-9, 9)!r}}}\nmethod: {method}\n"


def chained(r: random.Random, method: str) -> str:
    """A beam that hangs on another."""
    text = places(A=0j, B=4 + 0j, C=complex(r.uniform(4.5, 6), 0), D=9 + 0j, E=complex(r.uniform(1, 3), 0), F=7 + 0j)
    text += "bodies: {1: [A, E, B, C], 2: [C, F, D]}\nsupports: {A: hinge, B: roller, D: roller}\nloads:\n"
    for p in "EF":
        text += f"  - {{point: {p}, force: {r.uniform(1, 9)!r}, direction: {r.uniform(-130, -50)!r}}}\n"
    return text + f"method: {method}\n"


def arched(r: random.Random, method: str) -> str:
    """Three hinges, a force on either side of the middle one, a distributed load and a couple."""
    text = places(A=0j, B=complex(8, r.uniform(-1, 1)), C=complex(r.uniform(3, 5), r.uniform(2, 4)), D=1 + 1j, E=6 + 2j)
    text += "bodies: {1: [A, D, C], 2: [C, E, B]}\nsupports: {A: hinge, B: hinge}\nloads:\n"
    for p in "DE":
        text += f"  - {{point: {p}, force: {r.uniform(1, 9)!r}, direction: {r.uniform(-180, 180)!r}}}\n"
    text += f"  - {{from: A, to: C, intensity: {r.uniform(1, 3)!r}}}\n  - {{moment: {r.uniform(-5, 5)!r}, body: 2}}\n"
    return text + f"method: {method}\n"


KINDS = [
    (arched, "moments"),
    (beam, "moments"),
    (beam, "string"),
    (beam, "three-forces"),
    (beam, "composition"),
    (three_rods, "moments"),
    (three_rods, "culmann"),
    (three_rods, "string"),
    (clamped, "moments"),
    (chained, "moments"),
    (chained, "string"),
]


def sharp(make: object, method: str, r: random.Random) -> str | None:
    """Loads taken together must meet well: composition fails where they do not, and says so."""
    text = make(r, method)  # type: ignore[operator]
    try:
        solve(loads("planes: 1\n" + text))
    except SceneError:
        assert method == "composition"
        return None
    return str(text)


@pytest.mark.parametrize(("make", "method"), KINDS)
def test_reactions_are_those_of_linear_equations(make: object, method: str) -> None:
    r = random.Random(f"{make.__name__} {method}")  # type: ignore[attr-defined]
    for text in [sharp(make, method, r) for _ in range(5)]:
        if text:
            agrees(text)


@pytest.mark.slow
@pytest.mark.parametrize(("make", "method"), KINDS)
def test_two_hundred_of_each_kind(make: object, method: str) -> None:
    r = random.Random(f"many {make.__name__} {method}")  # type: ignore[attr-defined]
    drawn = [text for _ in range(200) if (text := sharp(make, method, r))]
    for text in drawn:
        agrees(text)
    assert len(drawn) > 150


def girder(r: random.Random) -> str:
    """A truss of triangles between two chords, loaded along both."""
    n = r.randint(2, 6)
    low = {f"B{k}": complex(k + r.uniform(-0.1, 0.1), r.uniform(-0.2, 0.2)) for k in range(n + 1)}
    high = {f"T{k}": complex(k + 0.5 + r.uniform(-0.1, 0.1), r.uniform(0.6, 1.4)) for k in range(n)}
    pairs = [(f"B{k}", f"B{k + 1}") for k in range(n)] + [(f"T{k}", f"T{k + 1}") for k in range(n - 1)]
    pairs += [p for k in range(n) for p in ((f"B{k}", f"T{k}"), (f"T{k}", f"B{k + 1}"))]
    r.shuffle(pairs)
    text = places(**low, **high) + "members: [" + ", ".join(f"[{a}, {b}]" for a, b in pairs) + "]\n"
    text += f"supports: {{B0: hinge, B{n}: {{roller: {r.uniform(60, 120)!r}}}}}\nloads:\n"
    for joint in r.sample([*low, *high], r.randint(1, n + 2)):
        text += f"  - {{point: {joint}, force: {r.uniform(1, 9)!r}, direction: {r.uniform(-180, 180)!r}}}\n"
    return text


FINK = """points: {A: [0, 0], B: [12, 0], C: [6, 4], D: [4, 0.5], E: [8, 0.5], F: [1.5, 1], G: [3, 2], H: [4.5, 3],
  I: [7.5, 3], J: [9, 2], K: [10.5, 1], L: [2, 0.25], M: [5, 2.25], N: [10, 0.25], P: [7, 2.25]}
members: [[A, F], [F, G], [G, H], [H, C], [C, I], [I, J], [J, K], [K, B], [A, L], [L, D], [D, E], [E, N], [N, B],
  [F, L], [L, G], [G, D], [G, M], [H, M], [D, M], [M, C], [K, N], [N, J], [J, E], [J, P], [I, P], [E, P], [P, C]]
supports: {A: hinge, B: roller}
loads:
"""


def fink(r: random.Random) -> str:
    """A roof truss that joints alone do not solve: three joints in a row have three unknown members each."""
    return FINK + "".join(f"  - {{point: {p}, force: {r.uniform(1, 9)!r}, direction: -90}}\n" for p in "FGHCIJK")


def carries(text: str) -> None:
    """Every member as the node solver has it."""
    (position,) = solve(loads("planes: 1\n" + text)).positions
    truth = members(text)
    most = max(1.0, *map(abs, truth.values()))  # loads are no smaller: in a hinge they reach no member
    for name, force in truth.items():
        assert abs(position.of("values")[name].number - force) <= 3 * TINY * most, name


@pytest.mark.parametrize("make", [girder, fink])
def test_members_are_those_of_the_joints_equations(make: object) -> None:
    r = random.Random(make.__name__)  # type: ignore[attr-defined]
    for _ in range(5):
        carries(make(r))  # type: ignore[operator]


@pytest.mark.slow
@pytest.mark.parametrize("make", [girder, fink])
def test_two_hundred_trusses(make: object) -> None:
    r = random.Random(f"many {make.__name__}")  # type: ignore[attr-defined]
    for _ in range(200):
        carries(make(r))  # type: ignore[operator]


def test_a_truss_says_how_its_members_are_strained() -> None:
    """A king post: rafters pressed, tie pulled, the post idle; by a cut where joints stop."""
    from planes.plans.structures.figure import member_strains

    text = "points: {A: [0, 0], B: [4, 0], C: [2, 2], D: [2, 0]}\nmembers: [AC, CB, AD, DB, CD]\n"
    text += "supports: {A: hinge, B: roller}\nloads: [{point: C, force: 10000, direction: -90}]\n"
    (position,) = solve(loads("planes: 1\n" + text)).positions
    told = member_strains(position.plans.figure, position.drawing)
    assert told == {"S_AC": "compression", "S_CB": "compression", "S_AD": "tension", "S_DB": "tension", "S_CD": "idle"}
    assert position.of("values")["S_AC"].number == pytest.approx(-5000 * math.sqrt(2), rel=1e-14)
    rounding = {**position.drawing.things, "S_CD": 1e-6}  # beside 7071 N
    assert member_strains(position.plans.figure, replace(position.drawing, things=rounding))["S_CD"] == "idle"


BAR = "points: {A: [0, 0], B: [4, 0], C: [1, 0], E: [4, 3]}\nbodies: {1: [A, C, B]}\n"
ARCH = "points: {A: [0, 0], B: [8, 0], C: [4, 3]}\nbodies: {1: [A, C], 2: [C, B]}\nsupports: {A: hinge, B: hinge}\n"
LOAD = "loads: [{point: C, force: 5, direction: -90}]\n"
TRIANGLE = "points: {A: [0, 0], B: [4, 0], C: [2, 2], D: [2, 3]}\n"
PINNED = "supports: {A: hinge, B: roller}\nloads: [{point: C, force: 5, direction: -90}]\n"


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            BAR + "supports: {A: hinge}\n" + LOAD,
            "2 unknown reactions and 3 equations of equilibrium: this is a mechanism",
        ),
        (BAR + "supports: {A: hinge, B: hinge}\n" + LOAD, "statically indeterminate, with 1 redundant"),
        (BAR + "supports: {A: hinge, B: {roller: 0}}\n" + LOAD, "passes through the hinge A"),
        (BAR + "supports: {A: [roller], B: [roller], C: roller}\n" + LOAD, "meet in one point or are parallel"),
        (
            BAR + "supports: {A: hinge, B: {rope: E}}\nloads: [{point: C, force: 5, direction: 90}]\n",
            "rope BE would have",
        ),
        (
            BAR + "supports: {A: hinge, B: roller}\n" + LOAD + "method: three-forces\n",
            "parallel to the line of the reaction",
        ),
        (BAR + "supports: {A: hinge, B: roller}\n" + LOAD + "method: culmann\n", "is not for these supports"),
        (BAR + "supports: {A: clamp}\n" + LOAD + "method: string\n", "does not give the moment in the clamp"),
        (BAR + "supports: {A: hinge, B: roller}\nloads: [{moment: 3}]\nmethod: string\n", "the couple M_1 acts"),
        (BAR + "supports: {A: hinge, B: rod}\n" + LOAD, "needs another fixed point"),
        (BAR + "supports: {A: hinge, Z: roller}\n" + LOAD, 'there is no point "Z"'),
        (BAR + "loads: [{point: E, force: 5, direction: 0}]\n", "belongs to no body"),
        (BAR + "loads: [{from: A, to: A, intensity: 5}]\n", "must have a length"),
        (TRIANGLE + "members: [AB, BC, CD, AD]\n" + PINNED, "2j > m + r"),
        (TRIANGLE + "members: [AB, BC, CA, CD, AD, BD]\n" + PINNED, "2j < m + r"),
        (TRIANGLE + "members: [AB, BC, CA]\n" + PINNED, "no member ends at D"),
        (TRIANGLE + "members: [AB, BC, CX]\n" + PINNED, "which two points"),
        (TRIANGLE + "members: [AB, BC, AB]\n" + PINNED, "listed once"),
        (TRIANGLE + "members: [AD, DB, AB, AC, CB]\n" + PINNED, "inside the truss"),
        (ARCH.replace("C: [4, 3]", "C: [4, 0]"), "lie on one line"),
        (ARCH.replace("B: hinge", "B: roller"), "this is a mechanism"),
        (BAR + "supports: {A: hinge, E: roller}\n" + LOAD, "belongs to no body"),
        (BAR.replace("E: [4, 3]", "E: [4, 0]") + "supports: {A: hinge, B: roller}\n" + LOAD, "are in one place"),
        (ARCH.replace("{A: hinge, B: hinge}", "{A: [clamp, {roller: 0}]}") + LOAD, "body 2 has 2 unknown reactions"),
        (BAR + "supports: {A: hinge, B: roller}\n" + LOAD.replace("5", "0") + "method: string\n", "at least one force"),
        (BAR + "vectors: {F: {value: 1, direction: 0}}\n", "do not go together"),
    ],
)
def test_what_cannot_stand_is_refused_in_a_sentence(text: str, said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        solve(loads("planes: 1\n" + text))
    told = refusal.value.told("en")
    assert said in told and told.startswith("scene.yaml:"), told
    assert refusal.value.told("ru") != told


def straight(r: random.Random) -> tuple[str, list[tuple[float, float]], dict[str, float]]:
    """A beam on supports anywhere, forces across it anywhere; forces with reactions, and places of points, along it."""
    stops = sorted(r.uniform(0, 9) for _ in range(7))
    names = r.sample("ABCDEFG", 7)
    at = dict(zip(names, stops, strict=True))
    hinge, roller = r.sample(names[1:-1], 2)
    loaded = r.sample([n for n in names if n not in (hinge, roller)], 4)
    sizes = {n: r.uniform(1, 9) * r.choice((1, 1, -1)) for n in loaded}
    text = (
        places(**{n: complex(x, 0) for n, x in at.items()})
        + f"supports: {{{hinge}: hinge, {roller}: roller}}\nloads:\n"
    )
    text += "".join(f"  - {{point: {n}, force: {v!r}, direction: -90}}\n" for n, v in sizes.items())
    push = sum(v * (at[n] - at[hinge]) for n, v in sizes.items()) / (at[roller] - at[hinge])
    forces = [(at[n], -v) for n, v in sizes.items()] + [(at[roller], push), (at[hinge], sum(sizes.values()) - push)]
    return text + "method: string\n", forces, at


def bends(r: random.Random) -> None:
    """Every bending moment and shear as the sums over the forces to the left have them."""
    text, forces, at = straight(r)
    (position,) = solve(loads("planes: 1\n" + text)).positions
    found = {n: f.number for n, f in position.of("values").items()}
    most = max(abs(f) for _, f in forces)
    order = sorted(at, key=at.__getitem__)
    for point in order:
        moment = sum(f * (at[point] - x) for x, f in forces if x < at[point])
        assert abs(found[f"M_{point}"] - moment) <= 1e-12 * 9 * most * 4
    for one, other in pairwise(order):
        name = f"Q_{one}{other}" if f"Q_{one}{other}" in found else f"Q_{other}{one}"
        shear = sum(f for x, f in forces if x < (at[one] + at[other]) / 2)
        assert abs(found[name] - shear) <= 1e-12 * 4 * most, name


def test_ordinates_of_the_string_polygon_are_bending_moments() -> None:
    r = random.Random(8)
    for _ in range(6):
        bends(r)


@pytest.mark.slow
def test_two_hundred_beams_bend() -> None:
    r = random.Random(88)
    for _ in range(200):
        bends(r)


def test_a_distributed_load_bends_the_beam_between_its_ends() -> None:
    """2 kN/m over 4 m: qL²/8 in the middle, a shear from qL/2 to -qL/2; a triangular load by its cubic."""
    from planes.diagrams.beams import beam_outlines

    text = "points: {A: [0, 0], B: [4, 0]}\nsupports: {A: hinge, B: roller}\n"
    text += "loads: [{from: A, to: B, intensity: %s}]\nmethod: string\n"
    for q, peak, left in (("2000", 2000 * 16 / 8, 4000.0), ("[0, 3000]", 3000 * 16 / (9 * math.sqrt(3)), 2000.0)):
        (position,) = solve(loads("planes: 1\n" + text % q)).positions
        found = beam_outlines(position)
        assert found and max(v for _, v in found.moments) == pytest.approx(peak, rel=2e-3)
        assert found.shears[1][1] == pytest.approx(left) and found.shears[-2][1] == pytest.approx(left - abs(sum_of(q)))


def sum_of(q: str) -> float:
    return {"2000": 8000.0, "[0, 3000]": 6000.0}[q]


THROUGH = """points: {A: [0, 0], C: [4, 3], B: [8, 1], D: [1.5, 2.5], E: [3, 3], F: [5.5, 3]}
bodies: {1: [A, D, E, C, F, B]}
loads:
  - {point: D, force: 2000, direction: -90}
  - {point: E, force: 1500, direction: -80}
  - {point: F, force: 2500, direction: -100}
pole: {through: [A, %sB]}
"""


@pytest.mark.parametrize("middle", ["", "C, "])
def test_strings_go_through_the_points_they_are_to(middle: str) -> None:
    (position,) = solve(loads("planes: 1\n" + THROUGH % middle)).positions
    drawn, mark = position.drawing, lambda p: complex(position.drawing[f"position:{p}"])
    rays = [complex(drawn[f"∥{k}"]) for k in range(4)]
    knots = [mark(p) for p in ("A", "1", "2", "3")]
    off = lambda z, k: abs(((z - knots[k]) * rays[k].conjugate()).imag)  # noqa: E731
    assert off(mark("B"), 3) < 1e-12 * 100
    figure = position.plans.figure
    assert figure and {s.name for s in figure.strokes if s.kind == "string"} == {"0", "1", "2", "3"}
    assert not middle or off(mark("C"), 2) < 1e-12 * 100


def test_strings_through_points_refuse_loads_out_of_order() -> None:
    turned = (
        THROUGH.replace("{point: D,", "{point: X,")
        .replace("{point: F,", "{point: D,")
        .replace("{point: X,", "{point: F,")
    )
    for text in (turned % "C, ", THROUGH.replace("C: [4, 3]", "C: [1, 3]") % "C, "):
        with pytest.raises(SceneError) as refusal:
            solve(loads("planes: 1\n" + text))
        assert "are not in order between" in refusal.value.told("en")


@pytest.mark.parametrize("pole", ["[187.93852415718169, -68.40402866513374]", "{r: 200, angle: -20}"])
def test_a_chosen_pole_stands_where_it_is_said(pole: str) -> None:
    """In newtons from where the polygon of forces begins; the resultant knows nothing of it."""
    text = "points: {A: [0, 0], B: [2, 0.5], C: [4, 0]}\nloads:\n"
    for p, size, angle in (("A", 100, -80), ("B", 150, -100), ("C", 80, -60)):
        text += f"  - {{point: {p}, force: {size}, direction: {angle}}}\n"
    (position,) = solve(loads(f"planes: 1\n{text}pole: {pole}\n")).positions
    mu = position.scales["mu_force"]
    assert abs(complex(position.drawing["force:O"]) / mu - complex(187.93852415718169, -68.40402866513374)) < 1e-10
    (free,) = solve(loads(f"planes: 1\n{text}")).positions
    (own, other) = (p.of("vectors")["R"].vector for p in (position, free))
    assert abs(own - other) < 1e-12 * abs(own)
    knots = [complex(p.drawing["position:K"]) / p.scales["mu_position"] for p in (position, free)]
    assert abs(((knots[0] - knots[1]) * own.conjugate()).imag) < 1e-11 * abs(own)  # one line of action


@pytest.mark.parametrize(("direction", "measured"), [(-90, True), (-60, False)])
def test_moments_and_shears_are_measured_where_loads_stand_across_the_beam(direction: float, measured: bool) -> None:
    text = (
        "planes: 1\nmethod: string\npoints: {A: [0, 0], C: [1, 0], B: [3, 0]}\nsupports: {A: hinge, B: {roller: 90}}\n"
    )
    (position,) = solve(loads(text + f"loads: [{{point: C, force: 1200, direction: {direction}}}]\n")).positions
    assert bool(position.of("values")) == measured


@pytest.mark.parametrize("name", ["truss-king-post", "truss-warren", "truss-roof-wind"])
def test_letters_of_outer_regions_stand_beside_the_middle_of_a_member(name: str) -> None:
    """Bow's notation: those of inner regions are within their triangles."""
    (position,) = solve(load(ROOT / "samples" / "statics" / f"{name}.yaml")).positions
    figure = position.plans.figure
    assert figure
    bars = [(figure.points[a], figure.points[b]) for _, a, b in figure.members]
    truss = polygonize([((a.real, a.imag), (b.real, b.imag)) for a, b in bars])
    cells = list(truss)
    outer = [z for z in figure.letters.values() if not any(c.contains(Point(z.real, z.imag)) for c in cells)]
    assert len(outer) > 1 and len(outer) + len(cells) == len(figure.letters)
    for z in outer:
        a, b = min(bars, key=lambda ends: abs(z - sum(ends) / 2))
        assert ((z - a) / (b - a)).real == pytest.approx(0.5)
