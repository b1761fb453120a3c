"""Checks that the imported package ``render`` is the one installed with this one: another project may use the name."""

from importlib.util import find_spec
from pathlib import Path

from planes.words import Phrase
from planes.words.errors import PlanesError

PROGRAM_FOLDER = Path(__file__).resolve().parents[2]


def _refuse_foreign_render() -> None:
    """Refuse in one sentence to draw with a foreign ``render``; it is not executed."""
    spec = find_spec("render")
    places = [p for p in (spec.origin, *(spec.submodule_search_locations or ())) if p] if spec else []
    if PROGRAM_FOLDER / "render" not in (Path(p).resolve() for p in places):
        raise PlanesError(Phrase("foreign_render", home=PROGRAM_FOLDER / "render", found=places[0] if places else "—"))


_refuse_foreign_render()
