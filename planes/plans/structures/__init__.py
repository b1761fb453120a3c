"""Bodies and trusses in equilibrium, by graphical statics: string polygons and poles, lines of action, Bow's
notation."""
