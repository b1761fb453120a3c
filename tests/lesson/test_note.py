def test_the_note_says_why_each_group_is_determinate() -> None:
    """3n = 2p of every group without a drive inside; their q add up to that of the mechanism without its driver's."""
    from planes.lesson.stated_note import note_of
    from planes.scene import load
    from planes.solving import solve
    from planes.solving.document import Paragraph
    from tests.helpers import ROOT

    scene = load(ROOT / "samples" / "six-link.yaml")
    (position,) = solve(scene).positions
    told = [b.text for b in note_of(scene, position, "en").structure() if isinstance(b, Paragraph)]
    assert sum("3·2 = 2·3, the group is statically determinate" in t and t.endswith("= 3.") for t in told) == 2
