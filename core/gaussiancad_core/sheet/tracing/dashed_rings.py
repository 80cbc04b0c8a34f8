"""Dashed circles about one centre that lie so close to each other that their dashes melt.

The end view of a shaft has a circle for every shoulder.  Beside its axis the other views show the
same radii as lines, mirrored at it: these are candidates, and the ink on circles about the centre
tells which of them are drawn, and what other circles are.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.annotations.annotation_marks import values_at
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.tracing.hidden_labels import TOLD, label_odds
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.ring_fits import SAME_PX, InkAbout, Ring, fit_rings
from gaussiancad_core.sheet.tracing.view_shapes import Shape, ViewShapes

Floats = npt.NDArray[np.float64]

_SEEN = 0.3
"""Share of a circle that has ink at least for it to tell the centre."""

_WHOLE = 0.9
"""Share from which it is drawn through."""

_CONCENTRIC_PX = 0.8
"""px between the centres of circles about one centre, at most."""

_FEWEST = 2
"""Circles that tell a centre."""

_STEP = 0.25
"""px between the radii at which the ink is looked at."""

_AXIS_PX, _MIRRORED_PX, _STRAIGHT = 2.0, 0.5, 0.02
"""px from where a view should have the axis to where it has; by which radii on its two sides
differ; sine of the angle to the sheet's axes of lines beside it."""

_BLEEDS, _THEIRS = 0.8, 0.85
"""px beyond half a line's width within which ink is a ring's; share of a circle's from which all of
it is theirs."""

_DENSE = 2.2
"""Distance in line widths up to which dashes of two circles melt."""


def with_rings(views: Mapping[Role, ViewShapes], boxes: Mapping[Role, Box]) -> list[ViewShapes]:
    """The views, with the dashed circles about a centre in the place of what their ink seemed.

    Args:
        views: shapes of all views of a sheet.
        boxes: of their ink, px of the sheet.
    """
    return [_with_rings(role, views, boxes) for role in views]


def _with_rings(
    role: Role, views: Mapping[Role, ViewShapes], boxes: Mapping[Role, Box]
) -> ViewShapes:
    view = views[role]
    shapes, width = list(view.shapes), view.sheet.stroke_width
    for centre in _centres(view):
        stated = _told_radii(role, np.array(centre) + view.offset, views, boxes)
        rings = [ring for ring in _rings(view, centre, stated) if _may_be(ring, view, centre)]
        melting = _melting(rings, view)
        circles = _circles_about(view, centre)
        # Of what was found as it is nothing is known better.
        if not all(_is_seen(ring, circles) for ring in melting):
            drawn = [_shape(centre, ring) for ring in melting]
            shapes = [shape for shape in shapes if not _is_replaced(shape, drawn, width)] + drawn
    return replace(view, shapes=tuple(shapes))


def _centres(view: ViewShapes) -> list[tuple[float, float]]:
    """Where circles are drawn about one centre, px of the view; best known ones first."""
    circles = [s for s in view.shapes if isinstance(s.geometry, Circle) and _coverage(s) > _SEEN]
    circles.sort(key=lambda shape: -shape.support)
    groups: list[list[Shape]] = []
    for shape in circles:
        near = (g for g in groups if _apart(g[0].circle, shape.circle) < _CONCENTRIC_PX)
        group = next(near, None)
        if group is None:
            groups.append([shape])
        else:
            group.append(shape)
    found = []
    for group in groups:
        if len(group) >= _FEWEST:
            centres = [shape.circle.centre for shape in group]
            x, y = np.average(centres, axis=0, weights=[shape.support for shape in group])
            found.append((float(x), float(y)))
    return found


def _coverage(shape: Shape) -> float:
    return sum(run.length for run in shape.runs) / shape.geometry.around


def _apart(one: Circle, other: Circle) -> float:
    return float(np.hypot(*np.subtract(one.centre, other.centre)))


def _told_radii(
    role: Role, centre: Floats, views: Mapping[Role, ViewShapes], boxes: Mapping[Role, Box]
) -> list[float]:
    """Radii about a centre, px of the sheet, that other views show on both sides of its axis."""
    found: list[float] = []
    for axis, share in _shares(role, centre, boxes[role]):
        for other, view in views.items():
            frame = other.frame
            for coordinate, (this_axis, sign) in enumerate((frame.right_axis, frame.up_axis)):
                if other is role or this_axis is not axis:
                    continue
                box = boxes[other]
                # Rows of the sheet count downwards.
                forward = sign > 0 if coordinate == 0 else sign < 0
                low, high = box[coordinate], box[coordinate + 2]
                middle = low + (share if forward else 1.0 - share) * (high - low)
                found += _mirrored(_places(view, coordinate), middle)
    return _distinct(found)


def _shares(role: Role, centre: Floats, box: Box) -> Iterator[tuple[Axis, float]]:
    """The two axes of a view, and where along each a place is, as a share of the part's extent."""
    x0, y0, x1, y1 = box
    frame = role.frame
    shares = (centre[0] - x0) / (x1 - x0), (y1 - centre[1]) / (y1 - y0)
    for (axis, sign), share in zip((frame.right_axis, frame.up_axis), shares, strict=True):
        yield axis, float(share if sign > 0 else 1.0 - share)


def _places(view: ViewShapes, coordinate: int) -> Floats:
    """Columns (or rows) of the sheet of lines that run along them."""
    found = [
        shape.geometry.at((run.start + run.end) / 2.0)[coordinate]
        for shape in view.shapes
        if isinstance(shape.geometry, Line)
        and abs(shape.geometry.direction[coordinate]) < _STRAIGHT
        for run in shape.runs
    ]
    return np.array(found) + view.offset[coordinate]


def _mirrored(places: Floats, middle: float) -> list[float]:
    """Half of the distances between places mirrored at the axis that is near a place."""
    if len(places) < 2:
        return []
    centres = (places[:, None] + places) / 2.0
    radii = (places - places[:, None]) / 2.0
    close = (radii > SAME_PX) & (np.abs(centres - middle) < _AXIS_PX)
    if not close.any():
        return []
    # The axis is where most of them have their middle.
    values = np.sort(centres[close])
    count = [int((np.abs(values - value) < _MIRRORED_PX).sum()) for value in values]
    axis = float(np.median(values[np.abs(values - values[int(np.argmax(count))]) < _MIRRORED_PX]))
    return [float(radius) for radius in radii[close & (np.abs(centres - axis) < _MIRRORED_PX)]]


def _distinct(radii: Sequence[float]) -> list[float]:
    """One of each group of radii that are alike, the first one."""
    kept: list[float] = []
    for radius in radii:
        if all(abs(radius - other) > SAME_PX for other in kept):
            kept.append(radius)
    return kept


def _rings(view: ViewShapes, centre: tuple[float, float], stated: Sequence[float]) -> list[Ring]:
    """The circles about a centre."""
    seen = [
        shape.circle.radius for shape in _circles_about(view, centre) if _coverage(shape) > _WHOLE
    ]
    ink = _ink_about(view, centre, max([*stated, *seen], default=0.0))
    known = _distinct([*seen, *(radius for radius in stated if radius < ink.radii[-1])])
    return fit_rings(ink, known, view.sheet.stroke_width)


def _may_be(ring: Ring, view: ViewShapes, centre: tuple[float, float]) -> bool:
    """Whether a ring is drawn through, or labels leave its ink for a hidden line's."""
    circle = Circle(centre, ring.radius)
    points = circle.points_at(np.arange(0.0, circle.around, 1.0))
    inked = values_at(view.sheet.ink, points)
    odds = label_odds(view.sheet, points[inked])
    return ring.solid or not len(odds) or float(np.median(odds)) > -TOLD


def _circles_about(view: ViewShapes, centre: tuple[float, float]) -> list[Shape]:
    about = Circle(centre, 1.0)
    return [
        shape
        for shape in view.shapes
        if isinstance(shape.geometry, Circle) and _apart(shape.geometry, about) < _CONCENTRIC_PX
    ]


def _ink_about(view: ViewShapes, centre: tuple[float, float], farthest: float) -> InkAbout:
    reach = farthest + 2.0 * view.sheet.stroke_width
    radii = np.arange(_STEP, reach, _STEP)
    angles = np.linspace(0.0, 2.0 * np.pi, max(64, int(2.0 * np.pi * reach)), endpoint=False)
    xs = centre[0] + radii[:, None] * np.cos(angles)
    ys = centre[1] + radii[:, None] * np.sin(angles)
    return InkAbout(radii, sample(view.sheet.weight, xs, ys).astype(np.float64))


def _melting(rings: Sequence[Ring], view: ViewShapes) -> list[Ring]:
    """The dashed circles that are too near to others for their dashes to be told apart, and those
    drawn through that are as near to them."""
    reach = _DENSE * view.sheet.stroke_width
    return [
        ring
        for ring in rings
        if any(
            other is not ring
            and not (ring.solid and other.solid)
            and abs(other.radius - ring.radius) < reach
            for other in rings
        )
    ]


def _is_seen(ring: Ring, circles: Sequence[Shape]) -> bool:
    """Whether a ring is one of the circles that were found, all around."""
    least = _WHOLE if ring.solid else _SEEN
    return any(
        abs(shape.circle.radius - ring.radius) < SAME_PX and _coverage(shape) > least
        for shape in circles
    )


def _is_replaced(shape: Shape, rings: Sequence[Shape], stroke_width: float) -> bool:
    """Whether a circle is what the ink of rings was taken for: one nearly alike, or one across
    their dashes."""
    circle = shape.geometry
    if not isinstance(circle, Circle):
        return False
    if _coverage(shape) > _SEEN and any(
        _apart(circle, ring.circle) + abs(circle.radius - ring.circle.radius) < 2.0 * _CONCENTRIC_PX
        for ring in rings
    ):
        return True
    along = [np.arange(run.start, run.end + 0.5) for run in shape.runs]
    points = circle.points_at(np.concatenate([*along, np.empty(0)]))
    if not len(points):
        return True
    away = np.min([ring.geometry.distances(points) for ring in rings], axis=0)
    return bool((away < stroke_width / 2.0 + _BLEEDS).mean() > _THEIRS)


def _shape(centre: tuple[float, float], ring: Ring) -> Shape:
    """A ring as a shape whose linetype is known all around."""
    circle = Circle(centre, ring.radius)
    linetype = Linetype.VISIBLE if ring.solid else Linetype.HIDDEN
    return Shape(circle, (), circle.around, close=True, given_linetype=linetype)
