"""Reads ``crank_slider:``; every value is checked, every error is a sentence with its line."""

import math

from planes.crank_slider.given import (
    PASCALS_BY_UNIT,
    Concentration,
    Counterweights,
    Given,
    Limits,
    PistonPin,
    Shaft,
    Speed,
)
from planes.crank_slider.parts import (
    ELASTICITY_MPA,
    STEEL_PROPERTIES,
    Material,
    RoundPart,
    Shank,
    Web,
    make_material,
    steel_by_name,
)
from planes.crank_slider.reading_table import KEYS_BY_TABLE, Values, read_indicator
from planes.crank_slider.shape import shape_of
from planes.scene import Scene
from planes.scene.reader import Reader, section_in_words
from planes.scene.source import SourceScalar
from planes.words import Phrase
from planes.words.errors import SceneError, list_valid_choices, quoted_excerpt

WORDS_BY_LIST = {
    "units": tuple(PASCALS_BY_UNIT),
    "steels": (*STEEL_PROPERTIES, *(int(s) for s in STEEL_PROPERTIES if s.isdigit())),
}
"""The words that a value may be, by the name of their list in ``pack.json``."""


def read_given_data(scene: Scene) -> Given:
    """All input for the calculation of a scene."""
    shape = shape_of(scene)
    reader = Reader(scene.file, scene.parameters)
    top = Values(reader, scene.parts["crank_slider"], section_in_words("crank_slider"), KEYS_BY_TABLE["crank_slider"])
    indicator = read_indicator(top)
    pascals = PASCALS_BY_UNIT[indicator.unit]
    given = Given(
        shape=shape,
        bore=top.above("bore"),
        ambient=top.read_non_negative("ambient", 0.1e6 / pascals) * pascals,
        indicator=indicator,
        step_deg=_read_step_deg(top),
        speed=top.part("speed", _read_speed) or Speed(),
        allowed_unevenness=top.part("flywheel", lambda flywheel: flywheel.between("unevenness", 1e-4, 0.5)) or 0.02,
        positions=_read_positions(top, indicator.cycle_deg, indicator.start_deg),
        shaft=top.part("shaft", _read_shaft),
        counterweights=top.part("counterweights", _read_counterweights),
        rod=top.part("rod", _read_rod_shank),
        pin=top.part("piston_pin", _read_piston_pin),
        materials=top.part("materials", lambda table: {key: _read_material(table, key) for key in table.table.entries})
        or {},
        concentration=top.part("fatigue", _read_concentration) or {},
        limits=top.part("limits", _read_limits) or Limits(),
    )
    _check_parts(scene, top, given)
    return given


def _check_parts(scene: Scene, top: Values, given: Given) -> None:
    """Check that each part has all its data, and that the crank's mass is that of its shaft."""
    shaft = given.shaft
    shape = given.shape
    if given.counterweights and not shaft:
        raise top.error_by_key("cs_needs", "counterweights", what="shaft", other="counterweights")
    by_shaft = shaft.static_moment(shape.r) if shaft else 0.0
    if shaft and shape.m1 and not math.isclose(shape.m1 * shape.s, by_shaft, rel_tol=0.01):
        words = Phrase("cs_crank_mass", link=shape.m1 * shape.s, shaft=by_shaft, name=shape.crank)
        raise SceneError(words, scene.file, scene.where.get(("crank_slider", "shaft", "masses")))
    for part, there in (("shaft", shaft), ("rod", given.rod), ("piston_pin", given.pin)):
        if there and part not in given.materials:
            raise top.error_by_key("cs_needs", part, what=f"materials.{part}", other=part)
    if shaft and given.concentration.keys() != {"journal", "crankpin"}:
        raise top.error_by_key("cs_needs", "shaft", what="fatigue: {journal: …, crankpin: …}", other="shaft")


def _read_step_deg(top: Values) -> float:
    step = top.above("step", 1.0)
    if step > 15.0 or abs(15.0 / step - round(15.0 / step)) > 1e-9 or step < 0.1:
        raise top.error_by_key("cs_step", "step", what=top.phrase_of_key("step"), value=step)
    return step


def _read_speed(table: Values) -> Speed:
    unevenness = table.between("unevenness", 0.0, 0.5)
    waves = table.between("waves", 0.5, 20, 1.0)
    return Speed(unevenness, waves, table.read_number("phase", 0.0))


def _read_positions(top: Values, cycle: float, start: float) -> tuple[float, ...]:
    if (node := top.optional_node("positions")) is None:
        return ()
    what = top.phrase_of_key("positions")
    places = tuple(top.reader.read_number(item, what) for item in top.reader.read_list(node, what))
    for value in places:
        if not start <= value <= start + cycle:
            raise top.error_by_key("cs_range", "positions", what=what, low=start, high=start + cycle, value=value)
    return places[:6]


def _read_counterweights(table: Values) -> Counterweights:
    masses = table.pair("masses")
    if masses and min(masses) < 0.0:
        raise table.error_by_key("negative", "masses", what=table.phrase_of_key("masses"), value=min(masses))
    return Counterweights(table.above("radius"), masses, table.between("translating", 0.0, 1.0, 0.5))


def _read_limits(table: Values) -> Limits:
    usual = Limits()
    low, high = fatigue = table.pair("fatigue") or usual.fatigue
    if not 1.0 <= low < high:
        raise table.error_by_key(
            "cs_range", "fatigue", what=table.phrase_of_key("fatigue"), low=1.0, high=high, value=low
        )
    return Limits(
        static=table.between("static", 1.0, 20.0, usual.static),
        fatigue=fatigue,
        buckling=table.between("buckling", 1.0, 50.0, usual.buckling),
        bush_mpa=table.above("bush_MPa", usual.bush_mpa),
        boss_mpa=table.above("boss_MPa", usual.boss_mpa),
    )


def _read_shaft(table: Values) -> Shaft:
    span = table.above("span")
    n = table.above("pin_from_B")
    m = table.above("webs")
    if m >= min(n, span - n):
        raise table.error_by_key("cs_span", "webs", webs=m, left=span - n, right=n)
    web = table.inner_fields("web", KEYS_BY_TABLE["web"])
    masses = table.inner_fields("masses", KEYS_BY_TABLE["masses"])
    return Shaft(
        span,
        pin_from_b=n,
        webs=m,
        journal=_read_bored_part(table.inner_fields("journal", KEYS_BY_TABLE["round"])),
        crankpin=_read_bored_part(table.inner_fields("crankpin", KEYS_BY_TABLE["round"])),
        web=Web(web.above("width"), web.above("thickness")),
        pin_mass=masses.read_non_negative("pin"),
        web_mass=masses.read_non_negative("webs"),
        web_radius=masses.read_number("webs_radius"),
    )


def _read_bored_part(table: Values) -> RoundPart:
    outer = table.above("diameter")
    bore = table.read_non_negative("bore", 0.0)
    if bore >= outer:
        raise table.error_by_key("cs_thin", "bore", what=table.what, inner=bore, outer=outer)
    return RoundPart(outer, bore)


def _read_rod_shank(table: Values) -> Shank:
    """The rod's shank: an I-section, or a bar where flange and web are left out."""
    height = table.above("height")
    width = table.above("width")
    flange = table.above("flange", height / 2)
    web = table.above("web", width)
    for key, inner, outer in (("flange", 2 * flange, height), ("web", web, width)):
        if inner > outer:
            raise table.error_by_key("cs_thin", key, what=table.phrase_of_key(key), inner=inner, outer=outer)
    return Shank(height, width, flange, web)


def _read_piston_pin(table: Values) -> PistonPin:
    length = table.above("length")
    bush = table.above("bush")
    gap = table.above("gap")
    if not bush <= gap < length:
        raise table.error_by_key("cs_pin_length", "gap", gap=gap, bush=bush, length=length)
    return PistonPin(_read_bored_part(table), length, bush, gap)


def _read_material(table: Values, key: str) -> Material:
    """The steel of a part: a name of the table, or numbers in MPa."""
    if isinstance(table.required_node(key), SourceScalar):
        name = table.read_text(key)
        if known_steel := steel_by_name(name):
            return known_steel
        what = Phrase("about", what=table.phrase_of_key(key), why=quoted_excerpt(name))
        raise table.error_by_key("cs_no_steel", key, what=what, valid=list_valid_choices(name, STEEL_PROPERTIES))
    inner = table.inner_fields(key, KEYS_BY_TABLE["material"])
    strength = inner.above("strength_MPa")
    yields = inner.above("yield_MPa")
    if yields > strength:
        raise inner.error_by_key("cs_yield", "yield_MPa", what=inner.what, one=yields, two=strength)
    name = key if inner.optional_node("name") is None else inner.read_text("name")
    is_alloyed = inner.optional_node("alloyed") is not None and inner.read_word("alloyed", ("yes", "no")) == "yes"
    bending, torsion = (inner.above(k) if k in inner else None for k in KEYS_BY_TABLE["material"][4:6])
    return make_material(
        name, strength, yields, is_alloyed, bending, torsion, inner.above("elasticity_MPa", ELASTICITY_MPA)
    )


def _read_concentration(table: Values) -> dict[str, Concentration]:
    """Stress raisers of journal and crank pin."""
    raisers = {}
    for key in table.table.entries:
        inner = table.inner_fields(key, KEYS_BY_TABLE["concentration"])
        raisers[key] = Concentration(
            k_sigma=inner.between("k_sigma", 1.0, 20.0),
            k_tau=inner.between("k_tau", 1.0, 20.0),
            size_sigma=inner.between("size_sigma", 0.1, 1.0),
            size_tau=inner.between("size_tau", 0.1, 1.0),
        )
    return raisers
