"""What standards and practice say of lines and sheets (ISO 128-2, ISO 128-3, ISO 5457).

Wide lines are twice as wide as thin ones.  Dashes are 12 widths long and their gaps 3, dots no
longer than half a width; programs keep the order of these, and none of their sizes.  Hatching is of
thin lines at even distances.  A frame leaves a margin of 10 mm, on the filing side of 20.
"""

THIN = 0.75
"""Width of a thin line at most, in that of the wide ones: halfway between both."""

SLENDER = 2.5
"""Stroke widths that a dash is long at least: a shorter one is a dot."""

LONGEST_DASH = 120.0
"""px of a dash at most, 15 mm at 200 dpi."""

WIDEST_GAP = 1.5
"""Gap between two dashes at most, in the length of the longer one."""

HATCHING = 4
"""Parallel lines of a hatching at least."""

UNEVEN = 0.15
"""Share by which the distances of a hatching's lines differ at most."""

FRAME = 0.6
"""Share of a sheet that the longest lines of its frame span at least."""

MARGIN = 0.15
"""Share of a sheet that its margin is wide at most, a title strip or filing margin with it."""

CELLS = 3
"""Fields with writing that a table or a title block has at least."""

SMALLEST_VIEW = 32
"""px of the longer side of a view at least, 4 mm at 200 dpi."""
