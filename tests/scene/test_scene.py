"""Floor 2: scene files, read in full."""

import pytest

from planes.scene import VectorGiven, load, loads
from planes.scene.mechanism import Assembly, Drive, Guide, Link, Load, Slide
from planes.words.errors import SceneError
from tests.helpers.scene_texts import SIX_LINK, VECTORS, changed

LINKS = {
    "1": Link("1", {"A": 0j, "B": 0.1 + 0j}, {}, None, 60.0, 5.0),
    "2": Link(
        "2",
        {"B": 0j, "C": 0.3 + 0j, "S2": 0.2 + 0j, "N": 0.1 + 0.05j, "Q": complex(0.2 * 3**0.5 / 2, 0.1)},
        {"CL": Guide("CL", 0.3 + 0j, -90.0, "C")},
        None,
        40.0,
        2.0,
        "S2",
    ),
    "3": Link("3", {"D": 0j, "C": 0.15 + 0j}, {}, None, 70.0, 0.5),
    "4": Link("4", {"H": 0j}, {}, Slide("CL")),
    "5": Link("5", {"H": 0j}, {}, Slide("y-y"), 50.0),
}


def test_the_example_is_read_in_full():
    scene = loads(SIX_LINK, "six-link.yaml")
    mechanism = scene.mechanism
    assert mechanism is not None
    assert {*scene.title.values()} == {"Шестизвенный рычажный механизм"}
    assert (scene.file, scene.variant, scene.variants, scene.frame_number) == ("six-link.yaml", None, ("А",), "0")
    assert scene.parameters == {"l_AB": 0.1, "l_BC": 0.3, "phi_1": 150.0}
    assert mechanism.frame == Link(
        "0", {"A": 0j, "D": -0.35 - 0.27j}, {"y-y": Guide("y-y", -0.42 + 0j, 90.0, origin_given=False)}
    )
    assert list(mechanism.links) == ["1", "2", "3", "4", "5"]
    for name, link in LINKS.items():
        read = mechanism.links[name]
        assert list(read.points) == list(link.points)
        assert all(abs(read.points[p] - link.points[p]) < 1e-16 for p in link.points)
        assert {**vars(read), "points": None} == {**vars(link), "points": None}
    assert mechanism.drive == Drive("1", "phi", 150.0, -20.0, 80.0)
    assert mechanism.loads == (
        Load("5", "force", 6000.0, "H", sense="against"),
        Load("3", "moment", 45.0, sense="against"),
    )
    assert (mechanism.gravity, mechanism.friction) == (9.81, {"y-y": 0.15})
    assert mechanism.assembly == {"C": Assembly("right")}
    assert scene.mu == {"position": 250.0, "velocity": 30.0, "acceleration": 2.0, "force": 0.01}
    assert scene.find == ("v_C", "a_H", "omega_2", "F_21", "M_1")
    assert (scene.statement, scene.sheet) == (None, {})


@pytest.mark.parametrize(
    ("path", "line"),
    [
        (("links", "2"), 11),
        (("links", "2", "points", "C"), 11),
        (("links", "2", "guides", "CL"), 12),
        (("assembly", "C"), 16),
        (("drive",), 17),
        (("loads", "0"), 19),
        (("loads", "1"), 20),
        (("friction", "y-y"), 22),
        (("find",), 28),
        (("frame", "guides", "y-y"), 8),
        (("frame", "points", "D"), 7),
        (("links", "5", "slides"), 15),
    ],
)
def test_lines_are_kept(path, line):
    assert loads(SIX_LINK).mechanism.where[path] == line


def test_a_variant_overrides_parameters():
    scene = loads(SIX_LINK, variant="А")
    assert (scene.parameters["phi_1"], scene.mechanism.drive.position, scene.variant) == (160.0, 160.0, "А")
    derived = SIX_LINK.replace("l_BC: 0.3,", "l_BC: 3*l_AB,").replace("{phi_1: 160}", "{phi_1: 10*l_AB, l_AB: 0.2}")
    assert loads(derived, variant="А").parameters == {"l_AB": 0.2, "l_BC": 0.2 * 3, "phi_1": 2.0}
    assert loads(derived).mechanism.links["2"].points["C"] == 0.1 * 3
    assert loads(SIX_LINK.replace("  А:", "  й:"), variant="и\u0306").variant == "й"


def mechanism(old, new):
    return loads(changed(old, new)).mechanism


def test_other_forms_of_the_same_things():
    assert mechanism("{x: -0.42}", "{y: 0.1, mark: K}").guide("y-y") == Guide("y-y", 0.1j, 0.0, None, "K", False)
    assert mechanism("{x: -0.42}", "{through: [0, 1], angle: 3}").guide("y-y") == Guide("y-y", 1j, 3.0)
    assert mechanism("{x: -0.42}", "{through: D}").guide("y-y") == Guide("y-y", -0.35 - 0.27j, 0.0, "D")
    assert mechanism("{x: -0.42}", "{through: {r: 2, angle: 90}}").guide("y-y") == Guide("y-y", 2j, 0.0)
    slide = mechanism("slides: CL", "slides: {guide: CL, angle: 20, offset: l_AB/2}").links["4"].slides
    assert slide == Slide("CL", 20.0, 0.05)
    assert mechanism("C: right", "C: {near: [0.1, -1]}").assembly == {"C": Assembly(near=0.1 - 1j)}
    assert mechanism("C: right", "CL: behind").assembly == {"CL": Assembly("behind")}
    assert mechanism("C: right", "").assembly == {}
    assert mechanism("phi: phi_1, omega: -20, epsilon: 80", "phi: 30*2").drive == Drive("1", "phi", 60.0)
    sliding = mechanism(
        "link: 1, phi: phi_1, omega: -20, epsilon: 80", "link: 5, s: 0.1, velocity: 2, acceleration: -1"
    )
    assert sliding.drive == Drive("5", "s", 0.1, 2.0, -1.0)


def test_other_forms_of_loads():
    def first(given):
        return mechanism("against: motion}   #", given + "}  #").loads[0]

    assert first("along: motion") == Load("5", "force", 6000.0, "H", sense="along")
    assert first("direction: 45*2") == Load("5", "force", 6000.0, "H", 90.0)
    assert first("direction: {link: 3, angle: 90}") == Load("5", "force", 6000.0, "H", 90.0, "3")
    assert first("direction: {link: 0, angle: 90}") == Load("5", "force", 6000.0, "H", 90.0)
    assert mechanism("moment: 45, against: motion", "moment: -45").loads[1] == Load("3", "moment", -45.0)


def test_what_may_be_left_out():
    text = (
        "planes: 1\nframe: {points: {A: 0}}\nlinks: {1: {points: {A: 0, B: 1}, inertia: 2}}\ndrive: {link: 1, phi: 0}\n"
    )
    scene = loads(text + "loads:\nfriction: ~\nassembly: null\ntitle:\nplans: {velocity: auto, force: {mu: auto}}\n")
    assert not any(scene.title.values()) and scene.find is None and scene.parameters == {}
    assert scene.mechanism.gravity is None and scene.mechanism.loads == ()
    assert (scene.mechanism.links["1"].mass, scene.mechanism.links["1"].inertia) == (None, 2.0)
    assert set(scene.mu.values()) == {None}


def test_words_and_sheet():
    scene = loads(
        changed("frame:\n", "frame:\n  number: 6\n", SIX_LINK) + "note: {en: Hello}\n"
        "sheet: {group: 01-21, number: 007, font: ISOCPEUR, positions: 12, mass: 1e1, format: а3, "
        "reactions: from-on, letter: [У, 2], revisions: [{sign: Я}, [1, 2]]}\n"
    )
    assert scene.frame_number == "6" and {*scene.note.values()} == {"Hello"}
    assert scene.sheet == {
        "group": "01-21",
        "number": "007",
        "font": "ISOCPEUR",
        "positions": True,
        "mass": 10.0,
        "format": "A3",
        "reactions": "from-on",
        "letter": ["У", "2"],
        "revisions": [{"sign": "Я"}, {"change": "1", "sheet": "2"}],
    }
    titled = changed("title: Шестизвенный рычажный механизм", "title: {ru: а, en: b}")
    assert (loads(titled).title["ru"], loads(titled).title["en"]) == ("а", "b")


def test_names_of_any_alphabet_and_keys_that_are_not_booleans():
    text = (
        "planes: 1\nparameters: {длина: 1e-3, y: 2}\nframe: {points: {on: 0, y: [1, 1], O′: 3}}\n"
        "links: {кривошип: {points: {on: 0, 7: длина*y}}, no: {points: {7: 0, и\u0306: 1}, centre: й}}\n"
        "drive: {link: кривошип, phi: 0}\nassembly: {7: left}\n"
    )
    mechanism = loads(text).mechanism
    assert list(mechanism.frame.points) == ["on", "y", "O′"] and list(mechanism.links) == ["кривошип", "no"]
    assert mechanism.links["кривошип"].points["7"] == 0.002 and mechanism.links["no"].mass_centre == "й"


def test_a_scene_of_vectors():
    scene = loads(VECTORS)
    (equation,) = scene.statement.equations
    assert scene.mechanism is None and (equation.text, equation.line) == ("v_C = v_B + v_CB", 6)
    assert scene.statement.vectors == {
        "v_B": VectorGiven(2.0, 120.0),
        "v_CB": VectorGiven(None, 35.0),
        "v_C": VectorGiven(None, 80.0),
    }
    assert (scene.mu["velocity"], scene.statement.quantity) == (30.0, "velocity")
    other = changed("{direction: 35}", "{perpendicular_to: 125, near: -20}", VECTORS).replace("mu: 30 mm/(m/s)", "")
    scene = loads(changed("{direction: 80}", "", other))
    stated = scene.statement.vectors
    assert stated["v_CB"] == VectorGiven(None, 215.0, -20.0) and stated["v_C"] == VectorGiven()
    assert (scene.mu["velocity"], scene.statement.quantity) == (None, None)


def test_a_file_on_disk(tmp_path):
    path = tmp_path / "механизм.yaml"
    path.write_text(SIX_LINK, encoding="utf-8")
    assert load(path).mechanism == load(str(path)).mechanism == loads(SIX_LINK).mechanism
    path.write_text(changed("mass: 60", "mass: -60"), encoding="utf-8")
    with pytest.raises(SceneError, match=r"механизм.yaml:10: mass of link 1 cannot be negative, but is -60"):
        load(path)


def test_a_small_number_written_back_is_read_again():
    text = (
        "planes: 1\nframe: {points: {A: 0}}\nlinks: {1: {points: {A: 0, B: 0.1}, mass: 1, inertia: 1e-05}}\n"
        "drive: {link: 1, phi: 30}\n"
    )
    written = loads(text).to_yaml()
    assert "!!" not in written and loads(written).mechanism.links["1"].inertia == 1e-05
