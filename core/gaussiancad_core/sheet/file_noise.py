"""How exactly a file's strokes are known, in px at 200 dpi: as its program wrote their numbers.

Most write three decimals of a point or a mm, hundredths of a px; plotters and old programs round to
coarser steps, which :mod:`.pixel_grids` and :mod:`.missed_ends` measure.
"""

EXACT = 0.005
"""px by which curves of one line or circle lie beside it, where nothing was rounded."""

SAME_POINT = 0.02
"""px within which points of a file are one: two roundings of its numbers."""

DOT = 0.05
"""px up to which a stroke is a dot, and has no direction."""
