"""From a grey sheet to ink: even light, median filter, adaptive threshold, stroke width, upright.

The filter and its 3 x 3 kernel are those of the GaussianCAD paper; a larger kernel makes dashed
lines vanish.  As even a 3 x 3 median erases lines of one pixel and shortens dashes, it decides only
which pieces of ink are noise: those of which it leaves nothing, unless they are as long as a dash.
"""

from dataclasses import replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.files.paper import STROKE_REACH, enlarged, even_paper, smaller
from gaussiancad_core.sheet.image.dash_gaps import dash_gap
from gaussiancad_core.sheet.image.deskew import Turn, find_turn
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet, Ink
from gaussiancad_core.sheet.image.pale_strokes import mean_stroke_width, with_pale
from gaussiancad_core.sheet.reading_options import MEDIAN_KERNEL
from gaussiancad_core.sheet.tracing.grown_shapes import grown_lines
from gaussiancad_core.sheet.tracing.ridges import ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import GrowthRules, grow_straight
from gaussiancad_protocol.codes import Code

_SHORTEST_DASH = 7.0
"""Length in px from which a piece of ink is a dash; specks of noise are seldom as long."""

_BLOCK = 41
"""Side of the adaptive threshold's neighbourhood in px, wider than any stroke."""

_CONTRAST = 25
"""Grey levels by which ink is darker than the paper around it."""

_MAX_INK = 0.35
"""Largest share of a line drawing that can be ink; a photograph has more."""


_MOST_PIECES = 1500
"""Pieces of ink from which a sheet is asked for its lines: a full page of text has as many."""

_LINE_PX = 24
"""px from which a straight piece of ink is a line and no part of a texture."""

_LEAST_LINES = 0.1
"""Share of the strokes' length that lines have at least."""

_NOISE = 4.0
"""Standard deviations of the paper's own darkness under which there is no ink.

More would be cut off one side of a smooth stroke than off the other, and shift its centre.
"""

_EVEN_PAPER = 2.0
"""Grey levels of the paper's own darkness up to which a sheet was plotted and not scanned."""


def clean_sheet(grey: npt.NDArray[np.uint8], median_kernel: int = MEDIAN_KERNEL) -> CleanSheet:
    """Separate ink from paper.

    Args:
        grey: (h, w) uint8, dark ink on light paper.
        median_kernel: side of the median filter in px; 0 for none.

    Raises:
        NoModelError: ``blank-sheet`` if there is no ink, ``not-a-line-drawing`` if there is too
            much of it.
    """
    ink = _threshold(grey)
    if median_kernel:
        filtered = _threshold(np.asarray(cv2.medianBlur(grey, median_kernel), dtype=np.uint8))
        ink = _without_specks(ink, filtered)
    share = float(ink.mean())
    if share < 1e-5:
        raise NoModelError(Code.BLANK_SHEET, "the sheet is blank: there are no lines to read")
    if share > _MAX_INK:
        raise NoModelError(
            Code.NOT_A_LINE_DRAWING,
            "{percent} % of the sheet is dark, which no line drawing is: "
            "use an export or a scan of the drawing, not a photograph",
            percent=round(100 * share),
        )
    weight = _weight(grey, ink)
    unturned = Turn(0.0, (grey.shape[1] / 2, grey.shape[0] / 2))
    return CleanSheet(ink, weight, mean_stroke_width(ink, weight), unturned)


def upright_sheet(sheet: CleanSheet, turn: Turn | None = None) -> CleanSheet:
    """The sheet turned so that its lines are level, with the gaps of its dashes.

    Args:
        sheet: as stored.
        turn: how it lies; None where its lines have to tell that.

    Raises:
        NoModelError: ``not-a-line-drawing``, the ink is many pieces and hardly any is a line.
    """
    turn = turn or _seen_turn(sheet)
    if turn.angle:
        ink = turn.upright(sheet.ink.astype(np.float32)) > 0.5
        sheet = replace(sheet, ink=ink, weight=turn.upright(sheet.weight), turn=turn)
    gap = dash_gap(sheet.ink, sheet.stroke_width)
    return replace(sheet, dash_gap=gap) if gap else sheet


def _seen_turn(sheet: CleanSheet) -> Turn:
    """How a sheet lies by the lines that are seen on it.

    Raises:
        NoModelError: ``not-a-line-drawing``.
    """
    ridges = ridge_points(sheet.weight, sheet.stroke_width)
    shapes = grow_straight(ridges, GrowthRules.of_width(sheet.stroke_width))
    along_lines = sum(len(shape.members) for shape in shapes if len(shape.members) >= _LINE_PX)
    pieces, _ = cv2.connectedComponents(sheet.ink.astype(np.uint8), connectivity=8)
    if pieces > _MOST_PIECES and along_lines < _LEAST_LINES * len(ridges.points):
        raise NoModelError(
            Code.NOT_A_LINE_DRAWING,
            "the sheet has {pieces} pieces of ink and hardly a line: use an export or a scan of "
            "the drawing, not a photograph",
            pieces=pieces,
        )
    return find_turn(*grown_lines(shapes), sheet.ink.shape)


def _without_specks(raw: Ink, filtered: Ink) -> Ink:
    """(h, w) the connected pieces of ink of which the filter left something, or that are long."""
    _, labels, stats, _ = cv2.connectedComponentsWithStats(raw.astype(np.uint8), connectivity=8)
    width, height = stats[:, cv2.CC_STAT_WIDTH], stats[:, cv2.CC_STAT_HEIGHT]
    wanted = np.hypot(width, height) >= _SHORTEST_DASH
    wanted[labels[filtered & raw]] = True
    wanted[0] = False
    return wanted[labels]


def _threshold(grey: npt.NDArray[np.uint8]) -> Ink:
    """Adaptive threshold with Gaussian weights."""
    binary = cv2.adaptiveThreshold(
        grey, 255, cv2.ADAPTIVE_THRESH_GAUSSIAN_C, cv2.THRESH_BINARY_INV, _BLOCK, _CONTRAST
    )
    return binary > 0


def _weight(grey: npt.NDArray[np.uint8], ink: Ink) -> npt.NDArray[np.float32]:
    """Darkness of each pixel between the paper's around it (0) and the ink's (1)."""
    height, width = grey.shape
    darkness = enlarged(even_paper(smaller(grey), STROKE_REACH), (width, height)) - grey
    full = float(np.percentile(darkness[ink], 75))
    blank = darkness[cv2.dilate(ink.astype(np.uint8), np.ones((5, 5), np.uint8)) == 0]
    noise = float(np.sqrt(np.mean(np.minimum(blank, 0.25 * full) ** 2))) if len(blank) else 0.0
    darkness[darkness < _NOISE * noise] = 0.0
    weight = np.clip(darkness / max(full, 1.0), 0.0, 1.0)
    # In the midst of much ink the paper is taken for darker than it is; noise is darker, too.
    dark = np.clip(blank, 0.0, 0.25 * full)
    plotted = not len(blank) or float(np.sqrt(np.mean(dark**2))) < _EVEN_PAPER
    return with_pale(weight, ink) if plotted else weight
