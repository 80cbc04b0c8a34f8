"""Shares that are asked of a sheet: how many of several agree, how much of a stroke is drawn.

No two are nearer to each other than what one spurious or missing stroke of a small drawing changes.
"""

HALF = 0.5
"""Share from which more is than is not."""

MOST = 0.65
"""Share that is most: about two of three, with one left over by a wrong stroke."""

LARGELY = 0.8
"""Share that is there but for what other strokes cross and hide."""

NEARLY_ALL = 0.95
"""Share that is all, but for noise and rounding."""
