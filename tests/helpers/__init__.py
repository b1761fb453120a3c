"""What tests share: independent solvers, random scenes, drawings as people make them."""

from pathlib import Path

ROOT = Path(__file__).parents[2]
