"""How exactly the lines of a sheet are known, as far as it tells.

Views contradict each other about the coordinates that they share; programs round the places of
lines to parts of a pixel, in two views alike.
"""

from gaussiancad_core.sheet.image.pixel_grids import Rounding, rounding_step, seen_rounding
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet

_MEAN = 0.15
"""Least median of how far views contradict each other, as a share of the farthest: programs that
place lines on quarters of a pixel draw most coordinates alike in two views, and wrong alike."""

_LEAST_NOISE_PX = 0.015
"""The same in px at least: what two views round alike is seen in neither."""

_ROUNDED_NOISE_PX = 0.03
"""The same where lines are rounded, mostly to quarters of a pixel: they are off by a sixteenth of a
pixel at the mean, and all faces together by up to a thirteenth, of parts whose solids are known."""

_ROUGH_NOISE = 0.12
"""The same as a share of the step that they are rounded to: programs that place lines on whole
pixels misplace them by four times as much."""

_USUAL_STEP_PX = 0.25
"""Step of programs that round: where a sheet has too few lines to tell, one may have drawn it."""

_ROUNDED_APART = 0.78
"""Steps within which the distance of two lines lies that are rounded, each by itself, in 95 % of
cases: it is distributed as a triangle over one step to either side."""

_SEEN_APART = 4.1
"""The same in the median by which two views contradict each other: that is .48 deviations of a
line, and a measure is the difference of two places that are means of two lines."""

_FREE_NOISE_PX, _LEAST_BOUND = 0.0075, 3.0
"""px of noise of pictures in which nothing is rounded, at least, and times that within which
measures lie: neighbours and corners move lines alike in all views."""

_FINE_PX, _FINE_COORDINATES = 0.02, 5
"""px that so many coordinates differ by at most which one view shows along rows and another along
columns of the sheet: then nothing is rounded."""


def noise_px(registered: RegisteredSheet) -> tuple[float, float]:
    """px by which lines of a picture may miss where they belong, and by which 95 % of what is
    measured between them does, as far as it tells."""
    seen = _seen_px(registered)
    strokes = [view.strokes for view in registered.drawn]
    well_read = seen <= _FREE_NOISE_PX
    by_file = _file_step(registered)
    rounding = Rounding.TOLD if by_file else seen_rounding(strokes, well_read=well_read)
    if rounding is Rounding.TOLD:
        step = by_file or rounding_step(strokes, well_read=well_read)
        least = max(_ROUNDED_NOISE_PX, _ROUGH_NOISE * step)
    elif rounding is Rounding.NONE or _is_fine(registered):
        step, least = 0.0, _FREE_NOISE_PX
    else:
        step, least = _USUAL_STEP_PX, _LEAST_NOISE_PX
    floor = _LEAST_BOUND * _FREE_NOISE_PX
    return max(least, seen), max(_ROUNDED_APART * step, _SEEN_APART * seen, floor)


def bound_of_seen_px(registered: RegisteredSheet) -> float:
    """px by which 95 % of what is measured between lines of a file misses, as far as views
    contradict each other, and at least as its grid says: it rounds all views alike."""
    return max(_ROUNDED_APART * _file_step(registered), _SEEN_APART * _seen_px(registered))


def _file_step(registered: RegisteredSheet) -> float:
    """px of the coarsest grid to which the file of a view was rounded; 0 of pictures."""
    return max(view.step for view in registered.drawn)


def _seen_px(registered: RegisteredSheet) -> float:
    """px by which views contradict each other about what they share, at the median of an axis."""
    residuals = registered.extents.residuals.values()
    return max(
        (max(residual.median, _MEAN * residual.largest) for residual in residuals), default=0.0
    )


def _is_fine(registered: RegisteredSheet) -> bool:
    """Whether views that would be rounded each in its own way agree."""
    frames = [role.frame for role in registered.views.roles]
    turned = {frame.right_axis[0] for frame in frames} & {frame.up_axis[0] for frame in frames}
    residuals = [
        residual for axis, residual in registered.extents.residuals.items() if axis in turned
    ]
    return any(
        residual.coordinates >= _FINE_COORDINATES and residual.largest <= _FINE_PX
        for residual in residuals
    ) and all(residual.largest <= _FINE_PX for residual in residuals)
