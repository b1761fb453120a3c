"""Vectors and equations that a scene states by themselves."""
