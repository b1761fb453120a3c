"""Loads, reactions and plans of forces; Zhukovsky's lever."""
