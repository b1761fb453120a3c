"""Explanations weighed: the ink a plan would leave against the ink there is, and the best of its placings."""
