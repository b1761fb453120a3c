"""Where marks may be: places told by strokes, letters read, the pole, the scale of the print, parts of a page."""
