"""All weights of the search in one place: natural logarithms of odds, except lengths.

They were set by hand on pictures of right plans and of mistakes of any size, and compared with a logistic regression on
340 of these; they are not fitted to it. How often verdicts held is counted in docs/checking.md.
"""

# per mm of a line missing; found, where stray ink is not weighed
MISSING_LINE_COST_PER_MM = 0.55
DRAWN_LINE_GAIN_PER_MM = 0.30
UNEXPLAINED_COST_PER_MM = 0.70  # per mm of unexplained ink
# of it, beside a scheme: single views have 15, sheets with twelve positions 1400 to 1900
MOST_INK_BESIDE_SCHEME_MM = 100.0
HEAD_EVIDENCE_WEIGHT = 1.2  # per unit of evidence for a head at the end of a line
# of a vector that shows no head, where more show theirs: so do 7 of 1453 with one, 140 of 241 without
HEADLESS_VECTOR_COST = 4.7
SAME_SYMBOL_MM = 1.5  # marks nearer to each other have one circle or dot
DRAWING_ERROR_WEIGHT = 0.2  # per squared distance of a mark from its constructed point, in σ
DRAWING_SIGMA_MM, DRAWING_SIGMA_PER_MM = 0.35, 0.004  # that σ: constant part, and part per distance from the pole
HYPOTHESIS_COSTS = {"right": 0.0, "catalogue": 4.0, "length": 6.0, "turned": 6.0, "anywhere": 8.0, "whole": 6.0}
# extra cost of a second mistake; of another order; of a print scale not 100 %
SECOND_MISTAKE_COST = 4.0
OTHER_ORDER_COST = 2.0
PRINT_SCALE_COST = 5.0
OMITTED_LINE_COST = 4.5  # of a line never drawn

# free sizes: step, smallest, reach in any direction, grid
DISPLACEMENT_STEP_MM = 1.5
LEAST_DISPLACEMENT_MM = 1.4
MOST_DISPLACEMENT_MM = 24.0
DISPLACEMENT_GRID_MM = 2.0
# limits of a wrong length: its share, mm shorter and longer
MOST_LENGTH_ERROR_SHARE = 1.3
MOST_SHORTENING_MM = 125.0
MOST_LENGTHENING_MM = 90.0
SHORTEST_LINE_MM = 1.5  # shorter lines are not looked for
# free sizes weighed after the first pass; kept per kind and mark, their distance
MOST_DISPLACEMENTS = 900
MOST_DISPLACEMENTS_PER_MARK = 4
DISPLACEMENT_SPACING_MM = 4.0
# weighed on all ink; settled; bases for a second one
MOST_HYPOTHESES_SCORED = 120
MOST_HYPOTHESES_SETTLED = 10
MOST_FIRST_MISTAKES = 3
MOST_SECOND_MISTAKES = 3
# of settling marks, by ink within a pixel, and exactly there
SETTLING_MOVES_MM = ((1, (0.8, 0.3)), (0, (0.5, 0.25, 0.1)))
# from a mark to a line's end, where ends are known; per distance from the pole
MOVE_TO_END_MM = 1.6
MOVE_TO_END_PER_MM = 0.05
# rounds of moves; the smallest gain; tolerance of lines before they settle
MOST_SETTLING_ROUNDS = 14
LEAST_SETTLING_GAIN = 0.05
UNSETTLED_LINE_TOLERANCE_MM = 0.8
DRAWN_LINE_SHARE = 0.5  # share of a line above which it is drawn, if without its head
COARSE_SAMPLES_PER_LINE, FINE_SAMPLES_PER_LINE = 24, 56  # samples per line
# of a mark off the sheet; of the drawing area, and around it
MOST_MARK_DISTANCE_MM = 230.0
DRAWING_AREA_RADIUS_MM = 150.0
DRAWING_AREA_MARGIN_MM = 20.0
PRINT_SCALE_RANGE = 0.935, 0.996, 0.005  # print scales, in steps: those that fit the margins of a printer
# print scales besides full size examined closely; difference of equal scales
MOST_OTHER_PRINT_SCALES = 2
EQUAL_PRINT_SCALE_DIFFERENCE = 0.012
MOST_ORDERS_BY_NAMES = 5  # orders suggested by names and settled
ORDER_BEAM_WIDTH = 12  # beam width for polygon orders
SIDE_OUT_OF_TURN_COST = 0.01  # cost per side out of turn
OVERLAP_COST_PER_MM = 0.1  # of a side over others, among orders that find as much ink
SIDE_END_MOVE_MM = 0.8  # from the place of a side's end to where it may have been drawn
LEAST_COVER_FOR_SECOND = 0.5  # minimum share of a plan's lines found for a second mistake to be sought
MOST_COVER_FOR_SECOND = 0.9  # share of a plan's lines found above which no second mistake is sought
LEAST_MISTAKE_SHIFT_MM = 1.5  # least displacement by a mistake

MISPLACED_NAME_WEIGHT = 1.2  # weight of names that stand elsewhere
MISTAKE_LOG_ODDS = (0.0, 0.8)  # of a mistake: at equal scores, and factor on a score, as logarithms
# evidence for a mark's place over another at that distance, or the mark is unverified;
LEAST_EVIDENCE_GAP = 0.5
RIVAL_MARK_DISTANCE_MM = 4.0
# of 45 right blanks by other means at most one is right as seen for it; two wrong ones had been called right
# chance of a vector turned round by its head on a picture: a page in twenty has one, seen on one in four,
REVERSED_VECTOR_CHANCE = 0.9
# and of 614 right pages none shows one
# less doubt is none; with more, the drawing may as well be the other
NEGLIGIBLE_DOUBT = 0.02
LEAST_SERIOUS_DOUBT = 0.05
LEAST_COVER = 0.75  # minimum share of the likeliest drawing's lines found, or no such plan is seen
# σ of a mark; per distance moved; by its settling; of the pole; not seen
READING_SIGMA_MM = 0.3
SIGMA_PER_MM_MOVED = 0.5
SETTLING_SIGMA_FACTOR = 1.0
POLE_SIGMA_MM = 0.2
UNSEEN_MARK_SIGMA_MM = 1.2
SCHEME_POINT_SIGMA_MM = 1.0  # σ of a point of a scheme along its only link
# of ink fitted by a line: aside, off its ends; points; their σ
FITTED_INK_OFFSET_MM = 0.6
UNFITTED_LINE_END_MM = 1.5
LEAST_FITTED_POINTS = 10
INK_POINT_SIGMA_MM = 1.0
SHORTEST_SIDE_MM = 0.3  # a shorter side is a point
MOST_STRAY_INK_MM = 25.0  # more ink than this outside the plan's vectors is reported
# of a line that must be visible; of which may be missing (of 335 on right pictures 1.0)
VISIBLE_LINE_MM = 8.0
MOST_LINE_GAP_MM = 3.0
SIMILAR_DIRECTIONS_RAD = 0.42  # radians between lines of nearly one direction
# maximum distance of a name from its mark; certainty of its reading
MOST_NAME_DISTANCE_MM = 7.0
LEAST_NAME_CERTAINTY = 0.5
# odds of two names at each other's marks, alone and over their own; certainty of their reading
LEAST_SWAPPED_NAME_ODDS, SWAPPED_OVER_OWN_ODDS, SWAPPED_NAMES_CERTAINTY = 0.08, 25.0, 0.95
NEARER_NAME_MARGIN_MM = 1.5  # margin by which a text is nearer to its own mark than to any other
