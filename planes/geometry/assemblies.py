"""The number of ways in which links assemble on their ties, with the method that suits the number of links."""

from collections.abc import Sequence

from planes.geometry.parallel_ties import parallel
from planes.geometry.searched import searched
from planes.geometry.sextic import Counted, assemblies
from planes.geometry.tracks import Tie, hung_on
from planes.geometry.two_tracks import both_assemblies


def all_assemblies(ties: Sequence[Tie], size: float) -> Counted:
    """All assemblies of one link on three ties, or of two links in a hinge: an exact count; for more links, those
    found."""
    if all(t.link == 0 for t in ties):
        same = parallel(ties)
        return same.assemblies() if same else assemblies(ties)
    return both_assemblies(ties) if len(hung_on(ties)) == 2 else searched(ties, size)
