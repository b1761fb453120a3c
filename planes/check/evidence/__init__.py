"""The evidence of a drawing, by place and direction: ink along a line, a head at its end, unexplained ink.

It knows no plan.
"""
