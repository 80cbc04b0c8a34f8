"""The layout of a sheet: where its views are, and the clusters of ink that may be views."""

from collections.abc import Container, Iterable
from dataclasses import dataclass
from typing import Literal

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.sheet.line_conventions import SMALLEST_VIEW
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.view_kinds import SpecialView
from gaussiancad_core.sheet.votes import LARGELY
from gaussiancad_protocol.codes import Code

_REACH = 6
"""Ink closer than this many px belongs to the same cluster."""

_ENDS_NEAR = 12
"""px from either end of a line that touches nothing within which the view's other lines are."""

_THIN = 12.0
"""px; what is less wide is a line."""

_MIN_SIDE = 12
"""px; clusters smaller than this in both directions are specks."""

ProjectionSource = Literal["given", "inferred", "default"]
"""Where the reading of an arrangement comes from."""


@dataclass(frozen=True)
class Layout:
    """The views of a sheet.

    Attributes:
        boxes: role -> box of the view's ink.
        projection: the reading of the arrangement.
        source: ``given``, ``inferred`` or ``default``, as in the report.
        alternatives: other projections that fit the arrangement as well.
        left_out: boxes of clusters that are no view and have no name.
        special: drawings that are no plain views, by name.
        symbol: what the projection symbol of the sheet says, or None.
        frame: box of what was taken for the frame of a drawing that has no paper to tell it by.
    """

    boxes: dict[Role, Box]
    projection: Projection
    source: ProjectionSource
    alternatives: tuple[Projection, ...]
    left_out: tuple[Box, ...]
    special: tuple[SpecialView, ...] = ()
    symbol: Projection | None = None
    frame: Box | None = None


def view_clusters(
    ink: npt.NDArray[np.bool_], stub_width: float, *, has_paper: bool = True
) -> list[Box]:
    """Boxes of connected groups of ink, largest first, without single lines that stick out."""
    return [_without_stubs(box, ink, stub_width) for box in find_clusters(ink, has_paper=has_paper)]


def may_be_views(clusters: Iterable[Box]) -> list[Box]:
    """Those of some clusters that are as large as a view is at least, both ways."""
    return [box for box in clusters if min(_width(box), _height(box)) >= SMALLEST_VIEW]


def is_unusual(roles: Container[Role]) -> bool:
    """Whether there is a bottom view and none from above, which hardly anybody draws."""
    return Role.BOTTOM in roles and Role.TOP not in roles


def find_clusters(ink: npt.NDArray[np.bool_], *, has_paper: bool = True) -> list[Box]:
    """Boxes of connected groups of ink, largest first; on paper a drawing frame is left out."""
    height, width = ink.shape
    # An even kernel would shift what it closes by a pixel.
    kernel = np.ones((_REACH + 1, _REACH + 1), np.uint8)
    closed = cv2.morphologyEx(ink.astype(np.uint8), cv2.MORPH_CLOSE, kernel)
    count, _, stats, _ = cv2.connectedComponentsWithStats(closed, connectivity=8)
    boxes = [
        (float(x), float(y), float(x + w), float(y + h))
        for x, y, w, h, _ in stats[1:count]
        if max(w, h) >= 3
    ]
    frames = [box for box in boxes if has_paper and _is_frame(box, boxes, width, height)]
    merged = _merge_overlapping([box for box in boxes if box not in frames])
    merged = _merge_overlapping(_with_lone_lines(merged, ink))
    views = [box for box in merged if max(_width(box), _height(box)) >= _MIN_SIDE]
    return sorted(views, key=lambda box: -_width(box) * _height(box))


def _without_stubs(box: Box, ink: npt.NDArray[np.bool_], width: float) -> Box:
    """The box without what a single line bounds: a body has two sides wherever it is cut."""
    x0, y0, x1, y1 = (int(value) for value in box)
    window = ink[y0:y1, x0:x1]
    columns = np.flatnonzero(window.sum(axis=0) > width)
    rows = np.flatnonzero(window.sum(axis=1) > width)
    if not width or not len(columns) or not len(rows):
        return box
    return (
        float(x0 + columns[0]),
        float(y0 + rows[0]),
        float(x0 + columns[-1] + 1),
        float(y0 + rows[-1] + 1),
    )


def _is_frame(box: Box, boxes: list[Box], width: int, height: int) -> bool:
    spans = _width(box) > LARGELY * width and _height(box) > LARGELY * height
    return spans and sum(_contains(box, other) for other in boxes if other != box) >= 2


def _merge_overlapping(boxes: list[Box]) -> list[Box]:
    """Unite boxes until none overlaps another (dashes inside an outline join it)."""
    # In an array: a sheet of specks has ten thousand boxes.
    merged = np.empty((len(boxes), 4))
    count = 0
    for box in sorted(boxes, key=lambda b: -_width(b) * _height(b)):
        current = box
        while True:
            x0, y0, x1, y1 = merged[:count].T
            touching = (current[0] < x1) & (x0 < current[2]) & (current[1] < y1) & (y0 < current[3])
            if not touching.any():
                break
            current = _union([current, *_boxes(merged[:count][touching])])
            left = merged[:count][~touching]
            count = len(left)
            merged[:count] = left
        merged[count] = current
        count += 1
    return _boxes(merged[:count])


def _boxes(table: npt.NDArray[np.float64]) -> list[Box]:
    return [(x0, y0, x1, y1) for x0, y0, x1, y1 in table.tolist()]


def _with_lone_lines(boxes: list[Box], ink: npt.NDArray[np.bool_]) -> list[Box]:
    """The boxes, those of views reaching as far as lines that end short of all others."""
    joined = []
    for box in boxes:
        pair = _adjacent_view(box, boxes, ink)
        joined.append(_union([box, pair]) if pair is not None else box)
    return joined


def _adjacent_view(line: Box, boxes: list[Box], ink: npt.NDArray[np.bool_]) -> Box | None:
    """The view whose other lines are near both ends of a line, and of nothing else of it."""
    x0, y0, x1, y1 = line
    across, length = sorted((_width(line), _height(line)))
    if across > _THIN or length <= 3 * _ENDS_NEAR:
        return None
    middle = (x0 + x1) / 2, (y0 + y1) / 2
    ends = (
        ((middle[0], y0), (middle[0], y1))
        if x1 - x0 < y1 - y0
        else ((x0, middle[1]), (x1, middle[1]))
    )
    reach = across / 2 + _ENDS_NEAR
    for other in boxes:
        if other == line or min(_width(other), _height(other)) <= _THIN:
            continue
        if all(_has_ink(end, reach, other, ink) for end in ends):
            return None if _has_ink(middle, reach, other, ink) else other
    return None


def _has_ink(
    point: tuple[float, float], reach: float, box: Box, ink: npt.NDArray[np.bool_]
) -> bool:
    """Whether there is ink of a box within a square around a point."""
    x0, y0 = (int(max(at - reach, low)) for at, low in zip(point, box[:2], strict=True))
    x1, y1 = (int(min(at + reach, high)) for at, high in zip(point, box[2:], strict=True))
    return x0 < x1 and y0 < y1 and bool(ink[y0:y1, x0:x1].any())


def alignment_tolerance(extent: float) -> float:
    """How far in px the ends of two intervals of this extent may differ: a drawing that was edited
    by a few per cent is still read."""
    return max(4.0, 0.03 * extent)


def no_views(clusters: list[Box]) -> NoModelError:
    """Why some drawings are no views that belong together."""
    places = ", ".join("({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*box) for box in clusters[:4])
    if not clusters:
        return NoModelError(
            Code.NO_VIEWS,
            "no views were found: the sheet has no drawing of a part that can be read",
        )
    if len(clusters) < 2:
        return NoModelError(
            Code.ONE_VIEW,
            "only one view was found, at {places} px: a model needs two orthogonal views or more",
            boxes=clusters,
            places=places,
        )
    return NoModelError(
        Code.VIEWS_NOT_ALIGNED,
        "{count} groups of lines were found ({places} px), but none is aligned with two others as "
        "views are: name the views with --view ROLE=X0,Y0,X1,Y1",
        boxes=clusters,
        count=len(clusters),
        places=places,
    )


def _width(box: Box) -> float:
    return box[2] - box[0]


def _height(box: Box) -> float:
    return box[3] - box[1]


def _contains(outer: Box, inner: Box) -> bool:
    return (
        outer[0] <= inner[0]
        and outer[1] <= inner[1]
        and outer[2] >= inner[2]
        and outer[3] >= inner[3]
    )


def _union(boxes: list[Box]) -> Box:
    x0, y0, x1, y1 = zip(*boxes, strict=True)
    return min(x0), min(y0), max(x1), max(y1)
