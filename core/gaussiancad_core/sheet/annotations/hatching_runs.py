"""Hatching: cut material is filled with parallel slanted lines at equal distances (ISO 128-3).

Four lines and more, each as far from the next as the next from the one after, are a family.  Each
of them must end where another stroke passes by: an edge of the part ends at a corner instead.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.sheet.annotations.annotation_marks import Mark, Mask
from gaussiancad_core.sheet.annotations.erase import Kinds
from gaussiancad_core.sheet.annotations.inked_shapes import InkedShape, points_along
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.line_conventions import HATCHING, UNEVEN
from gaussiancad_core.sheet.picture_noise import PARALLEL
from gaussiancad_core.sheet.tracing.ink_runs import Run
from gaussiancad_core.sheet.tracing.ink_shapes import sample
from gaussiancad_core.sheet.tracing.ridges import RidgePoints

Floats = npt.NDArray[np.float64]
Pixels = npt.NDArray[np.uint8]

_SLANTED = np.radians(12.0)
"""Least angle between hatching and the sheet's own directions."""

_LONG = 6.0
"""Length of the lines that show a family, in stroke widths; its others may be shorter."""

_PITCH = (2.0, 25.0)
"""Distance of the lines, in stroke widths."""

_FREE_PX = 1.5

_LOOSE_PX = 2.0
"""By how much the end of a piece may lie beside the direction of its family."""

_ENDING = 0.6
"""Share of the ends of a family's lines at which another stroke passes by."""

_MISSING = 3.0
"""Distances from one line to the next found at most."""

_REACH = 1.1
"""Distances of the lines over which their area is closed and looked around: one line may be
missing."""

_BEYOND = 12.0
"""How far from its other lines hatching may go on beyond a bore, in distances of the lines."""

_STRAY = 5.0
"""Length of a piece that was taken for something else at most, in distances of the lines."""

_INK = 0.4
"""Ink beside an end from which there is a stroke."""


@dataclass(frozen=True, eq=False)
class Hatching:
    """The hatching of a sheet.

    Attributes:
        runs: (shape, run) indices of its lines.
        area: (h, w) bool, cut material.
        loose: (n,) bool, ridge points that are its shortest pieces.
        marks: one for each hatched area.
    """

    runs: frozenset[tuple[int, int]]
    area: Mask
    loose: npt.NDArray[np.bool_]
    marks: tuple[Mark, ...]

    def kinds(self, shapes: Sequence[InkedShape]) -> Kinds:
        """For each run of each shape whether it is hatching."""
        return [
            [AnnotationKind.HATCHING if (k, j) in self.runs else None for j in range(len(s.runs))]
            for k, s in enumerate(shapes)
        ]

    def shortened(self, shapes: Sequence[InkedShape], by: float) -> list[InkedShape]:
        """The shapes, the lines of the hatching shorter at both ends by some px: they run on
        through the strokes that they end at."""
        found = []
        for k, shape in enumerate(shapes):
            runs = []
            for j, run in enumerate(shape.runs):
                cut = min(by, 0.5 * run.run.length) if (k, j) in self.runs else 0.0
                runs.append(replace(run, run=Run(run.run.start + cut, run.run.end - cut)))
            found.append(InkedShape(shape.geometry, tuple(runs)))
        return found

    def others(self, shapes: Sequence[InkedShape]) -> list[InkedShape]:
        """The shapes without the runs that are hatching."""
        return [
            InkedShape(
                s.geometry, tuple(r for j, r in enumerate(s.runs) if (k, j) not in self.runs)
            )
            for k, s in enumerate(shapes)
        ]


@dataclass(frozen=True)
class _Piece:
    """A slanted run: which one, its direction, its interval along it, its distance across it."""

    key: tuple[int, int]
    shape: InkedShape
    run: Run
    angle: float


@dataclass(frozen=True)
class _Family:
    """Lines at equal distances.

    Attributes:
        pieces: of them.
        angle: of their direction.
        pitch: their distance in px.
        offset: of one of them across their direction, in px.
    """

    pieces: tuple[_Piece, ...]
    angle: float
    pitch: float
    offset: float

    @property
    def way(self) -> Floats:
        """(2,) unit vector along the lines."""
        return np.array([np.cos(self.angle), np.sin(self.angle)])

    def area(self, shape: tuple[int, ...]) -> Pixels:
        """(h, w) uint8, where the lines lie side by side."""
        lines = np.zeros(shape, np.uint8)
        for piece in self.pieces:
            start, end = np.rint(_ends(piece) * 8).astype(int).tolist()
            cv2.line(lines, start, end, 1, 1, shift=3)
        filled = cv2.morphologyEx(lines, cv2.MORPH_CLOSE, self._kernel())
        return np.asarray(filled, dtype=np.uint8)

    def around(self, area: Pixels) -> Pixels:
        """The area with the corners in which its shortest lines lie."""
        return np.asarray(cv2.dilate(area, self._kernel()), dtype=np.uint8)

    def with_others(self, pieces: Sequence[_Piece], sheet: CleanSheet) -> "_Family":
        """The family with all pieces that lie beside its own, or beside one of those, and end where
        another stroke passes by: a chamfer may lie on a line of the hatching by chance.  Beyond a
        bore, its lines go on; there both ends of two of them at least have to be passed."""
        normal = np.array([-self.way[1], self.way[0]])
        ends = np.array([_ends(piece) for piece in pieces])
        spans = np.sort(ends @ self.way, axis=1)
        across = (ends @ normal).mean(axis=1)
        fitting = self.on_lines(ends.mean(axis=1))
        known = {piece.key for piece in self.pieces}
        member = np.array([piece.key in known for piece in pieces])
        passed = np.array([_ending([piece], sheet) for piece in pieces])
        fitting &= member | (passed > 0.0)
        middles = ends.mean(axis=1)
        away = middles[:, None] - middles[member]
        near_by = np.hypot(away[..., 0], away[..., 1]).min(axis=1) < _BEYOND * self.pitch
        apart = fitting & ~member & near_by & (passed == 1.0)
        if len(np.unique(np.round(across[apart] / self.pitch))) > 1:
            member |= apart
        waiting = list(np.flatnonzero(member))
        while waiting:
            k = waiting.pop()
            shared = np.minimum(spans[:, 1], spans[k, 1]) - np.maximum(spans[:, 0], spans[k, 0])
            near = (np.abs(across - across[k]) < 2.3 * self.pitch) & (shared > -self.pitch)
            new = np.flatnonzero(near & fitting & ~member)
            member[new] = True
            waiting.extend(new)
        return replace(self, pieces=tuple(pieces[k] for k in np.flatnonzero(member).tolist()))

    def mistaken(self, shapes: Sequence[InkedShape], area: Pixels) -> set[tuple[int, int]]:
        """Keys of short runs of other shapes that lie along the lines in an area: flat arcs."""
        found = set()
        for k, shape in enumerate(shapes):
            for j, run in enumerate(shape.runs):
                if run.run.length > _STRAY * self.pitch:
                    continue
                points = points_along(shape.geometry, run.run, 2.0)
                columns = np.clip(np.rint(points[:, 0]).astype(int), 0, area.shape[1] - 1)
                rows = np.clip(np.rint(points[:, 1]).astype(int), 0, area.shape[0] - 1)
                if area[rows, columns].all() and self.on_lines(points).all():
                    found.add((k, j))
        return found

    def on_lines(self, points: Floats) -> npt.NDArray[np.bool_]:
        """(n,) whether points lie on lines of the family."""
        normal = np.array([-self.way[1], self.way[0]])
        turns = (points @ normal - self.offset) / self.pitch
        return np.abs(turns - np.round(turns)) * self.pitch < max(_FREE_PX, UNEVEN * self.pitch)

    def _kernel(self) -> Pixels:
        reach = 2 * int(np.ceil(_REACH * self.pitch)) + 1
        kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (reach, reach))
        return np.asarray(kernel, dtype=np.uint8)


def find_hatching(
    sheet: CleanSheet,
    shapes: Sequence[InkedShape],
    ridges: RidgePoints,
    free: npt.NDArray[np.bool_],
) -> Hatching:
    """Find the hatching of a sheet.

    Args:
        sheet: without frame and writing.
        shapes: its lines and circles with their runs.
        ridges: of the sheet.
        free: (n,) ridge points that no shape explains.
    """
    pieces = _slanted(shapes)
    chosen: set[tuple[int, int]] = set()
    area = np.zeros(sheet.ink.shape, np.uint8)
    loose = np.zeros(len(ridges.points), dtype=bool)
    for angle in _directions(pieces, sheet.stroke_width):
        this_pieces = [piece for piece in pieces if _is_parallel(piece, angle)]
        for seed in _families(this_pieces, angle, sheet):
            family = seed.with_others(this_pieces, sheet)
            filled = family.area(area.shape)
            near = family.around(filled)
            chosen |= {piece.key for piece in family.pieces}
            chosen |= family.mistaken(shapes, near)
            area |= filled
            columns, rows = np.rint(ridges.points).astype(int).T
            along = np.abs(ridges.tangents @ family.way) > np.cos(np.radians(20.0))
            short = free & along & (near[rows, columns] > 0)
            loose[short] |= family.on_lines(ridges.points[short])
    return Hatching(frozenset(chosen), area > 0, loose, _marks(area))


def _slanted(shapes: Sequence[InkedShape]) -> list[_Piece]:
    found = []
    for index, shape in enumerate(shapes):
        if not isinstance(shape.geometry, Line):
            continue
        angle = float(np.arctan2(shape.geometry.direction[1], shape.geometry.direction[0])) % np.pi
        if _between(2.0 * angle, 0.0) < 2.0 * _SLANTED:
            continue
        found += [_Piece((index, k), shape, run.run, angle) for k, run in enumerate(shape.runs)]
    return found


def _between(one: float, other: float) -> float:
    """Angle between two directions modulo half a turn."""
    return float(abs((one - other + np.pi / 2) % np.pi - np.pi / 2))


def _is_parallel(piece: _Piece, angle: float) -> bool:
    """Whether a piece runs along a direction; the shorter it is, the less exactly it is known."""
    return _between(piece.angle, angle) < max(PARALLEL, _LOOSE_PX / piece.run.length)


def _directions(pieces: Sequence[_Piece], stroke_width: float) -> list[float]:
    """The directions that many long pieces share, those with most length first."""
    long = [piece for piece in pieces if piece.run.length > _LONG * stroke_width]
    angles = np.array([piece.angle for piece in long])
    lengths = np.array([piece.run.length for piece in long])
    order = np.argsort(angles, kind="stable")
    # After half a turn they come again: those near to each are in a row, whichever it is.
    around = np.concatenate([angles[order] + turn for turn in (-np.pi, 0.0, np.pi)])
    first = np.searchsorted(around, angles - PARALLEL, side="right")
    last = np.searchsorted(around, angles + PARALLEL, side="left")
    found: list[float] = []
    left = np.ones(len(long), dtype=bool)
    while left.sum() >= HATCHING:
        rows = np.tile(np.where(left, lengths, 0.0)[order], 3)
        total = np.concatenate([[0.0], np.cumsum(rows)])
        best = int(np.argmax(np.where(left, total[last] - total[first], -1.0)))
        offset = (angles - angles[best] + np.pi / 2) % np.pi - np.pi / 2
        near = left & (np.abs(offset) < PARALLEL)
        if near.sum() < HATCHING:
            break
        found.append(float(angles[best] + np.average(offset[near], weights=lengths[near])))
        left &= ~near
    return found


def _families(pieces: Sequence[_Piece], angle: float, sheet: CleanSheet) -> list["_Family"]:
    """Families of one direction."""
    way = np.array([np.cos(angle), np.sin(angle)])
    normal = np.array([-way[1], way[0]])
    long = [piece for piece in pieces if piece.run.length > _LONG * sheet.stroke_width]
    if len(long) < HATCHING:
        return []
    ends = np.array([_ends(piece) for piece in long])
    spans = np.sort(ends @ way, axis=1)
    offsets = (ends @ normal).mean(axis=1)
    low, high = (factor * sheet.stroke_width for factor in _PITCH)
    steps = _steps(spans, offsets, (low, high))
    groups = _joined(steps, len(long))
    families = []
    for members in groups:
        this_pieces = [long[k] for k in members]
        distances = [steps[k][1] for k in members if k in steps]
        if not distances:
            continue
        lines, pitch, first = _even(offsets[members], float(np.median(distances)))
        if lines >= HATCHING and _ending(this_pieces, sheet) > _ENDING:
            families.append(_Family(tuple(this_pieces), angle, pitch, first))
    return families


def _even(offsets: Floats, pitch: float) -> tuple[int, float, float]:
    """How many lines there are, their distance over all of them, and where the first one lies."""
    order = np.sort(offsets)
    numbers = np.concatenate([[0.0], np.cumsum(np.round(np.diff(order) / pitch))])
    if numbers[-1] == 0.0:
        return 1, pitch, float(order[0])
    exact, first = np.polyfit(numbers, order, 1)
    return len(np.unique(numbers)), float(exact), float(first)


def _steps(
    spans: Floats, offsets: Floats, limits: tuple[float, float]
) -> dict[int, tuple[int, float]]:
    """For each piece the nearest one beside it, and their distance."""
    steps = {}
    for k, (start, end) in enumerate(spans):
        shared = np.minimum(end, spans[:, 1]) - np.maximum(start, spans[:, 0])
        away = offsets - offsets[k]
        neighbour = (away > limits[0] / 2) & (shared > 0.0)
        if not neighbour.any():
            continue
        nearest = int(np.argmin(np.where(neighbour, away, np.inf)))
        if limits[0] <= away[nearest] <= limits[1]:
            steps[k] = nearest, float(away[nearest])
    return steps


def _joined(steps: dict[int, tuple[int, float]], count: int) -> list[list[int]]:
    """Pieces in groups: neighbours whose distance is that of their next neighbours."""
    parent = list(range(count))

    def root(k: int) -> int:
        while parent[k] != k:
            k = parent[k]
        return k

    if not steps:
        return []
    usual = _usual(np.array([distance for _, distance in steps.values()]))
    for k, (nearest, distance) in steps.items():
        # A line may be missing, or have been taken for a flat arc.
        times = float(np.clip(np.round(distance / usual), 1.0, _MISSING))
        if abs(distance / times - usual) <= max(_FREE_PX, UNEVEN * usual):
            parent[root(k)] = root(nearest)
    groups: dict[int, list[int]] = {}
    for k in range(count):
        groups.setdefault(root(k), []).append(k)
    return [members for members in groups.values() if len(members) >= HATCHING]


def _usual(distances: Floats) -> float:
    """The distance that most others are like."""
    like = np.abs(distances[:, None] - distances) <= np.maximum(_FREE_PX, UNEVEN * distances)
    return float(distances[int(np.argmax(like.sum(axis=1)))])


def _ends(piece: _Piece) -> Floats:
    """(2, 2) px of both ends."""
    line = piece.shape.line
    return np.array([line.at(piece.run.start), line.at(piece.run.end)])


def _ending(pieces: Sequence[_Piece], sheet: CleanSheet) -> float:
    """Share of the ends at which another stroke passes by: it shows on both sides of the line."""
    passed = []
    radius = 1.5 * sheet.stroke_width + 2.0
    sides = np.radians(np.arange(20.0, 156.0, 9.0))
    for piece in pieces:
        ends = _ends(piece)
        way = (ends[1] - ends[0]) / max(piece.run.length, 1e-9)
        for end, outward in ((ends[0], -way), (ends[1], way)):
            ahead = np.arctan2(outward[1], outward[0])
            # Behind the end lies the line itself.
            turns = ahead + np.stack([sides, -sides])
            inked = sample(
                sheet.weight,
                end[0] + radius * np.cos(turns),
                end[1] + radius * np.sin(turns),
            )
            passed.append(bool((inked.max(axis=1) > _INK).all()))
    return float(np.mean(passed))


def _marks(area: Pixels) -> tuple[Mark, ...]:
    _, _, stats, _ = cv2.connectedComponentsWithStats(area.astype(np.uint8), connectivity=8)
    return tuple(
        Mark(AnnotationKind.HATCHING, (float(x), float(y), float(x + w), float(y + h)))
        for x, y, w, h, _ in stats[1:]
    )
