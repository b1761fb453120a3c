"""The plans of a scene, whatever it states."""

from planes.plans import Plans, plans_of
from planes.plans.stated import stated_plans
from planes.scene import Scene


def scene_plans(scene: Scene) -> Plans:
    """All the plans of a scene's mechanism, or of its vectors, stated once and kept with it: neither changes."""
    assert scene.mechanism or scene.statement
    kept = vars(scene.mechanism or scene.statement)
    if "plans" not in kept:
        kept["plans"] = plans_of(scene.mechanism, scene.file) if scene.mechanism else stated_plans(scene)
    plans: Plans = kept["plans"]
    return plans
