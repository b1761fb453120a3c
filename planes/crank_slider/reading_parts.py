"""Reads the parts of ``crank_slider:``: crankshaft, rod, piston pin, their steels and stress raisers."""

from __future__ import annotations

from planes.crank_slider.given import Concentration, PistonPin, Shaft
from planes.crank_slider.materials import ELASTICITY_MPA, STEELS, Material, made, steel
from planes.crank_slider.reading_table import Values
from planes.crank_slider.sections import Round, Shank, Web
from planes.scene.source import SourceScalar
from planes.words import Phrase
from planes.words.errors import choices, shown

_MATERIAL = ("name", "strength_MPa", "yield_MPa", "alloyed", "fatigue_MPa", "fatigue_torsion_MPa", "elasticity_MPa")


def read_shaft(top: Values) -> Shaft | None:
    """The crankshaft."""
    table = top.inner("shaft", ("span", "pin_from_B", "webs", "journal", "crankpin", "web", "masses"))
    if table is None:
        return None
    span, n, m = table.above("span"), table.above("pin_from_B"), table.above("webs")
    if m >= min(n, span - n):
        raise table.error(Phrase("cs_span", webs=m, left=span - n, right=n), "webs")
    web = table.needed("web", ("width", "thickness"))
    masses = table.needed("masses", ("pin", "webs", "webs_radius"))
    return Shaft(
        span,
        n,
        m,
        _round(table, "journal"),
        _round(table, "crankpin"),
        Web(web.above("width"), web.above("thickness")),
        masses.not_negative("pin"),
        masses.not_negative("webs"),
        masses.number("webs_radius"),
    )


def _round(table: Values, key: str) -> Round:
    inner = table.needed(key, ("diameter", "bore"))
    return _bored(inner)


def _bored(table: Values) -> Round:
    outer, bore = table.above("diameter"), table.not_negative("bore", 0.0)
    if bore >= outer:
        raise table.error(Phrase("cs_thin", what=table.what, inner=bore, outer=outer), "bore")
    return Round(outer, bore)


def read_rod(top: Values) -> Shank | None:
    """The rod's shank: an I-section, or a bar where flange and web are left out."""
    table = top.inner("rod", ("height", "width", "flange", "web"))
    if table is None:
        return None
    height, width = table.above("height"), table.above("width")
    flange, web = table.above("flange", height / 2), table.above("web", width)
    if 2 * flange > height:
        raise table.error(Phrase("cs_thin", what=table.named("flange"), inner=2 * flange, outer=height), "flange")
    if web > width:
        raise table.error(Phrase("cs_thin", what=table.named("web"), inner=web, outer=width), "web")
    return Shank(height, width, flange, web)


def read_pin(top: Values) -> PistonPin | None:
    """The piston pin."""
    table = top.inner("piston_pin", ("diameter", "bore", "length", "bush", "gap"))
    if table is None:
        return None
    length, bush, gap = table.above("length"), table.above("bush"), table.above("gap")
    if not bush <= gap < length:
        raise table.error(Phrase("cs_pin_length", gap=gap, bush=bush, length=length), "gap")
    return PistonPin(_bored(table), length, bush, gap)


def read_materials(top: Values) -> dict[str, Material]:
    """The steel of each part: a name of the table or its own numbers in MPa."""
    table = top.inner("materials", ("shaft", "rod", "piston_pin"))
    return {} if table is None else {key: _material(table, key) for key in table.table.entries}


def _material(table: Values, key: str) -> Material:
    node = table.reader.required(table.table, key, table.what)
    if isinstance(node, SourceScalar):
        name = table.reader.text(node, table.named(key))
        found = steel(name)
        if found is None:
            words = Phrase(
                "cs_no_steel", what=Phrase("about", what=table.named(key), why=shown(name)), valid=choices(name, STEELS)
            )
            raise table.error(words, key)
        return found
    inner = table.needed(key, _MATERIAL)
    strength, yields = inner.above("strength_MPa"), inner.above("yield_MPa")
    if yields > strength:
        raise inner.error(Phrase("cs_yield", what=inner.what, one=yields, two=strength), "yield_MPa")
    name_node = inner.reader.optional(inner.table, "name")
    name = key if name_node is None else inner.reader.text(name_node, inner.named("name"))
    alloyed = inner.reader.optional(inner.table, "alloyed")
    is_alloyed = alloyed is not None and inner.reader.word(alloyed, inner.named("alloyed"), ("yes", "no")) == "yes"
    bending, torsion = (inner.above(k) if k in inner.table.entries else None for k in _MATERIAL[4:6])
    elasticity = inner.above("elasticity_MPa", ELASTICITY_MPA)
    return made(name, strength, yields, is_alloyed, bending, torsion, elasticity)


def read_concentration(top: Values) -> dict[str, Concentration]:
    """Stress raisers of journal and crank pin."""
    table = top.inner("fatigue", ("journal", "crankpin"))
    if table is None:
        return {}
    found = {}
    for key in table.table.entries:
        inner = table.needed(key, ("k_sigma", "k_tau", "size_sigma", "size_tau"))
        found[key] = Concentration(
            inner.between("k_sigma", 1.0, 20.0),
            inner.between("k_tau", 1.0, 20.0),
            inner.between("size_sigma", 0.1, 1.0),
            inner.between("size_tau", 0.1, 1.0),
        )
    return found
