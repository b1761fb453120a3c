"""How the links of a mechanism make groups of Assur: structure, class, order, what drives what."""
