"""The curves of a vector sheet that belong to the part, on the upright sheet."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.deskew import Turn
from gaussiancad_core.sheet.files.curves import affine_arc, to_point
from gaussiancad_core.sheet.files.vectors import (
    Chain,
    CircularArc,
    Curve,
    EllipticArc,
    Line,
    StrokeKind,
    StrokeRole,
    VectorStroke,
)

Mask = npt.NDArray[np.uint8]

_PARTS = (StrokeKind.GEOMETRY, StrokeKind.BLOCK)

_LINES_OF_PARTS = (StrokeRole.VISIBLE, StrokeRole.HIDDEN, StrokeRole.UNKNOWN)

_LEFT = 0.6
"""Share of a stroke's ink that is left without the annotations, if it is the part's."""

_THIN = 0.75
"""Width of a thin line over that of most of the part's lines, by length (ISO 128-2: a half)."""

_NEAR = 2.0
"""px between the end of a stroke and another that it ends at."""

_STEP = 1.0
"""px between the places at which a stroke is looked for."""

_MOST_PLACES = 4000
"""Places of one stroke at most."""

_SHORTEST = 0.05
"""px: shorter strokes are dots."""


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
        masks = (cv2.dilate(sheet.ink.astype(np.uint8), kernel) for sheet in (whole, part))
        return cls(*masks)


def share_inked(curve: Curve, mask: Mask) -> float:
    """Share of the places along a curve that lie on a mask; those off the sheet do not."""
    points = curve.sample(max(_STEP, curve.length / _MOST_PLACES))
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
        if curve.length < _SHORTEST:
            continue
        named = stroke.kind in _PARTS and stroke.role in _LINES_OF_PARTS
        inked = share_inked(curve, masks.whole) if named else 0.0
        # No annotation is drawn in even dashes: the file is right where the picture was misread.
        told = stroke.role is StrokeRole.HIDDEN
        if inked > 0.0 and (told or share_inked(curve, masks.part) >= _LEFT * inked):
            found.append(replace(stroke, curve=curve))
        else:
            others.append(curve)
    loose = _thin_and_loose(found)
    others += [stroke.curve for stroke, is_loose in zip(found, loose, strict=True) if is_loose]
    kept = (stroke for stroke, is_loose in zip(found, loose, strict=True) if not is_loose)
    return tuple(kept), tuple(others)


def _thin_and_loose(strokes: Sequence[VectorStroke]) -> npt.NDArray[np.bool_]:
    """(n,) which solid lines are thinner than edges are and end on paper: dashes of centre lines
    that were drawn one by one."""
    widths = np.array([stroke.width or 0.0 for stroke in strokes])
    solid = np.array([not stroke.dashes for stroke in strokes], dtype=bool) & (widths > 0.0)
    found = np.zeros(len(strokes), bool)
    if not solid.any():
        return found
    lengths = np.array([stroke.curve.length for stroke in strokes])
    order = np.argsort(widths[solid])
    along = np.cumsum(lengths[solid][order])
    usual = widths[solid][order][np.searchsorted(along, along[-1] / 2.0)]
    thin = np.flatnonzero(solid & (widths < _THIN * usual))
    if not len(thin):
        return found
    points = [stroke.curve.sample(_STEP) for stroke in strokes]
    owner = np.repeat(np.arange(len(points)), [len(own) for own in points])
    tree = cKDTree(np.concatenate(points))
    for index in thin:
        near = tree.query_ball_point(points[index][[0, -1]], _NEAR)
        found[index] = any((owner[own] == index).all() for own in near)
    return found


def _upright(curve: Curve, turn: Turn) -> Curve:
    """A curve turned with its sheet."""
    if not turn.angle:
        return curve

    def at(*points: tuple[float, float]) -> npt.NDArray[np.float64]:
        return turn.to_upright(np.array(points))

    if isinstance(curve, Line):
        start, end = at(curve.start, curve.end)
        return Line(to_point(start), to_point(end))
    if isinstance(curve, Chain):
        return Chain(tuple(to_point(point) for point in at(*curve.points)))
    centre = at(curve.centre)[0]
    if isinstance(curve, CircularArc):
        start = float(np.mod(curve.start_angle - turn.angle, 2.0 * np.pi))
        return replace(curve, centre=to_point(centre), start_angle=start)
    major = at(np.add(curve.centre, curve.major))[0] - centre
    minor = curve.ratio * np.array([-major[1], major[0]])
    turned = affine_arc(centre, major, minor, curve.start, curve.sweep)
    return turned if isinstance(turned, EllipticArc) else curve
