"""Bodies and trusses in equilibrium, by graphical statics: strings and poles, lines of action, Bow's letters."""
