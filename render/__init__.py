"""Sheets: marks in millimetres of paper and the writers of SVG, PDF and PNG. No mechanics is computed here."""
