"""Vectors and equations stated directly in a scene."""
