"""The number of ways in which links assemble on their ties, with the method that suits the number of links."""

from planes.geometry.parallel_ties import find_parallel_ties
from planes.geometry.searched import search_assemblies
from planes.geometry.sextic import Counted, three_tie_assemblies
from planes.geometry.tracks import Ties, carrier_links
from planes.geometry.two_tracks import two_link_assemblies


def all_assemblies(ties: Ties, size: float) -> Counted:
    """All assemblies of one link on three ties, or of two links in a hinge: an exact count; for more links, those
    found."""
    if all(t.link == 0 for t in ties):
        same = find_parallel_ties(ties)
        return same.assemblies() if same else three_tie_assemblies(ties)
    if len(carrier_links(ties)) == 2:
        return two_link_assemblies(ties)
    return search_assemblies(ties, size)
