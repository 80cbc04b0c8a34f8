"""The numbers of a sheet's dimensions, as lengths in the model's axes.

A level dimension measures along the axis that runs to the right in the view, or the column of
views, that it stands beside, an upright one along the one that runs up.
"""

import math
from collections.abc import Iterator, Sequence

import numpy as np

from gaussiancad_core.evidence.dimension_constraints import (
    DimensionConstraints,
    LengthDimension,
    RadiusDimension,
    Told,
)
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.projection_planes import plane_points, role_plane
from gaussiancad_core.model.unseen_extent import Unseen
from gaussiancad_core.model.views import Arc
from gaussiancad_core.sheet.registration.view_registration import Placement
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_core.writing.dimension_layout import MISSED
from gaussiancad_core.writing.dimension_texts import Span
from gaussiancad_core.writing.scale_agreement import AGREE, EXACT, Measure
from gaussiancad_core.writing.sheet_scale import SheetScale

_LEAST_PX, _NOISES, _MOST_PX = 0.5, 5.0, 0.75
"""px by which a length may be drawn otherwise than its number says: times the noise of the lines,
from and to."""


def dimension_constraints(
    registered: RegisteredSheet, measures: Sequence[Measure], noise_px: float
) -> DimensionConstraints | None:
    """What dimensions say of a part, in mm; None where they say nothing.

    Args:
        registered: its views.
        measures: in px of the upright sheet.
        noise_px: by which lines miss where they belong.
    """
    # Digits are rather lost in reading than added: of two numbers for one length the longer counts.
    ordered = sorted(measures, key=lambda measure: measure.digit_mm)
    found = tuple(item for measure in ordered for item in _measured(registered, measure))
    found += tuple(_thickness(registered.unseen))
    if not found:
        return None
    reach = min(max(_NOISES * noise_px, _LEAST_PX), _MOST_PX)
    # Zeros at the end are left out: the longest number tells how all are rounded.
    digit = min((measure.digit_mm for measure in measures), default=0.0)
    return DimensionConstraints(found, reach * registered.mm_per_pixel, digit)


def trusted(registered: RegisteredSheet, scale: SheetScale | None) -> tuple[Measure, ...]:
    """What dimensions say, where they are true at the scale that was taken."""
    apart = scale_apart(registered, scale)
    return () if scale is None or apart is None or apart > EXACT else scale.measures


def contradicts(registered: RegisteredSheet, scale: SheetScale | None) -> bool:
    """Whether the dimensions of a sheet agree on another scale than the one that was taken."""
    apart = scale_apart(registered, scale)
    return apart is not None and apart > AGREE


def scale_apart(registered: RegisteredSheet, scale: SheetScale | None) -> float | None:
    """Share by which the dimensions' scale differs from the one that was taken; None without."""
    if scale is None or not scale.measures or scale.mm_per_pixel is None:
        return None
    return abs(math.log(scale.mm_per_pixel / registered.mm_per_pixel))


def _measured(registered: RegisteredSheet, measure: Measure) -> Iterator[Told]:
    for role, placement in registered.placements.items():
        found: Told | None
        if isinstance(measure.place, Span):
            found = _length(role, placement, measure.place, measure.value_mm)
        else:
            found = _radius(role, placement, registered.mm_per_pixel, measure, measure.place)
        if found is not None:
            # Views in one column, or row, show the same.
            yield found
            return


def _length(role: Role, placement: Placement, span: Span, value: float) -> LengthDimension | None:
    x0, y0, x1, y1 = placement.box
    first, last = (x0, x1) if span.level else (y0, y1)
    if span.low < first - MISSED or span.high > last + MISSED:
        return None
    ends = [(at, y0) if span.level else (x0, at) for at in (span.low, span.high)]
    right, up = placement.to_plane(np.array(ends)).T
    along, (axis, sign) = (right, role.frame.right_axis) if span.level else (up, role.frame.up_axis)
    low, high = sorted((sign * along).tolist())
    return LengthDimension(axis, low, high, value)


def _thickness(unseen: Unseen | None) -> Iterator[LengthDimension]:
    """That the part is as thick as was said, where no view shows it."""
    if unseen is not None and unseen.thickness is not None:
        yield LengthDimension(unseen.axis, 0.0, unseen.thickness, unseen.thickness)


def _radius(
    role: Role, placement: Placement, mm_per_pixel: float, measure: Measure, arc: Arc
) -> RadiusDimension | None:
    x0, y0, x1, y1 = placement.box
    x, y = arc.centre
    radius = arc.radius
    if not (x0 - radius <= x <= x1 + radius and y0 - radius <= y <= y1 + radius):
        return None
    ((a, b),) = plane_points(placement.to_plane(np.array([[x, y]])), role, 1.0)
    centre = (float(a), float(b))
    drawn = radius * mm_per_pixel
    return RadiusDimension(role_plane(role).normal, centre, drawn, measure.value_mm)
