"""Links alone: the plan of each closes with the reaction inside its group, and is on sheet 2 and in the note."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

from planes.documents.lesson import note_position
from planes.documents.sheets import sheet_of
from planes.lesson.note import Note
from planes.plans.apart import links_with_own_polygon
from planes.scene import load
from planes.solving.document import DrawnViews, Figure
from render.paper.marks import Text
from tests.helpers import ROOT

SAMPLES = sorted(p for p in (ROOT / "samples").rglob("*.yaml") if not {"assignments", "course", "vectors"} & {*p.parts})
SCENES = {p.stem: scene for p in SAMPLES if (scene := load(str(p))).mechanism}


@pytest.mark.few(12, slow=22)
@pytest.mark.parametrize("name", SCENES)
def test_every_link_alone_is_in_balance(name: str) -> None:
    """All forces but the last are found before; the last is the reaction of the results."""
    drawn = note_position(SCENES[name], None, "en")
    plans = drawn.plans
    for one in (x for plan in plans.plan_names for x in links_with_own_polygon(plans, plan)):
        marks = one.vector_end_marks(plans, drawn.drawing)
        r, back = one.reactions[one.force]
        force = -[*(marks or {}).values()][-1] / drawn.scales[one.group.mu_name]
        found = drawn.of("reactions")[r.key].vector * (-1 if back else 1)
        assert (
            abs(force - found) <= 1e-9 * max(map(abs, (marks or {0: 1.0}).values())) / drawn.scales[one.group.mu_name]
        )
        assert not math.isnan(abs(force)) and one.force not in one.known


def test_they_are_on_sheet_2_and_in_the_note() -> None:
    scene = SCENES["six-link"]
    drawn = note_position(scene, None, "ru")
    texts = {m.text for m in sheet_of(scene, None, "ru", 2).marks if isinstance(m, Text)}
    assert any(t.startswith("План сил звена 3, μ_{F} = 0,01") for t in texts)
    assert not any(t.startswith("План сил звена 4") for t in texts)  # two opposite vectors: its equation alone
    figures = [b for b in Note(scene, drawn, "ru").document_blocks() if isinstance(b, Figure)]
    shown = [f for f in figures if isinstance(f.of, DrawnViews) and f.of.views == (("force:3",),)]
    assert len(shown) == 1 and "0,01" in shown[0].caption


@pytest.mark.parametrize(("asked", "shown"), [("F_30^t", False), ("F_30", True), ("F_32", True)])
def test_a_link_alone_is_in_the_note_where_its_reactions_are_drawn(asked: str, shown: bool) -> None:
    """The part of F_30 across its link comes from moments: where it alone is sought, the plan of the group stops at
    its end, and F_30 itself has a start and no end."""
    scene = replace(SCENES["six-link"], find=(asked,))
    drawn = note_position(scene, None, "en")
    r = drawn.plans.reactions["F_30"]
    assert r.start in drawn.drawing and (r.end in drawn.drawing) == shown
    views = [
        f.of.views
        for f in Note(scene, drawn, "en").document_blocks()
        if isinstance(f, Figure) and isinstance(f.of, DrawnViews)
    ]
    assert ((("force:3",),) in views) == shown and (("force:2-3",),) in views
