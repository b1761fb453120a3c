"""A drafting machine for the theory of mechanisms: plans drawn construction by construction, then measured.

The rooms, in the order data flows: ``scene`` (the file) → ``mechanism`` → ``structure`` (Assur groups) → ``plans``
(vector equations of positions, velocities, accelerations and forces) → ``drafting`` (equations to ``steps``) →
``program`` → ``instruments`` and ``drawing`` → ``measuring`` and ``solving``. Readers of the one program: ``cycle``
(many positions, the compiled loop, claims), ``diagrams`` (curves over the cycle, extremes, graphical methods),
``lesson``, ``check``, ``crank_slider``, ``course`` (individual work for a list of students), and the sheets behind
``roof``. ``words`` holds all text for people.
"""

__version__ = "0.1.0"
