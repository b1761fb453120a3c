"""All weights of the search in one place: natural logarithms of odds, except lengths.

They were set by hand on pictures of right plans and of mistakes of any size, and compared with a logistic regression on
340 of these; they are not fitted to it, and the odds are not calibrated.
"""

MISSING, GAINED = 0.55, 0.30  # per mm of a line missing; found, where stray ink is not weighed
STRANGE = 0.70  # per mm of unexplained ink
BESIDE_SCHEME_MM = 100.0  # of it, beside a scheme: single views have 15, sheets with twelve positions 1400 to 1900
HEAD = 1.2  # per unit of evidence for a head at the end of a line
ONE_HEAD_MM, ONE_WAY = 2.5, 0.95  # half of a head's length: ends nearer than this share it; cosine of their directions
HEADLESS = 4.7  # of a vector that shows no head, where more show theirs: so do 7 of 1453 with one, 140 of 241 without
HAND = 0.2  # per squared distance of a mark from its constructed point, in σ
HAND_MM, HAND_SHARE = 0.35, 0.004  # that σ: constant part, and part per distance from the pole
COSTS = {"right": 0.0, "catalogue": 4.0, "length": 6.0, "turned": 6.0, "anywhere": 8.0, "whole": 6.0}
ANOTHER, ORDER, PRINTED = 4.0, 2.0, 5.0  # extra cost of a second mistake; of another order; of a print scale not 100 %
OMITTED = 4.5  # of a line never drawn

STEP_MM, LEAST_MM, REACH_MM, GRID_MM = 1.5, 1.4, 24.0, 2.0  # free sizes: step, smallest, reach in any direction, grid
LONGER, SHORTER_MM, LONGEST_MM = 1.3, 125.0, 90.0  # limits of a wrong length: its share, mm shorter and longer
SHORT_MM = 1.5  # shorter lines are not looked for
MOST, KEPT, APART_MM = 900, 4, 4.0  # free sizes weighed after the first pass; kept per kind and mark, their distance
WEIGHED, SETTLED, FIRSTS, SECONDS = 120, 10, 3, 3  # weighed on all ink; settled; bases for a second one
MOVES_MM = (1, (0.8, 0.3)), (0, (0.5, 0.25, 0.1))  # of settling marks, by ink within a pixel, and exactly there
TO_END_MM, TO_END_SHARE = 1.6, 0.05  # from a mark to a line's end, where ends are known; per distance from the pole
ROUNDS, ENOUGH, LOOSE_MM = 14, 0.05, 0.8  # rounds of moves; the smallest gain; tolerance of lines before they settle
DRAWN = 0.5  # share of a line above which it is drawn, if without its head
COARSE, FINE = 24, 56  # samples per line
FAR_MM, ROOM_MM, MARGIN_MM = 230.0, 150.0, 20.0  # of a mark off the sheet; of the drawing area, and around it
SHARES = 0.935, 0.996, 0.005  # print scales, in steps: those that fit the margins of a printer
PRINTS, ALIKE = 2, 0.012  # print scales besides full size examined closely; difference of equal scales
NAMED = 5  # orders suggested by names and settled
BEAMS, STRAY = 12, 0.01  # beam width for polygon orders; cost per side out of turn
AT_ALL = 0.5  # minimum share of a plan's lines found for a second mistake to be sought
EXPLAINED = 0.9  # share of a plan's lines found above which no second mistake is sought
MOVED_MM = 1.5  # least displacement by a mistake

LETTERS = 1.2  # weight of names that stand elsewhere
ODDS = (0.0, 0.8)  # of a mistake: at equal scores, and factor on a score, as logarithms
TELLING, FAR_OFF_MM = 0.5, 4.0  # evidence for a mark's place over another at that distance, or the mark is unverified;
# of 45 right blanks by other means at most one is right as seen for it; two wrong ones had been called right
TURNED = 0.9  # chance of a vector turned round by its head on a picture: a page in twenty has one, seen on one in four,
# and of 614 right pages none shows one
NO_DOUBT, ASKED = 0.02, 0.05  # less doubt is none; with more, the drawing may as well be the other
LEAST_COVER = 0.75  # minimum share of the likeliest drawing's lines found, or no such plan is seen
READ_MM, ASTRAY, SIGMAS, POLE_MM, UNSEEN_MM = (
    0.3,
    0.5,
    1.0,
    0.2,
    1.2,
)  # σ of a mark; per distance moved; by its settling; of the pole; not seen
SIGN_MM = 1.0  # σ of a point of a scheme along its only link
NEAR_MM, RIM_MM, FEW, PIXEL_MM = 0.6, 1.5, 10, 1.0  # of ink fitted by a line: aside, off its ends; points; their σ
POINT_MM = 0.3  # a shorter side is a point
STRANGE_MM = 25.0  # more ink than this outside the plan's vectors is reported
LONG_MM, TORN_MM = 8.0, 3.0  # of a line that must be visible; of which may be missing (of 335 on right pictures 1.0)
NARROW = 0.42  # radians between lines of nearly one direction
BESIDE_MM, LIKELY = 7.0, 0.5  # maximum distance of a name from its mark; certainty of its reading
# odds of two names at each other's marks, alone and over their own; certainty of their reading
CROSSED, RATHER, EXCHANGED = 0.08, 25.0, 0.95
SOFT_MM = 1.5  # margin by which a text is nearer to its own mark than to any other
