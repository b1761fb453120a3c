"""Many positions of a mechanism at once: a program recorded on a tape, and loops that run it.

May import the engine and ``words``. A tape (``tape, symbols, tracing, plain_tape``) needs no numpy; ``cycle`` and the
loops do.
"""
