"""The package ``render`` that is found is the one installed beside this: another project may have one of that name."""

from importlib.util import find_spec
from pathlib import Path

from planes.words import Phrase
from planes.words.errors import PlanesError

HOME = Path(__file__).resolve().parents[2]


def _insist() -> None:
    """Refuse in one sentence to draw with somebody else's ``render``; it is not run."""
    spec = find_spec("render")
    places = [p for p in (spec.origin, *(spec.submodule_search_locations or ())) if p] if spec else []
    if HOME / "render" not in (Path(p).resolve() for p in places):
        raise PlanesError(Phrase("foreign_render", home=HOME / "render", found=places[0] if places else "—"))


_insist()
