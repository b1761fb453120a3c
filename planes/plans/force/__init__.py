"""Loads, reactions and force plans; Zhukovsky's lever."""
