"""Reads marks from drawings written by other programs."""
