"""Velocity and acceleration plans."""
