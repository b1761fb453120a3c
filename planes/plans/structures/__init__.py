"""Bodies and trusses in equilibrium, by graphical statics: string polygons, lines of action, Bow's notation."""
