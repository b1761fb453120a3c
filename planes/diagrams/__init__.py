"""Diagrams over the cycle: every quantity as a curve over the driver's position, its extremes, and the graphical
construction.

``curves`` names the quantities, ``turn`` runs the one program for many positions of the driver, once with the drive's
given motion and once with a unit drive (ω₁ = 1, ε₁ = 0: its results are the analogues, exactly); ``extremes`` refines
the brackets of a grid; ``summary`` gathers strokes, dead points, the time ratio and paths; ``graphical`` draws
differentiation by chords and integration by a pole, as programs of steps.
"""
