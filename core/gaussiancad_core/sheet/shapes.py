"""Straight lines and circles under the ink: Canny, probabilistic Hough, Hough circles.

The transforms give candidates to about a pixel, several for each stroke, since the edge map has both
sides of it.  Each candidate is fitted to the ink it lies on (total least squares for lines, a robust
geometric fit for circles), which merges the doubles and finds the stroke's centre line.
"""

from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.clean import CleanSheet

Points = npt.NDArray[np.float64]


@dataclass(frozen=True)
class Line:
    """An infinite line with unit direction, in px of the image (centres of pixels at integers)."""

    point: tuple[float, float]
    direction: tuple[float, float]

    def coordinates(self, points: Points) -> tuple[Points, Points]:
        """(n, 2) points -> position along the line and signed distance from it, (n,) each."""
        offset = points - np.array(self.point)
        along = offset @ np.array(self.direction)
        across = offset @ np.array([-self.direction[1], self.direction[0]])
        return along, across

    def at(self, along: float) -> tuple[float, float]:
        """The point at a position along the line."""
        return (
            self.point[0] + along * self.direction[0],
            self.point[1] + along * self.direction[1],
        )


@dataclass(frozen=True)
class Circle:
    """A circle in px of the image (centres of pixels at integers)."""

    centre: tuple[float, float]
    radius: float


def edge_map(sheet: CleanSheet) -> npt.NDArray[np.uint8]:
    """Canny edges of the thresholded ink, 0 or 255."""
    return cv2.Canny(sheet.ink.astype(np.uint8) * 255, 80, 160)


def find_lines(sheet: CleanSheet, edges: npt.NDArray[np.uint8]) -> list[Line]:
    """Lines under straight strokes, longest evidence first."""
    found = cv2.HoughLinesP(
        edges,
        1,
        np.pi / 360,
        threshold=14,
        minLineLength=max(8.0, 3 * sheet.stroke_width),
        maxLineGap=6,
    )
    if found is None:
        return []
    segments = found.reshape(-1, 4).astype(np.float64)
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

    Args:
        sheet: the ink.
        line: a fit to part of the stroke.
        spans: where along the line there is ink of its own; the origin of positions stays.
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
    total = profile.sum(1)
    # Where the profile is inked at an end, another stroke crosses or lies beside.
    clear = (total > 0.8) & (np.maximum(profile[:, 0], profile[:, -1]) < 0.3)
    if clear.sum() < 6:
        return line
    across = (profile[clear] * offsets).sum(1) / total[clear]
    good = np.abs(across - np.median(across)) < 1.0
    if good.sum() < 6 or np.ptp(along[clear][good]) < 6:
        return line
    slope, shift = np.polyfit(along[clear][good], across[good], 1)
    turned = direction + slope * normal
    origin = np.array(line.point) + shift * normal
    unit = turned / np.hypot(*turned)
    return Line((float(origin[0]), float(origin[1])), (float(unit[0]), float(unit[1])))


def find_circles(sheet: CleanSheet, box: tuple[int, int, int, int]) -> list[Circle]:
    """Circles under the strokes inside a box (x0, y0, x1, y1).

    Hough circles gives candidates, twice: the gradient method finds dashed circles, the ALT mode
    finds sharp ones and arcs.  A candidate stays if a fit to the ink converges near it.
    """
    x0, y0, x1, y1 = box
    ink = sheet.ink[y0:y1, x0:x1].astype(np.uint8) * 255
    grey = cv2.GaussianBlur(255 - ink, (0, 0), 1.0)
    side = max(ink.shape)
    candidates: list[tuple[float, float, float]] = []
    for method, first, second in (
        (cv2.HOUGH_GRADIENT_ALT, 200, 0.7),
        (cv2.HOUGH_GRADIENT, 160, 22),
    ):
        found = cv2.HoughCircles(
            grey,
            method,
            dp=1.5 if method == cv2.HOUGH_GRADIENT_ALT else 1.0,
            minDist=3,
            param1=first,
            param2=second,
            minRadius=4,
            maxRadius=side,
        )
        if found is not None:
            candidates += [tuple(row[:3]) for row in found.reshape(-1, found.shape[-1])]
    circles: list[Circle] = []
    for cx, cy, radius in candidates[:400]:
        circle = fit_circle(sheet, Circle((float(cx) + x0, float(cy) + y0), float(radius)))
        if circle is not None and not any(same_circle(circle, other) for other in circles):
            circles.append(circle)
    return circles


def same_circle(a: Circle, b: Circle) -> bool:
    """Whether two circles are the same to 1.5 px."""
    return (
        np.hypot(a.centre[0] - b.centre[0], a.centre[1] - b.centre[1]) < 1.5
        and abs(a.radius - b.radius) < 1.5
    )


def fit_circle(sheet: CleanSheet, start: Circle) -> Circle | None:
    """Fit a circle to the ink near it: centroids of radial profiles, then geometric least squares
    with a Huber-like weight.  None if it drifts away or too little of it is inked.
    """
    circle = start
    for reach in (sheet.stroke_width / 2 + 3.0, sheet.stroke_width / 2 + 2.0) + (
        sheet.stroke_width / 2 + 1.5,
    ) * 3:
        angles, radii = radial_profile(sheet, circle, reach)
        if len(angles) < 12:
            return None
        residual = radii - circle.radius
        weight = np.minimum(1.0, 0.4 / np.maximum(np.abs(residual - np.median(residual)), 1e-9))
        design = np.stack([np.cos(angles), np.sin(angles), np.ones_like(angles)], 1)
        scaled = design * weight[:, None]
        step, *_ = np.linalg.lstsq(scaled, residual * weight, rcond=None)
        if np.hypot(step[0], step[1]) > 6 or abs(step[2]) > 6:
            return None
        circle = Circle(
            (circle.centre[0] + step[0], circle.centre[1] + step[1]), circle.radius + step[2]
        )
        if circle.radius < 2.5:
            return None
    return circle


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
    values = cv2.remap(
        image, flat_x, flat_y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=0
    )
    return values.reshape(shape)
