"""Explains a drawing by synthesis: lays the right plan and every possible wrong one on the ink of a sheet.

It knows the construction program and its variants, and queries the ink for lines; it knows no pixels and no files.
"""
