"""Tangent edges of views: lines where faces meet smoothly, though nothing is bent there.

Such a line runs in its view from one place to another where an arc goes over into a line or an arc
without a corner.  Or it stands where another view that shows the same axis has such a place, as a
whole circle does on all its sides; an edge stands where that view has a corner.  A curve that goes
on smoothly from one such line to the next is one, too.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.geometry.near_points import near_lists
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.tangent_policies import TangentPolicy
from gaussiancad_core.model.views import Arc, Ellipse, Segment, Stroke
from gaussiancad_core.sheet.sheet_stages import ReadView
from gaussiancad_core.sheet.special_views.smooth_junctions import (
    ends_and_ways,
    goes_on,
    junctions_along,
    meeting_px,
    places_along,
)
from gaussiancad_core.sheet.special_views.tangent_policy import (
    SheetTangents,
    SmoothPlaces,
    axes_of,
    place_across,
    policy_of_views,
)


@dataclass(frozen=True, eq=False)
class TangentEdges:
    """Views, and the tangent edges that were among their strokes.

    Attributes:
        views: without them; each with those of it.
        sheet: what the sheet does with tangent edges.
    """

    views: tuple[ReadView, ...]
    sheet: SheetTangents


def _is_wide(_view: ReadView, _stroke: Stroke) -> bool:
    return False


def without_tangent_edges(
    drawn: Sequence[ReadView],
    other_pens: Mapping[Role, Sequence[Stroke]] | None = None,
    is_thin: Callable[[ReadView, Stroke], bool] = _is_wide,
    given: TangentPolicy | None = None,
) -> TangentEdges:
    """Views without their tangent edges, px of the upright sheet.

    Args:
        drawn: the views.
        other_pens: what views show besides their strokes, in pens that draw no edges.
        is_thin: whether a stroke of a view is in a clearly thinner pen than its edges.
        given: what a person says that the sheet does with tangent edges; None to infer it.
    """
    near = max(meeting_px(view) for view in drawn)
    pens = [tuple((other_pens or {}).get(view.role, ())) for view in drawn]
    every = [
        replace(view, strokes=(*view.strokes, *strokes))
        for view, strokes in zip(drawn, pens, strict=True)
    ]
    between = [_between_smooth(view, near) for view in every]
    plain = [_less(view, lines) for view, lines in zip(drawn, between, strict=True)]
    places = SmoothPlaces(
        {
            (view.role, axis): junctions_along(view, axis, near)
            for view in plain
            for axis in axes_of(view)
        },
        near,
    )
    wide, thin = [], []
    for view, strokes in zip(plain, pens, strict=True):
        found = [stroke for stroke in view.strokes if _is_tangent(stroke, view, places)]
        thin.append([stroke for stroke in found if is_thin(view, stroke)])
        thin[-1] += [stroke for stroke in strokes if _is_tangent(stroke, view, places)]
        wide.append(found)
    sheet = policy_of_views(plain, wide, thin, places)
    if given is not None:
        sheet = replace(sheet, policy=given, source="given")
    views = []
    for number, (view, whole) in enumerate(zip(plain, every, strict=True)):
        lines = _once([*between[number], *wide[number], *thin[number]])
        if not sheet.policy.draws:
            of_view = set(map(id, view.strokes))
            lines = [line for line in lines if id(line) not in of_view]
        lines += _going_on(whole, lines, near)
        views.append(replace(_less(view, lines), tangents=(*view.tangents, *lines)))
    return TangentEdges(tuple(views), sheet)


def _once(strokes: Iterable[Stroke]) -> list[Stroke]:
    return list({id(stroke): stroke for stroke in strokes}.values())


def _less(view: ReadView, gone: Sequence[Stroke]) -> ReadView:
    dropped = set(map(id, gone))
    return replace(
        view, strokes=tuple(stroke for stroke in view.strokes if id(stroke) not in dropped)
    )


def _between_smooth(view: ReadView, near: float) -> list[Segment]:
    """Lines from one place to another where, without them, an arc goes over into what follows."""
    ends, ways = ends_and_ways(view.strokes)
    if not len(ends):
        return []
    groups = near_lists(ends, ends, near)

    def is_passed(end: int) -> bool:
        others = [item for item in groups[end] if item // 2 != end // 2]
        return (
            len(others) == 2
            and not any(goes_on(ways[end], ways[other]) for other in others)
            and goes_on(ways[others[0]], ways[others[1]])
            and any(_is_round(view.strokes, other) for other in others)
        )

    return [
        stroke
        for number, stroke in enumerate(view.strokes)
        if isinstance(stroke, Segment) and is_passed(2 * number) and is_passed(2 * number + 1)
    ]


def _is_tangent(stroke: Stroke, view: ReadView, places: SmoothPlaces) -> bool:
    if isinstance(stroke, Arc) and stroke.is_full:
        return _is_tangent_circle(stroke, view, places)
    return any(
        places.is_smooth(view, axis, at)
        for axis in axes_of(view)
        if (at := place_across(stroke, view, axis)) is not None
    )


def _is_tangent_circle(circle: Arc, view: ReadView, places: SmoothPlaces) -> bool:
    """Whether another view has smooth places where a circle is outermost, on both sides."""
    return any(
        all(places.is_smooth(view, axis, at) for at in _outermost(circle, view, axis))
        for axis in axes_of(view)
    )


def _outermost(circle: Arc, view: ReadView, axis: Axis) -> list[float]:
    """px along an axis of both sides of a circle."""
    sides = np.array(circle.centre) + circle.radius * np.array([[-1.0, -1.0], [1.0, 1.0]])
    return [float(at) for at in places_along(view, axis, sides)]


def _going_on(view: ReadView, lines: Sequence[Stroke], near: float) -> list[Stroke]:
    """Arcs that go on smoothly, at both ends, from tangent edges or from each other."""
    dropped = set(map(id, lines))
    ends, ways = ends_and_ways(view.strokes)
    groups = near_lists(ends, ends, near) if len(ends) else []
    found: list[Stroke] = []
    while True:
        more = [
            stroke
            for number, stroke in enumerate(view.strokes)
            if id(stroke) not in dropped
            and isinstance(stroke, Arc | Ellipse)
            and all(
                any(
                    id(view.strokes[other // 2]) in dropped and goes_on(ways[end], ways[other])
                    for other in groups[end]
                )
                for end in (2 * number, 2 * number + 1)
            )
        ]
        if not more:
            return found
        found += more
        dropped |= set(map(id, more))


def _is_round(strokes: Sequence[Stroke], end: int) -> bool:
    return isinstance(strokes[end // 2], Arc | Ellipse)
