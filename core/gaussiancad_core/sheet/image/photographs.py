"""Photographs of sheets, straightened: the paper cut out, seen from straight above, evenly lit.

How the camera saw the sheet follows from the drawing's own lines
(:mod:`.perspective`).  What they leave open, how wide the sheet is for its
height, is told by the circles, or by the paper's corners where its proportion is a usual one.
"""

from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.content import MAX_PIXELS, Note
from gaussiancad_core.files.paper import PICTURE_REACH, enlarged, smaller
from gaussiancad_core.messages import Message
from gaussiancad_core.sheet.image.paper_outline import PaperOutline, paper_outline
from gaussiancad_core.sheet.image.perspective import (
    Segments,
    Sight,
    explained,
    find_sight,
    find_turned,
    segments_of,
)
from gaussiancad_core.sheet.image.roundness import proportion
from gaussiancad_core.sheet.votes import MOST
from gaussiancad_protocol.codes import Code

Floats = npt.NDArray[np.float64]
Grey = npt.NDArray[np.uint8]

_CLEARLY = 1.2
"""Factor by which a slant explains more of the lines than a mere turn does, to be believed."""

_LEAST_LINES = 12
"""Straight pieces of line from which a sheet tells how it was seen."""

_LEAST_SLANT = np.radians(1.0)
"""Slant under which a sheet was seen from straight above."""

_LARGER = 4.0
"""Pixels of the straightened sheet at most, in those of the photograph."""

_PROPORTIONS = (2.0**0.5, 11.0 / 8.5, 17.0 / 11.0)
"""Longer by shorter side of usual paper: ISO's, and ANSI's by turns."""

_NEARLY = 0.03
"""Share by which a paper's proportion may be off and is a usual one."""

_INK, _SPECK = 160, 12
"""Grey level on white paper under which there is ink, and px of it that are no speck."""

_MARGIN = 0.02
"""Paper around what is drawn, in the longer side of the sheet."""


@dataclass(frozen=True, eq=False)
class Straightened:
    """A photograph made into a sheet.

    Attributes:
        grey: (h, w) uint8, dark ink on white paper.
        tint: (h, w) uint8 as of :class:`.SheetImage`, or None.
        slant: radians between the way in which the camera looked and straight down onto the sheet;
            0 where only the paper's surroundings were left out, and all places are as they were.
        true_width: whether circles or paper tell how wide the sheet is for its height.
    """

    grey: Grey
    tint: Grey | None
    slant: float
    true_width: bool

    @property
    def note(self) -> Note:
        """What the reader of the sheet should know of that."""
        if not self.slant:
            return Note(Code.SURROUNDINGS_LEFT_OUT, "what surrounds the paper was left out")
        template = (
            "the sheet was photographed at a slant of about {degrees} degrees and was straightened "
            "by its lines: places are given in px of the straightened picture"
        )
        values: dict[str, object] = {"degrees": round(np.degrees(self.slant))}
        if not self.true_width:
            template += ", and how wide it is for its height may be some per cent off"
            values["case"] = "width"
        said = Message(template, boxes=(), **values)
        return Note(Code.PHOTOGRAPHED_AT_A_SLANT, said, is_doubt=True)


def straightened(grey: Grey, tint: Grey | None) -> Straightened | None:
    """A photograph made into a sheet; None for a picture that is one as it is.

    Args:
        grey: (h, w) uint8, dark ink on light paper.
        tint: (h, w) uint8 as of :class:`.SheetImage`, or None.
    """
    outline = paper_outline(grey)
    mask = np.full(grey.shape, 255, np.uint8) if outline is None else outline.mask(grey.shape)
    sight = _slanted(segments_of(_covered(grey, mask)))
    if outline is None and sight is None:
        return None
    even = _evenly_lit(grey, mask)
    if sight is None:
        return Straightened(even, _only_on(mask, tint), 0.0, True)
    size = (grey.shape[1], grey.shape[0])
    to_picture = sight.to_picture(size)
    first = _seen_from_above(even, mask, to_picture, cv2.INTER_LINEAR)
    if first is None:
        return None
    wider = proportion(first) or _paper_wider(outline, to_picture)
    if wider is not None:
        factor = float(np.sqrt(wider))
        to_picture = to_picture @ np.diag([factor, 1.0 / factor, 1.0])
    picture = _seen_from_above(even, mask, to_picture, cv2.INTER_CUBIC)
    if picture is None:
        return None
    tint = _only_on(mask, tint)
    if tint is not None:
        tint = _seen_from_above(tint, mask, to_picture, cv2.INTER_NEAREST, 0)
    return _cut_out(Straightened(picture, tint, sight.tilt, wider is not None))


def _slanted(segments: Segments) -> Sight | None:
    """How a sheet was seen at a slant; None where it was seen from straight above."""
    if len(segments.lengths) < _LEAST_LINES:
        return None
    turned = explained(find_turned(segments), segments)
    sight = find_sight(segments)
    along = explained(sight, segments)
    if along < _CLEARLY * turned or along < MOST * segments.lengths.sum():
        return None
    return sight if sight.tilt >= _LEAST_SLANT else None


def _covered(grey: Grey, mask: Grey) -> Grey:
    """A picture in which there is paper around the paper."""
    if mask.all():
        return grey
    return np.where(mask > 0, grey, np.uint8(np.median(grey[mask > 0])))


def _only_on(mask: Grey, tint: Grey | None) -> Grey | None:
    """The colours of what is on the paper."""
    return None if tint is None else np.asarray(cv2.bitwise_and(tint, tint, mask=mask), np.uint8)


def _cut_out(whole: Straightened) -> Straightened:
    """The sheet as far as there is anything on it, with a margin of paper."""
    ink = (whole.grey < _INK).astype(np.uint8)
    count, _, stats, _ = cv2.connectedComponentsWithStats(ink, connectivity=8)
    boxes = stats[1:, :4][stats[1:, cv2.CC_STAT_AREA] >= _SPECK] if count > 1 else stats[:0, :4]
    if not len(boxes):
        return whole
    margin = round(_MARGIN * max(whole.grey.shape))
    x0, y0 = np.maximum(boxes[:, :2].min(axis=0) - margin, 0)
    x1, y1 = (boxes[:, :2] + boxes[:, 2:]).max(axis=0) + margin
    cut = slice(y0, y1), slice(x0, x1)
    tint = None if whole.tint is None else whole.tint[cut]
    return replace(whole, grey=np.ascontiguousarray(whole.grey[cut]), tint=tint)


def _evenly_lit(grey: Grey, mask: Grey) -> Grey:
    """(h, w) uint8 the sheet on white paper, and white around it."""
    small = smaller(grey)
    kernel = np.ones((PICTURE_REACH, PICTURE_REACH), np.uint8)
    closed = cv2.morphologyEx(cv2.GaussianBlur(small, (0, 0), 1.0), cv2.MORPH_CLOSE, kernel)
    share = smaller(mask).astype(np.float32) / np.float32(255.0)
    sigma = PICTURE_REACH / 2
    lit = np.asarray(cv2.GaussianBlur(closed * share, (0, 0), sigma), dtype=np.float32)
    lit /= np.maximum(cv2.GaussianBlur(share, (0, 0), sigma), np.float32(1e-3))
    light = np.maximum(enlarged(lit, (grey.shape[1], grey.shape[0])), np.float32(1.0))
    even = np.minimum(grey * (np.float32(255.0) / light), np.float32(255.0)).astype(np.uint8)
    even[mask == 0] = 255
    return even


def _seen_from_above(
    picture: Grey, mask: Grey, to_picture: Floats, way: int, blank: int = 255
) -> Grey | None:
    """What is on the paper of a picture, from straight above; None where the sheet would be much
    larger than the picture.

    Args:
        picture: (h, w) uint8.
        mask: (h, w) uint8, 255 on paper.
        to_picture: (3, 3) from px of the sheet to px of the picture.
        way: OpenCV's interpolation.
        blank: what is around the paper.
    """
    outlines, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_SIMPLE)
    if not outlines:
        return None
    around = np.concatenate(outlines).reshape(-1, 2).astype(np.float64)
    above = np.column_stack([around, np.ones(len(around))]) @ np.linalg.inv(to_picture).T
    if (above[:, 2] <= 0).any():
        return None
    places = above[:, :2] / above[:, 2:]
    low, high = np.floor(places.min(axis=0)), np.ceil(places.max(axis=0))
    width, height = (int(item) + 1 for item in high - low)
    if width * height > min(_LARGER * picture.size, MAX_PIXELS):
        return None
    moved = to_picture @ np.array([[1.0, 0.0, low[0]], [0.0, 1.0, low[1]], [0.0, 0.0, 1.0]])
    flags = way | cv2.WARP_INVERSE_MAP
    shown = cv2.warpPerspective(picture, moved, (width, height), flags=flags, borderValue=blank)
    return np.asarray(shown, dtype=np.uint8)


def _paper_wider(outline: PaperOutline | None, to_picture: Floats) -> float | None:
    """How much wider the paper is than paper of its proportion; None where that is no usual one."""
    if outline is None or outline.corners is None:
        return None
    corners = np.column_stack([outline.corners, np.ones(4)]) @ np.linalg.inv(to_picture).T
    places = corners[:, :2] / corners[:, 2:]
    sides = places - np.roll(places, 1, axis=0)
    level = np.abs(sides[:, 0]) > np.abs(sides[:, 1])
    if level.sum() != 2:
        return None
    lengths = np.hypot(*sides.T)
    seen = lengths[level].mean() / lengths[~level].mean()
    usual = [item for one in _PROPORTIONS for item in (one, 1.0 / one)]
    nearest = min(usual, key=lambda item: abs(np.log(seen / item)))
    return float(seen / nearest) if abs(np.log(seen / nearest)) < _NEARLY else None
