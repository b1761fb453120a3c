"""A picture: its file decoded, its corner marks or its frame found, the bend of the paper taken out."""
