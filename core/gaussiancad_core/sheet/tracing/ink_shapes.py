"""Straight lines and circles under the ink: Canny, probabilistic Hough, Hough circles.

The transforms give candidates to about a pixel, several for each stroke, since the edge map has
both sides of it.  Each candidate is fitted to the ink it lies on (total least squares for lines, a
robust geometric fit for circles), which merges the doubles and finds the stroke's centre line.
"""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.points import Points
from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.sheet.image.clean_ink import CleanSheet
from gaussiancad_core.sheet.tracing.sharp_edges import between_edges

_MAX_CENTRES = 200
"""Hough circles looked at, best first, for each of its modes."""

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

_HOUGH_WAYS = ((12, 8, 5), (24, 30, 22))
"""Votes, shortest line, widest gap in px: for short solid lines, and across the gaps of dashes."""

_RADIAL_SHARE = 0.12
"""Share of a circle that is inked where there may be an arc: a fillet is a quarter, dashed less."""


def edge_map(sheet: CleanSheet) -> npt.NDArray[np.uint8]:
    """Canny edges of the thresholded ink, 0 or 255."""
    return np.asarray(cv2.Canny(sheet.ink.astype(np.uint8) * 255, 80, 160), dtype=np.uint8)


def find_lines(sheet: CleanSheet, edges: npt.NDArray[np.uint8]) -> list[Line]:
    """Lines under straight strokes, longest evidence first."""
    segments = np.concatenate([_hough_segments(edges, *way) for way in _HOUGH_WAYS])
    lengths = np.hypot(segments[:, 2] - segments[:, 0], segments[:, 3] - segments[:, 1])
    lines: list[Line] = []
    for index in np.argsort(-lengths, kind="stable"):
        start, end = segments[index, :2], segments[index, 2:]
        if any(_lies_on(line, start, end, sheet.stroke_width) for line in lines):
            continue
        line = _fit_line(sheet, start, end)
        if line is not None and not any(_same_line(line, other, start, end) for other in lines):
            lines.append(line)
    return lines


def _hough_segments(
    edges: npt.NDArray[np.uint8], votes: int, shortest: int, gap: int
) -> npt.NDArray[np.float64]:
    """(n, 4) x0, y0, x1, y1 by the probabilistic Hough transform, half a degree fine."""
    found = cv2.HoughLinesP(edges, 1, np.pi / 360, votes, minLineLength=shortest, maxLineGap=gap)
    return np.zeros((0, 4)) if found is None else found.reshape(-1, 4).astype(np.float64)


def _lies_on(line: Line, start: Points, end: Points, stroke_width: float) -> bool:
    """Whether a segment is an edge of a stroke along the line."""
    _, across = line.coordinates(np.stack([start, end]))
    return bool(np.all(np.abs(across) < stroke_width / 2 + 1.0)) and bool(
        abs(across[1] - across[0]) < max(1.0, 0.03 * float(np.hypot(*(end - start))))
    )


def _same_line(line: Line, other: Line, start: Points, end: Points) -> bool:
    along, _ = line.coordinates(np.stack([start, end]))
    ends = np.array([line.at(along[0]), line.at(along[1])])
    _, across = other.coordinates(ends)
    return bool(np.all(np.abs(across) < 0.8))


def _fit_line(sheet: CleanSheet, start: Points, end: Points) -> Line | None:
    """Total least squares on the ink's weight in a band around a Hough segment.

    None if the ink is curved: a chord of a circle.
    """
    length = float(np.hypot(*(end - start)))
    line = Line(tuple((start + end) / 2), tuple((end - start) / length))
    half = length / 2
    if half > 3.0 * sheet.stroke_width:
        # Strokes that meet this one at its ends pull a short fit to their side, and bend it.
        half -= min(1.5 * sheet.stroke_width, 0.3 * half)
    sagitta = 0.0
    for band in (sheet.stroke_width / 2 + 2.0, sheet.stroke_width / 2 + 1.2):
        points, weights = _ink_near(sheet, line, half, band)
        if len(points) < 6:
            return None
        mean = np.average(points, axis=0, weights=weights)
        centred = points - mean
        covariance = (centred * weights[:, None]).T @ centred
        direction = np.linalg.eigh(covariance)[1][:, 1]
        if direction @ np.array(line.direction) < 0:
            direction = -direction
        line = Line(tuple(mean), tuple(direction))
        along, across = line.coordinates(points)
        curvature = np.polyfit(along, across, 2, w=np.sqrt(weights))[0]
        sagitta = abs(curvature) * half**2
    return line if sagitta < max(0.3, 0.01 * length) else None


def _ink_near(
    sheet: CleanSheet, line: Line, half: float, band: float
) -> tuple[Points, npt.NDArray[np.float64]]:
    """Ink pixels within a band around a piece of a line: (n, 2) x, y and their weights."""
    ends = np.array([line.at(-half), line.at(half)])
    x0, y0 = np.floor(ends.min(0) - band).astype(int)
    x1, y1 = np.ceil(ends.max(0) + band).astype(int) + 1
    x0, y0 = max(x0, 0), max(y0, 0)
    window = sheet.weight[y0:y1, x0:x1]
    ys, xs = np.nonzero(window > 0.15)
    points = np.stack([xs + x0, ys + y0], 1).astype(np.float64)
    along, across = line.coordinates(points)
    keep = (np.abs(along) <= half) & (np.abs(across) <= band)
    return points[keep], window[ys, xs][keep].astype(np.float64)


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


def find_circles(sheet: CleanSheet) -> list[Circle]:
    """Circles and arcs under the strokes of a view.

    Hough circles finds centres, twice: the gradient method those of dashed circles, the ALT mode
    sharp ones and arcs.  It gives one radius a centre, so all circles around a centre are looked
    for in the ink's radial profile.  A candidate stays if a fit to the ink converges near it.
    """
    grey = cv2.GaussianBlur(255 - sheet.ink.astype(np.uint8) * 255, (0, 0), 1.0)
    side = max(sheet.ink.shape)
    candidates: list[Circle] = []
    for method, dp, edge, votes in (
        (cv2.HOUGH_GRADIENT_ALT, 1.5, 200, 0.7),
        (cv2.HOUGH_GRADIENT, 2.0, 160, 40),
    ):
        found = cv2.HoughCircles(
            grey, method, dp, 3, param1=edge, param2=votes, minRadius=4, maxRadius=side
        )
        if found is not None:
            rows = found.reshape(-1, found.shape[-1])[:_MAX_CENTRES].astype(np.float64)
            candidates += [Circle((float(x), float(y)), float(r)) for x, y, r in rows[:, :3]]
    circles = _fitted(sheet, candidates, [])
    around = [
        Circle(centre, radius)
        for centre in _distinct_centres(circles)
        for radius in _radii_around(sheet, centre)
    ]
    return _fitted(sheet, around, circles)


def _fitted(sheet: CleanSheet, candidates: list[Circle], known: list[Circle]) -> list[Circle]:
    """The known circles and those that candidates converge to; of two alike the better one.

    A fit can end beside the circle, where tangents pull it: it must not keep the right one out.
    """
    circles = [(circle, circle_support(sheet, circle)) for circle in known]
    for candidate in candidates:
        if any(same_circle(candidate, other) for other, _ in circles):
            continue
        circle = fit_circle(sheet, candidate)
        if circle is None:
            continue
        support = circle_support(sheet, circle)
        alike = [pair for pair in circles if same_circle(circle, pair[0])]
        if all(support > other for _, other in alike):
            circles = [pair for pair in circles if pair not in alike] + [(circle, support)]
    return [circle for circle, _ in circles]


def _distinct_centres(circles: list[Circle]) -> list[tuple[float, float]]:
    centres: list[tuple[float, float]] = []
    for circle in circles:
        if all(np.hypot(circle.centre[0] - x, circle.centre[1] - y) > 2.0 for x, y in centres):
            centres.append(circle.centre)
    return centres


def _radii_around(sheet: CleanSheet, centre: tuple[float, float]) -> list[float]:
    """Radii at which a good part of the circle around a centre is inked."""
    height, width = sheet.ink.shape
    reach = float(np.hypot(max(centre[0], width - centre[0]), max(centre[1], height - centre[1])))
    angles, step = 720, 0.5
    polar = cv2.warpPolar(
        sheet.weight,
        (int(reach / step), angles),
        centre,
        reach,
        cv2.INTER_LINEAR | cv2.WARP_FILL_OUTLIERS,
    )
    share = cv2.blur(polar.mean(0)[None], (3, 1))[0]
    peaks = (share > _RADIAL_SHARE) & (share >= np.roll(share, 1)) & (share > np.roll(share, -1))
    return [float(i * step) for i in np.flatnonzero(peaks) if i * step >= 4.0]


def same_circle(a: Circle, b: Circle) -> bool:
    """Whether two circles are the same to 1.5 px."""
    return (
        np.hypot(a.centre[0] - b.centre[0], a.centre[1] - b.centre[1]) < 1.5
        and abs(a.radius - b.radius) < 1.5
    )


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
