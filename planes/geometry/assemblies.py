"""In how many ways links assemble on their ties: by what can be said of so many."""

from collections.abc import Sequence

from planes.geometry.parallel_ties import parallel
from planes.geometry.searched import searched
from planes.geometry.sextic import Counted, assemblies
from planes.geometry.tracks import Tie, hung_on
from planes.geometry.two_tracks import both_assemblies


def all_assemblies(ties: Sequence[Tie], size: float) -> Counted:
    """All of one link on three ties, or of two hinged to each other: counted exactly; of more those that are met."""
    if all(t.link == 0 for t in ties):
        same = parallel(ties)
        return same.assemblies() if same else assemblies(ties)
    return both_assemblies(ties) if len(hung_on(ties)) == 2 else searched(ties, size)
