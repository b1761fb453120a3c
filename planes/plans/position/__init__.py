"""The scheme: the plan of positions, group by group, and which assembly is meant."""
