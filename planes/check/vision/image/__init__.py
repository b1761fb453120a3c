"""A picture: its file decoded, its corner marks or frame found, the bend of the paper corrected."""
