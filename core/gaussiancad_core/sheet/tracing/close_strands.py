"""Lines and circles that run close beside each other.

A strand is one of them with all its pieces; strands with less than about a line width of paper
between them are a bundle, since the ink of each pulls the fit of the others.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.whole_curves import Circle, Line
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.picture_noise import ONE_PLACE, PARALLEL, SIDE_BY_SIDE
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.ink_runs import Piece

Floats = npt.NDArray[np.float64]

_NEAREST, _PAPER = 0.6, 3.0
"""Line widths between two lines that are told apart, at least; px of paper between two that pull
each other, at most."""


@dataclass(frozen=True)
class Strand:
    """A line or circle of a bundle, and where it is drawn.

    Attributes:
        geometry: px, pixel centres at integers.
        pieces: of it, all visible or all hidden.
        dashes: px from where to where a hidden one has ink; None for a visible one.
    """

    geometry: Line | Circle
    pieces: tuple[Piece, ...]
    dashes: tuple[tuple[float, float], ...] | None = None

    @property
    def line(self) -> Line:
        """Its geometry, of a straight one."""
        if not isinstance(self.geometry, Line):
            raise ValueError("the strand is not straight")
        return self.geometry

    @property
    def kind(self) -> Linetype:
        """Visible or hidden."""
        return self.pieces[0].linetype

    def moved(self, values: Floats) -> "Strand":
        """With three numbers: px across and radians of turn about its middle, 0; or px of a
        circle's centre and of its radius."""
        if isinstance(self.geometry, Circle):
            x, y = self.geometry.centre
            centre = (float(x + values[0]), float(y + values[1]))
            circle = Circle(centre, float(self.geometry.radius + values[2]))
            factor = circle.radius / self.geometry.radius
            pieces = tuple(scaled(piece, factor) for piece in self.pieces)
            return replace(self, geometry=circle, pieces=pieces)
        middle = 0.5 * (self.pieces[0].start + self.pieces[-1].end)
        way = np.array(self.geometry.direction)
        normal = np.array([-way[1], way[0]])
        turned = way + np.tan(values[1]) * normal
        turned /= np.hypot(*turned)
        at = np.array(self.geometry.at(middle)) + values[0] * normal
        origin = at - middle * turned
        line = Line((float(origin[0]), float(origin[1])), (float(turned[0]), float(turned[1])))
        return replace(self, geometry=line)

    def offsets(self, pixels: Floats, facing: Floats) -> Floats:
        """(n, 2) pixels -> (n,) px by which the strand lies beside each: signed along ``facing``,
        or away from the centre; infinite where it is not drawn."""
        geometry = self.geometry
        if isinstance(geometry, Circle):
            around = pixels - np.array(geometry.centre)
            neighbour = geometry.radius - np.hypot(*around.T)
        else:
            across = geometry.coordinates(pixels)[1]
            normal = np.array([-geometry.direction[1], geometry.direction[0]])
            neighbour = -across * np.sign(normal @ facing)
        at = geometry.positions(pixels)
        drawn = np.zeros(len(pixels), bool)
        solid = ((piece.start, piece.end) for piece in self.pieces)
        for start, end in solid if self.dashes is None else self.dashes:
            along = at
            if np.isfinite(geometry.around):
                along = start + np.mod(at - start, geometry.around)
            drawn |= (along >= start) & (along <= end)
        return np.where(drawn, neighbour, np.inf)


def find_bundles(ended: Sequence[Placed], width: float) -> list[list[Strand]]:
    """Strands each of which runs close beside another one of its bundle.

    Args:
        ended: pieces of a view with their ends at junctions; px, pixel centres at integers.
        width: px of a line.
    """
    bundles: list[list[Strand]] = []
    for strand in _strands(ended):
        bs = [b for b in bundles if any(_run_parallel(strand, other, width) for other in b)]
        bundles = [b for b in bundles if b not in bs]
        bundles.append([strand, *(other for b in bs for other in b)])
    return [bundle for bundle in bundles if len(bundle) > 1]


def scaled(piece: Piece, factor: float) -> Piece:
    """The piece at the same angles of a circle of another radius."""
    return Piece(piece.start * factor, piece.end * factor, piece.linetype, piece.confidence)


def _strands(ended: Sequence[Placed]) -> list[Strand]:
    """The lines and visible circles all of whose pieces are of one linetype."""
    found: dict[Line | Circle, list[Piece]] = {}
    for geometry, piece in ended:
        if isinstance(geometry, Line | Circle):
            found.setdefault(geometry, []).append(piece)
    return [
        Strand(geometry, tuple(sorted(pieces, key=lambda piece: piece.start)))
        for geometry, pieces in found.items()
        if len({piece.linetype for piece in pieces}) == 1
        and (isinstance(geometry, Line) or pieces[0].linetype is Linetype.VISIBLE)
    ]


def _run_parallel(one: Strand, other: Strand, width: float) -> bool:
    # Of two hidden lines whose dashes melt the places are told by these, and their pen is not.
    if one.kind is other.kind is Linetype.HIDDEN:
        return False
    apart = _NEAREST * width, width + _PAPER
    a, b = one.geometry, other.geometry
    if isinstance(a, Circle) and isinstance(b, Circle):
        near = np.hypot(*np.subtract(a.centre, b.centre)) <= ONE_PLACE
        return bool(near and apart[0] <= abs(a.radius - b.radius) <= apart[1])
    if not isinstance(a, Line) or not isinstance(b, Line):
        return False
    (x, y), (u, v) = a.direction, b.direction
    if abs(x * v - y * u) > PARALLEL:
        return False
    for piece in one.pieces:
        for adjacent_piece in other.pieces:
            ends = a.positions(b.points_at(np.array([adjacent_piece.start, adjacent_piece.end])))
            start, end = max(piece.start, float(ends.min())), min(piece.end, float(ends.max()))
            if end - start >= SIDE_BY_SIDE:
                away = b.distances(a.points_at(np.array([start, end])))
                if apart[0] <= away.min() and away.max() <= apart[1]:
                    return True
    return False
