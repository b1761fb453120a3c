"""What a scene says of its letters: the number of its frame, the order of a reaction's indices, and what only its
plans know, which vectors end at a point of the frame under a slider."""

from __future__ import annotations

from planes.plans import Plans
from planes.scene import Scene
from planes.scene.mechanism import FRAME
from planes.words.records import Json


def lettering(scene: Scene, plans: Plans | None = None) -> Json:
    """How names of a scene are lettered, on a sheet as on a page; the vectors of force plans ask for no plans."""
    means = plans.means if plans else {}
    return {
        "frame": scene.frame_number,
        "from_on": scene.sheet.get("reactions") == "from-on",
        "driver": scene.mechanism.drive.link if scene.mechanism else "",
        "grounded": [name for name, m in means.items() if m.quantity == "rate" and m.link == FRAME],
    }
