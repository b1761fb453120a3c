"""Drawings written as files: SVG, PDF, PNG, DXF."""
