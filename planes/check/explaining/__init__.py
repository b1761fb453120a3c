"""What was drawn, by drawing it again: the right plan, and every way it may have gone wrong, laid on a sheet's ink.

It knows the program and its variants, and asks the evidence of lines; it knows no pixels and no file.
"""
