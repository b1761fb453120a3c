"""Computer vision on a picture of paper: the rectified sheet, its ink, lines, heads, points."""
