"""Masks of the views: where the part covers the plane of a view.

The contours (Suzuki and Abe 1985) of the solid ink are filled, and brought from the strokes' outer
edge to their centre line.  The paper stops there; this module can also open the through holes, for
which the hidden lines of the other views are the evidence.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.image.inked_sheet import CleanSheet

Mask = npt.NDArray[np.bool_]

_GAPS_PX = (1, 3, 6)
"""Half of the gaps in an outline that are closed, in turn: a pixel or two are missing at a corner,
and more where a copy faded."""

_BARE_PX, _BARE_SHARE = 10.0, 0.02
"""How far ink may reach beyond the filled outline: strokes drawn too long, and marks left over."""

_LEAST_COVERED = 0.1
"""Share of its box that a view covers at least where it encloses nothing that reaches all sides."""


@dataclass(frozen=True)
class Region:
    """A blank area inside a view's outline.

    Attributes:
        mask: (h, w) bool at the outline's resolution, up to the centre lines around it.
        corner: (x, y) px of the outline's mask where this mask starts.
        parents: indices of the regions that go around it, innermost first.
    """

    mask: Mask
    corner: tuple[int, int]
    parents: tuple[int, ...]

    @property
    def box(self) -> tuple[float, float, float, float]:
        """(x0, y0, x1, y1) extent in px of the outline's mask."""
        x, y, width, height = cv2.boundingRect(self.mask.astype(np.uint8))
        x, y = x + self.corner[0], y + self.corner[1]
        return float(x), float(y), float(x + width), float(y + height)


@dataclass(frozen=True)
class Outline:
    """The filled outline of a view and the blank regions inside.

    Attributes:
        depth: (h, w) float32 mask px inside the centre line of the outermost strokes; negative
            outside.
        regions: blank areas of the view, largest first.
        supersampling: mask px per sheet px.
        offset: (x, y) sheet px of the mask's upper left corner.
    """

    depth: npt.NDArray[np.float32]
    regions: tuple[Region, ...]
    supersampling: int
    offset: tuple[float, float]

    @property
    def mask(self) -> Mask:
        """(h, w) bool, the filled outline."""
        return self.depth > 0

    @property
    def box(self) -> tuple[float, float, float, float]:
        """(x0, y0, x1, y1) extent of the filled outline in sheet px."""
        x, y, width, height = cv2.boundingRect(self.mask.astype(np.uint8))
        scale = 1.0 / self.supersampling
        left, top = self.offset[0] + x * scale, self.offset[1] + y * scale
        return float(left), float(top), float(left + width * scale), float(top + height * scale)

    def without(self, regions: tuple[Region, ...]) -> npt.NDArray[np.float32]:
        """(h, w) float32 depth inside the material when some regions are holes."""
        depth = self.depth.copy()
        for region in regions:
            x, y = region.corner
            height, width = region.mask.shape
            pad = np.pad(region.mask, 1).astype(np.uint8)
            inside = cv2.distanceTransform(pad, cv2.DIST_L2, 5)[1:-1, 1:-1]
            outside = cv2.distanceTransform(1 - pad, cv2.DIST_L2, 5)[1:-1, 1:-1]
            window = depth[y : y + height, x : x + width]
            signed = np.where(region.mask, 0.5 - inside, outside - 0.5)
            # Beyond its crop a region is at least the crop's margin away.
            np.minimum(window, signed, out=window)
        return depth


def find_outline(
    sheet: CleanSheet, box: tuple[float, float, float, float], supersampling: int
) -> Outline | None:
    """Fill the contours of the view inside a box; None if its outline is open.

    Args:
        sheet: the cleaned sheet.
        box: of the view's ink in sheet px.
        supersampling: mask px per sheet px.
    """
    margin = int(np.ceil(sheet.stroke_width)) + 3
    x0, y0 = max(0, int(box[0]) - margin), max(0, int(box[1]) - margin)
    x1, y1 = int(np.ceil(box[2])) + margin, int(np.ceil(box[3])) + margin
    weight = sheet.weight[y0:y1, x0:x1] * _near(sheet.ink[y0:y1, x0:x1])
    factor = supersampling
    fine = cv2.resize(weight, None, fx=factor, fy=factor, interpolation=cv2.INTER_CUBIC)
    ink = (fine > 0.5).astype(np.uint8)
    area = (box[2] - box[0]) * (box[3] - box[1]) * factor**2
    best: Outline | None = None
    for closed, filled in _fillings(ink, factor):
        # By the ink as it is: closing fills what is between two edges close beside each other.
        within = np.asarray(cv2.distanceTransform(filled, cv2.DIST_L2, 5), dtype=np.float32)
        half = _outline_width(ink, within) / 2 if filled.any() else 0.0
        # Distances count from the first pixel outside, half a pixel beyond the edge.
        inside = within - 0.5
        outside = cv2.distanceTransform(1 - filled, cv2.DIST_L2, 5) - 0.5
        depth = np.where(filled > 0, inside, -outside) - half
        covers = float((depth > 0).sum()) >= _LEAST_COVERED * max(area, 1.0)
        if covers or _encloses_all(filled & (closed == 0), (x0, y0), factor, half, box):
            regions = _regions(closed, filled, half)
            found = Outline(depth.astype(np.float32), regions, factor, (float(x0), float(y0)))
            if _is_filled(found, half, box):
                return found
            best = best or found
    return best


def _fillings(
    ink: npt.NDArray[np.uint8], factor: int
) -> Iterator[tuple[npt.NDArray[np.uint8], npt.NDArray[np.uint8]]]:
    """The ink with ever wider gaps closed, and what it encloses then, most cautious first."""
    for gap in _GAPS_PX:
        reach = 2 * gap * factor + 1
        # Padded, or closing would fill what lies near the border.
        padded = np.pad(ink, reach)
        inner = slice(reach, -reach), slice(reach, -reach)
        # A square fills a corner; past two ends a step apart it finds a way, a disc does not.
        for form in (cv2.MORPH_RECT, cv2.MORPH_ELLIPSE):
            kernel = cv2.getStructuringElement(form, (reach, reach))
            whole = cv2.morphologyEx(padded, cv2.MORPH_CLOSE, kernel)
            closed = np.ascontiguousarray(whole[inner], dtype=np.uint8)
            filled = np.zeros_like(ink)
            contours, _ = cv2.findContours(closed, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
            cv2.drawContours(filled, contours, -1, 1, cv2.FILLED)
            yield closed, filled
        # Discs on both sides of two ends before a corner overlap, though none comes through.
        adjacent = cv2.dilate(padded, kernel)
        cv2.floodFill(adjacent, None, (0, 0), 2)
        outside = cv2.dilate((adjacent == 2).astype(np.uint8), kernel)
        yield closed, np.ascontiguousarray(1 - outside[inner])


def _is_filled(outline: Outline, half: float, box: tuple[float, float, float, float]) -> bool:
    """Whether an outline is as large as the ink of its view: a gap may leave a part of it open.

    Lines beside an area that is open enclose nothing: ``half`` is how far they reach inward, mask
    px, and what is deeper counts.
    """
    inner = replace(outline, depth=outline.depth - half)
    if not inner.mask.any():
        return False
    grown = half / outline.supersampling * np.array([-1.0, -1.0, 1.0, 1.0])
    off = np.abs(np.add(inner.box, grown) - box).reshape(2, 2)
    sides = np.subtract(box[2:], box[:2])
    return bool((off <= np.maximum(_BARE_PX, _BARE_SHARE * sides)).all())


def _encloses_all(
    blank: npt.NDArray[np.uint8],
    corner: tuple[int, int],
    factor: int,
    half: float,
    box: tuple[float, float, float, float],
) -> bool:
    """Whether what is blank within lines reaches all sides of a view: a thin profile that is bent
    covers little of its box.

    Args:
        blank: (h, w) 0 or 1.
        corner: sheet px of its upper left corner.
        factor: mask px per sheet px.
        half: of the outline's width, mask px.
        box: of the view, sheet px.
    """
    x, y, width, height = cv2.boundingRect(blank)
    if not width:
        return False
    reach = 2.0 * half
    low = np.array([x - reach, y - reach]) / factor + corner
    high = np.array([x + width + reach, y + height + reach]) / factor + corner
    off = np.maximum(low - box[:2], box[2:] - high)
    sides = np.subtract(box[2:], box[:2])
    return bool((off <= np.maximum(_BARE_PX, _BARE_SHARE * sides)).all())


def _near(ink: Mask) -> npt.NDArray[np.float32]:
    """1 on the ink and the pixel around it, 0 elsewhere: keeps specks that were filtered out."""
    return cv2.dilate(ink.astype(np.uint8), np.ones((3, 3), np.uint8)).astype(np.float32)


def supersampling_for(side: float) -> int:
    """Mask px per sheet px for views of a side in px: a mask px is small against a stroke."""
    return int(np.clip(1600 // max(side, 1.0), 1, 3))


def _outline_width(ink: npt.NDArray[np.uint8], depth: npt.NDArray[np.float32]) -> float:
    """Width in px of the stroke along the outline: the depth at which most of the ink has ended.

    Args:
        ink: (h, w) 0 or 1.
        depth: (h, w) px to the first pixel outside of what is filled, 0 there.
    """
    filled = depth > 0.0
    bins = np.floor(depth[filled] * 2).astype(int)
    total = np.bincount(bins)
    share = np.bincount(bins, weights=ink[filled]) / np.maximum(total, 1)
    blank = np.flatnonzero((share < 0.5) & (total > 0))
    # Bin k is k / 2 px deep; the first pixel of the outline has depth 1.
    return max(float(blank[0]) / 2 - 0.75, 1.0) if len(blank) else 1.0


def _regions(
    ink: npt.NDArray[np.uint8], filled: npt.NDArray[np.uint8], half: float
) -> tuple[Region, ...]:
    blank = ((filled > 0) & (ink == 0)).astype(np.uint8)
    count, labels, stats, _ = cv2.connectedComponentsWithStats(blank, connectivity=4)
    smallest = (4 * half) ** 2
    kept = [i for i in range(1, count) if stats[i, cv2.CC_STAT_AREA] > smallest]
    kept.sort(key=lambda i: -stats[i, cv2.CC_STAT_AREA])
    found = [_region(labels, i, stats[i], half) for i in kept]
    return tuple(
        Region(mask, corner, around)
        for (mask, corner), around in zip(found, _parents_of(found), strict=True)
    )


def _region(
    labels: npt.NDArray[np.int32], label: int, stat: npt.NDArray[np.int32], half: float
) -> tuple[Mask, tuple[int, int]]:
    """A blank component grown to the centre lines around it, and its corner."""
    reach = int(np.ceil(half)) + 2
    x0, y0 = max(0, int(stat[0]) - reach), max(0, int(stat[1]) - reach)
    x1, y1 = int(stat[0] + stat[2]) + reach, int(stat[1] + stat[3]) + reach
    other = (labels[y0:y1, x0:x1] != label).astype(np.uint8)
    return cv2.distanceTransform(other, cv2.DIST_L2, 5) < half + 0.5, (x0, y0)


def _parents_of(found: list[tuple[Mask, tuple[int, int]]]) -> list[tuple[int, ...]]:
    """The regions that go around each of some, innermost first.

    Args:
        found: masks of regions, and their corners.
    """
    areas = [_filled(mask) for mask, _ in found]
    return [_parents(index, found, areas) for index in range(len(found))]


def _parents(
    index: int, found: list[tuple[Mask, tuple[int, int]]], areas: list[Mask]
) -> tuple[int, ...]:
    """Regions that go around a region, innermost first.

    Args:
        index: of the region.
        found: all regions, and their corners.
        areas: the regions with all that they go around.
    """
    mask, (x, y) = found[index]
    around = []
    for other, (area, (ox, oy)) in enumerate(found):
        inside_box = ox <= x and oy <= y and area.shape[1] + ox >= x + mask.shape[1]
        if other == index or not inside_box or area.shape[0] + oy < y + mask.shape[0]:
            continue
        filled = areas[other]
        if filled[y - oy :, x - ox :][: mask.shape[0], : mask.shape[1]][mask].mean() > 0.98:
            around.append((int(filled.sum()), other))
    return tuple(other for _, other in sorted(around))


def _filled(mask: Mask) -> Mask:
    contours, _ = cv2.findContours(mask.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
    area = np.zeros(mask.shape, np.uint8)
    cv2.drawContours(area, contours, -1, 1, cv2.FILLED)
    return area > 0
