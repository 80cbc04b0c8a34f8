"""How exactly the lines of a sheet are known, in grid steps.

A grid step is the noise of the lines: a pixel of a picture, the rounding of a file, or what its
views contradict each other by (:mod:`gaussiancad_core.evidence.line_noise`).  What is one place
lies within a step or little more, as two ends of it may be off.
"""

LEAN = 0.4
"""By which a line along an axis may lean: half a step would be another coordinate."""

STEP = 1.0
"""Within which a line is at a place that another one shows."""

NEAR = 1.2
"""Within which two places that lines show are one: a step, and what rounding adds."""

MEETING = 1.5
"""Between ends that meet: both are off, across each other."""

SHORTEST_LEVEL = 2.5
"""That a line is long at least to show a level of its own."""
