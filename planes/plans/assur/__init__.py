"""How the links of a mechanism form Assur groups: structure, class, order, and the sequence of attachment."""
