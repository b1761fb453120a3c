"""The structure of a mechanism: degree of freedom, redundant constraints, pairs, Assur groups in order."""

from planes.plans.assur.contours import AnyGroup
from planes.plans.assur.groups import Group, Pair
from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen
from planes.words.names import NameTuple
from planes.words.records import Json

GROUP_CLASSES = ("II", "III", "IV")
"""The classes of groups that can be drawn, from the lowest."""


@frozen
class Structure:
    """The structure of a mechanism: degree of freedom, redundant constraints, pairs, groups in order."""

    W: int
    q: int
    drive_pair: Pair
    groups: tuple[AnyGroup, ...]
    driver: str
    passive: NameTuple = ()  # passive links, left out of the analysis
    ways: tuple["Structure", ...] = ()  # of other drivers that give a lower class

    @property
    def class_index(self) -> int:
        """The index in ``LEVELS`` of the mechanism's class, that of its highest group."""
        return max((GROUP_CLASSES.index(g.level) for g in self.groups), default=0)

    @property
    def mechanism_class(self) -> str:
        """The class of the mechanism."""
        return GROUP_CLASSES[self.class_index]

    @property
    def has_inner_drive(self) -> bool:
        """Whether the drive is between two moving links."""
        return self.drive_pair.other != FRAME

    @property
    def pairs(self) -> tuple[Pair, ...]:
        """Every pair once: the drive's, then the outer, inner and outer pair of each group; a braced hinge last."""
        braced = (g.drive for g in self.class_two_groups if g.brace and g.drive)
        return tuple(dict.fromkeys((self.drive_pair, *(p for g in self.groups for p in g.pairs), *braced)))

    @property
    def drive_pairs(self) -> tuple[Pair, ...]:
        """The drive's pair, and the hinge across which a cylinder works."""
        return (self.drive_pair, *(g.drive for g in self.class_two_groups if g.brace and g.drive))

    def is_driving_cylinder(self, group: AnyGroup) -> bool:
        """Whether a group is the driving cylinder."""
        return isinstance(group, Group) and group.inner == self.drive_pair

    def json(self) -> Json:
        """W, q, formula and groups as in the JSON output."""
        report = {
            "W": self.W,
            "q": self.q,
            "formula": self.structural_formula,
            "groups": [g.json() for g in self.groups],
        }
        ways = [{"link": s.driver, "class": s.class_index + 2, "formula": s.structural_formula} for s in self.ways]
        return report | ({"passive": list(self.passive)} if self.passive else {}) | ({"drivers": ways} if ways else {})

    @property
    def structural_formula(self) -> str:
        """The structural formula: "I(0;1) -> II(2;3) -> II(4;5)"; for a cylinder of 1 and 2 that moves 3, "I(1;2) ->
        II(1-2;3)"."""
        return self.formula_with_frame_number(FRAME)

    def formula_with_frame_number(self, frame: str, kinds: bool = False) -> str:
        """The same with the frame's number; ``kinds``: lettered, with the kind of every group as a subscript."""
        kind = {id(g): f"_{{{g.kind}}}" for g in self.class_two_groups if kinds}
        groups = (
            f"{g.level}{kind.get(id(g), '')}({g.formula_members})"
            for g in self.groups
            if not self.is_driving_cylinder(g)
        )
        base = self.drive_pair.other if self.has_inner_drive else frame
        return (" → " if kinds else " -> ").join([f"I({base};{self.driver})", *groups])

    @property
    def driven(self) -> tuple[Group, ...]:
        """The dyads driven from inside: groups, and a lead with the basic link."""
        leads = ((g.basic, lead) for g in self.groups if not isinstance(g, Group) for lead in g.leads)
        return *(g for g in self.class_two_groups if g.drive), *(
            x.as_inner_driven_dyad(basic) for basic, x in leads if x.drive
        )

    @property
    def class_two_groups(self) -> tuple[Group, ...]:
        """The groups of class II."""
        return tuple(g for g in self.groups if isinstance(g, Group))
