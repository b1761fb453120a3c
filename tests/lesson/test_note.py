def test_the_note_says_why_each_group_is_determinate() -> None:
    """3n = 2p of every group without a drive inside; their q add up to that of the mechanism without its driver's."""
    from planes.lesson.stated_note import position_note
    from planes.scene import load
    from planes.solving import solve
    from planes.solving.document import Paragraph
    from tests.helpers import ROOT

    scene = load(ROOT / "samples" / "six-link.yaml")
    (position,) = solve(scene).positions
    told = [b.text for b in position_note(scene, position, "en").structure_blocks() if isinstance(b, Paragraph)]
    assert sum("3·2 = 2·3, the group is statically determinate" in t and t.endswith("= 3.") for t in told) == 2


def test_loads_and_poles_of_statics_may_be_changed_in_a_lesson() -> None:
    from planes.lesson.told import SceneLesson
    from planes.scene import load
    from tests.helpers import ROOT

    for name, given in (("beam", {"|P_C|", "|pO|", "angle_∠O"}), ("truss-king-post", {"|P_C|", "angle_∠P_C"})):
        knobs = SceneLesson.of(load(ROOT / "samples" / "statics" / f"{name}.yaml")).knobs
        own = {k["given"]: k for k in knobs.offered_numbers}
        assert given <= own.keys() and not any("when" in k for k in knobs.offered_numbers)
        assert "position:C" in knobs.numbers_fixing_marks()


def test_the_results_hold_the_balancing_load_by_the_symbol_of_the_figures() -> None:
    from planes.lesson.stated_note import position_note
    from planes.scene import load
    from planes.solving import solve
    from planes.solving.document import Paragraph
    from planes.words.naming import Naming
    from tests.helpers import ROOT

    scene = load(ROOT / "samples" / "crank-slider.yaml")
    (position,) = solve(scene).positions
    told = [b.text for b in position_note(scene, position, "en").result_blocks() if isinstance(b, Paragraph)]
    assert any(text.startswith("Balancing moment: ⟨M_1⟩ = ") for text in told)
    assert [Naming(lang).lettered_vector("M_1") for lang in ("en", "ru")] == ["M_{b}", "M_{ур}"]
