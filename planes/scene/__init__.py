"""The scene file, format 1: the student's text, read into a mechanism (or vectors) and the results asked for."""

import unicodedata
from collections.abc import Mapping
from functools import cached_property
from importlib import import_module
from pathlib import Path
from types import MappingProxyType

from planes.scene import settings, source
from planes.scene.doubts import check_rod_lengths, parameters_used_only_under, read_doubts
from planes.scene.friction import read_friction
from planes.scene.links import read_frame, read_links
from planes.scene.load_laws import LawReader, law_reader_without_mechanism
from planes.scene.mechanism import FRAME, Drive, Mechanism, Where, nothing
from planes.scene.motion import read_assembly, read_drive, read_loads
from planes.scene.outline import kind_of_scene
from planes.scene.packs import PARTS_OF_PACKS, SUBJECTS_BY_KEY
from planes.scene.parameters import (
    KEYS_WITHOUT_EFFECT,
    choose_variant,
    parameter_values_in_use,
    read_laws,
    read_parameters,
    read_variants,
    variant_with_numbers,
)
from planes.scene.paths import entries_of_table, line_of_path
from planes.scene.reader import Fields, Reader
from planes.scene.settings import Words
from planes.scene.source import Nodes
from planes.scene.vector_equations import VectorEquations
from planes.scene.vectors import Statement, StatementReader, VectorGiven, read_own_equations
from planes.words import Phrase
from planes.words.errors import Doubt, SceneError
from planes.words.frozen import field, frozen
from planes.words.names import NameTuple, NumbersByName, with_latin_letters
from planes.words.records import Pictured
from planes.words.units import Convention

__all__ = ["ReadWith", "Scene", "Statement", "VectorGiven", "load", "loads"]


@frozen
class ReadWith:
    """How a scene was read; for other parameters or another variant its file is read again."""

    variant: str | None = None
    variants: NameTuple = ()
    parameters: NumbersByName = field(default_factory=nothing)
    source: str = field(default="", compare=False)
    changed: NumbersByName = field(default_factory=nothing, compare=False)


@frozen
class Scene(Pictured):
    """The contents of a scene file: either a ``mechanism``, or a ``statement`` of vectors and equations.

    ``mu`` is in mm per SI unit, None where the program chooses; its keys are the four plans, and in a scene of vectors
    "contour" and "vectors" too. ``parts`` of packs are kept as written, by their keys. ``missing`` lists the gaps in
    the data of an assignment.
    """

    file: str = ""
    title: Words = field(default_factory=nothing)
    note: Words = field(default_factory=nothing)
    reading: ReadWith = field(default_factory=ReadWith)
    mechanism: Mechanism | None = None
    statement: Statement | None = None
    mu: Mapping[str, float | None] = field(default_factory=nothing)
    find: NameTuple | None = None
    sheet: Mapping[str, object] = field(default_factory=nothing)
    where: Where = field(default_factory=nothing, compare=False, repr=False)
    parts: Nodes = field(default_factory=nothing, compare=False, repr=False)
    missing: Mapping[str, str] = field(default_factory=nothing)
    doubts: tuple[Doubt, ...] = ()
    mu_written: Convention | None = None
    equations: VectorEquations = ()  # the user's equations beside a mechanism

    @property
    def variant(self) -> str | None:
        """The variant it was read for."""
        return self.reading.variant

    @property
    def variants(self) -> NameTuple:
        """The variants the file has."""
        return self.reading.variants

    @property
    def parameters(self) -> NumbersByName:
        """The parameters it was read with."""
        return self.reading.parameters

    @cached_property
    def used(self) -> NumbersByName:
        """The parameters in use, directly or through one another."""
        return parameter_values_in_use(self.reading.source, self.file, self.parameters)

    @property
    def frame_number(self) -> str:
        """The number of the frame on sheets."""
        return self.mechanism.frame_number if self.mechanism else FRAME

    @property
    def drive(self) -> Drive | None:
        """The drive of the mechanism, or of the laws of the statement."""
        if self.mechanism:
            return self.mechanism.drive
        if self.statement:
            return self.statement.drive
        return None

    @property
    def mu_convention(self) -> Convention:
        """The convention in which μ is printed: that of ``sheet``, otherwise that of the first scale in the scene."""
        said = self.sheet.get("mu_convention", self.mu_written)
        return "unit_per_mm" if said == "unit_per_mm" else "mm_per_unit"

    def __hash__(self) -> int:
        return hash((self.file, self.variant, *sorted(self.parameters.items())))

    def __repr__(self) -> str:
        what = "vectors" if self.mechanism is None else f"links {', '.join(self.mechanism.links)}"
        variant = f", variant {self.variant}" if self.variant else ""
        return f"<Scene {self.title.get('en') or self.file!r}: {what}{variant}>"

    def with_parameters(self, **values: float) -> "Scene":
        """The same scene read again with other numbers for some of its parameters (SI, degrees)."""
        return loads(self.reading.source, self.file, self.variant, **{**self.reading.changed, **values})

    def to_yaml(self) -> str:
        """The text of its scene file. Where a variant was chosen or parameters were changed, their numbers are in its
        parameters, and variants and remarks are not kept."""
        from planes.scene.writing import scene_text_with_numbers

        changed = {name: repr(float(value)) for name, value in self.reading.changed.items()}
        if not changed and self.variant is None:
            return self.reading.source
        return scene_text_with_numbers(self.reading.source, self.file, self.variant, changed, {})


def load(path: str | Path, variant: str | None = None, **parameters: float) -> Scene:
    """Read a scene file, with other numbers for the ``parameters`` named (SI, degrees).

    Raises :class:`~planes.words.errors.SceneError`, with file and line, for a mistake in the file or an unknown
    parameter.
    """
    return loads(source.read_file_text(path), str(path), variant, **parameters)


def loads(text: str, file: str = "scene.yaml", variant: str | None = None, **parameters: float) -> Scene:
    """Read the text of a scene file, as :func:`load` does."""
    table = source.parse_yaml(text, file)
    reader = Reader(file)
    kind = kind_of_scene(reader, table)
    variant = variant and unicodedata.normalize("NFC", variant[:1000])
    scene = Fields(reader, table, Phrase("the_scene"))
    given = scene.optional_node("parameters")
    tables = read_variants(reader, scene.optional_node("variants"), given)
    variant, chosen = choose_variant(reader, tables, variant, table.lines.get("variants", 1))
    changed = variant_with_numbers(reader, given, chosen, parameters)
    reader.parameters = MappingProxyType(read_parameters(reader, given, changed))
    stated = {**entries_of_table(given), **entries_of_table(changed)}
    if idle := parameters.keys() & parameters_used_only_under(table, stated, KEYS_WITHOUT_EFFECT):
        raise SceneError(Phrase("parameter_idle", name=min(idle)), file, line_of_path(table, ("parameters", min(idle))))
    reading = ReadWith(variant, tuple(tables), reader.parameters, text, MappingProxyType(parameters))
    return _scene_from_fields(scene, kind, reading, stated)


def _scene_from_fields(scene: Fields, kind: str, reading: ReadWith, stated: Nodes) -> Scene:
    reader = scene.reader
    table = scene.table
    where = MappingProxyType({path: line for path, _, line in source.walk_nodes(table) if path})
    pack = SUBJECTS_BY_KEY.get(kind)
    laws = None if kind == "frame" else law_reader_without_mechanism(scene, stated)
    subject = import_module(pack.reader).read_subject(scene, laws) if pack else None
    mechanism = _mechanism_from_fields(scene, where, stated) if kind == "frame" else None
    mu = settings.read_plan_scales(reader, scene.optional_node("plans"))
    quantity = None
    if kind == "vectors":
        mu, quantity = settings.read_vector_scales(scene, mu)
    if pack:
        mu |= {plan: mu[other] for plan, other in pack.scales.items()}
    if "note" in scene and "text" in scene:
        scene.require_one_key("note", "text")
    said = {key: scene.optional_node(key) for key in ("title", "note", "missing")}
    said["note"] = said["note"] or scene.optional_node("text")
    statement = StatementReader(scene, laws).read_statement(quantity) if kind == "vectors" else None
    if pack:
        statement = Statement(parameters=reader.parameters, subject=subject, drive=laws.drive if laws else None)
    words = {key: MappingProxyType(settings.read_text_by_language(reader, node, key)) for key, node in said.items()}
    return Scene(
        file=reader.file,
        title=words["title"],
        note=words["note"],
        reading=reading,
        mechanism=mechanism,
        statement=statement,
        mu=MappingProxyType(mu),
        find=settings.read_names_to_find(reader, scene.optional_node("find")),
        sheet=MappingProxyType(dict(settings.read_sheet_settings(reader, scene.optional_node("sheet")))),
        where=where,
        parts=MappingProxyType({key: node for key in PARTS_OF_PACKS if (node := scene.optional_node(key))}),
        missing=words["missing"],
        doubts=tuple(read_doubts(reader.file, table, stated, mechanism)),
        mu_written=settings.written_mu_convention(table),
        equations=read_own_equations(reader, table.entries["equations"]) if mechanism and "equations" in scene else (),
    )


def _mechanism_from_fields(scene: Fields, where: Where, stated: Nodes) -> Mechanism:
    reader = scene.reader
    table = scene.table
    reader.taken = {with_latin_letters(path[-1]) for path in where if path[-2:-1] == ("points",)}
    frame = read_frame(reader, table.entries["frame"])
    links = read_links(reader, table.entries["links"], frame)
    drive = read_drive(reader, table.entries["drive"], links)
    assembly = scene.optional_node("assembly")
    loads = scene.optional_node("loads")
    friction, journals = read_friction(reader, f, frame, links) if (f := scene.optional_node("friction")) else ({}, {})
    mechanism = Mechanism(
        frame,
        MappingProxyType(links),
        drive,
        () if loads is None else read_loads(LawReader(scene, links, drive, stated), loads, {FRAME: frame, **links}),
        None
        if (gravity := scene.optional_node("gravity")) is None
        else reader.read_non_negative(gravity, Phrase("gravity")),
        MappingProxyType(friction),
        MappingProxyType(journals),
        MappingProxyType({} if assembly is None else read_assembly(reader, assembly, frame, links)),
        where,
        MappingProxyType(read_laws(table, stated)),
        settings.read_number_of_frame(reader, table.entries["frame"]),
        reader.written,
    )
    check_rod_lengths(reader, mechanism)
    return mechanism
