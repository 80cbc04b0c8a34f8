"""Where each view looks from: one search over front views, roles, quarter turns and projections.

Two views that share an axis of the part are as long as each other along it: that is a must.
Everything else adds log-odds: levels, where the views stand (ISO 5456-2), which side of a view its
neighbours see, their names, and what the sheet says of its projection.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import combinations
from math import inf

import numpy as np

from gaussiancad_core.geometry.points import Box
from gaussiancad_core.model.axes import Axis, Projection, Role
from gaussiancad_core.views.drawing_titles import PICTORIAL
from gaussiancad_core.views.drawn_groups import DrawingKind, DrawnView
from gaussiancad_core.views.facing_corners import odds_for_third
from gaussiancad_core.views.stroke_levels import Levels, agreement, levels_of

_MOST_VIEWS, _BEAM, _KEPT = 7, 300, 3
"""Views, the largest ones, that are tried; arrangements that are followed, and kept of each front
view."""

_IN_PLACE, _OUT_OF_PLACE, _WRONG_SIDE = 4.0, 2.5, 8.0
"""Log-odds for a view in line along an axis that it shares, against one that is in line with none,
and against one that stands where its projection has another role."""

_LEFT_OUT, _LEFT_OUT_ODD = 3.0, 0.9
"""Log-odds against leaving out a plain view, and any other drawing."""

_TURNED, _OVERTURNED = 3.0, 2.1
"""Log-odds against a view that is drawn turned, and besides by half a turn."""

_CUT, _CUT_FRONT, _SLANTED = 4.0, 5.0, 4.0
"""Log-odds against a section as a view, and as the front view; against what looks pictorial."""

_NAMED = 5.0
"""Log-odds for a role that is a view's name, and against any other."""

_SMALL_FRONT = 1.0
"""Log-odds against a front view that is smaller than another one."""

_USUAL_THIRD = 0.3
"""Log-odds for third angle where nobody says which."""

_RARE = {Role.BOTTOM: 0.7, Role.LEFT: 0.3, Role.REAR: 0.7}
"""Log-odds against views that are seldom drawn."""

_ALIGNED, _ALIGNED_END, _BESIDE = 0.6, 0.8, 0.5
"""mm by which the beginnings and the ends of views in line differ; by which boxes may overlap that
are beside each other."""

_ASKED = (DrawingKind.PLAIN, DrawingKind.SECTION, DrawingKind.PICTORIAL)


@dataclass(frozen=True)
class Placed:
    """A view in its role.

    Attributes:
        role: where it looks from.
        turn: quarter turns counterclockwise on the sheet by which it is drawn turned.
    """

    role: Role
    turn: int = 0


@dataclass(frozen=True, eq=False)
class Arrangement:
    """Views in their roles.

    Attributes:
        placed: by number of the view.
        projection: by which they stand around the front view.
        odds: log-odds of all that speaks for it.
    """

    placed: Mapping[int, Placed]
    projection: Projection
    odds: float


@dataclass(frozen=True, eq=False)
class Ranking:
    """Arrangements of a sheet's views.

    Attributes:
        best: of all.
        others: the next ones, the likeliest first.
    """

    best: Arrangement
    others: tuple[Arrangement, ...]

    @property
    def margin(self) -> float:
        """Log-odds of the best arrangement over the next one; infinite where there is none."""
        return self.best.odds - self.others[0].odds if self.others else inf

    @property
    def other_projection(self) -> float:
        """Log-odds of the best arrangement over the same views in the other projection."""
        odds = [one.odds for one in self.others if one.projection is not self.best.projection]
        return self.best.odds - max(odds, default=-inf)


def arranged_views(
    views: Sequence[DrawnView],
    third_angle: float = 0.0,
    fixed: Mapping[int, Role] | None = None,
) -> Ranking | None:
    """The roles of views; nothing where there are none to be named.

    Args:
        views: of a sheet.
        third_angle: log-odds for third angle by what the sheet says of its projection.
        fixed: roles that somebody has given to views, by their numbers: these hold.
    """
    fixed = fixed or {}
    asked = [
        number
        for number, view in enumerate(views)
        if number in fixed or (view.kind in _ASKED and view.name != PICTORIAL)
    ]
    asked.sort(key=lambda number: (number not in fixed, -views[number].area))
    asked = asked[:_MOST_VIEWS]
    if not asked:
        return None
    roles = {asked.index(number): role for number, role in fixed.items() if number in asked}
    search = _Search([views[number] for number in asked], third_angle, roles)
    found = sorted(search.arrangements(), key=lambda item: -item.odds)
    renamed = [
        Arrangement({asked[i]: p for i, p in item.placed.items()}, item.projection, item.odds)
        for item in found
    ]
    if not renamed:
        return None
    best = renamed[0]
    others = [i for i in renamed[1:] if (i.placed, i.projection) != (best.placed, best.projection)]
    return Ranking(best, tuple(others))


def any_in_line(boxes: Sequence[Box]) -> bool:
    """Whether two of some boxes begin at one place, across the sheet or down it."""
    return any(
        min(abs(one[0] - other[0]), abs(one[1] - other[1])) < _ALIGNED
        for one, other in combinations(boxes, 2)
    )


def shown_axes(placed: Placed) -> tuple[tuple[Axis, int], tuple[Axis, int]]:
    """The axes of the part that a view shows across the sheet and down it, and whether they run
    with it (1) or against it (-1)."""
    frame = placed.role.frame
    across = np.array(frame.right, dtype=int)
    down = -np.array(frame.up, dtype=int)
    for _ in range(placed.turn % 4):
        # What ran to the right runs up the sheet now.
        across, down = down, -across
    first, second = (
        (Axis(int(np.flatnonzero(way)[0])), int(way[np.flatnonzero(way)[0]]))
        for way in (across, down)
    )
    return first, second


_PLACES = tuple(Placed(role, turn) for role in Role for turn in range(4))
_SHOWN = {placed: shown_axes(placed) for placed in _PLACES}


@dataclass(eq=False)
class _Search:
    """A beam over the views of a sheet, the largest first, around each front view.

    Attributes:
        views: those that are asked.
        third_angle: log-odds by what the sheet says.
        fixed: roles that hold, by number of the view.
    """

    views: Sequence[DrawnView]
    third_angle: float
    fixed: Mapping[int, Role]
    _levels: list[tuple[Levels, Levels]] = field(init=False)
    _agreed: dict[tuple[int, int, int, int, bool], float] = field(default_factory=dict)
    _facing: dict[tuple[int, int, int], float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._levels = [levels_of(view) for view in self.views]

    def arrangements(self) -> list[Arrangement]:
        """The best ones around each front view, for each projection."""
        found = []
        for front in range(len(self.views)):
            if self.fixed.get(front, Role.FRONT) is not Role.FRONT:
                continue
            for projection in Projection:
                found += self._around(front, projection)
        return found

    def _around(self, front: int, projection: Projection) -> list[Arrangement]:
        is_third = projection is Projection.THIRD
        odds = self.third_angle / 2.0 * (1.0 if is_third else -1.0)
        odds += _USUAL_THIRD if is_third else 0.0
        odds -= self._odd(front, _CUT_FRONT)
        odds -= _SMALL_FRONT if front else 0.0
        odds += self._by_name(front, Role.FRONT)
        beam: list[tuple[float, dict[int, Placed]]] = [(odds, {front: Placed(Role.FRONT)})]
        for number, view in enumerate(self.views):
            if number == front:
                continue
            left_out = _LEFT_OUT if view.kind is DrawingKind.PLAIN else _LEFT_OUT_ODD
            grown = []
            for score, placed in beam:
                if number not in self.fixed:
                    grown.append((score - left_out, placed))
                taken = {item.role for item in placed.values()}
                for place in _PLACES:
                    if place.role not in taken and self._may_be(number, place):
                        more = self._odds(number, place, placed, front, projection)
                        if more > -inf:
                            grown.append((score + more, {**placed, number: place}))
            grown.sort(key=lambda item: -item[0])
            beam = grown[:_BEAM]
        return [
            Arrangement(placed, projection, score)
            for score, placed in beam[:_KEPT]
            if all(number in placed for number in self.fixed)
        ]

    def _may_be(self, number: int, place: Placed) -> bool:
        """Whether a place is what somebody gave to a view, or nobody gave it one."""
        role = self.fixed.get(number)
        return role is None or place == Placed(role)

    def _odd(self, number: int, cut: float) -> float:
        """Log-odds against a drawing as a view, by its kind."""
        kind = self.views[number].kind
        return {DrawingKind.SECTION: cut, DrawingKind.PICTORIAL: _SLANTED}.get(kind, 0.0)

    def _by_name(self, number: int, role: Role) -> float:
        name = self.views[number].name
        return 0.0 if not name else _NAMED if name == role.value else -_NAMED

    def _odds(
        self,
        number: int,
        place: Placed,
        placed: Mapping[int, Placed],
        front: int,
        projection: Projection,
    ) -> float:
        """Log-odds of a view beside those that are placed; minus infinity where extents are
        apart, where it shares no axis, and of sections beside a view."""
        if self._is_beside(number, place, placed):
            return -inf
        total = 0.0
        shares, in_line = False, False
        for along, (axis, sign) in enumerate(_SHOWN[place]):
            best = -inf
            for other, other_place in placed.items():
                for other_along, (other_axis, other_sign) in enumerate(_SHOWN[other_place]):
                    if other_axis is not axis:
                        continue
                    odds = self._agree(number, along, other, other_along, sign != other_sign)
                    if odds == -inf:
                        return -inf
                    if along == other_along and self._begins_with(number, other, along):
                        odds += _IN_PLACE
                        in_line = True
                    best = max(best, odds)
            if best > -inf:
                shares = True
                total += best
        if not shares:
            return -inf
        total -= _TURNED if place.turn else 0.0
        total -= _OVERTURNED if place.turn == 2 else 0.0
        total -= _RARE.get(place.role, 0.0) + self._odd(number, _CUT)
        total -= 0.0 if in_line else _OUT_OF_PLACE
        return (
            total
            + self._by_name(number, place.role)
            + self._by_side(number, place, front, projection)
        )

    def _is_beside(self, number: int, place: Placed, placed: Mapping[int, Placed]) -> bool:
        """Whether a section stands for no view, as another looks along its axis."""
        looks = place.role.frame.look_axis[0]
        return any(
            other_place.role.frame.look_axis[0] is looks
            and DrawingKind.SECTION in (self.views[number].kind, self.views[other].kind)
            for other, other_place in placed.items()
        )

    def _agree(self, one: int, along: int, other: int, other_along: int, turned: bool) -> float:
        key = one, along, other, other_along, turned
        if key not in self._agreed:
            levels = self._levels[one][along], self._levels[other][other_along]
            in_line = along == other_along and self._begins_with(one, other, along)
            self._agreed[key] = agreement(*levels, is_turned=turned, is_in_line=in_line)
        return self._agreed[key]

    def _begins_with(self, one: int, other: int, along: int) -> bool:
        return abs(self.views[one].box[along] - self.views[other].box[along]) < _ALIGNED

    def _by_side(self, number: int, place: Placed, front: int, projection: Projection) -> float:
        """Log-odds by the side of the front view on which a view stands, and what it sees there."""
        view, front_view = self.views[number], self.views[front]
        column, row = place.role.slot(projection)
        third_column, third_row = place.role.slot(Projection.THIRD)
        total = 0.0
        for along, slot, third in ((0, -row, -third_row), (1, column, third_column)):
            away = 1 - along
            after = view.box[away] >= front_view.box[away + 2] - _BESIDE
            before = view.box[away + 2] <= front_view.box[away] + _BESIDE
            if not (after or before):
                continue
            is_after = view.box[away] > front_view.box[away]
            is_aligned = self._begins_with(number, front, along) and (
                abs(view.box[along + 2] - front_view.box[along + 2]) < _ALIGNED_END
            )
            is_wrong = not slot or (slot > 0) != is_after
            if is_aligned:
                if is_wrong and (place.role is not Role.REAR or along == 0):
                    total -= _WRONG_SIDE
            elif slot and is_wrong and not place.turn:
                total -= _OUT_OF_PLACE
            is_asked = slot and not place.turn and place.role is not Role.REAR
            if is_asked and front_view.kind is not DrawingKind.SECTION:
                votes = self._facing_odds(front, number, along)
                total += votes if (third > 0) == is_after else -votes
        return total

    def _facing_odds(self, front: int, number: int, along: int) -> float:
        key = front, number, along
        if key not in self._facing:
            view, other = self.views[front], self.views[number]
            is_before = other.box[1 - along] > view.box[1 - along]
            self._facing[key] = odds_for_third(view, other, along, is_before=is_before)
        return self._facing[key]
