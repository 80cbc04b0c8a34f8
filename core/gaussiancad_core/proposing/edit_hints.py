"""Which features are worth a trial: those on whose outlines most of the misfit lies."""

from collections.abc import Sequence

import numpy as np

from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.proposing.lines_by_plane import Floats
from gaussiancad_core.proposing.part_features import Feature, Prism, Turned, single_features
from gaussiancad_core.proposing.plane_loops import Numbers
from gaussiancad_core.proposing.planned_part import PlannedJudge, PlannedPart
from gaussiancad_core.proposing.planned_views import RASTER, sums_of, within_boxes

_MOST_POINTS = 60
"""Points along an edge of an outline."""


class EditHints:
    """Where the outlines of features lie in all views.

    Args:
        pool: features that may be tried.
        judge: before which they are.
    """

    def __init__(self, pool: Sequence[Feature], judge: PlannedJudge) -> None:
        self._judge, self._count = judge, len(pool)
        self.boxes = np.array([feature.box for feature in pool])
        owned = [
            (number, single)
            for number, feature in enumerate(pool)
            for single in single_features(feature)
        ]
        self._owner = np.array([number for number, _ in owned], np.int64)
        singles = [single for _, single in owned]
        self._boxes = np.array([single.box for single in singles])
        self._axis = np.array([single.axis.value for single in singles])
        numbers: dict[object, int] = {}
        self._squares: list[Numbers] = []
        self._outline = np.zeros(len(singles), np.int64)
        for row, single in enumerate(singles):
            key = _outline_key(single)
            if key not in numbers:
                numbers[key] = len(self._squares)
                self._squares.append(self._outline_squares(single))
            self._outline[row] = numbers[key]

    def of(self, part: PlannedPart) -> Floats:
        """(n,) mm of misfit on the outlines of each feature."""
        score = np.zeros(len(self._owner))
        for number, view in enumerate(self._judge.views):
            axis = view.sights.axis
            size = self._judge.sheet.size[list(IN_PLANE[axis])]
            values = part.misfits(number)
            sums = np.array([values[squares].sum() for squares in self._squares])
            facing = self._axis == axis.value
            score[facing] += sums[self._outline[facing]]
            boxes = self._boxes[~facing][:, :, list(IN_PLANE[axis])]
            score[~facing] += _on_sides(values.reshape(RASTER, RASTER), boxes, size)
        return np.bincount(self._owner, score, self._count).astype(np.float64)

    def reach(self, part: PlannedPart) -> Floats:
        """(n,) mm of misfit that each feature can explain at most."""
        total = np.zeros(self._count)
        for number, view in enumerate(self._judge.views):
            columns = list(IN_PLANE[view.sights.axis])
            size = self._judge.sheet.size[columns]
            sums = sums_of(part.misfits(number))
            total += within_boxes(sums, self.boxes[:, :, columns], size, 0.02)
        return total

    def stale(self, part: PlannedPart) -> np.ndarray:
        """(n, views) whether the part changed in a feature's box since this was last asked."""
        found = np.zeros((self._count, len(self._judge.views)), bool)
        for number, view in enumerate(self._judge.views):
            columns = list(IN_PLANE[view.sights.axis])
            size = self._judge.sheet.size[columns]
            sums = sums_of(part.touched[number].astype(np.float64))
            found[:, number] = within_boxes(sums, self.boxes[:, :, columns], size, 1.0) > 0.0
            part.touched[number][:] = False
        return found

    def _outline_squares(self, single: Prism | Turned) -> Numbers:
        """Squares of the raster along a feature's outline in a view along its axis."""
        if isinstance(single, Prism):
            start, end = single.loop.edges[:, None, :2], single.loop.edges[:, None, 2:]
            longest = float(np.hypot(*(end - start)[:, 0].T).max())
            count = 2 + int(longest / self._judge.sheet.longest * 2 * RASTER)
            share = np.linspace(0.0, 1.0, min(count, _MOST_POINTS))[None, :, None]
            points = (start + share * (end - start)).reshape(-1, 2)
        else:
            turn = np.linspace(0.0, 2.0 * np.pi, _MOST_POINTS)
            circle = np.stack([np.cos(turn), np.sin(turn)], axis=1)
            points = np.array(single.centre) + single.radius * circle
        size = self._judge.sheet.size[list(IN_PLANE[single.axis])]
        cells = np.floor(points / size * RASTER).astype(np.int64)
        cells = np.minimum(cells[((cells >= 0) & (cells <= RASTER)).all(axis=1)], RASTER - 1)
        return np.unique(cells[:, 0] * RASTER + cells[:, 1])


def _outline_key(single: Prism | Turned) -> object:
    if isinstance(single, Prism):
        return id(single.loop)
    return single.axis, *np.round((*single.centre, single.radius), 3).tolist()


def _on_sides(values: Floats, boxes: Floats, size: Floats) -> Floats:
    """(n,) misfit on the four sides of boxes (n, 2, 2) mm, a square to either side of each."""
    wide = np.pad(values, 1)
    inner = wide[1:-1, 1:-1]
    near_sides = (
        wide[:-2, 1:-1] + inner + wide[2:, 1:-1],
        wide[1:-1, :-2] + inner + wide[1:-1, 2:],
    )
    cells = np.clip(np.floor(boxes / size * RASTER).astype(np.int64), 0, RASTER - 1)
    total = np.zeros(len(boxes))
    for fixed in (0, 1):
        sums = np.zeros((RASTER + 1, RASTER))
        sums[1:] = (near_sides[fixed] if fixed == 1 else near_sides[fixed].T).cumsum(axis=0)
        low, high = cells[:, 0, 1 - fixed], cells[:, 1, 1 - fixed] + 1
        for end in (0, 1):
            at = cells[:, end, fixed]
            total += sums[high, at] - sums[low, at]
    return total
