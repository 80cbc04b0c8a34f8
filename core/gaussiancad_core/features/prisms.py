"""Prisms that a solid may be made of: along one direction, from level to level."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
import numpy.typing as npt
from OCP.TopoDS import TopoDS_Edge

from gaussiancad_core.cells.arrangement import Arrangement
from gaussiancad_core.features.frames import Frame
from gaussiancad_core.features.inside_rays import Rays
from gaussiancad_core.features.plane_curves import (
    segment,
    stretches_along,
    stretches_of_walls,
    supports_of,
)
from gaussiancad_core.features.round_axes import levels_along
from gaussiancad_core.features.sample_points import Samples
from gaussiancad_core.features.sketch_cells import Cells, edge_count, length_of
from gaussiancad_core.features.solid_faces import SolidFace
from gaussiancad_core.features.sweeps import Sweep, SweptPlane, regions_of
from gaussiancad_core.geometry.tolerances import ON_CURVE

Points = npt.NDArray[np.float64]

_WITHIN = 1e-4
"""mm by which a stretch of material may miss the ends of a layer that it fills."""

_MOST_STRETCHES = 400
"""Stretches of curves in a plane, more of which take long to divide it."""


@dataclass(frozen=True, eq=False)
class PrismPlane:
    """A plane across a direction, and the layers along it.

    Attributes:
        plane: with its cells.
        levels: units along the normal, ascending; layers lie between them.
        fills: (places, layers) share of each layer that is material, at each place of the cells;
            NaN where that is not known.
    """

    plane: SweptPlane
    levels: tuple[float, ...]
    fills: Points


def prism_plane(
    edges: Sequence[TopoDS_Edge],
    faces: Sequence[SolidFace],
    frame: Frame,
    box: tuple[Points, Points],
    rays: Rays,
) -> tuple[PrismPlane, Samples] | None:
    """The plane across a direction; None where more is seen in it than can be divided.

    Args:
        edges: of the solid.
        faces: of the solid.
        frame: the plane.
        box: (3,) corners of the part, in the frame's coordinates.
        rays: through the solid.

    Returns:
        The plane, and the points at which its cells were looked at.
    """
    low, high = box
    stretches = stretches_along(edges, frame) + stretches_of_walls(faces, frame)
    corners = [
        (float(a), float(b))
        for a, b in ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1]))
    ]
    sides = [segment(*ends) for ends in pairwise([*corners, corners[0]])]
    stretches += [side for side in sides if side is not None]
    if len(stretches) > _MOST_STRETCHES:
        return None
    cells = Cells(Arrangement(supports_of(stretches)))
    ordered = _distinct(
        [float(low[2]), *levels_along(faces, np.zeros(3), np.array(frame.normal)), float(high[2])]
    )
    fills, samples = _looked_at(cells, ordered, frame, rays)
    return PrismPlane(SweptPlane(frame, cells), tuple(ordered), fills), samples


def prisms_of(plane: PrismPlane, number: int, samples: Samples) -> Iterator[Sweep]:
    """The prisms of a plane: what is material in whole runs of layers, and what may be taken away.

    Args:
        plane: the plane.
        number: that the sweeps carry.
        samples: of the solid; what they say of cells that were looked at elsewhere counts, too.
    """
    cells, layers = plane.plane.cells, len(plane.levels) - 1
    inside = cells.by_cell(plane.fills, np.fmin) > 1.0 - 1e-9
    touched = cells.by_cell(plane.fills, np.fmax) > 1e-9
    cell_of, layer_of = plane.plane.clearly_in(samples.points), _layers_of(plane, samples.points)
    known = (cell_of >= 0) & (layer_of >= 0)
    void, solid = known & ~samples.is_inside, known & samples.is_inside
    inside[cell_of[void], layer_of[void]] = False
    touched[cell_of[solid], layer_of[solid]] = True
    seen: set[tuple[frozenset[int], int, int, bool]] = set()
    for low in range(layers):
        for high in range(low + 1, layers + 1):
            full = np.all(inside[:, low:high], axis=1)
            some = np.any(touched[:, low:high], axis=1)
            for group, adds in regions_of(cells, full, some):
                if _goes_on(group, low, high, inside if adds else ~touched):
                    continue
                key = group, low, high, adds
                if key not in seen:
                    seen.add(key)
                    border = cells.border(group)
                    ends = plane.levels[low], plane.levels[high]
                    outline = edge_count(border), length_of(border)
                    yield Sweep(number, group, ends, adds, *outline)


def _layers_of(plane: PrismPlane, points: Points) -> npt.NDArray[np.int64]:
    """(n,) numbers of the layers that points are in; -1 of those at a level or beyond all."""
    heights = plane.plane.frame.project(points)[:, 2]
    found = [np.searchsorted(plane.levels, heights + aside) - 1 for aside in (-_WITHIN, _WITHIN)]
    within = (found[0] == found[1]) & (found[0] >= 0) & (found[0] < len(plane.levels) - 1)
    return np.where(within, found[0], -1)


def _goes_on(group: frozenset[int], low: int, high: int, holds: npt.NDArray[np.bool_]) -> bool:
    """Whether what holds of cells in some layers holds in the layer below or above, too."""
    values = holds[sorted(group)]
    if not values[:, low:high].all():
        return False
    below = low > 0 and bool(values[:, low - 1].all())
    return below or (high < holds.shape[1] and bool(values[:, high].all()))


def _looked_at(
    cells: Cells, levels: Sequence[float], frame: Frame, rays: Rays
) -> tuple[Points, Samples]:
    fills = np.zeros((len(cells.places), len(levels) - 1))
    bases = frame.lift(cells.places, 0.0)
    points, is_inside = [], []
    for number, base in enumerate(bases):
        stretches = rays.inside(base, frame.normal)
        if stretches is None:
            fills[number] = np.nan
            continue
        for layer, (low, high) in enumerate(pairwise(levels)):
            cut = np.clip(stretches, low, high)
            cut = cut[cut[:, 1] - cut[:, 0] > _WITHIN]
            filled = float((cut[:, 1] - cut[:, 0]).sum())
            share = filled / (high - low)
            fills[number, layer] = 1.0 if high - low - filled <= _WITHIN else share
            for at, within in _heights(cut, low, high):
                points.append(base + at * np.array(frame.normal))
                is_inside.append(within)
    return fills, Samples(np.array(points).reshape(-1, 3), np.array(is_inside, dtype=bool))


def _heights(cut: Points, low: float, high: float) -> Iterator[tuple[float, bool]]:
    """The middle of each stretch of a layer, material and void."""
    ends = [low, *cut.ravel().tolist(), high]
    for number, (start, end) in enumerate(pairwise(ends)):
        if end - start > _WITHIN:
            yield (start + end) / 2.0, bool(number % 2)


def _distinct(values: Sequence[float]) -> list[float]:
    found: list[float] = []
    for value in sorted(values):
        if not found or value - found[-1] > ON_CURVE:
            found.append(value)
    return found
