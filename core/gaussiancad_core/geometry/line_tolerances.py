"""The lengths that decide what counts as one line, and as none."""

from dataclasses import dataclass


@dataclass(frozen=True)
class Precision:
    """Lengths in mm that decide what an edge looks like.

    Attributes:
        fit: largest distance between a projected edge and the line or circle that replaces it.
        chord: largest distance between a curve and the chain that replaces it.
        cover: chains closer to another line than this are that line; they follow intersection
            curves, which are known less exactly than lines and circles.
        fragment: strokes shorter than this are dropped, gaps shorter than this are closed.
    """

    fit: float
    chord: float
    cover: float
    fragment: float
