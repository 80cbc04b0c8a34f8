"""Strokes of a view as lines in the plane of the part's axes, and back."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.projection_planes import role_plane
from gaussiancad_core.model.views import Arc, Segment
from gaussiancad_core.proposing.lines_by_plane import ROUND, Floats

_SAMPLE = 9
"""Points along a straight line that tell where it runs."""


@dataclass(frozen=True, eq=False)
class StrokeLine:
    """A stroke in its plane.

    Attributes:
        stroke: as the view has it.
        points: (n, 2) mm along it, the ends first and last.
    """

    stroke: DrawnStroke
    points: Floats

    @property
    def is_whole(self) -> bool:
        """Whether it is a whole circle."""
        return isinstance(self.stroke, Arc) and self.stroke.is_full

    @property
    def is_straight(self) -> bool:
        """Whether it is a straight stroke."""
        return isinstance(self.stroke, Segment)

    @property
    def length(self) -> float:
        """mm."""
        return float(np.hypot(*np.diff(self.points, axis=0).T).sum())

    @property
    def ends(self) -> Floats:
        """(2, 2) mm."""
        return self.points[[0, -1]]

    def lies_at(self, place: Floats, near: float) -> bool:
        """Whether an end of it is at a place."""
        return bool(np.hypot(*(self.ends - place).T).min() <= near)

    def leads(self, place: Floats, corner: Floats) -> bool:
        """Whether it leads from a place away from a corner."""
        far = self.ends[np.hypot(*(self.ends - place).T).argmax()]
        return float((far - place) @ (place - corner)) > 0.0


def stroke_lines(strokes: Sequence[DrawnStroke], role: Role) -> list[StrokeLine]:
    """The strokes of a view in its plane."""
    signs = np.array(role_plane(role).signs)
    return [StrokeLine(stroke, _points(stroke) * signs) for stroke in strokes]


def _points(stroke: DrawnStroke) -> Floats:
    if isinstance(stroke, Segment):
        ways = np.linspace(0.0, 1.0, _SAMPLE)[:, None]
        return np.asarray(stroke.start) * (1.0 - ways) + np.asarray(stroke.end) * ways
    return np.asarray(stroke.sample(stroke.length / ROUND))


def led(line: StrokeLine, ends: Floats) -> StrokeLine:
    """A straight line between other ends, (2, 2) mm."""
    ways = np.linspace(0.0, 1.0, _SAMPLE)[:, None]
    return replace(line, points=ends[0] * (1.0 - ways) + ends[1] * ways)


def as_stroke(line: StrokeLine, signs: Floats) -> DrawnStroke:
    """A line as a stroke of its view.

    Args:
        line: in its plane.
        signs: (2,) of the plane's coordinates in terms of the view's.
    """
    if not isinstance(line.stroke, Segment):
        return line.stroke
    start, end = (line.ends * signs).tolist()
    return replace(line.stroke, start=tuple(start), end=tuple(end))
