"""Names people write beside marks, brought to the names of the program: primes, indices, look-alike letters."""

from __future__ import annotations

import unicodedata
from collections.abc import Callable, Iterable
from functools import lru_cache

from planes.words.names import POLE

_ALIKE = str.maketrans("АВЕКМНОРСТХУЈІаеорсхуі", "ABEKMHOPCTXYJIaeopcxyi")
_PRIMES = str.maketrans(dict.fromkeys("’‘′ʹ`´", "'"))
_POLES = {"π", "p", "p'", "π'", "полюс", "pole", "P"}


def latin(name: str) -> str:
    """The name with every Cyrillic letter that looks like a Latin one replaced by it."""
    return name.translate(_ALIKE)


@lru_cache(4096)
def tidy(name: str) -> str:
    """A name without markup: Latin letters, straight primes, no indices' signs."""
    text = unicodedata.normalize("NFKC", name).strip().translate(_PRIMES).replace("″", "''")
    text = text if text == "полюс" else text.translate(_ALIKE)
    for old, new in (("Φ", "I"), ("ω", "omega"), ("ε", "epsilon"), ("φ", "phi"), ("τ", "t"), ("μ", "mu")):
        text = text.replace(old, new)
    return "".join(c for c in text if c not in "_^{} .·*")


class Names:
    """Finds the program's name for a written one; ``poles`` also reads the ways to write p.

    What is written as ``spelt`` says has that meaning before any other.
    """

    def __init__(self, known: Iterable[str], poles: bool = True, spelt: Callable[[str], str] = str) -> None:
        self.known = list(dict.fromkeys(known))
        self.poles, self.spelt = poles, spelt
        self._spelt = {tidy(spelt(name)): name for name in self.known}
        self._keys: list[dict[str, list[str]]] = [{}, {}, {}]
        for name in self.known:
            for table, key in zip(self._keys, self._forms(name), strict=True):
                table.setdefault(key, []).append(name)

    @staticmethod
    def _forms(name: str) -> tuple[str, str, str]:
        exact = tidy(name)
        folded = exact.casefold()
        return exact, folded, folded.replace("'", "")

    def exactly(self, written: str) -> str | None:
        """The program's name where it is written letter by letter, or the pole however it is written."""
        name = self.find(written)
        return name if name == POLE or tidy(written) in self._spelt or tidy(written) == tidy(name or "") else None

    def find(self, written: str) -> str | None:
        """The program's name, or None where there is none or two would do."""
        if self.poles and tidy(written) in _POLES:
            return POLE
        if tidy(written) in self._spelt:
            return self._spelt[tidy(written)]
        for table, key in zip(self._keys, self._forms(written), strict=True):
            found = table.get(key, [])
            if len(found) == 1:
                return found[0]
            if found:
                return None
        return None
