"""The studio's answers: the lesson of a text, its errors and their corrections, a drawn mechanism as a text.

Owns the messages of the studio, independent of the carrier. May import the engine, ``lesson`` and ``words``; draws
nothing, writes nothing, and needs no numpy.
"""
