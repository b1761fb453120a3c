"""Shared by tests: independent solvers, random scenes, realistic drawings."""

from pathlib import Path

ROOT = Path(__file__).parents[2]
