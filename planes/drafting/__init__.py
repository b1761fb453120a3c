"""Equations drawn step by step into a program, and the instruments that run it; knows no mechanism."""
