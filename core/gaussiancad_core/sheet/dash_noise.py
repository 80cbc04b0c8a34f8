"""How alike the dashes of a sheet are, and how few of them tell anything.

ISO 128-2 draws dashes of 12 line widths with gaps of 3; programs keep neither length, but one sheet
keeps its own.  On a picture a dash is known to a px at either end, and more where strokes cross it.
"""

LIKE_A_DASH = 0.35
"""Share by which a dash or a gap of a picture may be longer or shorter than the sheet's: two px of
the shortest."""

ONE_DASH = 1.75
"""Dashes from which a stroke is more than one: a whole one, and what crossing strokes add to it."""

ROW = 4
"""Dashes one after the other that are a row: three stand in line by chance."""

FEWEST = 3
"""Dashes, or pairs of them, that tell a rhythm at least."""

TELLING = 6
"""Dashes, or gaps, of a whole sheet that tell anything of it at least."""
