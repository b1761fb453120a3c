"""A scene written back as the file that says it: the same mechanism when it is read again."""

import math
from collections.abc import Container, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any

import yaml

from planes.scene.mechanism import FRAME, RATES, Amount, Drive, Guide, Link, Load, LoadLaw, Mechanism, Slide, StrokeLoad
from planes.scene.paths import entries_of
from planes.scene.source import Node, SourceScalar, SourceTable, parse
from planes.words.records import Json


class _Lines(yaml.SafeDumper):
    """Tables of tables on lines of their own, everything below them in one line."""


_Lines.add_representer(complex, lambda dumper, z: dumper.represent_sequence("tag:yaml.org,2002:seq", [z.real, z.imag]))


def as_yaml(mechanism: Mechanism, title: str) -> str:
    """The text of a scene file: numbers in full, no expressions; parts that say nothing are left out."""
    parts: Json = {"planes": 1, "title": title, **dict(_mechanism(mechanism))}
    if mechanism.frame_number != FRAME:
        parts["frame"]["number"] = mechanism.frame_number
    return written({key: value for key, value in parts.items() if _said(value)})


def written(parts: Mapping[str, object]) -> str:
    """The text of a file with these parts, each as it was written if it was kept so."""
    return "".join(_dumped(key, _as_written(value)) for key, value in parts.items())


def own_scene(
    text: str,
    file: str,
    variant: str | None,
    numbers: Mapping[str, str],
    sheet: Mapping[str, Node],
    without: Container[str] = (),
) -> str:
    """The scene with the numbers of a variant, then ``numbers``, in its parameters; ``sheet`` joins its own. Keys it
    is to be ``without`` are left out, those of its sheet too."""
    entries = {key: node for key, node in parse(text, file).entries.items() if key not in without}
    variants = entries.pop("variants", None)
    if isinstance(parameters := entries.get("parameters"), SourceTable):
        more = entries_of(entries_of(variants).get(variant or ""))
        drawn = {name: SourceScalar(value, 0) for name, value in numbers.items()}
        entries["parameters"] = SourceTable({**parameters.entries, **more, **drawn}, 0)
    if sheet:
        entries["sheet"] = SourceTable({**entries_of(entries.get("sheet")), **sheet}, 0)
    if kept := {key: node for key, node in entries_of(entries.get("sheet")).items() if key not in without}:
        entries["sheet"] = SourceTable(kept, 0)
    else:
        entries.pop("sheet", None)
    return written(entries)


def _dumped(key: str, value: object) -> str:
    flow = None if isinstance(value, dict | list) else False
    text: str = yaml.dump(
        {key: value}, Dumper=_Lines, allow_unicode=True, sort_keys=False, width=110, default_flow_style=flow
    )
    return text


def _said(value: object) -> bool:
    empty = isinstance(value, dict) and all(one == "" for one in value.values())
    return value is not None and value != [] and not empty


def _mechanism(m: Mechanism) -> Iterator[tuple[str, object]]:
    yield "frame", _link(m.frame)
    yield "links", {name: _link(link) for name, link in m.links.items()}
    yield "assembly", {name: a.order or {"near": a.near} for name, a in m.assembly.items()}
    yield "drive", _drive(m.drive)
    yield "loads", [_load(load) for load in m.loads]
    yield "gravity", m.gravity
    pins = {name: {"coefficient": j.coefficient, "radius": j.radius} for name, j in m.journals.items()}
    yield "friction", {**m.friction, **pins, **{name: j.coefficient for name, j in m.journals.items() if j.round}}


def _as_written(node: Any) -> object:
    """A part of the scene as it was written; of anything else plain tables, lists, texts and numbers, whichever
    library they come from."""
    if isinstance(node, SourceScalar):
        return _scalar(node)
    if isinstance(node, SourceTable | Mapping):
        entries = node.entries if isinstance(node, SourceTable) else node
        return {key: _as_written(one) for key, one in entries.items()}
    plain = node.tolist() if hasattr(node, "tolist") else getattr(node, "items", node)
    if plain is None or isinstance(plain, str | int | complex):
        return plain
    if isinstance(plain, Sequence):
        return [_as_written(one) for one in plain]
    number = float(plain) if hasattr(plain, "__float__") else math.nan
    return number if math.isfinite(number) else str(plain)


def _scalar(node: SourceScalar) -> object:
    for kind in (int, float) if node.plain else ():
        with suppress(ValueError):
            return kind(node.text)
    return None if node.absent else node.text


def _link(link: Link) -> Json:
    on_axis, slides = link.name != "0", link.slides or link.slides_round
    points = dict(list(link.points.items())[:-1]) if link.slides_round else link.points  # the last is the centre
    round_guides = {g.name: {"centre": g.centre, "radius": g.radius} for g in link.round_guides.values()}
    said = {
        "points": {name: z.real if on_axis and not z.imag else z for name, z in points.items()},
        "guides": {name: _guide(guide) for name, guide in link.guides.items()} | round_guides,
        "slides": None if slides is None else _slide(slides),
        "centre": link.centre,
        "mass": link.mass,
        "inertia": link.inertia,
    }
    return {key: value for key, value in said.items() if _said(value)}


def _guide(guide: Guide) -> Json:
    if guide.origin_given:
        form: Json = {"through": guide.through_point or guide.through, "angle": guide.angle_deg}
    else:
        form = {"x": guide.through.real} if guide.angle_deg == 90.0 else {"y": guide.through.imag}
    return form | ({"mark": guide.mark} if guide.mark else {})


def _slide(slide: Slide) -> Json | str:
    more = {"angle": slide.angle_deg, "offset": slide.offset, "length": slide.length}
    given = {key: value for key, value in more.items() if value is not None}
    return {"guide": slide.guide, **given} if given else slide.guide


def _drive(drive: Drive) -> Json:
    names = drive.kind, *RATES[drive.kind]
    on = {} if drive.on == FRAME else {"on": drive.on}
    values = drive.position, drive.velocity, drive.acceleration
    balance = {"balance": dict(zip(("point", "angle"), drive.balance, strict=True))} if drive.balance else {}
    return {"link": drive.link, **on, **dict(zip(names, values, strict=True)), **balance}


def _load(load: Load) -> Json:
    said: Json = {"link": load.link, "point": load.point, load.kind: _amount(load.value)}
    if load.sense:
        said[load.sense] = "motion"
    elif load.direction_deg is not None:
        angle = _amount(load.direction_deg)
        said["direction"] = {"link": load.direction_link, "angle": angle} if load.direction_link else angle
    return {key: value for key, value in said.items() if value is not None}


def _amount(value: Amount | StrokeLoad) -> object:
    """A number of a load, or the law it follows."""
    if isinstance(value, StrokeLoad):
        both = {"working": _amount(value.working), "idle": _amount(value.idle)}
        return {**both, "stroke": value.stroke, "slider": value.slider}
    if isinstance(value, LoadLaw):
        return {"over": value.text, "table": [list(pair) for pair in value.table]} if value.table else value.text
    return value
