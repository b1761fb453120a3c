"""All weights of the search in one place: natural logarithms of odds, but for lengths.

They were set by hand on pictures with the right plan and with mistakes of any size, and compared with a logistic
regression on 340 of these; they are not fitted to it, and the odds are not calibrated.
"""

MISSING, GAINED = 0.55, 0.30  # of a millimetre of line that is not there; that is, where strange ink is not weighed
STRANGE = 0.70  # of a millimetre of ink that no line explains
BESIDE_SCHEME_MM = 100.0  # of it, beside a scheme: single views have 15, sheets with twelve positions 1400 to 1900
HEAD = 1.2  # of a unit of what speaks for a head at a line's end
HAND = 0.2  # of the square of a mark's way from where steps lead, in its σ
HAND_MM, HAND_SHARE = 0.35, 0.004  # that σ: of any mark, and by how far it is from the pole
COSTS = {"right": 0.0, "catalogue": 4.0, "length": 6.0, "turned": 6.0, "anywhere": 8.0, "whole": 6.0}
ANOTHER, ORDER, PRINTED = 4.0, 2.0, 5.0  # more of a second mistake; of another order; of a sheet not printed at 100 %
OMITTED = 4.5  # of a line that nobody drew

STEP_MM, LEAST_MM, REACH_MM, GRID_MM = 1.5, 1.4, 24.0, 2.0  # of free sizes: steps, from where, how far any other way
LONGER, SHORTER_MM, LONGEST_MM = 1.3, 125.0, 90.0  # by which share a line may be wrong, and by how much at the most
SHORT_MM = 1.5  # lines that are not looked for
MOST, KEPT, APART_MM = 900, 4, 4.0  # free sizes weighed after the first look; kept of a kind and mark, how far apart
WEIGHED, SETTLED, FIRSTS, SECONDS = 120, 10, 3, 3  # weighed by all ink; settled; on which a second one is tried
MOVES_MM = (1, (0.8, 0.3)), (0, (0.5, 0.25, 0.1))  # of marks that settle, by ink a pixel about, and just there
TO_END_MM, TO_END_SHARE = 1.6, 0.05  # of a mark to the end of a line, where ends are known; of its way from the pole
ROUNDS, ENOUGH, LOOSE_MM = 14, 0.05, 0.8  # how often they are moved; what is no gain; of lines before they settle
COARSE, FINE = 24, 56  # places of a line at which ink is felt
FAR_MM, ROOM_MM, MARGIN_MM = 230.0, 150.0, 20.0  # of a mark that is off the sheet; of what may be drawn, and about it
SHARES = 0.935, 0.996, 0.005  # of its size, at which a sheet may have been printed: to fit the margins of a printer
PRINTS, ALIKE = 2, 0.012  # others than its full size that are looked at closely; shares that are one
NAMED = 5  # orders that names tell, settled
BEAMS, STRAY = 12, 0.01  # orders of a polygon followed at once; what each side out of turn costs
AT_ALL = 0.5  # the share of a plan's lines that must be there, or a second mistake is not looked for
EXPLAINED = 0.9  # the share of a plan's lines that must be there before no second mistake is looked for
MOVED_MM = 1.5  # what a mistake moves at the least

LETTERS = 1.2  # of what it costs that names stand elsewhere
ODDS = (0.0, 0.8)  # of a mistake: at equal scores, and by which a score counts, as logarithms
TELLING, FAR_OFF_MM = 0.5, 4.0  # by how much more a mark's place is told than another so far off, or it is not told;
# of 45 right blanks by other means at most one is as seen for it; two wrong ones had been called right
NO_DOUBT, ASKED = 0.02, 0.05  # less doubt is none; with more a drawing may as well be the other
LEAST_COVER = 0.75  # the share of the likeliest drawing's lines that must be there, or no such plan is seen
READ_MM, ASTRAY, SIGMAS, POLE_MM, UNSEEN_MM = (
    0.3,
    0.5,
    1.0,
    0.2,
    1.2,
)  # σ of a mark; by how far it was moved; by its settling; of the pole; not seen
SIGN_MM = 1.0  # σ of a point of a scheme along its only link
NEAR_MM, RIM_MM, FEW, PIXEL_MM = 0.6, 1.5, 10, 1.0  # of ink a line is fitted to: aside, off its ends; points; their σ
POINT_MM = 0.3  # a shorter side is a point
STRANGE_MM = 25.0  # more ink than this that is none of a plan's vectors is told of
LONG_MM, TORN_MM = 8.0, 3.0  # of a line that must be seen; how much of it may be lost (of 335 on right pictures 1.0)
NARROW = 0.42  # radians between lines of which one may look like the other's head, or feel it as its own
HEADS_MM = 2.4  # ends nearer to each other feel one head: it is felt 1.6 to 4 mm from an end
HEADED_MM, USUAL_HEAD, NO_HEAD, TURNED, FEWEST = 14.0, 1.0, 0.55, 0.9, 3  # of lines with plain heads; the evidence
BESIDE_MM, LIKELY = 7.0, 0.5  # how far off its mark a name stands, at the most; how surely it is read
# how likely two names together are by each other's marks, how much rather than by their own; how surely they were read
CROSSED, RATHER, EXCHANGED = 0.08, 25.0, 0.95
SOFT_MM = 1.5  # by which a text is nearer to what it names than to anything else
