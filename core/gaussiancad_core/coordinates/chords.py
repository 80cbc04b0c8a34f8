"""Chords: straight strokes that follow one curve, told from the edges of slanted faces.

Readers give a free curve as short straight strokes that go on in each other.  Taken for the traces
of planes they would divide space for nothing.  Where two faces meet in an edge, another view draws
that edge, at a coordinate that the joint of the two strokes has; at the joints of chords no view
draws anything.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.geometry.tolerances import LEVEL
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, plane_points, role_plane
from gaussiancad_core.model.views import Segment

_FEWEST = 3
"""Chords that follow a curve at least."""

_BENDS = np.radians(0.2), np.radians(25.0)
"""Least and largest turn from one chord to the next."""

_DRAWN_JOINTS = 0.34
"""Share of the joints at which other views may draw lines by chance."""


@dataclass(frozen=True)
class Chords:
    """A run of strokes of one view that follow a curve.

    Attributes:
        role: the view.
        first, last: numbers of its first and last stroke.
        points: (n, 2) their joints and both ends, mm of the view's plane.
    """

    role: Role
    first: int
    last: int
    points: np.ndarray


def find_chords(strokes: Mapping[Role, Sequence[DrawnStroke]], tolerance: float) -> list[Chords]:
    """The runs of neighbouring strokes that follow curves.

    Args:
        strokes: of each view, mm; chords of a curve lie one behind the other.
        tolerance: mm by which strokes may miss where they belong.
    """
    levels = {role: _levels(curves, role) for role, curves in strokes.items()}
    found = []
    for role, this_curves in strokes.items():
        seen = [levels[other] for other in strokes if other is not role]
        for run in _runs(role, this_curves):
            if not _is_drawn(run, seen, tolerance):
                found.append(run)
    return found


def _runs(role: Role, strokes: Sequence[DrawnStroke]) -> list[Chords]:
    """Runs of strokes that go on in each other with small bends."""
    found = []
    first = 0
    for last in range(len(strokes)):
        go_on = last + 1 < len(strokes) and _goes_on(strokes[last], strokes[last + 1])
        if go_on:
            continue
        if last - first + 1 >= _FEWEST:
            pieces = [stroke for stroke in strokes[first : last + 1] if isinstance(stroke, Segment)]
            ends = [pieces[0].start, *(stroke.end for stroke in pieces)]
            found.append(Chords(role, first, last, np.array(ends, dtype=np.float64)))
        first = last + 1
    return found


def _goes_on(one: DrawnStroke, other: DrawnStroke) -> bool:
    if not (isinstance(one, Segment) and isinstance(other, Segment)):
        return False
    if one.linetype is not other.linetype:
        return False
    gap = np.hypot(*np.subtract(other.start, one.end))
    if gap > LEVEL * min(one.length, other.length):
        return False
    (a, b), (c, d) = (np.subtract(stroke.end, stroke.start) for stroke in (one, other))
    bend = abs(np.arctan2(a * d - b * c, a * c + b * d))
    return bool(_BENDS[0] < bend < _BENDS[1])


def _is_drawn(run: Chords, seen: Sequence[dict[Axis, np.ndarray]], tolerance: float) -> bool:
    """Whether other views draw lines at the joints: then these are edges."""
    joints = plane_points(run.points[1:-1], run.role, 1.0)
    axes = IN_PLANE[role_plane(run.role).normal]
    drawn = np.zeros(len(joints), dtype=bool)
    for coordinate, index in enumerate(axes):
        for levels in seen:
            values = levels.get(Axis(index))
            if values is not None and len(values):
                away = np.abs(joints[:, [coordinate]] - values[None]).min(axis=1)
                drawn |= away <= tolerance
    return bool(drawn.mean() > _DRAWN_JOINTS)


def _levels(strokes: Sequence[DrawnStroke], role: Role) -> dict[Axis, np.ndarray]:
    """Coordinates of the straight strokes of a view that run across an axis."""
    axes = IN_PLANE[role_plane(role).normal]
    found: dict[Axis, list[float]] = {Axis(index): [] for index in axes}
    for stroke in strokes:
        if not isinstance(stroke, Segment):
            continue
        start, end = plane_points(np.array([stroke.start, stroke.end]), role, 1.0)
        for coordinate, index in enumerate(axes):
            if abs(end[coordinate] - start[coordinate]) <= LEVEL * stroke.length:
                found[Axis(index)].append(float(start[coordinate] + end[coordinate]) / 2.0)
    return {axis: np.array(values) for axis, values in found.items()}
