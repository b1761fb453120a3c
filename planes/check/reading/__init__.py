"""Marks read out of drawings written by other programs."""
