"""What a scene asks for: its sheet, lesson and note show this on the whole scheme, and nothing that follows it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from planes.documents.lesson import note_file_contents
from planes.documents.sheets import sheet_of
from planes.lesson.data import lesson_data
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene, load
from planes.solving import Position, plans_and_requested_results, solve_position
from planes.words.naming import Naming
from render.views.scheme import Scheme
from tests.helpers import ROOT

SAMPLES = ("six-link", "kind-2-rrp", "kind-5-rpp", "sliding-driver", "shaper")


def asks(scene: Scene) -> dict[str, tuple[str, ...]]:
    """A question of each kind, by the last kind of plans it needs."""
    plans = scene_plans(scene)
    point = list(plans.points)[-1]
    reaction = next(r.key for r in plans.reactions.values() if r.plan)
    return {"position": (f"r_{point}",), "velocity": (f"v_{point}",), "force": (reaction,)}


def shown(scene: Scene) -> Position:
    """The position as it is drawn on paper."""
    plans, wanted = plans_and_requested_results(scene, shown=True)
    return solve_position(scene, plans, wanted, plans.mechanism.drive.position, None, "en")


@pytest.mark.few(2)
@pytest.mark.parametrize("kind", ["position", "velocity", "force"])
@pytest.mark.parametrize("name", SAMPLES)
def test_papers_show_what_is_asked_on_the_whole_scheme(name: str, kind: str) -> None:
    every = load(ROOT / "samples" / f"{name}.yaml")
    scene = replace(every, find=asks(every)[kind])
    now, all_of_it = shown(scene), shown(replace(every, find=None))
    naming = Naming("en", scene.frame_number)
    assert len(Scheme(now, naming).drawn_marks()) == len(Scheme(all_of_it, naming).drawn_marks())
    kinds = {plan.kind for plan in now.plans.plan_names}
    assert kind in kinds and (kind == "force" or "force" not in kinds)
    frames = lesson_data(scene)["frames"]
    assert {f["plan"].kind for f in frames} <= kinds
    assert len(frames) < len(lesson_data(replace(every, find=None))["frames"])
    assert sheet_of(scene, None).marks
    heavy = any(link.mass for link in now.plans.mechanism.links.values())
    assert (">kg<" in note_file_contents(scene, None, ".html", "en").decode()) == (kind == "force" and heavy)
