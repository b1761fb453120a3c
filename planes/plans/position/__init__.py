"""The scheme: the plan of positions, group by group, and the choice of assembly."""
