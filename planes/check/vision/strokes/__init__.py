"""What the pen left: ink by its contrast, lines fitted to it, heads of arrows, what was rubbed out."""
