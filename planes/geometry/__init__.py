"""Points and directions as complex numbers, and the arithmetic that draws with them."""
