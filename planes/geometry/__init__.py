"""Points and directions as complex numbers, and the arithmetic of the constructions."""
