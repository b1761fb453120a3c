"""The scene for a drawing: a sketch as a text, and a text after its sketch was changed."""

import cmath
import json
import math
from collections.abc import Iterator

from planes.scene import loads
from planes.scene.mechanism import DRIVE_RATE_KEYS, FRAME
from planes.scene.source import parse_yaml, walk_nodes
from planes.studio.numbers_back import changeable_numbers, text_with_numbers
from planes.studio.sketches import SAME_PLACE_M, sketch_of
from planes.studio.text_edits import Edited
from planes.words import Phrase
from planes.words.errors import PlanesError, SceneError
from planes.words.records import Json

EMPTY_SCENE_TEXT = "planes: 1\ntitle: {title}\nframe:\n  points: {{}}\nlinks: {{}}\ngravity: 9.81\n"
LOAD_TARGET_KEYS = (("link",), ("point",))  # what a load acts on
# all points of a sketch together: closer than this to where a text has them, the text is right
SAME_SKETCH_DISTANCE_M = 1e-3
MOST_OPEN_ASSEMBLIES = 12  # groups of a sketch for which an assembly is requested


class Unfinished(SceneError):
    """A sketch that is not a mechanism yet: the reason, and its ``text`` so far."""

    def __init__(self, error: SceneError, text: str) -> None:
        super().__init__(error.phrase, error.file, error.line)
        self.text = text


def text_of_changed_sketch(text: str, sketch: Json, was: Json | None = None) -> Edited:
    """The text of a scene after its sketch was changed. Where only places have changed, their numbers are written back
    into the text's own; otherwise only new or changed points, links and guides are written. ``was`` is the sketch
    before, for a text that is no mechanism yet.

    :class:`Unfinished` says what the mechanism still lacks.
    """
    if not text.strip():
        return _text_with_changed_parts(
            EMPTY_SCENE_TEXT.format(title=json.dumps(sketch.get("title", ""), ensure_ascii=False)), sketch
        )
    try:
        was = sketch_of(loads(text))
        if _differ_only_in_places(was, sketch):
            before, now = (changeable_numbers(_text_with_changed_parts(text, one).text) for one in (was, sketch))
            moved = {n: v - before[n] for n, v in now.items() if n in before and v != before[n]}
            home = changeable_numbers(text)
            return text_with_numbers(text, {n: home[n] + by for n, by in moved.items() if n in home})
    except PlanesError:
        pass
    return _text_with_changed_parts(text, sketch, was)


def _text_with_changed_parts(text: str, sketch: Json, was: Json | None = None) -> Edited:
    """The text with the parts of the sketch that differ from what it ``was``; all of them where that is unknown."""
    return _with_assemblies(_with_sketch_parts(Edited(text), sketch, was), sketch)


def _differ_only_in_places(old: Json, sketch: Json) -> bool:
    """Whether two sketches differ only in places."""
    same = all(old[k] == sketch[k] for k in ("fixed", "links", "drive"))
    return same and all(old[k].keys() == sketch[k].keys() for k in ("points", "guides"))


def _with_sketch_parts(edited: Edited, sketch: Json, was: Json | None) -> Edited:
    """Frame, links and drive as drawn; what has not changed stays as written."""
    old = dict(_sketch_part_texts(was)) if was else {}
    new = dict(_sketch_part_texts(sketch))
    for path, _, _ in walk_nodes(parse_yaml(edited.text, "")):
        part = path[:1] in (("frame",), ("links",)) and path[-2:-1] in (("points",), ("guides",), ("links",))
        if part and not any(p[: len(path)] == path for p in new):
            edited = edited.without_key(path)
    unheld = {
        path[1]
        for path, node, _ in walk_nodes(parse_yaml(edited.text, ""))
        if path[:1] == ("loads",)
        and path[2:] in LOAD_TARGET_KEYS
        and getattr(node, "text", "") not in sketch[f"{path[2]}s"]
    }
    for k in sorted(unheld, key=int, reverse=True):
        edited = edited.without_key(("loads", k))
    for path, value in new.items():
        if old.get(path) != value:
            edited = edited.with_value(path, value) if value else edited.without_key(path)
    return edited


def _sketch_part_texts(sketch: Json) -> Iterator[tuple[tuple[str, ...], str]]:
    """The parts of a text that a sketch states, by their paths: points, guides and slides in the axes of their link,
    the drive; "" for a part that it has not."""
    points = {p: complex(*z) for p, z in sketch["points"].items()}
    for p in sketch["fixed"]:
        yield ("frame", "points", p), _coordinates_text(points[p])
    for name, g in sketch["guides"].items():
        if g["link"] == FRAME:
            yield ("frame", "guides", name), _frame_guide_text(g)
    for name, link in sketch["links"].items():
        first = link["points"][0]
        axis = link_axis(name, sketch, points)
        local = {p: (points[p] - points[first]) * axis.conjugate() for p in link["points"]}
        for p, z in local.items():
            yield ("links", name, "points", p), _place_text(z)
        for guide, g in sketch["guides"].items():
            if g["link"] == name:
                yield ("links", name, "guides", guide), _link_guide_text(g, local, points[first], axis)
        yield ("links", name, "slides"), _slide_text(link["slides"], points[first], sketch)
        yield ("links", name, "centre"), link.get("centre") or ""
    yield ("drive",), _drive_text(sketch["drive"], sketch, points) if sketch.get("drive") else ""


def _slide_text(guide: str | None, first: complex, sketch: Json) -> str:
    """What a link slides on, with the distance of its first point from there."""
    aside = _place_on_guide(first, sketch["guides"][guide]).imag if guide else 0.0
    if abs(aside) < SAME_PLACE_M:
        return guide or ""
    return f"{{guide: {guide}, offset: {hand_set_number_text(aside)}}}"


def link_axis(name: str, sketch: Json, points: dict[str, complex]) -> complex:
    """The axis a drawn link is written in: for a slider its guide's, else from its first point to its second."""
    link = sketch["links"][name]
    if link["slides"]:
        return guide_direction(sketch["guides"][link["slides"]])
    first = link["points"][0]
    ways = [way for p in link["points"][1:] if abs(way := points[p] - points[first]) > SAME_PLACE_M]
    ways += [guide_direction(g) for g in sketch["guides"].values() if g["link"] == name]
    return ways[0] / abs(ways[0]) if ways else 1 + 0j


def guide_direction(guide: Json) -> complex:
    """The direction of a guide."""
    return cmath.rect(1.0, math.radians(guide["angle"]))


def _place_on_guide(place: complex, guide: Json) -> complex:
    """A place along a guide and to the left of it, from the guide's defining point."""
    along: complex = (place - complex(*guide["at"])) * guide_direction(guide).conjugate()
    return along


def _frame_guide_text(g: Json) -> str:
    x, y = g["at"]
    turn = g["angle"] % 360
    if min(turn, 360 - turn) < 1e-6:
        return f"{{y: {hand_set_number_text(y)}}}"
    if abs(turn - 90) < 1e-6:
        return f"{{x: {hand_set_number_text(x)}}}"
    return f"{{through: {_coordinates_text(complex(x, y))}, angle: {hand_set_number_text(g['angle'])}}}"


def _link_guide_text(g: Json, local: dict[str, complex], origin: complex, axis: complex) -> str:
    """A guide of a link, through one of its points if possible."""
    along = guide_direction(g) * axis.conjugate()
    z = (complex(*g["at"]) - origin) * axis.conjugate()
    angle = hand_set_number_text(math.degrees(cmath.phase(along)))
    for p, place in local.items():
        if abs(((place - z) * along.conjugate()).imag) < SAME_PLACE_M:
            return f"{{through: {p}, angle: {angle}}}"
    return f"{{through: {_coordinates_text(z)}, angle: {angle}}}"


def _drive_text(drive: Json, sketch: Json, points: dict[str, complex]) -> str:
    """The drive at the position in which its link is drawn."""
    kind = drive["kind"]
    name = drive["link"]
    on = drive.get("on")
    if kind == "phi":
        base = link_axis(on, sketch, points) if on else 1 + 0j
        place = math.degrees(cmath.phase(link_axis(name, sketch, points) / base)) % 360
    else:
        link = sketch["links"][name]
        guide = sketch["guides"][link["slides"]]
        place = _place_on_guide(points[link["points"][0]], guide).real
    against = f" on: {on}," if on else ""
    position = hand_set_number_text(place)
    rate = hand_set_number_text(drive["rate"])
    return f"{{link: {name},{against} {kind}: {position}, {DRIVE_RATE_KEYS[kind][0]}: {rate}}}"


def _place_text(z: complex) -> str:
    if abs(z.imag) < SAME_PLACE_M:
        return hand_set_number_text(z.real)
    return _coordinates_text(z)


def _coordinates_text(z: complex) -> str:
    return f"[{hand_set_number_text(z.real)}, {hand_set_number_text(z.imag)}]"


def hand_set_number_text(value: float) -> str:
    """A number set by hand: to a hundredth of a millimetre, or five digits."""
    text = f"{round(value, 5):.5g}"
    return "0" if text == "-0" else text


def _with_assemblies(edited: Edited, sketch: Json) -> Edited:
    """The text with the assembly of every group as drawn; one that is right stays as written."""
    if _distance_from_sketch(edited, sketch, 0) < SAME_SKETCH_DISTANCE_M:
        return edited
    text = edited.without_key(("assembly",))
    for _ in range(MOST_OPEN_ASSEMBLIES):
        try:
            sketch_of(loads(text.text))
            break
        except SceneError as error:
            offers = assembly_offers(error)
            if not offers:
                raise Unfinished(error, text.text) from None
            text = min(
                (text.with_value(path, value) for path, value in offers), key=lambda t: _distance_from_sketch(t, sketch)
            )
    return text


def assembly_offers(error: SceneError) -> list[tuple[tuple[str, ...], str]]:
    """The possible choices of assembly, where a scene leaves it open: paths of keys, and their values."""
    offers = error.phrase_parts.get("offers")
    open_groups = [o.parts for o in offers if isinstance(o, Phrase)] if isinstance(offers, tuple) else []
    return [
        (("assembly", str(d["key"])), str(d.get("word", f"{{near: {d.get('place')}}}")))
        for d in open_groups
        if "key" in d and d.keys() & {"word", "place"}
    ]


def _distance_from_sketch(edited: Edited, sketch: Json, depth: int = MOST_OPEN_ASSEMBLIES) -> float:
    """The distance of a text's points from where they are drawn; of groups with an open assembly, the nearest."""
    try:
        own = sketch_of(loads(edited.text))["points"]
    except SceneError as error:
        offers = assembly_offers(error) if depth else []
        return min(
            (_distance_from_sketch(edited.with_value(path, value), sketch, depth - 1) for path, value in offers),
            default=math.inf,
        )
    except PlanesError:
        return math.inf
    return sum(math.dist(z, sketch["points"][p]) for p, z in own.items() if p in sketch["points"])
