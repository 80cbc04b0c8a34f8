"""Whether a result's lines and the sheet's lines in one view say the same.

Recall is the share of the sheet's line that the result draws; precision the share of the result's
line that the sheet has; each within a tolerance, visible and hidden apart.  Where a visible line
runs, a hidden one under it cannot be seen: a hidden result line on a visible line of the sheet
counts as explained, and hidden strokes of the sheet on its own visible ones are not asked for.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.lines.line_points import Lines, lines_of_strokes
from gaussiancad_core.lines.strokes import DrawnStroke

STEPS_PER_TOLERANCE = 4.0
"""Strokes become points this much closer than the tolerance: distances are then good to 0.8 %."""


@dataclass(frozen=True)
class Agreement:
    """Shares from 0 to 1; 1 where there is no line of the kind."""

    visible_recall: float
    visible_precision: float
    hidden_recall: float
    hidden_precision: float

    @property
    def worst(self) -> float:
        """The smallest of the four."""
        return min(
            self.visible_recall,
            self.visible_precision,
            self.hidden_recall,
            self.hidden_precision,
        )


@dataclass(frozen=True, eq=False)
class MatchedLines:
    """Both drawings of one view, and which points of each the other has.

    Attributes:
        sheet: the sheet's lines; hidden ones under visible ones left out.
        result: the result's lines.
        visible_found, hidden_found: (n,) of the sheet's points.
        visible_explained, hidden_explained: (n,) of the result's points.
    """

    sheet: Lines
    result: Lines
    visible_found: npt.NDArray[np.bool_]
    hidden_found: npt.NDArray[np.bool_]
    visible_explained: npt.NDArray[np.bool_]
    hidden_explained: npt.NDArray[np.bool_]

    @property
    def agreement(self) -> Agreement:
        """The shares of length."""
        return Agreement(
            self.sheet.visible.share(self.visible_found),
            self.result.visible.share(self.visible_explained),
            self.sheet.hidden.share(self.hidden_found),
            self.result.hidden.share(self.hidden_explained),
        )


def agreeing_share(matches: Iterable[MatchedLines]) -> float:
    """Share of all lines of views, the sheet's and the result's, that the other drawing has."""
    agreeing = total = 0.0
    for match in matches:
        for points, agree in (
            (match.sheet.visible, match.visible_found),
            (match.sheet.hidden, match.hidden_found),
            (match.result.visible, match.visible_explained),
            (match.result.hidden, match.hidden_explained),
        ):
            agreeing += float(points.lengths[agree].sum())
            total += float(points.lengths.sum())
    return agreeing / total if total else 0.0


def match_lines(strokes: Iterable[DrawnStroke], result: Lines, tolerance: float) -> MatchedLines:
    """Match a result's lines with the sheet's strokes.

    Args:
        strokes: of the sheet's view, mm of its plane.
        result: the result's lines in the same plane.
        tolerance: mm.
    """
    sheet = lines_of_strokes(strokes, tolerance / STEPS_PER_TOLERANCE)
    covered = sheet.hidden.near(sheet.visible, tolerance)
    asked = Lines(sheet.visible, sheet.hidden.only(~covered))
    return MatchedLines(
        asked,
        result,
        asked.visible.near(result.visible, tolerance),
        asked.hidden.near(result.hidden, tolerance),
        result.visible.near(sheet.visible, tolerance),
        result.hidden.near(sheet.hidden, tolerance) | result.hidden.near(sheet.visible, tolerance),
    )
