"""A drafting machine for the theory of mechanisms: plans drawn construction by construction, then measured."""

__version__ = "0.1.0"
