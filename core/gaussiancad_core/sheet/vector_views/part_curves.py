"""The curves of a vector sheet that belong to the part, on the upright sheet."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.files.vectors import StrokeKind, StrokeRole, VectorStroke
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.curves import Curve
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.sheet.file_noise import DOT
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.line_conventions import THIN
from gaussiancad_core.sheet.picture_noise import COARSE_STEP
from gaussiancad_core.sheet.votes import MOST
from gaussiancad_core.sheet.work_limits import PLACES

Mask = npt.NDArray[np.uint8]

_PARTS = (StrokeKind.GEOMETRY, StrokeKind.BLOCK)

_LINES_OF_PARTS = (StrokeRole.VISIBLE, StrokeRole.HIDDEN, StrokeRole.UNKNOWN)

_WIDEST_GAP = 20.0
"""px between the dashes of a centre line."""


@dataclass(frozen=True, eq=False)
class InkMasks:
    """Where ink is on an upright sheet, a pixel wider than it is.

    Attributes:
        whole: (h, w) 0 or 1, of the sheet.
        part: (h, w) 0 or 1, without the annotations.
    """

    whole: Mask
    part: Mask

    @classmethod
    def of(cls, whole: CleanSheet, part: CleanSheet) -> "InkMasks":
        """Masks of a sheet as it was cleaned, and as annotations were taken off it."""
        kernel = np.ones((3, 3), np.uint8)
        of_whole, of_part = (
            np.asarray(cv2.dilate(sheet.ink.astype(np.uint8), kernel), dtype=np.uint8)
            for sheet in (whole, part)
        )
        return cls(of_whole, of_part)


def share_inked(curve: Curve, mask: Mask) -> float:
    """Share of the places along a curve that lie on a mask; those off the sheet do not."""
    points = curve.vertices(max(COARSE_STEP, curve.length / PLACES))
    columns, rows = np.floor(points).astype(int).T
    height, width = mask.shape
    inside = (columns >= 0) & (columns < width) & (rows >= 0) & (rows < height)
    return float(mask[rows[inside], columns[inside]].sum()) / max(len(points), 1)


def part_curves(
    strokes: Sequence[VectorStroke], turn: Turn, masks: InkMasks
) -> tuple[tuple[VectorStroke, ...], tuple[Curve, ...]]:
    """The strokes that are the part's and the curves that are not, turned as the sheet was.

    What the file calls a dimension, hatching, centre line or fill is none, neither is what the
    annotations took with them.

    Args:
        strokes: of the file, in px of the sheet as stored.
        turn: of the sheet.
        masks: of the upright sheet.
    """
    found, others = [], []
    for stroke in strokes:
        curve = _upright(stroke.curve, turn)
        if curve.length < DOT:
            continue
        named = stroke.kind in _PARTS and stroke.role in _LINES_OF_PARTS
        inked = share_inked(curve, masks.whole) if named else 0.0
        # No annotation is drawn in even dashes: the file is right where the picture was misread.
        is_given = stroke.role is StrokeRole.HIDDEN
        if inked > 0.0 and (is_given or share_inked(curve, masks.part) >= MOST * inked):
            found.append(replace(stroke, curve=curve))
        else:
            others.append(curve)
    loose = _left_of_centre_lines(found, others)
    others += [stroke.curve for stroke, is_loose in zip(found, loose, strict=True) if is_loose]
    kept = (stroke for stroke, is_loose in zip(found, loose, strict=True) if not is_loose)
    return tuple(kept), tuple(others)


def _left_of_centre_lines(
    strokes: Sequence[VectorStroke], others: Sequence[Curve]
) -> npt.NDArray[np.bool_]:
    """(n,) which thin solid lines go on, after a gap, in a line that is an annotation: dashes of
    centre lines that were drawn one by one."""
    found = np.zeros(len(strokes), bool)
    thin = _thin_lines(strokes)
    if not len(thin) or not others:
        return found
    # Where the strokes of a file tell its views, nobody asks this.
    from scipy.spatial import cKDTree

    annotations = cKDTree(np.concatenate([_places(curve) for curve in others]))
    # Dashes of a hidden line go on in each other.
    owner = np.repeat(thin, [len(_places(strokes[index].curve)) for index in thin])
    dashes = cKDTree(np.concatenate([_places(strokes[index].curve) for index in thin]))
    ahead = np.arange(COARSE_STEP, _WIDEST_GAP, COARSE_STEP)[:, None]
    for index in thin:
        start, end = np.array([strokes[index].curve.start, strokes[index].curve.end])
        way = (end - start) / max(float(np.hypot(*(end - start))), 1e-12)
        for tip, outward in ((end, way), (start, -way)):
            points = tip + ahead * outward
            away, nearest = dashes.query(points)
            first = _first((away < COARSE_STEP) & (owner[nearest] != index))
            found[index] |= _first(annotations.query(points)[0] < COARSE_STEP) < first
    return found


def _places(curve: Curve) -> npt.NDArray[np.float64]:
    return curve.vertices(max(COARSE_STEP, curve.length / PLACES))


def _first(flags: npt.NDArray[np.bool_]) -> int:
    """Index of the first that is set; their number if none is."""
    return int(np.argmax(flags)) if flags.any() else len(flags)


def _thin_lines(strokes: Sequence[VectorStroke]) -> npt.NDArray[np.int64]:
    """Numbers of the solid straight strokes that are thinner than edges are."""
    widths = np.array([stroke.width or 0.0 for stroke in strokes])
    solid = np.array([not stroke.dashes for stroke in strokes], dtype=bool) & (widths > 0.0)
    if not solid.any():
        return np.empty(0, int)
    lengths = np.array([stroke.curve.length for stroke in strokes])
    order = np.argsort(widths[solid])
    along = np.cumsum(lengths[solid][order])
    usual = widths[solid][order][np.searchsorted(along, along[-1] / 2.0)]
    straight = np.array([isinstance(stroke.curve, LineSegment) for stroke in strokes], dtype=bool)
    return np.flatnonzero(solid & straight & (widths < THIN * usual))


def _upright(curve: Curve, turn: Turn) -> Curve:
    """A curve turned with its sheet."""
    if not turn.angle:
        return curve
    stored = turn.scale * turn.centre[0], turn.scale * turn.centre[1]
    return curve.mapped(
        Similarity(1.0 / turn.scale, -turn.angle, origin=stored, offset=turn.centre)
    )
