"""Equations drawn step by step into a program, and the instruments that run it; mechanisms are unknown here."""
