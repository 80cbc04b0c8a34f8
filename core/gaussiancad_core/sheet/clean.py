"""From a grey sheet to ink: even light, median filter, adaptive threshold, stroke width, upright.

The filter and its 3 x 3 kernel are those of the GaussianCAD paper; a larger kernel makes dashed
lines vanish.  As even a 3 x 3 median erases lines of one pixel and shortens dashes, it decides only
which pieces of ink are noise: those of which it leaves nothing, unless they are as long as a dash.
"""

from dataclasses import dataclass, replace
from itertools import pairwise

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.sheet.dash_gaps import dash_gap
from gaussiancad_core.sheet.deskew import Turn, find_turn
from gaussiancad_core.sheet.growth import GrowthRules, grow_straight
from gaussiancad_core.sheet.options import MEDIAN_KERNEL
from gaussiancad_core.sheet.ridges import ridge_points

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

_PAPER_SCALE = 4
"""Factor by which the sheet is made smaller to find its paper."""

_PAPER_REACH = 11
"""Side in px of the smaller sheet over which ink is closed: wider than any stroke."""

_NOISE = 4.0
"""Standard deviations of the paper's own darkness under which there is no ink.

More would be cut off one side of a smooth stroke than off the other, and shift its centre.
"""

_EVEN_PAPER = 2.0
"""Grey levels of the paper's own darkness up to which a sheet was plotted and not scanned."""

_PALE = 0.7
"""Share of the ink's darkness up to which all of a stroke is pale; the smooth edges of thin dark
strokes come in all shades, and now and then as one that is darker."""

_DARKER = 0.2
"""Share of what is not fully dark that is darker, at most: the edges of dark strokes."""

_ONE_SHADE = 0.1, 0.8
"""Share of the ink's darkness by which pale strokes differ, and of their length that does not by
more, at most and at least."""

_TWO_SHADES = 0.15
"""Share of the ink's darkness by which two pale pens differ at least: the strokes of one differ a
little with their places."""

_HALF = 0.55
"""Weight of the darker of two pale pens at least, above half of the ink's darkness."""

_THIN = 0.47
"""Share of the ink's darkness that a dark stroke of one px has at least, wherever it lies."""

_MANY_PALE_PX, _SPREAD = 300, 0.04
"""px of thin pale strokes, and the standard deviation of their shades, from which some of them lie
on a row of pixels."""

_STRONG, _WIDE_PX = 0.75, 1.6
"""Weight that a pale stroke is given, and px of width from which its ink bears it."""

_EQUAL = 0.01
"""Share of the ink's darkness by which the pixels along a stroke differ."""

_LEAST_PALE_PX = 30
"""px of pale strokes on a sheet at least."""

Ink = npt.NDArray[np.bool_]
"""(h, w), True where there is ink."""


@dataclass(frozen=True)
class CleanSheet:
    """The ink of a sheet.

    Attributes:
        ink: (h, w) bool, the thresholded strokes.
        weight: (h, w) float32 in 0..1, darkness relative to the ink's; for sub-pixel measuring.
        stroke_width: px, the mean over the sheet.
        turn: by which the sheet was turned back to be upright.
        dash_gap: px between dashes, of an upright sheet; 0 where they do not tell.
    """

    ink: Ink
    weight: npt.NDArray[np.float32]
    stroke_width: float
    turn: Turn
    dash_gap: float = 0.0

    @property
    def picture(self) -> npt.NDArray[np.uint8]:
        """(h, w) uint8, the ink dark on white paper, upright."""
        return np.rint(255.0 * (1.0 - self.weight)).astype(np.uint8)


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
        filtered = _threshold(cv2.medianBlur(grey, median_kernel))
        ink = _without_specks(ink, filtered)
    share = float(ink.mean())
    if share < 1e-5:
        raise NoModelError("blank-sheet", "the sheet is blank: there are no lines to read")
    if share > _MAX_INK:
        raise NoModelError(
            "not-a-line-drawing",
            f"{share:.0%} of the sheet is dark, which no line drawing is: "
            "use an export or a scan of the drawing, not a photograph",
        )
    weight = _weight(grey, ink)
    unturned = Turn(0.0, (grey.shape[1] / 2, grey.shape[0] / 2))
    return CleanSheet(ink, weight, _stroke_width(ink, weight), unturned)


def upright_sheet(sheet: CleanSheet) -> CleanSheet:
    """The sheet turned so that its lines are level, with the gaps of its dashes.

    Raises:
        NoModelError: ``not-a-line-drawing``, the ink is many pieces and hardly any is a line.
    """
    ridges = ridge_points(sheet.weight, sheet.stroke_width)
    shapes = grow_straight(ridges, GrowthRules.of_width(sheet.stroke_width))
    along_lines = sum(len(shape.members) for shape in shapes if len(shape.members) >= _LINE_PX)
    pieces, _ = cv2.connectedComponents(sheet.ink.astype(np.uint8), connectivity=8)
    if pieces > _MOST_PIECES and along_lines < _LEAST_LINES * len(ridges.points):
        raise NoModelError(
            "not-a-line-drawing",
            f"the sheet has {pieces} pieces of ink and hardly a line: use an export or a scan of "
            "the drawing, not a photograph",
        )
    turn = find_turn(shapes, sheet.ink.shape)
    if turn.angle:
        ink = turn.upright(sheet.ink.astype(np.float32)) > 0.5
        sheet = replace(sheet, ink=ink, weight=turn.upright(sheet.weight), turn=turn)
    gap = dash_gap(sheet.ink, sheet.stroke_width)
    return replace(sheet, dash_gap=gap) if gap else sheet


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
    darkness = _paper(grey) - grey
    full = float(np.percentile(darkness[ink], 75))
    blank = darkness[cv2.dilate(ink.astype(np.uint8), np.ones((5, 5), np.uint8)) == 0]
    noise = float(np.sqrt(np.mean(np.minimum(blank, 0.25 * full) ** 2))) if len(blank) else 0.0
    darkness[darkness < _NOISE * noise] = 0.0
    weight = np.clip(darkness / max(full, 1.0), 0.0, 1.0)
    # In the midst of much ink the paper is taken for darker than it is; noise is darker, too.
    dark = np.clip(blank, 0.0, 0.25 * full)
    plotted = not len(blank) or float(np.sqrt(np.mean(dark**2))) < _EVEN_PAPER
    return _with_pale(weight, ink) if plotted else weight


def _with_pale(weight: npt.NDArray[np.float32], ink: Ink) -> npt.NDArray[np.float32]:
    """The weight with strokes of one pale shade as strong ones: many programs plot hidden lines or
    dimensions in grey or in a light colour.

    They stay a little paler than dark ones, so that their ink is as that of a narrower pen.
    """
    around = cv2.dilate(weight, np.ones((5, 5), np.float32))
    middle = ink & (weight >= cv2.dilate(weight, np.ones((3, 3), np.float32)) - _EQUAL)
    shades = weight[middle & (around < 0.5 * (1.0 + _PALE))]
    if len(shades) < _LEAST_PALE_PX:
        return weight
    pens = _pale_pens(weight, shades)
    if not pens:
        shade = _pale_shade(weight, shades)
        if shade is None:
            return weight
        pens = [shade]
    # Beside dark strokes the shade of a pixel says nothing.
    beside = around <= _PALE
    own = np.array(pens)[np.searchsorted(_between(pens), around)]
    full = np.where(beside, np.minimum(weight / own, 1.0), weight)
    strokes = ink & beside
    strong = _STRONG if _stroke_width(strokes, full * strokes) > _WIDE_PX else 1.0
    return np.where(beside, strong * full, full).astype(np.float32)


def _pale_shade(weight: npt.NDArray[np.float32], shades: npt.NDArray[np.float32]) -> float | None:
    """The weight of the middles (n,) of pale strokes; None if they may be thin dark ones."""
    if float(np.mean(shades > _PALE)) > _DARKER:
        return None
    shades = shades[shades <= _PALE]
    darkest = float(np.percentile(shades, 97.0))
    shade = float(np.median(shades))
    apart, share = _ONE_SHADE
    if float(np.mean(np.abs(shades - shade) <= apart)) >= share:
        plateau = (np.abs(weight - shade) <= apart).astype(np.uint8)
        if shade <= _THIN or cv2.erode(plateau, np.ones((3, 3), np.uint8)).any():
            return shade
    # Thin strokes are as dark as their ink where they lie on a row of pixels: some do.
    many = len(shades) >= _MANY_PALE_PX and float(np.std(shades)) >= _SPREAD
    return darkest if many else None


def _pale_pens(weight: npt.NDArray[np.float32], shades: npt.NDArray[np.float32]) -> list[float]:
    """The weights of two pale pens, that of the paler one first, or of one beside a darker one;
    nothing where the middles (n,) of strokes are of other shades."""
    levels = np.rint(255.0 * shades).astype(np.uint8)
    cut, _ = cv2.threshold(levels, 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    apart, share = _ONE_SHADE
    pens = []
    for group in (shades[levels <= cut], shades[levels > cut]):
        if len(group) < _LEAST_PALE_PX:
            return []
        shade = float(np.median(group))
        if float(np.mean(np.abs(group - shade) <= 0.5 * apart)) < share:
            return []
        pens.append(shade)
    # A thin dark stroke between two rows of pixels has less than half of its ink in one of them.
    darker = (np.abs(weight - pens[1]) <= _TWO_SHADES).astype(np.uint8)
    wide = int(cv2.erode(darker, np.ones((2, 2), np.uint8)).sum()) >= _LEAST_PALE_PX
    if pens[1] - pens[0] < _TWO_SHADES or pens[1] < _HALF or not wide:
        return []
    return [shade for shade in pens if shade <= _PALE]


def _between(pens: list[float]) -> list[float]:
    """The weights half way from each pen to the next."""
    return [0.5 * (one + other) for one, other in pairwise(pens)]


def _paper(grey: npt.NDArray[np.uint8]) -> npt.NDArray[np.float32]:
    """The sheet as it would be without ink: the light of its surroundings."""
    height, width = grey.shape
    small = (max(1, width // _PAPER_SCALE), max(1, height // _PAPER_SCALE))
    coarse = cv2.resize(grey, small, interpolation=cv2.INTER_AREA)
    kernel = np.ones((_PAPER_REACH, _PAPER_REACH), np.uint8)
    # Closing dark strokes would take the brightest noise for paper: smooth before and after.
    closed = cv2.morphologyEx(cv2.GaussianBlur(coarse, (0, 0), 1.0), cv2.MORPH_CLOSE, kernel)
    even = cv2.GaussianBlur(closed.astype(np.float32), (0, 0), _PAPER_REACH / 2)
    return cv2.resize(even, (width, height), interpolation=cv2.INTER_LINEAR)


def _stroke_width(ink: Ink, weight: npt.NDArray[np.float32]) -> float:
    """Mean stroke width in px: twice the ink over the length of its outlines."""
    contours, _ = cv2.findContours(ink.astype(np.uint8), cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
    # Outlines run through the centres of the outermost pixels, so a thin stroke's are too short by
    # little, and its weight spreads over the pixels beside it.
    near = cv2.dilate(ink.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    length = sum(cv2.arcLength(contour, True) for contour in contours)
    return max(1.0, float(2.0 * weight[near].sum() / max(length, 1.0)))
