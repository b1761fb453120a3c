"""Diagrams over the cycle: every quantity as a curve of the driver's place, its extremes, and how it is found by hand.

``curves`` names the quantities, ``turn`` runs the one program for many places of the driver, once with the drive's own
motion and once with a unit drive (ω₁ = 1, ε₁ = 0: what it gives then are the analogues, exactly); ``extremes`` refines
what a grid only brackets; ``summary`` gathers strokes, dead points, the time ratio and paths; ``graphical`` draws
differentiation by chords and integration by a pole, as programs of steps.
"""
