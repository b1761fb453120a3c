"""Packs: subjects beside the plans of motion and forces. A folder with a ``pack.json`` is one, and nobody names it.

The file states the pack's key in a scene, the forms of its values for the schema, and its command. Its words stand in
separate files in the folders of languages.
"""

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from planes.scene.mechanism import nothing
from planes.words.frozen import field, frozen
from planes.words.records import Json


@frozen
class Pack:
    """A subject. Its ``key`` is a part of a scene of a mechanism; with ``scene_keys`` it decides another kind of scene,
    which ``read_subject`` of the module ``reader`` reads.

    ``scales`` are the plans that take their μ from another. ``schema`` has the keys of tables and the forms of
    ``schema_forms.json``; ``WORDS_BY_LIST`` of the ``reader`` has the words that values may be. ``command`` has the
    form of those in ``planes/cli/commands.json``; ``run`` of the module ``pack`` does it.
    """

    key: str
    reader: str
    schema: Mapping[str, Json]
    scene_keys: Sequence[str] = ()
    scales: Mapping[str, str] = field(default_factory=nothing)
    command: Mapping[str, Json] = field(default_factory=nothing)
    command_after: str = ""  # in lists


_ROOMS = Path(__file__).parents[1]
_FILES = sorted([*_ROOMS.glob("*/pack.json"), *_ROOMS.glob("*/*/pack.json")])  # as the package data of the wheel
PACKS = {pack.key: pack for pack in (Pack(**json.loads(file.read_text("utf-8"))) for file in _FILES)}
PARTS_OF_PACKS = tuple(key for key, pack in PACKS.items() if not pack.scene_keys)
"""The keys of packs in a scene of a mechanism."""
SUBJECTS_BY_KEY = {key: pack for key, pack in PACKS.items() if pack.scene_keys}
"""The packs with another kind of scene, by the key that decides it."""
