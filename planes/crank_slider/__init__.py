"""The integrated calculation of a crank-slider: kinematics, kinetostatics, balancing, strength.

Motion and forces come from the general plans; the closed forms of the text are the second way that must agree.
"""
