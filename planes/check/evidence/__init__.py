"""What a drawing shows, by place and way: ink along a line, a head at its end, ink that no line explains. It knows no
plan."""
