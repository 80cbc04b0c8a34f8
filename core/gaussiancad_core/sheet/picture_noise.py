"""How exactly a picture shows its lines: the one noise model of what is read from pixels.

At working scale a line is two or three px wide, and its ink is a weight from 0, paper, to 1.  The
centre of a stroke that lies alone is known to a tenth of a px (:mod:`.sharp_edges` to a hundredth).
Four things make it worse, each with a scale of its own.

* *Blur*: the edge of ink is spread over a px or two, more on scans.
* *Merging*: where strokes meet or touch, the ink of one hides where the other ends or leaves it.
* *Sampling*: strokes are looked at in places that are a part of a px apart.
* *Slant*: short strokes have directions that are off by a pixel over their length.
"""

import numpy as np

STEP = 0.5
"""px between places along a stroke that are looked at: the least that pixels tell apart."""

FINE_STEP = 0.25
"""px between places across a stroke, or of a stroke a few px long, whose middle is looked for."""

FINEST_STEP = 0.125
"""px between lengths, radii and offsets that are tried at last: about how well one is known."""

COARSE_STEP = 2.0
"""px between places of which each stands for the ink about it: strokes are as wide."""

DARK = 0.5
"""Ink from which a place is a stroke's: its edge is where its ink has half of its weight."""

FAINT = 0.35
"""Ink from which there may be a stroke: between two rows of pixels a thin one has half in each."""

BLANK = 0.1
"""Ink up to which a place is paper: blur, and the noise of scans."""

CLEAR = 0.75
"""px beside the edge of a stroke's ink from which its blur has ended."""

ON_LINE = 0.5
"""px by which the middle of a stroke's ink lies beside the stroke, at most."""

COURSE = 0.35
"""px by which the middle, or the width, of a stroke's ink varies along it, at most."""

ONE_PLACE = 1.0
"""px within which ends, middles and centres that were read one by one are one: twice as much."""

TOUCHING = 1.2
"""px by which a stroke may miss or cut another that it touches: their ink is one for a while, and
pulls both."""

SEEN_BEYOND = 1.8
"""px by which a stroke may seem to end beyond the ink that it has in common with another."""

DASH_END = 1.5
"""px from the end of a dash in which its ink falls off."""

OVERSHOOT = 6.0
"""px by which an edge may be drawn too short or too long."""

OVERRUN = 3.0
"""px by which a stroke may seem to end beyond the corner in which it ends: a line's width."""

JOINED = 2.5
"""px from an end within which a further stroke's end takes the same corner."""

AROUND = 2.5
"""px beside a stroke's ink that are looked at with it: its blur, and the ink of what it is not."""

FREE = 0.75
"""Line widths around an end, or a stroke, within which there is another that has the same ink."""

LONGEST_SHORT = 20.0
"""px of strokes that may be too short to be grown from the points of their ridge, at most."""

SMALLEST_RADIUS = 3.0
"""px under which an arc is a blot, and a rounded corner as good as sharp."""

LARGEST_RADIUS = 6_000.0
"""px from which an arc is not told from a line."""

SIDE_BY_SIDE = 10.0
"""px along which two strokes run beside each other at least: at a corner they do for less."""

NARROWEST, WIDEST = 0.5, 1.6
"""Line widths of ink across a line that are one stroke's."""

PARALLEL = float(np.radians(2.0))
"""Angle, or its sine, between lines that run along each other, at most: a px in thirty."""

LEVEL = 0.02
"""Sine of the angle within which a stroke of a part is level, upright, parallel or square."""

ASLANT = 0.05
"""Sine of the angle from which a stroke is aslant, and two lines cross in a point that is known."""

MEETING = 0.2
"""Sine of the angle between strokes that end each other, at least: others run along each other."""

SHARP, BLUNT = float(np.radians(25.0)), float(np.radians(155.0))
"""Angles between strokes that make a corner: at flatter ones they are each other's continuation."""

BETTER = 0.4
"""Share of the squared error without a stroke that is left with it at most, for it to be drawn."""

CLOSER = 0.7
"""Share of the squared error of a simpler, or an earlier, course of a stroke that another leaves at
most, to be taken instead."""

LEAST_GAIN = 1.0
"""Squared ink, in full pixels, that a stroke explains at least: noise explains a part of one."""

EVEN = 0.12
"""Mean ink by which the pixels about a stroke may differ from its pen's: else they show more."""

FEWEST_PLACES = 6
"""Places that tell the course of a stroke at least."""

FEWEST_PIXELS = 20
"""Pixels that are compared at least, for one course of a stroke to be better than another."""

INFERRED = 0.7
"""Confidence of a stroke much of whose ink others share; 1 is one whose ink is its own."""
