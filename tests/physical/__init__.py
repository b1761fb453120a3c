"""Pictures of drawings made by physics: graphite on grain, pens, printers, paper, lenses, light; and what is read."""
