"""Find the views on a sheet and say which is which.

A view is a cluster of ink.  Views that show the same axis side by side have the same interval on
the sheet: the view that shares its columns with one neighbour and its rows with another is the
front view, and the others' roles follow from where they stand and from the projection (ISO
5456-2).
"""

from collections.abc import Container, Iterable
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.errors import NoModelError, UsageError
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.special_views.kinds import SpecialView

_REACH = 6
"""Ink closer than this many px belongs to the same cluster."""

_ENDS_NEAR = 12
"""px from either end of a line that touches nothing within which the view's other lines are."""

_THIN = 12.0
"""px; what is less wide is a line."""

_MIN_SIDE = 12
"""px; clusters smaller than this in both directions are specks."""

_MIN_VIEW = 32
"""px; clusters smaller than this in both directions are too small for a view."""

_DEEP = 0.15
"""Share of the part's depth by which the width of a rear view differs from it at least."""

_FRAME_SHARE = 0.8
"""A cluster that spans this share of the sheet both ways, around others, is its frame."""


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
    source: str
    alternatives: tuple[Projection, ...]
    left_out: tuple[Box, ...]
    special: tuple[SpecialView, ...] = ()
    symbol: Projection | None = None
    frame: Box | None = None


def find_layout(
    ink: npt.NDArray[np.bool_],
    given: dict[Role, Box],
    projection: Projection | None,
    stub_width: float = 0.0,
) -> Layout:
    """Name the views of a sheet.

    Args:
        ink: (h, w) bool.
        given: views that the user named, each by a box around it; two or more of them are taken
            as they are, one fixes where the others are looked for.
        projection: as told by the user, or None to take third angle, or first where that calls
            a view the top one and third the bottom one.
        stub_width: px; where single lines of at most this width stick out of a view, they are
            remains of dimensions and do not count.

    Raises:
        NoModelError: there are fewer than two views that belong together.
        UsageError: a given box holds no ink.
    """
    return arrange_clusters(view_clusters(ink, stub_width), given, projection)


def view_clusters(
    ink: npt.NDArray[np.bool_], stub_width: float, *, has_paper: bool = True
) -> list[Box]:
    """Boxes of connected groups of ink, largest first, without single lines that stick out."""
    return [_without_stubs(box, ink, stub_width) for box in find_clusters(ink, has_paper=has_paper)]


def arrange_clusters(
    clusters: list[Box], given: dict[Role, Box], projection: Projection | None
) -> Layout:
    """Name clusters of ink, as :func:`find_layout` does.

    Raises:
        NoModelError: there are fewer than two views that belong together.
        UsageError: a given box holds no cluster.
    """
    source = "default" if projection is None else "given"
    chosen = projection or Projection.THIRD
    if given:
        named = {role: _inside(clusters, box, role) for role, box in given.items()}
        if len(named) >= 2:
            rest = tuple(box for box in clusters if box not in named.values())
            return Layout(named, chosen, "given" if projection else source, (), rest)
        clusters = _with_merged(clusters, next(iter(named.values())))
        boxes = _arrange(clusters, chosen, named)
    else:
        boxes = _arrange(clusters, chosen, {})
        if projection is None and is_unusual(boxes):
            chosen = chosen.other
            boxes = _arrange(clusters, chosen, {})
    rest = tuple(box for box in clusters if box not in boxes.values())
    alternatives = (chosen.other,) if projection is None else ()
    return Layout(boxes, chosen, source, alternatives, rest)


def lone_layout(clusters: list[Box], projection: Projection | None) -> Layout | None:
    """The layout of a sheet of one view, which is called the front view; None where there are more
    clusters as large as views."""
    large = may_be_views(clusters)
    if len(large) != 1:
        return None
    rest = tuple(box for box in clusters if box != large[0])
    source = "default" if projection is None else "given"
    return Layout({Role.FRONT: large[0]}, projection or Projection.THIRD, source, (), rest)


def may_be_views(clusters: Iterable[Box]) -> list[Box]:
    """Those of some clusters that are as large as a view is at least, both ways."""
    return [box for box in clusters if min(_width(box), _height(box)) >= _MIN_VIEW]


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
    spans = _width(box) > _FRAME_SHARE * width and _height(box) > _FRAME_SHARE * height
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
        own = _view_beside(box, boxes, ink)
        joined.append(_union([box, own]) if own is not None else box)
    return joined


def _view_beside(line: Box, boxes: list[Box], ink: npt.NDArray[np.bool_]) -> Box | None:
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


def _arrange(
    clusters: list[Box], projection: Projection, named: dict[Role, Box]
) -> dict[Role, Box]:
    """The arrangement around a front view that explains the most ink area."""
    best: dict[Role, Box] = {}
    best_score = (0, 0, 0.0)
    large = [box for box in clusters if max(_width(box), _height(box)) >= _MIN_VIEW]
    for front in large:
        found = _around(front, large, projection)
        if any(found.get(role) != box for role, box in named.items()):
            continue
        shown_axes = len({role.frame.look_axis[0] for role in found})
        # Two views alone do not tell which is the front: usual are a top view and a view beside it
        # on the right.
        usual = sum(role is Role.TOP or role.slot(projection) == (1, 0) for role in found)
        score = (shown_axes, usual, sum(_width(box) * _height(box) for box in found.values()))
        if score > best_score:
            best, best_score = found, score
    if len(best) < 2:
        raise _no_views(large)
    return best


def _around(front: Box, clusters: list[Box], projection: Projection) -> dict[Role, Box]:
    """Roles of the clusters aligned with ``front``, the nearest on each side."""
    by_slot = {
        role.slot(projection): role for role in (Role.TOP, Role.BOTTOM, Role.LEFT, Role.RIGHT)
    }
    found = {Role.FRONT: front}
    for slot, role in by_slot.items():
        column, row = slot
        neighbours = [
            (gap, box)
            for box in clusters
            if box != front and (gap := _gap(front, box, column, row)) is not None
        ]
        if neighbours:
            found[role] = min(neighbours)[1]
    _rename_rear(found)
    _add_rear(found, clusters)
    return found


def _rename_rear(found: dict[Role, Box]) -> None:
    """Call a view beside the front one the rear view, in place, where it is as wide as that and not
    as wide as the part is deep."""
    depths = [_height(found[role]) for role in (Role.TOP, Role.BOTTOM) if role in found]
    for role, other in ((Role.RIGHT, Role.LEFT), (Role.LEFT, Role.RIGHT)):
        if role not in found or Role.REAR in found:
            continue
        wide = _width(found[role])
        known = [*depths, *([_width(found[other])] if other in found else [])]
        clash = bool(known) and min(abs(wide - depth) / depth for depth in known) > _DEEP
        if clash and _same_interval(0.0, _width(found[Role.FRONT]), 0.0, wide):
            found[Role.REAR] = found.pop(role)


def _add_rear(found: dict[Role, Box], clusters: list[Box]) -> None:
    """Add the rear view in place: as large as the front view, beyond a view beside it."""
    front = found[Role.FRONT]
    if Role.REAR in found:
        return
    for box in [found[role] for role in (Role.RIGHT, Role.LEFT) if role in found]:
        column = 1 if box[0] > front[0] else -1
        beyond = [
            (gap, other)
            for other in clusters
            if (gap := _gap(box, other, column, 0)) is not None
            and _gap(front, other, column, 0) is not None
            and _same_interval(0.0, _width(front), 0.0, _width(other))
        ]
        if beyond:
            found[Role.REAR] = min(beyond)[1]
            return


def _gap(front: Box, box: Box, column: int, row: int) -> float | None:
    """Distance from ``front`` to an aligned ``box`` on the given side, or None."""
    if row:
        aligned = _same_interval(front[0], front[2], box[0], box[2])
        gap = front[1] - box[3] if row > 0 else box[1] - front[3]
    else:
        aligned = _same_interval(front[1], front[3], box[1], box[3])
        gap = box[0] - front[2] if column > 0 else front[0] - box[2]
    return gap if aligned and gap > 0 else None


def alignment_tolerance(extent: float) -> float:
    """How far in px the ends of two intervals of this extent may differ: a drawing that was edited
    by a few per cent is still read."""
    return max(4.0, 0.03 * extent)


def _same_interval(a0: float, a1: float, b0: float, b1: float) -> bool:
    tolerance = alignment_tolerance(max(a1 - a0, b1 - b0))
    return abs(a0 - b0) <= tolerance and abs(a1 - b1) <= tolerance


def _no_views(clusters: list[Box]) -> NoModelError:
    places = ", ".join("({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*box) for box in clusters[:4])
    if not clusters:
        return NoModelError(
            "no-views", "no views were found: the sheet has no drawing of a part that can be read"
        )
    if len(clusters) < 2:
        return NoModelError(
            "one-view",
            "only one view was found, at {places} px: a model needs two orthogonal views or more",
            boxes=clusters,
            places=places,
        )
    return NoModelError(
        "views-not-aligned",
        "{count} groups of lines were found ({places} px), but none is aligned with two others as "
        "views are: name the views with --view ROLE=X0,Y0,X1,Y1",
        boxes=clusters,
        count=len(clusters),
        places=places,
    )


def _inside(clusters: list[Box], box: Box, role: Role) -> Box:
    """Union of the clusters whose centre lies in a given box."""
    x0, y0, x1, y1 = box
    found = [c for c in clusters if x0 <= (c[0] + c[2]) / 2 <= x1 and y0 <= (c[1] + c[3]) / 2 <= y1]
    if not found:
        raise UsageError(
            "empty-view-box",
            "--view {view}: there are no lines in the box {box}",
            view=role,
            box=f"{x0:g},{y0:g},{x1:g},{y1:g}",
        )
    return _union(found)


def _with_merged(clusters: list[Box], union: Box) -> list[Box]:
    return [union, *(box for box in clusters if not _overlap(box, union))]


def _width(box: Box) -> float:
    return box[2] - box[0]


def _height(box: Box) -> float:
    return box[3] - box[1]


def _overlap(a: Box, b: Box) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


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
