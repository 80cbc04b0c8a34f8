"""How a flat sheet was seen by a camera: by the level and the upright lines of its drawing.

A drawing has two directions in which most of its lines run.  On a picture taken at a slant either
of them runs together in a vanishing point.  A camera with square pixels and its middle in that of
the picture sees both at right angles, so that its turn and tilt follow from them; how far it sees
(its focal length) follows, too, as far as they run together, and otherwise is that of most cameras.
"""

from dataclasses import dataclass
from functools import partial

import cv2
import numpy as np
import numpy.typing as npt
from scipy.optimize import least_squares

Floats = npt.NDArray[np.float64]

_LONGEST = 1600
"""px of the longer side of the picture in which lines are looked for."""

_SHORTEST = 0.02
"""Length from which a piece of line counts, in the longer side of the picture."""

_FOCAL, _FOCAL_SPREAD = 0.75, 0.15
"""Focal length in the longer side of a picture, of telephones: 27 mm on 36 mm; and the standard
deviation of its logarithm among them."""

_NOISE = np.radians(0.1)
"""Radians by which the direction of a long line is known on a picture."""

_END = 0.6
"""px by which the ends of a line are known beside it."""

_TILTS = np.radians([0.0, 8.0, 16.0, 24.0, 32.0])
_WAYS = np.linspace(0.0, 2.0 * np.pi, 8, endpoint=False)
"""Tilts, and the ways to which the sheet is tilted, from which the fit is started."""

_REACHES = np.radians([4.0, 1.5, 0.6, 0.4])
"""Angles to a vanishing direction within which a line belongs to it, from fit to fit."""

_FEWEST = 4
"""Lines that tell turn, tilt and focal length."""

_STEEPEST = np.radians(50.0)
"""Tilt over which a sheet is no picture to read."""


@dataclass(frozen=True, eq=False)
class Segments:
    """Straight pieces of line on a picture; px from its middle, in its longer side.

    Attributes:
        middles: (n, 2).
        ways: (n, 2) unit vectors along them.
        lengths: (n,).
        noise: (n,) radians by which their direction is known.
    """

    middles: Floats
    ways: Floats
    lengths: Floats
    noise: Floats


@dataclass(frozen=True, eq=False)
class Sight:
    """How a camera sees a sheet.

    Attributes:
        rotation: (3, 3), its columns the sheet's directions to the right, down and away from the
            camera, in the camera's: right, down, ahead.
        focal: focal length, in the longer side of the picture.
    """

    rotation: Floats
    focal: float

    @property
    def tilt(self) -> float:
        """Radians between the sheet's normal and the way in which the camera looks."""
        return float(np.arccos(np.clip(self.rotation[2, 2], -1.0, 1.0)))

    def to_picture(self, size: tuple[int, int]) -> Floats:
        """(3, 3) homography from the upright sheet to the picture, px of both, centres of pixels at
        integers; the picture's middle stays the origin, and its scale there, on the sheet.

        Args:
            size: width and height of the picture, px.
        """
        width, height = size
        focal = self.focal * max(size)
        camera = np.array([[focal, 0, (width - 1) / 2], [0, focal, (height - 1) / 2], [0, 0, 1]])
        plane = np.column_stack([self.rotation[:, 0], self.rotation[:, 1], [0.0, 0.0, focal]])
        return camera @ plane


def segments_of(grey: npt.NDArray[np.uint8]) -> Segments:
    """The straight pieces of line of a picture.

    Args:
        grey: (h, w) uint8.
    """
    height, width = grey.shape
    factor = min(1.0, _LONGEST / max(grey.shape))
    if factor < 1.0:
        size = (round(width * factor), round(height * factor))
        grey = np.asarray(cv2.resize(grey, size, interpolation=cv2.INTER_AREA), dtype=np.uint8)
    found = cv2.createLineSegmentDetector().detect(grey)[0]
    ends = np.zeros((0, 2, 2)) if found is None else found.reshape(-1, 2, 2).astype(np.float64)
    lengths = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    longest = max(grey.shape)
    ends, lengths = ends[lengths >= _SHORTEST * longest], lengths[lengths >= _SHORTEST * longest]
    middle = (np.array(grey.shape[::-1]) - 1) / 2
    return Segments(
        (ends.mean(axis=1) - middle) / longest,
        (ends[:, 1] - ends[:, 0]) / lengths[:, None],
        lengths / longest,
        _NOISE + _END / lengths,
    )


def explained(sight: Sight, segments: Segments) -> float:
    """The length of the segments that are level or upright on the sheet, as exactly as directions
    are known; in the longer side of the picture."""
    return _explained(sight.rotation, sight.focal, segments)


def find_turned(segments: Segments) -> Sight:
    """The camera straight above the sheet, turned about the way in which it looks."""
    angles = _angles(np.eye(3), _FOCAL, segments)
    common = _commonest(angles, segments)
    for reach in _REACHES[1:]:
        aside = _quarter(angles - common)
        near = np.abs(aside) < reach
        if near.any():
            weights = segments.lengths[near] / segments.noise[near] ** 2
            common += float(np.average(aside[near], weights=weights))
    return Sight(_turn(common), _FOCAL)


def find_sight(segments: Segments) -> Sight:
    """The camera that sees most of the segments as level or upright lines of a sheet."""
    starts = []
    for tilt in _TILTS:
        for way in _WAYS if tilt else _WAYS[:1]:
            tilted = _rotation(np.array([np.cos(way), np.sin(way), 0.0]) * tilt)
            angles = _angles(tilted, _FOCAL, segments)
            rotation = tilted @ _turn(_commonest(angles, segments))
            starts.append((_explained(rotation, _FOCAL, segments, _REACHES[1]), rotation))
    starts.sort(key=lambda start: -start[0])
    found = [_fitted(Sight(rotation, _FOCAL), segments) for _, rotation in starts[:3]]
    return max(found, key=lambda sight: explained(sight, segments))


def _fitted(sight: Sight, segments: Segments) -> Sight:
    """The camera near a first one that the lines which run its way tell best."""
    for reach in _REACHES:
        errors = np.abs(_errors(sight.rotation, sight.focal, segments))
        near = errors.min(axis=0) < reach
        if near.sum() < _FEWEST:
            break
        this_segments = Segments(
            segments.middles[near],
            segments.ways[near],
            segments.lengths[near],
            segments.noise[near],
        )
        residuals = partial(_residuals, sight, this_segments, errors[:, near].argmin(axis=0))
        found = least_squares(residuals, np.zeros(4), loss="soft_l1")
        sight = Sight(*_moved(sight, found.x))
    return sight


def _residuals(
    start: Sight, segments: Segments, axes: npt.NDArray[np.intp], values: Floats
) -> Floats:
    """(n + 1,) how far the segments are off their directions, and the focal length off its usual
    one, in their standard deviations.

    Args:
        start: the camera that is moved.
        segments: that are level or upright.
        axes: (n,) 0 for level ones, 1 for upright ones.
        values: (4,) as of :func:`_moved`.
    """
    rotation, focal = _moved(start, values)
    off = _errors(rotation, focal, segments)[axes, np.arange(len(axes))]
    weights = np.sqrt(segments.lengths / segments.lengths.sum()) / segments.noise
    prior = np.log(focal / _FOCAL) / _FOCAL_SPREAD / np.sqrt(len(axes))
    return np.append(weights * off, prior)


def _moved(sight: Sight, values: Floats) -> tuple[Floats, float]:
    """Rotation and focal length of a camera turned by a vector, with the logarithm of its focal
    length changed."""
    focal = sight.focal * float(np.exp(np.clip(values[3], -2.0, 2.0)))
    return _rotation(values[:3]) @ sight.rotation, focal


def _errors(rotation: Floats, focal: float, segments: Segments) -> Floats:
    """(2, n) radians between the segments and the sheet's level and upright directions there."""
    vanishing = np.array([[focal], [focal], [1.0]]) * rotation[:, :2]
    errors = []
    for point in vanishing.T:
        toward = point[:2] - point[2] * segments.middles
        sine = toward[:, 0] * segments.ways[:, 1] - toward[:, 1] * segments.ways[:, 0]
        cosine = (toward * segments.ways).sum(axis=1)
        angle = np.arctan2(sine, cosine)
        errors.append((angle + np.pi / 2) % np.pi - np.pi / 2)
    return np.array(errors)


def _explained(
    rotation: Floats, focal: float, segments: Segments, reach: float | None = None
) -> float:
    if np.arccos(np.clip(rotation[2, 2], -1.0, 1.0)) > _STEEPEST:
        return 0.0
    least = np.abs(_errors(rotation, focal, segments)).min(axis=0)
    near = least < (2.0 * segments.noise if reach is None else reach)
    return float(segments.lengths[near].sum())


def _angles(tilted: Floats, focal: float, segments: Segments) -> Floats:
    """(n,) radians of the segments on a sheet of a tilt, modulo a quarter of a turn."""
    # A segment runs on the sheet's plane where the plane of its sight cuts it.
    sights = np.column_stack([segments.middles, np.full(len(segments.middles), focal)])
    ways = np.column_stack([segments.ways, np.zeros(len(segments.ways))])
    along = np.cross(np.cross(sights, ways), tilted[:, 2])
    return _quarter(np.arctan2(along @ tilted[:, 1], along @ tilted[:, 0]))


def _commonest(angles: Floats, segments: Segments) -> float:
    """The angle that most of the segments' length has about."""
    if not len(angles):
        return 0.0
    near = np.abs(_quarter(angles[:, None] - angles)) < _REACHES[1]
    return float(angles[int(np.argmax(near @ segments.lengths))])


def _quarter(angles: Floats) -> Floats:
    """Radians modulo a quarter of a turn, from -pi/4 to pi/4."""
    return (angles + np.pi / 4) % (np.pi / 2) - np.pi / 4


def _turn(angle: float) -> Floats:
    return _rotation(np.array([0.0, 0.0, angle]))


def _rotation(vector: Floats) -> Floats:
    return np.asarray(cv2.Rodrigues(np.asarray(vector, np.float64))[0])
