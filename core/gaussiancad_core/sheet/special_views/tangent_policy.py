"""Whether a sheet draws tangent edges, by the places at which it would have to.

An outline that passes smoothly from an arc into a line tells of a tangent edge, which another view
of the same axis shows as a line across that axis: as wide as edges, thin, or not at all.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.tangent_policies import TangentPolicy
from gaussiancad_core.model.views import Segment, Stroke
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.smooth_junctions import (
    Floats,
    Junctions,
    extent_along,
    has_place,
    places_along,
)
from gaussiancad_core.sheet.votes import HALF, MOST

_LEVEL = 0.3
"""px by which the ends of a line along the sheet may differ across."""

Source = Literal["inferred", "given", "default"]


@dataclass(frozen=True)
class SheetTangents:
    """What a sheet does with tangent edges.

    Attributes:
        policy: of the sheet.
        source: ``inferred`` from its views, ``given`` by a person, or ``default``: nothing tells.
        drawn, thin, left_out: places at which a tangent edge has a line as wide as other edges, a
            thin one, or none.
    """

    policy: TangentPolicy = TangentPolicy.UNKNOWN
    source: Source = "default"
    drawn: int = 0
    thin: int = 0
    left_out: int = 0


UNKNOWN_TANGENTS = SheetTangents()
"""Of a sheet on which nothing tells."""


def inferred_policy(drawn: int, thin: int, left_out: int) -> SheetTangents:
    """The policy that most places tell; unknown where none has most of them.

    Args:
        drawn, thin, left_out: places as of :class:`SheetTangents`.
    """
    lines, places = drawn + thin, drawn + thin + left_out
    policy = TangentPolicy.UNKNOWN
    if places and left_out >= MOST * places:
        policy = TangentPolicy.LEFT_OUT
    elif places and lines >= MOST * places:
        policy = TangentPolicy.THIN if thin > HALF * lines else TangentPolicy.DRAWN
    source: Source = "default" if policy is TangentPolicy.UNKNOWN else "inferred"
    return SheetTangents(policy, source, drawn, thin, left_out)


@dataclass(frozen=True, eq=False)
class SmoothPlaces:
    """Where surfaces pass smoothly into each other, by all views.

    Attributes:
        junctions: of each view, along each axis that it shows.
        near: px within which two coordinates are one.
    """

    junctions: Mapping[tuple[Role, Axis], Junctions]
    near: float

    def is_smooth(self, view: ReadView, axis: Axis, at: float) -> bool:
        """Whether another view has a smooth place there, px along the axis, and none a corner."""
        if not self.near < at < extent_along(view, axis) - self.near:
            return False
        tells = [
            junctions.tells(at, self.near)
            for (role, shown), junctions in self.junctions.items()
            if shown is axis and role is not view.role
        ]
        return True in tells and False not in tells

    def wanted(self, view: ReadView, axis: Axis, *, hidden: bool) -> list[float]:
        """px along an axis at which a view has tangent edges, by the outlines of others.

        Args:
            view: of the sheet.
            axis: that it shows.
            hidden: also where something may stand before them.
        """
        look, sign = view.role.frame.look_axis
        outer = [
            junctions.outer if hidden else junctions.seen[0 if sign > 0 else 1]
            for (role, shown), junctions in self.junctions.items()
            if shown is axis
            and role is not view.role
            and (hidden or (role, look) in self.junctions)
        ]
        places = _distinct(np.concatenate([np.empty(0), *outer]), self.near)
        return [at for at in places if self.is_smooth(view, axis, at)]


def axes_of(view: ReadView) -> tuple[Axis, Axis]:
    """The axes of the part that a view shows."""
    frame = view.role.frame
    return frame.right_axis[0], frame.up_axis[0]


def place_across(stroke: Stroke, view: ReadView, axis: Axis) -> float | None:
    """px along an axis at which a line stands that runs square to it; None if it does not."""
    if not isinstance(stroke, Segment):
        return None
    (x0, y0), (x1, y1) = stroke.start, stroke.end
    upright, level = abs(x1 - x0) <= _LEVEL, abs(y1 - y0) <= _LEVEL
    is_right = view.role.frame.right_axis[0] is axis
    if upright == level or upright is not is_right:
        return None
    point = np.array([[(x0 + x1) / 2.0, (y0 + y1) / 2.0]])
    return float(places_along(view, axis, point)[0])


def policy_of_views(
    views: Sequence[ReadView],
    wide: Sequence[Sequence[Stroke]],
    thin: Sequence[Sequence[Stroke]],
    places: SmoothPlaces,
) -> SheetTangents:
    """What views tell; where all places may be hidden, that lines there are drawn at most.

    Args:
        views: without their tangent edges.
        wide: of each view, lines at smooth places, as wide as edges.
        thin: the same, of thin ones.
        places: where surfaces pass smoothly into each other.
    """
    found = inferred_policy(**_counts(views, wide, thin, places, hidden=False))
    if found.drawn + found.thin + found.left_out:
        return found
    found = inferred_policy(**_counts(views, wide, thin, places, hidden=True))
    return found if found.policy.draws else UNKNOWN_TANGENTS


def _counts(
    views: Sequence[ReadView],
    wide: Sequence[Sequence[Stroke]],
    thin: Sequence[Sequence[Stroke]],
    places: SmoothPlaces,
    *,
    hidden: bool,
) -> dict[str, int]:
    counts = {"drawn": 0, "thin": 0, "left_out": 0}
    for view, wide_lines, thin_lines in zip(views, wide, thin, strict=True):
        for axis in axes_of(view):
            seen = {
                "thin": _across(thin_lines, view, axis),
                "drawn": _across(wide_lines, view, axis),
            }
            for at in places.wanted(view, axis, hidden=hidden):
                found = (name for name, lines in seen.items() if has_place(lines, at, places.near))
                counts[next(found, "left_out")] += 1
    return counts


def _across(strokes: Sequence[Stroke], view: ReadView, axis: Axis) -> Floats:
    """(n,) px along an axis at which lines stand across it."""
    found = (place_across(stroke, view, axis) for stroke in strokes)
    return np.array([at for at in found if at is not None])


def _distinct(places: Floats, near: float) -> list[float]:
    """Places that are apart, in order."""
    found: list[float] = []
    for place in np.sort(places).tolist():
        if not found or place - found[-1] > near:
            found.append(place)
    return found
