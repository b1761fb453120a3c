"""The studio's answers: the lesson of a text, what is wrong in it and what would be right, a drawn mechanism as a text.

Owns the messages of the studio, whoever carries them. May import the engine, ``lesson`` and ``words``; draws nothing,
writes nothing, and needs no numpy.
"""
