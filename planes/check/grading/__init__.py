"""Judges marks step by step and finds the mistakes that explain them."""
