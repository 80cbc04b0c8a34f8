"""What the lines of a sheet were taken for, how surely, and what else they may be.

The labels of lines decide what ink is the part's; strokes are read from that ink later.  A stroke,
or an annotation, is as sure as the lines are along which it runs.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.arcs import CircularArc
from gaussiancad_core.geometry.chains import LineSegment
from gaussiancad_core.geometry.points import FULL_TURN, to_point
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.views import Stroke
from gaussiancad_core.sheet.annotations.inked_shapes import InkedShape, points_along
from gaussiancad_core.sheet.labels.ink_classes import PART, Evidence, InkClass
from gaussiancad_core.sheet.labels.labels_network import log_odds_factor, part_odds
from gaussiancad_core.sheet.labels.line_decoding import LabelledRun, likeliest
from gaussiancad_core.sheet.picture_noise import COARSE_STEP
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_protocol.reading_kinds import DOUBT

Floats = npt.NDArray[np.float64]

_LONG = 5.0
"""Length of a line from which a doubt of it matters, in widths of a line."""

_LEAST_POINTS = 4
"""Points of a curve at least: fewer are left where lines cross."""

_CENTRE = 0.5
"""px from the corner of a pixel, where strokes count from, to its centre, where ink does."""

_REACH = 1.0
"""Distance from a stroke to a line that it runs along, in widths of a line; and px more."""

_SPARE_PX = 1.0

_TELLING = 0.2
"""Share of a stroke that runs along a line from which that tells of all of it."""

_SURE, _LEAST = 0.9, 0.5
"""Confidence from which a label takes nothing from a stroke, and what a stroke weighs at least."""


@dataclass(frozen=True, eq=False)
class LabelledLine:
    """A line of the sheet, or a stretch of one, with what it was taken for.

    Attributes:
        points: (n, 2) px of the upright sheet, at most two px apart.
        length: px.
        ink: what it is taken for.
        otherwise: what it would be if that is wrong: an edge would be annotation, and the other
            way round.
        margin: log-odds of what it is taken for, from its own ink; negative where something else
            decided.
        confidence: 0 to 1, how sure that is.
        why: what decided.
        curve: px, of a straight one and of a piece of a circle; None of what is neither.
    """

    points: Floats
    length: float
    ink: InkClass
    otherwise: InkClass
    margin: float
    confidence: float
    why: Evidence
    curve: LineSegment | CircularArc | None = None

    @property
    def is_part(self) -> bool:
        """Whether it is an edge."""
        return self.ink in PART

    @property
    def box(self) -> Box:
        """Around it, px."""
        (x0, y0), (x1, y1) = self.points.min(axis=0).tolist(), self.points.max(axis=0).tolist()
        return x0, y0, x1, y1


def labelled_lines(
    shapes: Sequence[InkedShape], labelled: Sequence[Sequence[LabelledRun]]
) -> tuple[LabelledLine, ...]:
    """The decisions on the lines and circles of a sheet.

    Args:
        shapes: lines and circles.
        labelled: the pieces of each.
    """
    return tuple(
        _line(shape, piece)
        for shape, pieces in zip(shapes, labelled, strict=True)
        for piece in pieces
    )


def labelled_curves(
    points: Floats, chains: npt.NDArray[np.integer], log_p: Floats
) -> tuple[LabelledLine, ...]:
    """The decisions on curves that are no lines or circles.

    Args:
        points: (n, 2) px, one a px of a curve, centres of pixels at integers.
        chains: (n,) number of the curve that each belongs to; a curve is all of one kind.
        log_p: (n, classes) log-probabilities there.
    """
    found = []
    odds = part_odds(log_p)
    order = np.argsort(chains, kind="stable")
    for members in np.split(order, np.flatnonzero(np.diff(chains[order])) + 1):
        if len(members) < _LEAST_POINTS:
            continue
        margin, mean = float(odds[members].mean()), log_p[members].mean(axis=0)
        ink, otherwise = (likeliest(mean, part=part) for part in (margin > 0.0, margin <= 0.0))
        stated = abs(margin), _share(abs(margin) * log_odds_factor()), Evidence.NETWORK
        values = points[members] + _CENTRE
        found.append(LabelledLine(values, float(len(members)), ink, otherwise, *stated))
    return tuple(found)


def _line(shape: InkedShape, piece: LabelledRun) -> LabelledLine:
    points = points_along(shape.geometry, piece.run.run, COARSE_STEP) + _CENTRE
    margin = piece.margin if piece.is_part else -piece.margin
    # Near a tie its ink tells nothing, whatever speaks for the decision beside it.
    stated = abs(margin) * log_odds_factor()
    stated = stated if piece.support is None else min(stated, piece.support)
    return LabelledLine(
        points,
        piece.run.run.length,
        piece.ink,
        piece.otherwise(),
        margin,
        _share(stated),
        piece.why,
        _curve(shape, piece, points),
    )


def _curve(shape: InkedShape, piece: LabelledRun, points: Floats) -> LineSegment | CircularArc:
    geometry, run = shape.geometry, piece.run.run
    if isinstance(geometry, Line):
        return LineSegment(to_point(points[0]), to_point(points[-1]))
    (x, y), radius = geometry.centre, geometry.radius
    sweep = min(run.length / radius, FULL_TURN)
    return CircularArc((x + _CENTRE, y + _CENTRE), radius, run.start / radius, sweep)


@dataclass(frozen=True, eq=False)
class SheetLabels:
    """The lines of a sheet, or of a part of it, with what they were taken for.

    Attributes:
        lines: in any order; none where no labels told them.
        stroke_width: px of the sheet's lines.
    """

    lines: tuple[LabelledLine, ...] = ()
    stroke_width: float = 1.0

    def within(self, box: Box) -> "SheetLabels":
        """Those that meet a box, px of the upright sheet."""
        return replace(self, lines=tuple(line for line in self.lines if meets(line.box, box)))

    def doubtful(self) -> tuple[LabelledLine, ...]:
        """Those that may be either and are so long that it matters, the most doubtful first."""
        long = _LONG * self.stroke_width
        found = [line for line in self.lines if line.confidence < DOUBT and line.length > long]
        return tuple(sorted(found, key=lambda line: line.confidence))

    def along(self, points: Floats, part: bool) -> LabelledLine | None:
        """The line that tells what a stroke is: the least sure of those along which it runs; None
        where it runs along none.  What a person said goes before.

        A line counts from a fifth of the stroke, or from the length of which a doubt matters.

        Args:
            points: (n, 2) px of the upright sheet, evenly along the stroke.
            part: whether it is of the part.
        """
        group = self._groups[part]
        if group.tree is None or len(points) < 2:
            return None
        away, nearest = group.tree.query(points)
        near = away <= _REACH * self.stroke_width + _SPARE_PX
        shares = np.bincount(group.owners[nearest[near]], minlength=len(group.lines)) / len(points)
        length = float(np.hypot(*np.diff(points, axis=0).T).sum())
        telling = (shares >= _TELLING) | (shares * length > _LONG * self.stroke_width)
        found = [group.lines[k] for k in np.flatnonzero(telling)]
        return min(found, key=_by_confidence, default=None)

    def weighed(self, strokes: Iterable[Stroke]) -> tuple[Stroke, ...]:
        """Strokes of the part, those of doubtful labels with less confidence: these are given up
        first.

        Args:
            strokes: px of the upright sheet.
        """
        found = []
        for stroke in strokes:
            line = self.along(stroke.sample(COARSE_STEP), part=True)
            weight = solver_weight(line.confidence) if line is not None else 1.0
            found.append(replace(stroke, confidence=min(stroke.confidence, weight)))
        return tuple(found)

    @cached_property
    def _groups(self) -> "dict[bool, _Group]":
        return {
            part: _Group([line for line in self.lines if line.is_part is part])
            for part in (True, False)
        }


NO_LABELS = SheetLabels()
"""Of a sheet whose lines no labels told."""


class _Group:
    """Lines of the part, or of annotations, and whose each of their points is."""

    def __init__(self, lines: list[LabelledLine]) -> None:
        self.lines = lines
        counts = [len(line.points) for line in lines]
        self.owners = np.repeat(np.arange(len(lines)), counts)
        self.tree = None
        if lines:
            # A sheet whose strokes are known has none.
            from scipy.spatial import cKDTree

            self.tree = cKDTree(np.concatenate([line.points for line in lines]))


def _by_confidence(line: LabelledLine) -> tuple[bool, float]:
    return line.why is not Evidence.PERSON, line.confidence


def meets(one: Box, other: Box) -> bool:
    """Whether two boxes have a point in common."""
    return one[0] <= other[2] and other[0] <= one[2] and one[1] <= other[3] and other[1] <= one[3]


def meets_any(box: Box, others: npt.NDArray[np.float64]) -> bool:
    """Whether a box has a point in common with any of (n, 4) others."""
    if not len(others):
        return False
    apart = (box[0] > others[:, 2]) | (others[:, 0] > box[2])
    apart |= (box[1] > others[:, 3]) | (others[:, 1] > box[3])
    return not bool(apart.all())


def solver_weight(confidence: float) -> float:
    """What a stroke weighs whose label has a confidence: a doubtful one is given up first.

    No less than what is drawn: a label says nothing of visible or hidden.
    """
    return 1.0 if confidence >= _SURE else max(confidence, _LEAST)


def _share(log_odds: float) -> float:
    """Probability of log-odds."""
    return float(0.5 + 0.5 * np.tanh(0.5 * log_odds))
