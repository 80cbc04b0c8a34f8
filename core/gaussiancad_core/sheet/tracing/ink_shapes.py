"""Straight lines and circles fitted to the ink that they lie on.

A line is fitted to the centroids of profiles across it, a circle to those of radial ones, by robust
least squares; what of the ink has its centre line there is the shape's support.
"""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.tracing.sharp_edges import between_edges

_CIRCLE_FITS = ((3.0, 4.0), (2.5, 3.0), (2.0, 2.0), (1.5, 1.2), (1.5, 0.8), (1.5, 0.8))
"""Of each step of a circle's fit: px beside the stroke that it looks at, and Tukey's cutoff."""

_FOLLOWED = 0.8
"""px by which a shape may pass beside a stroke's centre line at most."""

_WINDOWS = ((1.0, 0.1), (1.5, 0.1), (2.0, 0.3))
"""px beside a stroke that its profile reaches, and the ink at its ends under which it is white."""

_MOST_ROWS = 30_000
"""Rows that OpenCV samples at once: fewer than 2^15."""

_LEAST_SUPPORT = 0.1
"""Share of a circle that has ink on it, at least: two tangents of a circle have less."""


def refit_line(sheet: CleanSheet, line: Line, spans: list[tuple[float, float]]) -> Line:
    """Fit a line again to all the ink found along it: centroids of cross profiles every px.

    Where it runs along the pixels, the middle between its edges counts.

    Args:
        sheet: the ink.
        line: a fit to part of the stroke.
        spans: where along the line there is ink of its own; the origin of positions stays.
    """
    along, across = cross_profile(sheet, line, spans)
    if len(along) < 6:
        return line
    good = np.abs(across - np.median(across)) < 1.0
    if good.sum() < 6 or np.ptp(along[good]) < 6:
        return line
    slope, shift = np.polyfit(along[good], across[good], 1)
    direction = np.array(line.direction)
    normal = np.array([-direction[1], direction[0]])
    turned = direction + slope * normal
    origin = np.array(line.point) + shift * normal
    unit = turned / np.hypot(*turned)
    fitted = Line((float(origin[0]), float(origin[1])), (float(unit[0]), float(unit[1])))
    return between_edges(sheet, fitted, along[good])


def line_support(sheet: CleanSheet, line: Line, spans: list[tuple[float, float]]) -> float:
    """px of the ink in some spans of a line whose centre line is the line."""
    return following(cross_profile(sheet, line, spans)[1]) if spans else 0.0


def following(residual: npt.NDArray[np.float64]) -> float:
    """Number of samples with a small residual in px, those in doubt counted less (Tukey)."""
    return float((np.clip(1.0 - (residual / _FOLLOWED) ** 2, 0.0, None) ** 2).sum())


def cross_profile(
    sheet: CleanSheet, line: Line, spans: list[tuple[float, float]]
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Every px along some spans: the position, and where across it the stroke's centre is.

    Returns:
        (n,) px along the line, and (n,) px to its left, seen along its direction with y down; only
        where a centre can be told.
    """
    along = np.concatenate([np.arange(start, end + 0.5) for start, end in spans])
    reach = sheet.stroke_width / 2 + 2.0
    offsets = np.arange(-reach, reach + 0.25, 0.5)
    direction = np.array(line.direction)
    normal = np.array([-direction[1], direction[0]])
    points = np.array(line.point) + along[:, None] * direction
    xs = points[:, :1] + offsets * normal[0]
    ys = points[:, 1:] + offsets * normal[1]
    profile = sample(sheet.weight, xs, ys)
    # The narrowest window that is white at both ends keeps neighbours out; where none is white,
    # another stroke crosses or lies beside.
    middle = len(offsets) // 2
    centre = np.full(len(along), np.nan)
    for offset, white in _WINDOWS:
        half = round(2.0 * (sheet.stroke_width / 2 + offset))
        window = slice(max(middle - half, 0), middle + half + 1)
        part = profile[:, window]
        total = part.sum(1)
        clear = (total > 0.8) & (np.maximum(part[:, 0], part[:, -1]) < white) & np.isnan(centre)
        centre[clear] = (part[clear] * offsets[window]).sum(1) / total[clear]
    found = np.isfinite(centre)
    return along[found], centre[found]


def fit_circle(sheet: CleanSheet, start: Circle) -> Circle | None:
    """Fit a circle to the ink near it: centroids of radial profiles, then least squares with
    Tukey's weights, which forget the tangents beside an arc as the fit tightens.

    None if the fit drifts away or little of the circle is inked: a line touches it.
    """
    circle = start
    half = sheet.stroke_width / 2
    for reach, cutoff in _CIRCLE_FITS:
        angles, radii = radial_profile(sheet, circle, half + reach)
        residual = radii - circle.radius
        weight = np.clip(1.0 - (residual / cutoff) ** 2, 0.0, None)
        if (weight > 0.2).sum() < 12:
            return None
        design = np.stack([np.cos(angles), np.sin(angles), np.ones_like(angles)], 1)
        scaled = design * weight[:, None]
        step, *_ = np.linalg.lstsq(scaled, residual * weight, rcond=None)
        if np.hypot(step[0], step[1]) > 6 or abs(step[2]) > 6:
            return None
        circle = Circle(
            (float(circle.centre[0] + step[0]), float(circle.centre[1] + step[1])),
            float(circle.radius + step[2]),
        )
        if circle.radius < 2.5:
            return None
    least = _LEAST_SUPPORT * 2 * np.pi * circle.radius
    return circle if circle_support(sheet, circle) > least else None


def refit_circle(sheet: CleanSheet, circle: Circle, spans: list[tuple[float, float]]) -> Circle:
    """Fit a circle again to the ink of its arcs alone, without the tangents that continue them.

    Args:
        sheet: the ink.
        circle: a fit to the arcs and what lies near.
        spans: of the arcs, px of arc length from angle 0.
    """
    angles, radii = radial_profile(sheet, circle, sheet.stroke_width / 2 + 1.5)
    around = 2 * np.pi * circle.radius
    along = angles * circle.radius
    within = [((along - start) % around) <= end - start for start, end in spans]
    residual = radii - circle.radius
    used = np.logical_or.reduce(within) & (np.abs(residual) < 1.5)
    if used.sum() < 12:
        return circle
    design = np.stack([np.cos(angles), np.sin(angles), np.ones_like(angles)], 1)[used]
    step, *_ = np.linalg.lstsq(design, residual[used], rcond=None)
    if np.abs(step).max() > 2.5:
        return circle
    centre = (float(circle.centre[0] + step[0]), float(circle.centre[1] + step[1]))
    return Circle(centre, float(circle.radius + step[2]))


def circle_support(sheet: CleanSheet, circle: Circle) -> float:
    """px of the ink along a circle whose centre line is the circle."""
    radii = radial_profile(sheet, circle, sheet.stroke_width / 2 + 1.5)[1]
    return following(radii - circle.radius)


def radial_profile(
    sheet: CleanSheet, circle: Circle, reach: float
) -> tuple[npt.NDArray[np.float64], npt.NDArray[np.float64]]:
    """Angles at which there is a stroke near a circle, and the radius of its centre line there."""
    count = max(32, int(2 * np.pi * circle.radius))
    angles = np.arange(count) * (2 * np.pi / count)
    offsets = np.arange(-reach, reach + 0.25, 0.5)
    radii = np.maximum(circle.radius + offsets, 0.0)
    xs = circle.centre[0] + np.cos(angles)[:, None] * radii
    ys = circle.centre[1] + np.sin(angles)[:, None] * radii
    profile = sample(sheet.weight, xs, ys)
    total = profile.sum(1)
    # A profile that is inked at both ends crosses another stroke, or several.
    clear = (total > 0.8) & (np.minimum(profile[:, 0], profile[:, -1]) < 0.5)
    centre = (profile * radii).sum(1) / np.maximum(total, 1e-9)
    return angles[clear], centre[clear]


def sample(
    image: npt.NDArray[np.float32], xs: npt.NDArray[np.float64], ys: npt.NDArray[np.float64]
) -> npt.NDArray[np.float32]:
    """Bilinear samples of an image at pixel positions; 0 outside."""
    shape = xs.shape
    flat_x = xs.astype(np.float32).reshape(shape[0], -1)
    flat_y = ys.astype(np.float32).reshape(shape[0], -1)
    values = np.empty(flat_x.shape, dtype=np.float32)
    for start in range(0, shape[0], _MOST_ROWS):
        rows = slice(start, start + _MOST_ROWS)
        values[rows] = cv2.remap(
            image,
            flat_x[rows],
            flat_y[rows],
            cv2.INTER_LINEAR,
            borderMode=cv2.BORDER_CONSTANT,
            borderValue=0,
        )
    return values.reshape(shape)
