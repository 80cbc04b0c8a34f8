"""Turned bodies that a solid may be made of: half planes that turn around an axis."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt

from gaussiancad_core.cells.arrangement import Arrangement
from gaussiancad_core.features.frames import frame_across
from gaussiancad_core.features.inside_rays import Rays
from gaussiancad_core.features.loops import Loop
from gaussiancad_core.features.plane_curves import Stretch, arc, segment, supports_of
from gaussiancad_core.features.round_axes import (
    SAME,
    RoundAxis,
    around,
    axis_through,
    by_axis,
    levels_along,
)
from gaussiancad_core.features.sample_points import Samples
from gaussiancad_core.features.sketch_cells import OFF_CENTRE, Cells, edge_count, length_of
from gaussiancad_core.features.solid_faces import Kind, SolidFace, cone_of, v_range
from gaussiancad_core.features.sweeps import Sweep, SweptPlane, TurnAxis, regions_of
from gaussiancad_core.geometry.outline_edges import OutlineEdge
from gaussiancad_core.geometry.points import Point
from gaussiancad_core.geometry.whole_curves import Circle

Vector = npt.NDArray[np.float64]
Points = npt.NDArray[np.float64]

_AROUND = 6
"""Half planes around an axis that are looked at."""

_MOST_AXES = 4
"""Axes of a part around which bodies are looked for."""

_FAR_OUT = 0.96
"""Share of a cell's width and height at which it is looked at as well: what is no turned body, such
as a block, is material all around near the axis, and not far away from it."""

_MOST_STRETCHES = 200


@dataclass(frozen=True, eq=False)
class TurnedPlane:
    """A half plane that turns.

    Attributes:
        plane: with its cells.
        fills: (places, 1) share of the turn that is material, at each place of the cells.
    """

    plane: SweptPlane
    fills: Points


def turned_planes(
    faces: Sequence[SolidFace], box: Points, rays: Rays
) -> Iterator[tuple[TurnedPlane, Samples]]:
    """The half planes at the axes of a solid's round faces, with the points that were looked at.

    Args:
        faces: of the solid.
        box: (2, 3) corners of the part; units.
        rays: through the solid.
    """
    axes = sorted(_axes(faces), key=lambda axis: -len(axis.faces))
    for found in axes[:_MOST_AXES]:
        point, direction = found.point, found.direction
        corners = np.array(np.meshgrid(*box.T)).reshape(3, -1).T - point
        along = corners @ direction
        far = np.linalg.norm(corners - along[:, None] * direction, axis=1)
        limits = float(along.min()), float(along.max()), float(far.max())
        levels = levels_along(faces, point, direction)
        stretches = _stretches(found.faces, levels, point, direction, limits)
        if len(stretches) > _MOST_STRETCHES:
            continue
        cells = Cells(Arrangement(supports_of(stretches)), (OFF_CENTRE, _FAR_OUT))
        axis = TurnAxis(tuple(point.tolist()), tuple(direction.tolist()))
        frame = frame_across(tuple(_across(direction).tolist()))
        plane = SweptPlane(frame, cells, axis)
        fills, samples = _looked_at(plane, rays)
        yield TurnedPlane(plane, fills), samples


def turned_sweeps(plane: TurnedPlane, number: int, samples: Samples) -> Iterator[Sweep]:
    """The turned bodies of a half plane; see :func:`.prisms.prisms_of`."""
    cells = plane.plane.cells
    full = cells.by_cell(plane.fills, np.fmin)[:, 0] > 1.0 - 1e-9
    touched = cells.by_cell(plane.fills, np.fmax)[:, 0] > 1e-9
    cell_of = plane.plane.clearly_in(samples.points)
    full[cell_of[(cell_of >= 0) & ~samples.is_inside]] = False
    touched[cell_of[(cell_of >= 0) & samples.is_inside]] = True
    for group, adds in regions_of(cells, full, touched):
        border = cells.border(group)
        yield Sweep(number, group, (0.0, 0.0), adds, edge_count(border), length_of(border))


def in_sketch(loop: Loop, plane: SweptPlane) -> Loop:
    """An outline of a half plane in the coordinates of its frame."""
    assert plane.axis is not None
    point, direction = np.array(plane.axis.point), np.array(plane.axis.direction)
    away = np.cross(direction, np.array(plane.frame.normal))

    def placed(place: Point) -> Point:
        x, y, _ = plane.frame.project((point + place[0] * direction + place[1] * away)[None])[0]
        return round(float(x), 9) + 0.0, round(float(y), 9) + 0.0

    # Away from the axis is to the right of its direction, seen against the normal: the outline
    # is mirrored, and runs the other way.
    return tuple(
        OutlineEdge(
            placed(edge.end),
            placed(edge.start),
            edge.circle and Circle(placed(edge.circle.centre), edge.circle.radius),
            edge.is_ccw,
        )
        for edge in reversed(loop)
    )


def _across(direction: Vector) -> Vector:
    """A direction at right angles to another; a main one where that is possible."""
    level = np.eye(3)[int(np.argmin(np.abs(direction)))]
    across = level - direction * float(level @ direction)
    return across / np.linalg.norm(across)


def _axes(faces: Sequence[SolidFace]) -> list[RoundAxis]:
    """The axes of round faces that no prism along a direction makes, with their faces."""
    found = by_axis(f for f in faces if f.kind in (Kind.CYLINDER, Kind.CONE, Kind.TORUS))
    for face in faces:
        if face.kind is Kind.SPHERE:
            _add_sphere(found, face)
    return [
        axis
        for axis in found
        if len({round(face.radius, 4) for face in axis.faces}) > 1
        or any(face.kind is not Kind.CYLINDER for face in axis.faces)
    ]


def _add_sphere(axes: list[RoundAxis], face: SolidFace) -> None:
    """A sphere belongs to all axes through its centre; else to one of its own."""
    through = [axis for axis in axes if axis.off(face.point) < SAME]
    if not through:
        through = [axis_through(face.point, face.direction)]
        axes += through
    for axis in through:
        axis.faces.append(face)


def _stretches(
    faces: Sequence[SolidFace],
    levels: Sequence[float],
    point: Vector,
    direction: Vector,
    limits: tuple[float, float, float],
) -> list[Stretch]:
    """The half plane's lines: what the round faces leave in it, the levels, and its border."""
    low, high, far = limits
    lines: list[tuple[Point, Point]] = [((at, 0.0), (at, far)) for at in levels]
    lines += pairwise([(low, 0.0), (low, far), (high, far), (high, 0.0), (low, 0.0)])
    found: list[Stretch] = []
    for face in faces:
        at = float((face.point - point) @ direction)
        bottom, top = v_range(face)
        if face.kind is Kind.CYLINDER:
            way = float(face.direction @ direction)
            lines.append(((at + way * bottom, face.radius), (at + way * top, face.radius)))
        elif face.kind is Kind.CONE:
            ends = cone_of(face, (bottom, top))
            start, end = ((float((place - point) @ direction), radius) for place, radius in ends)
            lines.append((start, end))
        else:
            found += _circle(face, at)
    made = (segment((a[0], a[1]), (b[0], b[1])) for a, b in lines)
    return [*(line for line in made if line is not None), *found]


def _circle(face: SolidFace, at: float) -> list[Stretch]:
    """What a sphere or torus leaves in a half plane."""
    if face.kind is Kind.SPHERE:
        radius, centre = face.radius, (at, 0.0)
        ends = (centre[0] + radius, 0.0), (centre[0] - radius, 0.0)
        return arc(centre, radius, ends, (centre[0], radius))
    radius, centre = face.minor, (at, face.radius)
    if radius > centre[1]:
        return []
    ends = (centre[0] + radius, centre[1]), (centre[0] + radius, centre[1])
    return arc(centre, radius, ends, (centre[0] - radius, centre[1]))


def _looked_at(plane: SweptPlane, rays: Rays) -> tuple[Points, Samples]:
    assert plane.axis is not None
    point, direction = np.array(plane.axis.point), np.array(plane.axis.direction)
    places = plane.cells.places
    fills = np.full((len(places), _AROUND), np.nan)
    points, is_inside = [], []
    for number, (at, radius) in enumerate(places):
        for turn, base in enumerate(around(point, direction, float(radius), _AROUND, 0.137)):
            stretches = rays.inside(base, direction)
            if stretches is None:
                continue
            within = bool(((stretches[:, 0] < at) & (stretches[:, 1] > at)).any())
            fills[number, turn] = float(within)
            points.append(base + at * direction)
            is_inside.append(within)
    known = np.isfinite(fills)
    share = np.where(known, fills, 0.0).sum(axis=1) / np.maximum(known.sum(axis=1), 1)
    share[~known.any(axis=1)] = np.nan
    samples = Samples(np.array(points).reshape(-1, 3), np.array(is_inside, dtype=bool))
    return share[:, None], samples
