"""Which drawings of a sheet are its views, and in which roles.

Views stand around the front view, usually in line with it; some are dragged to where there is room
(ISO 5456-2).  Wherever they stand, two views of one axis show the same coordinates on it: as long
an extent, and lines at the same places.  An arrangement is a front view with views around it; the
one counts for which these say most, in log-odds against chance.
"""

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import product
from math import inf, log

import numpy as np
import numpy.typing as npt

from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.sheet.line_conventions import SMALLEST_VIEW
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.views.drawing_neighbours import (
    box_inside,
    gap_to_neighbour,
    nearest,
    stands,
)
from gaussiancad_core.sheet.views.sheet_layout import (
    Layout,
    ProjectionSource,
    may_be_views,
    no_views,
)
from gaussiancad_core.sheet.views.view_levels import Levels, agreement

Ink = npt.NDArray[np.bool_]

_MOST = 16
"""Drawings, the largest ones, that are tried."""

_BESIDE = 2
"""Drawings on one side of a front view, the nearest ones, that are tried."""

_IN_LINE = log(20.0 * 50.0)
"""Log-odds that a drawing that stands in line with another is a view: of twenty views one is out of
line, and of fifty drawings one is in line by chance."""

_SURE = log(100.0)
"""Log-odds from which a drawing out of line is a view."""

_BEYOND = 3.0
"""Log-odds against a drawing beyond another one that may be the view as well."""

_SECTION = 4.0
"""Log-odds against a section in place of a view: most stand beside the view of their direction, or
between it and its neighbour."""

_CUT_FRONT = 15.0
"""Log-odds against a section as the front view of a whole rear view: mostly that is the front view,
and the section stands beside it."""

_UNEXPLAINED = 6.0
"""Log-odds against an arrangement that leaves out all that is drawn; in part if in part."""

_UNSEEN = 6.0
"""Log-odds against views that look along two axes alone: three views mostly look along three."""

_UNUSUAL = {Role.LEFT: 1.0, Role.BOTTOM: 2.0, Role.REAR: 1.0}
"""Log-odds against a view beside the front view on the left, as third angle has it, and against
views from below and behind."""

_BELOW_ALONE = 5.0
"""Log-odds against a view from below where none is from above, which hardly anybody draws."""

_FIRST = 1.5
"""Log-odds against first angle where nobody tells the projection."""

_ROW = ((1, 0), (-1, 0))
"""Slots in one row with the front view."""

_AROUND = (Role.TOP, Role.BOTTOM, Role.RIGHT, Role.LEFT)


@dataclass(frozen=True, eq=False)
class Drawings:
    """What may be views.

    Attributes:
        boxes: of groups of lines, px, the largest first.
        ink: (h, w) of the part.
        sections: boxes of those that are cut open as a whole.
    """

    boxes: Sequence[Box]
    ink: Ink
    sections: Collection[Box] = ()
    _levels: dict[Box, Levels] = field(default_factory=dict, repr=False)

    def levels(self, box: Box) -> Levels:
        """Places of the long lines of a drawing."""
        if box not in self._levels:
            self._levels[box] = Levels.of(box, self.ink)
        return self._levels[box]


@dataclass(frozen=True)
class _Arrangement:
    """Views, the projection that names them, and log-odds."""

    boxes: Mapping[Role, Box]
    projection: Projection
    score: float


def arrange(drawings: Drawings, given: Mapping[Role, Box], projection: Projection | None) -> Layout:
    """Name the views of a sheet.

    Args:
        drawings: of the sheet.
        given: views that the user named, each by a box around it; two or more of them are taken
            as they are, one fixes where the others are looked for.
        projection: as told by the user, or None to take third angle, or first where that calls
            a view the top one and third the bottom one.

    Raises:
        NoModelError: there are fewer than two views that belong together.
        UsageError: a given box holds no drawing.
    """
    boxes = list(drawings.boxes)
    named = {role: box_inside(boxes, box, role) for role, box in given.items()}
    if len(named) >= 2:
        rest = tuple(box for box in boxes if box not in named.values())
        taken = projection or Projection.THIRD
        return Layout(named, taken, _source(projection), (), rest)
    for box in named.values():
        boxes = [box, *(this_box for this_box in boxes if not _overlap(this_box, box))]
    tried = Drawings(boxes, drawings.ink, drawings.sections)
    found = [
        arrangement
        for taken in (Projection if projection is None else (projection,))
        for arrangement in _arrangements(tried, named, taken, is_told=projection is not None)
    ]
    if not found:
        raise no_views([box for box in boxes if _side(box) >= SMALLEST_VIEW])
    best = max(found, key=lambda arrangement: arrangement.score)
    rest = tuple(box for box in boxes if box not in best.boxes.values())
    alternatives = () if projection is not None else (best.projection.other,)
    return Layout(dict(best.boxes), best.projection, _source(projection), alternatives, rest)


def _source(projection: Projection | None) -> ProjectionSource:
    return "default" if projection is None else "given"


def _arrangements(
    drawings: Drawings, named: Mapping[Role, Box], projection: Projection, *, is_told: bool
) -> Iterator[_Arrangement]:
    """The best arrangement around each drawing that may be the front view."""
    large = [box for box in drawings.boxes if _side(box) >= SMALLEST_VIEW][:_MOST]
    total = sum(map(_area, large))
    for front in large:
        if named.get(Role.FRONT, front) != front:
            continue
        in_line = _in_line(front, large, drawings, projection)
        odds = _score(in_line, drawings, projection)
        found, more = _with_loose(in_line, large, drawings, projection)
        if len(found) < 2 or any(found.get(role) != box for role, box in named.items()):
            continue
        if len(in_line) == 1 and set(may_be_views(large)) - set(found.values()):
            # Where nothing is in line, all drawings belong together or none.
            continue
        against = 0.0 if is_told or projection is Projection.THIRD else _FIRST
        left = 1.0 - sum(map(_area, found.values())) / total
        against += _UNEXPLAINED * left
        if len({role.frame.look_axis[0] for role in found}) < len(Axis):
            against += _UNSEEN
        if front in drawings.sections and Role.REAR in found:
            against += _CUT_FRONT
        yield _Arrangement(found, projection, odds + more - against)


def _in_line(
    front: Box, boxes: Sequence[Box], drawings: Drawings, projection: Projection
) -> dict[Role, Box]:
    """The front view with those of the views around it that are in line."""
    neighbours = [[None, *nearest(front, boxes, role, projection)[:_BESIDE]] for role in _AROUND]
    tried = (
        {Role.FRONT: front, **{role: box for role, box in zip(_AROUND, items, strict=True) if box}}
        for items in product(*neighbours)
    )
    return max(tried, key=lambda entry: _score(entry, drawings, projection))


def _score(found: Mapping[Role, Box], drawings: Drawings, projection: Projection) -> float:
    """Log-odds of views in line; minus infinity where they do not belong together."""
    total = 0.0
    known: dict[Role, Box] = {}
    for role, box in found.items():
        if role is not Role.FRONT:
            odds = _log_odds(role, box, known, drawings, is_in_line=True)
            total += odds + _IN_LINE - _against(role, known, projection)
            nearer = nearest(found[Role.FRONT], drawings.boxes, role, projection)
            total -= _BEYOND * (nearer.index(box) if box in nearer else 0)
        known[role] = box
    return total - _sections_against(found, drawings)


def _sections_against(found: Mapping[Role, Box], drawings: Drawings) -> float:
    """Log-odds against sections in place of views: beside the front view none stands where another
    view looks along its axis."""
    cut = [role for role, box in found.items() if box in drawings.sections]
    looks = [role.frame.look_axis[0] for role in found]
    if any(looks.count(role.frame.look_axis[0]) > 1 for role in cut if role is not Role.FRONT):
        return inf
    return _SECTION * len(cut)


def _against(role: Role, known: Mapping[Role, Box], projection: Projection) -> float:
    """Log-odds against a view, for its role alone."""
    if role is Role.BOTTOM and Role.TOP not in known:
        return _BELOW_ALONE
    if role in (Role.LEFT, Role.RIGHT):
        return _UNUSUAL[Role.LEFT] if role.slot(projection)[0] < 0 else 0.0
    return _UNUSUAL.get(role, 0.0)


def _with_loose(
    found: Mapping[Role, Box], boxes: Sequence[Box], drawings: Drawings, projection: Projection
) -> tuple[dict[Role, Box], float]:
    """The views with the rear view and views out of line, the surest first; the odds of these."""
    views = dict(found)
    total = 0.0
    while True:
        tried = [
            (odds, role, box)
            for box in boxes
            if box not in views.values()
            for role in Role
            if role not in views
            for odds in [_loose_odds(role, box, views, drawings, projection)]
            if odds >= _SURE
        ]
        if not tried:
            return views, total
        odds, role, box = max(tried, key=lambda pair: pair[0])
        views[role] = box
        total += odds


def _loose_odds(
    role: Role, box: Box, found: Mapping[Role, Box], drawings: Drawings, projection: Projection
) -> float:
    front = found[Role.FRONT]
    if role is Role.REAR and any(gap_to_neighbour(front, box, slot) is not None for slot in _ROW):
        odds = _log_odds(role, box, found, drawings, is_in_line=True) + _IN_LINE
    elif may_be_views([box]) and stands(role, box, front, projection):
        odds = _log_odds(role, box, found, drawings, is_in_line=False)
    else:
        return -inf
    together = {**found, role: box}
    return (
        odds
        - _against(role, found, projection)
        - (_sections_against(together, drawings) - _sections_against(found, drawings))
    )


def _log_odds(
    role: Role, box: Box, known: Mapping[Role, Box], drawings: Drawings, *, is_in_line: bool
) -> float:
    """How surely a drawing is the view of a role, by what the known views show of its axes: of each
    that says most counts, and none may contradict it."""
    total = 0.0
    for axis, sign, level in _shown(role):
        odds = [
            agreement(
                drawings.levels(box).along(level=level),
                drawings.levels(known_box).along(level=known_level),
                is_turned=sign != known_sign,
                is_in_line=is_in_line,
            )
            for other, known_box in known.items()
            for known_axis, known_sign, known_level in _shown(other)
            if known_axis is axis
        ]
        total += -inf if -inf in odds else max(odds, default=0.0)
    return total


def _shown(role: Role) -> Iterator[tuple[Axis, int, bool]]:
    """The axes that a view shows: which, the sign in which it runs with the px of the sheet, and
    whether it runs across it."""
    axis, sign = role.frame.right_axis
    yield axis, sign, True
    axis, sign = role.frame.up_axis
    yield axis, -sign, False


def _side(box: Box) -> float:
    return max(box[2] - box[0], box[3] - box[1])


def _area(box: Box) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])


def _overlap(one: Box, other: Box) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]
