"""The accuracy of the numbers: error bounds, the scatter of a pencil, comparison of methods, limits, stability."""
