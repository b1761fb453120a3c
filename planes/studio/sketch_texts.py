"""The scene for a drawing: a sketch as a text, and a text after its sketch was changed."""

import cmath
import json
import math
from collections.abc import Iterator

from planes.scene import loads
from planes.scene.mechanism import FRAME, RATES
from planes.scene.source import parse, walk
from planes.studio.numbers_back import home_of, with_numbers
from planes.studio.sketches import NEAR_M, sketch_of
from planes.studio.text_edits import Edited
from planes.words import Phrase
from planes.words.errors import PlanesError, SceneError
from planes.words.records import Json

EMPTY = "planes: 1\ntitle: {title}\nframe:\n  points: {{}}\nlinks: {{}}\ngravity: 9.81\n"
ON = (("link",), ("point",))  # what a load acts on
RIGHT_M = 1e-3  # all points of a sketch together: closer than this to where a text has them, the text is right
CHOICES = 12  # groups of a sketch for which an assembly is requested


class Unfinished(SceneError):
    """A sketch that is not a mechanism yet: the reason, and its ``text`` so far."""

    def __init__(self, error: SceneError, text: str) -> None:
        super().__init__(error.phrase, error.file, error.line)
        self.text = text


def drawn(text: str, sketch: Json, was: Json | None = None) -> Edited:
    """The text of a scene after its sketch was changed. Where only places have changed, their numbers are written back
    into the text's own; otherwise only new or changed points, links and guides are written. ``was`` is the sketch
    before, for a text that is no mechanism yet.

    :class:`Unfinished` says what the mechanism still lacks.
    """
    if not text.strip():
        return _whole(EMPTY.format(title=json.dumps(sketch.get("title", ""), ensure_ascii=False)), sketch)
    try:
        was = sketch_of(loads(text))
        if _alike(was, sketch):
            before, now = (home_of(_whole(text, one).text) for one in (was, sketch))
            moved = {n: v - before[n] for n, v in now.items() if n in before and v != before[n]}
            home = home_of(text)
            return with_numbers(text, {n: home[n] + by for n, by in moved.items() if n in home})
    except PlanesError:
        pass
    return _whole(text, sketch, was)


def _whole(text: str, sketch: Json, was: Json | None = None) -> Edited:
    """The text with the parts of the sketch that differ from what it ``was``; all of them where that is unknown."""
    return _assembled(_parts(Edited(text), sketch, was), sketch)


def _alike(old: Json, sketch: Json) -> bool:
    """Whether two sketches differ only in places."""
    same = all(old[k] == sketch[k] for k in ("fixed", "links", "drive"))
    return same and all(old[k].keys() == sketch[k].keys() for k in ("points", "guides"))


def _parts(edited: Edited, sketch: Json, was: Json | None) -> Edited:
    """Frame, links and drive as drawn; what has not changed stays as written."""
    old, new = dict(_said(was)) if was else {}, dict(_said(sketch))
    for path, _, _ in walk(parse(edited.text, "")):
        part = path[:1] in (("frame",), ("links",)) and path[-2:-1] in (("points",), ("guides",), ("links",))
        if part and not any(p[: len(path)] == path for p in new):
            edited = edited.without(path)
    unheld = {
        path[1]
        for path, node, _ in walk(parse(edited.text, ""))
        if path[:1] == ("loads",) and path[2:] in ON and getattr(node, "text", "") not in sketch[f"{path[2]}s"]
    }
    for k in sorted(unheld, key=int, reverse=True):
        edited = edited.without(("loads", k))
    for path, value in new.items():
        if old.get(path) != value:
            edited = edited.put(path, value) if value else edited.without(path)
    return edited


def _said(sketch: Json) -> Iterator[tuple[tuple[str, ...], str]]:
    """The parts of a text that a sketch states, by their paths: points, guides and slides in the axes of their link,
    the drive; "" for a part that it has not."""
    points = {p: complex(*z) for p, z in sketch["points"].items()}
    for p in sketch["fixed"]:
        yield ("frame", "points", p), _pair(points[p])
    for name, g in sketch["guides"].items():
        if g["link"] == FRAME:
            yield ("frame", "guides", name), _on_frame(g)
    for name, link in sketch["links"].items():
        first, axis = link["points"][0], axis_of(name, sketch, points)
        local = {p: (points[p] - points[first]) * axis.conjugate() for p in link["points"]}
        for p, z in local.items():
            yield ("links", name, "points", p), _place(z)
        for guide, g in sketch["guides"].items():
            if g["link"] == name:
                yield ("links", name, "guides", guide), _on_link(g, local, points[first], axis)
        yield ("links", name, "slides"), _slide(link["slides"], points[first], sketch)
        yield ("links", name, "centre"), link.get("centre") or ""
    yield ("drive",), _drive(sketch["drive"], sketch, points) if sketch.get("drive") else ""


def _slide(guide: str | None, first: complex, sketch: Json) -> str:
    """What a link slides on, with the distance of its first point from there."""
    aside = _on_guide(first, sketch["guides"][guide]).imag if guide else 0.0
    return guide or "" if abs(aside) < NEAR_M else f"{{guide: {guide}, offset: {number(aside)}}}"


def axis_of(name: str, sketch: Json, points: dict[str, complex]) -> complex:
    """The axis a drawn link is written in: for a slider its guide's, else from its first point to its second."""
    link = sketch["links"][name]
    if link["slides"]:
        return direction(sketch["guides"][link["slides"]])
    first = link["points"][0]
    ways = [way for p in link["points"][1:] if abs(way := points[p] - points[first]) > NEAR_M]
    ways += [direction(g) for g in sketch["guides"].values() if g["link"] == name]
    return ways[0] / abs(ways[0]) if ways else 1 + 0j


def direction(guide: Json) -> complex:
    """The direction of a guide."""
    return cmath.rect(1.0, math.radians(guide["angle"]))


def _on_guide(place: complex, guide: Json) -> complex:
    """A place along a guide and to the left of it, from the guide's defining point."""
    along: complex = (place - complex(*guide["at"])) * direction(guide).conjugate()
    return along


def _on_frame(g: Json) -> str:
    x, y = g["at"]
    turn = g["angle"] % 360
    if min(turn, 360 - turn) < 1e-6:
        return f"{{y: {number(y)}}}"
    if abs(turn - 90) < 1e-6:
        return f"{{x: {number(x)}}}"
    return f"{{through: {_pair(complex(x, y))}, angle: {number(g['angle'])}}}"


def _on_link(g: Json, local: dict[str, complex], origin: complex, axis: complex) -> str:
    """A guide of a link, through one of its points if possible."""
    along, z = direction(g) * axis.conjugate(), (complex(*g["at"]) - origin) * axis.conjugate()
    angle = number(math.degrees(cmath.phase(along)))
    for p, place in local.items():
        if abs(((place - z) * along.conjugate()).imag) < NEAR_M:
            return f"{{through: {p}, angle: {angle}}}"
    return f"{{through: {_pair(z)}, angle: {angle}}}"


def _drive(drive: Json, sketch: Json, points: dict[str, complex]) -> str:
    """The drive at the position in which its link is drawn."""
    kind, name = drive["kind"], drive["link"]
    on = drive.get("on")
    if kind == "phi":
        base = axis_of(on, sketch, points) if on else 1 + 0j
        place = math.degrees(cmath.phase(axis_of(name, sketch, points) / base)) % 360
    else:
        link = sketch["links"][name]
        guide = sketch["guides"][link["slides"]]
        place = _on_guide(points[link["points"][0]], guide).real
    against = f" on: {on}," if on else ""
    return f"{{link: {name},{against} {kind}: {number(place)}, {RATES[kind][0]}: {number(drive['rate'])}}}"


def _place(z: complex) -> str:
    return number(z.real) if abs(z.imag) < NEAR_M else _pair(z)


def _pair(z: complex) -> str:
    return f"[{number(z.real)}, {number(z.imag)}]"


def number(value: float) -> str:
    """A number set by hand: to a hundredth of a millimetre, or five digits."""
    text = f"{round(value, 5):.5g}"
    return "0" if text == "-0" else text


def _assembled(edited: Edited, sketch: Json) -> Edited:
    """The text with the assembly of every group as drawn; one that is right stays as written."""
    if _apart(edited, sketch, 0) < RIGHT_M:
        return edited
    text = edited.without(("assembly",))
    for _ in range(CHOICES):
        try:
            sketch_of(loads(text.text))
            break
        except SceneError as error:
            offers = offers_of(error)
            if not offers:
                raise Unfinished(error, text.text) from None
            text = min((text.put(path, value) for path, value in offers), key=lambda t: _apart(t, sketch))
    return text


def offers_of(error: SceneError) -> list[tuple[tuple[str, ...], str]]:
    """The possible choices of assembly, where a scene leaves it open: paths of keys, and their values."""
    offers = error.parts.get("offers")
    open_groups = [o.parts for o in offers if isinstance(o, Phrase)] if isinstance(offers, tuple) else []
    return [
        (("assembly", str(d["key"])), str(d.get("word", f"{{near: {d.get('place')}}}")))
        for d in open_groups
        if "key" in d and d.keys() & {"word", "place"}
    ]


def _apart(edited: Edited, sketch: Json, depth: int = CHOICES) -> float:
    """The distance of a text's points from where they are drawn; of groups with an open assembly, the nearest."""
    try:
        own = sketch_of(loads(edited.text))["points"]
    except SceneError as error:
        offers = offers_of(error) if depth else []
        return min((_apart(edited.put(path, value), sketch, depth - 1) for path, value in offers), default=math.inf)
    except PlanesError:
        return math.inf
    return sum(math.dist(z, sketch["points"][p]) for p, z in own.items() if p in sketch["points"])
