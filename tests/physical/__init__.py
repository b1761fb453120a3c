"""Physically simulated pictures of drawings (graphite, pens, printers, paper, lenses, light), and their reading."""
