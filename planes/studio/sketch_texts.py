"""The scene for a drawing: a sketch as a text, and a text after its sketch was changed."""

import cmath
import json
import math
from collections.abc import Iterator

from planes.scene import loads
from planes.scene.mechanism import FRAME, RATES
from planes.studio.numbers_back import home_of, with_numbers
from planes.studio.sketches import NEAR_M, sketch_of
from planes.studio.text_edits import Edited
from planes.words import Phrase
from planes.words.errors import PlanesError, SceneError
from planes.words.records import Json

EMPTY = "planes: 1\ntitle: {title}\nframe:\n  points: {{}}\nlinks: {{}}\ngravity: 9.81\n"
CHOICES = 12  # groups of a sketch for which an assembly is requested


class Unfinished(SceneError):
    """A sketch that is not a mechanism yet: the reason, and its ``text`` so far."""

    def __init__(self, error: SceneError, text: str) -> None:
        super().__init__(error.phrase, error.file, error.line)
        self.text = text


def drawn(text: str, sketch: Json) -> Edited:
    """The text of a scene after its sketch was changed. Where only places have changed, their numbers are written back
    into the text's own; otherwise new or changed links and guides are written anew.

    :class:`Unfinished` says what the mechanism still lacks.
    """
    if not text.strip():
        return _whole(EMPTY.format(title=json.dumps(sketch.get("title", ""), ensure_ascii=False)), sketch)
    try:
        old = sketch_of(loads(text))
        if _alike(old, sketch):
            was, now = (home_of(_whole(text, one).text) for one in (old, sketch))
            moved = {n: v - was[n] for n, v in now.items() if n in was and v != was[n]}
            home = home_of(text)
            return with_numbers(text, {n: home[n] + by for n, by in moved.items() if n in home})
    except PlanesError:
        pass
    return _whole(text, sketch)


def _whole(text: str, sketch: Json) -> Edited:
    """The text with all parts of the sketch written anew."""
    return _assembled(_parts(Edited(text), sketch), sketch)


def _alike(old: Json, sketch: Json) -> bool:
    """Whether two sketches differ only in places."""
    same = all(old[k] == sketch[k] for k in ("fixed", "links", "drive"))
    return same and all(old[k].keys() == sketch[k].keys() for k in ("points", "guides"))


def _parts(edited: Edited, sketch: Json) -> Edited:
    """Frame, links and drive as drawn."""
    points = {p: complex(*z) for p, z in sketch["points"].items()}
    fixed = ", ".join(f"{p}: {_pair(points[p])}" for p in sketch["fixed"])
    edited = edited.put(("frame", "points"), f"{{{fixed}}}")
    of_frame = [g for g in sketch["guides"] if sketch["guides"][g]["link"] == FRAME]
    guides = ", ".join(f"{name}: {_on_frame(sketch['guides'][name])}" for name in of_frame)
    edited = edited.put(("frame", "guides"), f"{{{guides}}}") if guides else edited.without(("frame", "guides"))
    for name in edited.keys(("links",)):
        edited = edited if name in sketch["links"] else edited.without(("links", name))
    for name, link in sketch["links"].items():
        for key, value in _said(name, link, sketch, points):
            edited = edited.put(("links", name, key), value) if value else edited.without(("links", name, key))
    drive = sketch.get("drive")
    if drive and drive.get("kept"):
        return edited
    return edited.put(("drive",), _drive(drive, sketch, points)) if drive else edited.without(("drive",))


def _said(name: str, link: Json, sketch: Json, points: dict[str, complex]) -> Iterator[tuple[str, str]]:
    """Points, guides and slide of a link, in its own axes."""
    first, axis = link["points"][0], axis_of(name, sketch, points)
    local = {p: (points[p] - points[first]) * axis.conjugate() for p in link["points"]}
    yield "points", f"{{{', '.join(f'{p}: {_place(z)}' for p, z in local.items())}}}"
    own = {n: g for n, g in sketch["guides"].items() if g["link"] == name}
    yield (
        "guides",
        f"{{{', '.join(f'{n}: {_on_link(g, local, points[first], axis)}' for n, g in own.items())}}}" if own else "",
    )
    if not link["slides"]:
        yield "slides", ""
        return
    guide = sketch["guides"][link["slides"]]
    aside = _on_guide(points[first], guide).imag
    yield "slides", link["slides"] if abs(aside) < NEAR_M else f"{{guide: {link['slides']}, offset: {number(aside)}}}"


def axis_of(name: str, sketch: Json, points: dict[str, complex]) -> complex:
    """The axis a drawn link is written in: for a slider its guide's, else from its first point to its second."""
    link = sketch["links"][name]
    if link["slides"]:
        return direction(sketch["guides"][link["slides"]])
    first = link["points"][0]
    ways = [points[p] - points[first] for p in link["points"][1:] if abs(points[p] - points[first]) > NEAR_M]
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
    if kind == "phi":
        place = math.degrees(cmath.phase(axis_of(name, sketch, points))) % 360
    else:
        link = sketch["links"][name]
        guide = sketch["guides"][link["slides"]]
        place = _on_guide(points[link["points"][0]], guide).real
    return f"{{link: {name}, {kind}: {number(place)}, {RATES[kind][0]}: {number(drive['rate'])}}}"


def _place(z: complex) -> str:
    return number(z.real) if abs(z.imag) < NEAR_M else _pair(z)


def _pair(z: complex) -> str:
    return f"[{number(z.real)}, {number(z.imag)}]"


def number(value: float) -> str:
    """A number set by hand: to a hundredth of a millimetre, or five digits."""
    text = f"{round(value, 5):.5g}"
    return "0" if text in ("-0", "0") else text


def _assembled(edited: Edited, sketch: Json) -> Edited:
    """The text with the assembly of every group as drawn."""
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
    offers_made: list[tuple[tuple[str, ...], str]] = []
    offers = error.parts.get("offers", ())
    for offer in offers if isinstance(offers, tuple) else ():
        details = offer.parts if isinstance(offer, Phrase) else {}
        if "key" in details and ("word" in details or "place" in details):
            near = f"{{near: {details.get('place')}}}"
            offers_made.append((("assembly", str(details["key"])), str(details.get("word", near))))
    return offers_made


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
