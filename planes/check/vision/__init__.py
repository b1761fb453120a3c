"""What the checker sees on a picture of paper: the sheet made flat, its ink, lines, heads, places."""
