"""How far a number can be trusted: error bounds, the pencil's spread, methods compared, limits, stability."""
