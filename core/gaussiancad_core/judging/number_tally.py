"""Stated lengths and radii against a solid: what it measures where the sheet has a number.

A number counts, not the line that it stands at (ISO 129-1).  It is compared with the two places of
the solid, or its round face, that are near to what the dimension was drawn between.  A dimension
of which the solid has nothing near tells nothing here: its lines do.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import numpy as np

from gaussiancad_core.evidence.dimension_constraints import (
    DimensionConstraints,
    LengthDimension,
    RadiusDimension,
)
from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats
from gaussiancad_core.judging.model_features import RoundFace, round_faces
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE, role_plane

_NEAR = 0.02
"""Share of the longest extent within which a place of the solid is that of a dimension's end."""

_DIGITS, _SHARE = 0.6, 1e-3
"""Last digits of a number, and share of it, by which the solid's measure may differ."""


Ends = tuple[tuple[float, float], tuple[float, float]]
"""(right, up) mm of two places in a view."""


@dataclass(frozen=True)
class NumberDifference:
    """A number that a solid does not keep.

    Attributes:
        role: a view that shows the length.
        ends: of the dimension in this view, as drawn.
        stated: mm, a length or a radius.
        measured: mm, of the solid.
        is_radius: whether it is a radius.
    """

    role: Role
    ends: Ends
    stated: float
    measured: float
    is_radius: bool


def differing_numbers(
    solid: FacetedSolid, numbers: DimensionConstraints | None, roles: Iterable[Role]
) -> tuple[NumberDifference, ...]:
    """The numbers of a sheet that a solid does not keep, the farthest off first.

    Args:
        solid: on the sheet's axes, mm.
        numbers: that the sheet states; None where it states none.
        roles: its views.
    """
    if numbers is None:
        return ()
    rounds = tuple(round_faces(solid))
    levels = {axis: _levels(solid, rounds, axis) for axis in Axis}
    near = _NEAR * float(solid.extent.max())
    found = []
    for dimension in numbers.lengths:
        if isinstance(dimension, LengthDimension):
            measures = _lengths(dimension, levels[dimension.axis], near)
        else:
            measures = _radii(dimension, rounds, near)
        if not len(measures):
            continue
        measured = float(measures[np.abs(measures - dimension.value).argmin()])
        slack = max(_DIGITS * numbers.digit, _SHARE * dimension.value)
        if abs(measured - dimension.value) > slack:
            found += [*_placed(dimension, measured, roles)]
    return tuple(sorted(found, key=lambda each: -abs(each.measured - each.stated)))


def _levels(solid: FacetedSolid, rounds: Iterable[RoundFace], axis: Axis) -> Floats:
    """Places along an axis at which faces begin or end, and the middles of round ones."""
    along = solid.vertices[solid.triangles][..., axis.value]
    low = np.full(len(solid.smooth), np.inf)
    high = np.full(len(solid.smooth), -np.inf)
    np.minimum.at(low, solid.surfaces, along.min(axis=1))
    np.maximum.at(high, solid.surfaces, along.max(axis=1))
    middles = [
        float(face.centre[IN_PLANE[face.axis].index(axis.value)])
        for face in rounds
        if face.axis is not axis
    ]
    found = np.concatenate([low, high, middles])
    return np.unique(found[np.isfinite(found)])


def _lengths(dimension: LengthDimension, levels: Floats, near: float) -> Floats:
    """(k,) mm between places that are near to the ends of a dimension."""
    low, high = (levels[np.abs(levels - end) <= near] for end in (dimension.low, dimension.high))
    return (high[:, None] - low[None, :]).reshape(-1)


def _radii(dimension: RadiusDimension, rounds: Iterable[RoundFace], near: float) -> Floats:
    """(k,) mm, radii of round faces that are near to a stated one."""
    return np.array(
        [
            face.radius
            for face in rounds
            if face.axis is dimension.normal
            and np.hypot(*np.subtract(face.centre, dimension.centre)) <= near
            and abs(face.radius - dimension.radius) <= near
        ]
    )


def _placed(
    dimension: LengthDimension | RadiusDimension, measured: float, roles: Iterable[Role]
) -> Iterator[NumberDifference]:
    """The difference in the first view that shows it."""
    for role in roles:
        if isinstance(dimension, RadiusDimension):
            ends = _circle_ends(dimension, role)
        else:
            ends = _length_ends(dimension, role)
        if ends is not None:
            is_radius = isinstance(dimension, RadiusDimension)
            yield NumberDifference(role, ends, dimension.value, measured, is_radius)
            return


def _length_ends(dimension: LengthDimension, role: Role) -> Ends | None:
    """The ends of a length at the border of a view; None where it looks along the length."""
    frame = role.frame
    if dimension.axis is frame.right_axis[0]:
        sign = frame.right_axis[1]
        return (sign * dimension.low, 0.0), (sign * dimension.high, 0.0)
    if dimension.axis is frame.up_axis[0]:
        sign = frame.up_axis[1]
        return (0.0, sign * dimension.low), (0.0, sign * dimension.high)
    return None


def _circle_ends(dimension: RadiusDimension, role: Role) -> Ends | None:
    """The outermost places of a circle in a view; None where it shows the circle edge-on."""
    plane = role_plane(role)
    if plane.normal is not dimension.normal:
        return None
    right, up = np.multiply(dimension.centre, plane.signs).tolist()
    return (right - dimension.radius, up), (right + dimension.radius, up)
