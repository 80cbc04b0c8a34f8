"""Noise on exact drawings: missing and spurious strokes, jitter, edges of the wrong length.

All functions are pure: views and a seed give views.  A pixel is the part's longest extent by 600,
about what a view of a 1920 x 1080 sheet has.
"""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment

PIXELS = 600
"""Pixels of the longest extent."""

SHARE = 0.05
"""Share of the strokes that vanish, and as many that are added."""

JITTER_PX = 1.0
"""px by which ends, centres and radii are off at most."""

LENGTH_PX = 2.0
"""px by which ends are too far out or too far in at most: on a sheet that is seen after magnifying
it five times, as in the robustness test of the GaussianCAD paper (its figure 5)."""

_REACH = (0.05, 0.3)
"""Lengths of spurious strokes as shares of the longest extent."""


def pixel(views: DrawnViews) -> float:
    """mm of a pixel."""
    return max(views.size) / PIXELS


def missing_and_spurious(views: DrawnViews, seed: int, share: float = SHARE) -> DrawnViews:
    """Without a share of all strokes, at least one, and with as many that no edge has."""
    random = np.random.default_rng(seed)
    places = [(role, index) for role in views.roles for index in range(len(views.strokes[role]))]
    count = max(1, round(share * len(places)))
    lost = {places[i] for i in random.choice(len(places), count, replace=False)}
    strokes = {
        role: [stroke for index, stroke in enumerate(drawn) if (role, index) not in lost]
        for role, drawn in views.strokes.items()
    }
    for _ in range(count):
        role = views.roles[int(random.integers(len(views.roles)))]
        strokes[role].append(_spurious(views, role, random))
    return replace(views, strokes={role: tuple(drawn) for role, drawn in strokes.items()})


def _spurious(views: DrawnViews, role: Role, random: np.random.Generator) -> Segment:
    """A line somewhere in the view's box, along an axis in two cases of three."""
    low, high = _box(views, role)
    start = random.uniform(low, high)
    length = max(views.size) * random.uniform(*_REACH)
    angle = float(random.choice([0.0, np.pi / 2.0, random.uniform(0.0, np.pi)]))
    end = np.clip(start + length * np.array([np.cos(angle), np.sin(angle)]), low, high)
    if np.hypot(*(end - start)) < 0.2 * length:
        end = np.clip(2.0 * start - end, low, high)
    linetype = Linetype.VISIBLE if random.random() < 0.5 else Linetype.HIDDEN
    return Segment(_pair(start), _pair(end), linetype)


def _box(views: DrawnViews, role: Role) -> np.ndarray:
    """(2, 2) lower and upper corner of a view in its plane."""
    frame = role.frame
    box = []
    for axis, sign in (frame.right_axis, frame.up_axis):
        extent = views.size[axis.value]
        box.append((0.0, extent) if sign > 0 else (-extent, 0.0))
    return np.array(box).T


def jittered(views: DrawnViews, seed: int, pixels: float = JITTER_PX) -> DrawnViews:
    """With every end, centre and radius off by up to some pixels; chains move as a whole."""
    random = np.random.default_rng(seed)
    reach = pixels * pixel(views)

    def off() -> np.ndarray:
        angle, radius = random.uniform(0.0, 2.0 * np.pi), reach * np.sqrt(random.uniform())
        return radius * np.array([np.cos(angle), np.sin(angle)])

    def moved(stroke: DrawnStroke) -> DrawnStroke:
        if isinstance(stroke, Segment):
            start, end = np.array(stroke.start) + off(), np.array(stroke.end) + off()
            return replace(stroke, start=_pair(start), end=_pair(end))
        if isinstance(stroke, Arc):
            radius = max(stroke.radius + random.uniform(-reach, reach), 0.25 * stroke.radius)
            return replace(stroke, centre=_pair(np.array(stroke.centre) + off()), radius=radius)
        return stroke.mapped(Similarity(offset=_pair(off())))

    return _each(views, moved, reach)


def of_wrong_length(views: DrawnViews, seed: int, pixels: float = LENGTH_PX) -> DrawnViews:
    """With every end prolonged or cut by up to some pixels along its stroke.

    Whole circles have no ends, and strokes keep three quarters of their length.
    """
    random = np.random.default_rng(seed)
    reach = pixels * pixel(views)

    def changed(stroke: DrawnStroke) -> DrawnStroke:
        if stroke.is_closed or (isinstance(stroke, Ellipse) and stroke.sweep > 6.28):
            return stroke
        most = min(reach, 0.125 * stroke.length)
        low, high = random.uniform(-most, most), stroke.length + random.uniform(-most, most)
        return stroke.part(low, high)

    return _each(views, changed, reach)


def _each(
    views: DrawnViews, change: Callable[[DrawnStroke], DrawnStroke], tolerance: float
) -> DrawnViews:
    strokes = {
        role: tuple(change(stroke) for stroke in drawn) for role, drawn in views.strokes.items()
    }
    return DrawnViews(strokes, views.size, tolerance)


def _pair(point: np.ndarray) -> tuple[float, float]:
    x, y = point.tolist()
    return x, y
