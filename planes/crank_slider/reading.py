"""Reads ``crank_slider:``; every value is checked, every refusal is a sentence with its line."""

from __future__ import annotations

import math
from dataclasses import replace

from planes.crank_slider.given import Counterweights, Given, Limits, Speed
from planes.crank_slider.reading_parts import read_concentration, read_materials, read_pin, read_rod, read_shaft
from planes.crank_slider.reading_table import Values, read_indicator
from planes.crank_slider.shape import CrankSliderShape, shape_of
from planes.scene import Scene
from planes.scene.reader import Reader, section
from planes.words import Phrase
from planes.words.errors import SceneError

_KEYS = ("bore", "ambient", "indicator", "step", "speed", "flywheel", "positions")
_PARTS = ("shaft", "counterweights", "rod", "piston_pin", "materials", "fatigue", "limits")


def read(scene: Scene) -> Given:
    """All that the calculation of a scene starts from."""
    shape = shape_of(scene)
    assert scene.crank_slider is not None
    reader = Reader(scene.file, scene.parameters)
    top = Values(
        reader, reader.table(scene.crank_slider, section("crank_slider"), (*_KEYS, *_PARTS)), section("crank_slider")
    )
    indicator = read_indicator(top)
    given = Given(
        shape,
        top.above("bore"),
        top.pressure("ambient", indicator.unit, 0.1e6),
        indicator,
        _step(top),
        _speed(top),
        _flywheel(top),
        _positions(top, indicator.cycle_deg, indicator.start_deg),
    )
    return _parts(scene, top, given)


def _parts(scene: Scene, top: Values, given: Given) -> Given:
    shaft, rod, pin = read_shaft(top), read_rod(top), read_pin(top)
    weights = _counterweights(top)
    if weights and not shaft:
        raise top.error(Phrase("cs_needs", what="shaft", other="counterweights"), "counterweights")
    if shaft:
        _check_crank_mass(scene, given.shape, shaft.pin_mass * given.shape.r + shaft.web_mass * shaft.web_radius)
    materials, concentration = read_materials(top), read_concentration(top)
    for part, there in (("shaft", shaft), ("rod", rod), ("piston_pin", pin)):
        if there and part not in materials:
            raise top.error(Phrase("cs_needs", what=f"materials.{part}", other=part), part)
    if shaft and concentration.keys() != {"journal", "crankpin"}:
        raise top.error(Phrase("cs_needs", what="fatigue: {journal: …, crankpin: …}", other="shaft"), "shaft")
    return replace(
        given,
        shaft=shaft,
        counterweights=weights,
        rod=rod,
        pin=pin,
        materials=materials,
        concentration=concentration,
        limits=_limits(top),
    )


def _check_crank_mass(scene: Scene, shape: CrankSliderShape, by_shaft: float) -> None:
    by_link = shape.m1 * shape.s
    if shape.m1 and not math.isclose(by_link, by_shaft, rel_tol=0.01):
        words = Phrase("cs_crank_mass", link=by_link, shaft=by_shaft, name=shape.crank)
        raise SceneError(words, scene.file, scene.where.get(("crank_slider", "shaft", "masses")))


def _step(top: Values) -> float:
    step = top.above("step", 1.0)
    if step > 15.0 or abs(15.0 / step - round(15.0 / step)) > 1e-9 or step < 0.1:
        raise top.error(Phrase("cs_step", what=top.named("step"), value=step), "step")
    return step


def _speed(top: Values) -> Speed:
    table = top.inner("speed", ("unevenness", "waves", "phase"))
    if table is None:
        return Speed()
    return Speed(
        table.between("unevenness", 0.0, 0.5), table.between("waves", 0.5, 20, 1.0), table.number("phase", 0.0)
    )


def _flywheel(top: Values) -> float:
    table = top.inner("flywheel", ("unevenness",))
    return 0.02 if table is None else table.between("unevenness", 1e-4, 0.5)


def _positions(top: Values, cycle: float, start: float) -> tuple[float, ...]:
    if (node := top.reader.optional(top.table, "positions")) is None:
        return ()
    what = top.named("positions")
    found = tuple(top.reader.number(item, what) for item in top.reader.items(node, what))
    for value in found:
        if not start <= value <= start + cycle:
            raise top.error(Phrase("cs_range", what=what, low=start, high=start + cycle, value=value), "positions")
    return found[:6]


def _counterweights(top: Values) -> Counterweights | None:
    table = top.inner("counterweights", ("radius", "masses", "translating"))
    if table is None:
        return None
    masses = table.pair("masses")
    if masses and min(masses) < 0.0:
        raise table.error(Phrase("negative", what=table.named("masses"), value=min(masses)), "masses")
    return Counterweights(table.above("radius"), masses, table.between("translating", 0.0, 1.0, 0.5))


def _limits(top: Values) -> Limits:
    usual = Limits()
    table = top.inner("limits", ("static", "fatigue", "buckling", "bush_MPa", "boss_MPa"))
    if table is None:
        return usual
    low, high = fatigue = table.pair("fatigue") or usual.fatigue
    if not 1.0 <= low < high:
        raise table.error(Phrase("cs_range", what=table.named("fatigue"), low=1.0, high=high, value=low), "fatigue")
    return Limits(
        table.between("static", 1.0, 20.0, usual.static),
        fatigue,
        table.between("buckling", 1.0, 50.0, usual.buckling),
        table.above("bush_MPa", usual.bush_mpa),
        table.above("boss_MPa", usual.boss_mpa),
    )
