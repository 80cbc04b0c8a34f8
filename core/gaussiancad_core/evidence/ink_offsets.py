"""How far the ink of a sheet lies beside the lines of a solid that is drawn again.

Strokes are what a reader made of the ink; a solid that has all strokes may still run beside the ink
where a curve was misread.  Across each visible line of the solid the darkness of the sheet is
weighed: its centroid tells where the pen went, to some hundredths of a pixel, wherever no other ink
is near.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.ndimage import map_coordinates, uniform_filter1d

from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import AROUND, EVEN, FEWEST_PLACES
from gaussiancad_core.sheet.registration.view_registration import Placement

Floats = npt.NDArray[np.float64]

_STEP, _ACROSS = 1.0, 0.25
"""px between places along a line, and between those across it that are weighed."""

_SAME_WIDTH = 0.35
"""Share of the pen's width by which the ink across may be more or less."""

_PARTS = 8
"""Parts of a line over each of which the offset is a mean: noise of paper is no offset."""


@dataclass(frozen=True)
class InkOffset:
    """Where the ink lies beside a line.

    Attributes:
        role: the view.
        place: (right, up) mm of the line there.
        offset: px.
    """

    role: Role
    place: tuple[float, float]
    offset: float


def ink_offsets(
    role: Role, lines: Iterable[DrawnStroke], placement: Placement, sheet: CleanSheet
) -> list[InkOffset]:
    """How far the ink lies beside each visible line of a view, where it does so most.

    Lines are left out of which too little has no other ink near.

    Args:
        role: the view.
        lines: of the solid in it, mm.
        placement: of the view on the sheet.
        sheet: upright; its px are those of the placement.
    """
    found = []
    for line in lines:
        if line.linetype is Linetype.VISIBLE and line.length > 0.0:
            offset = _offset(line, placement, sheet)
            if offset is not None:
                (place,) = placement.to_plane(offset[0][None]).tolist()
                found.append(InkOffset(role, (place[0], place[1]), offset[1]))
    return found


def _offset(
    line: DrawnStroke, placement: Placement, sheet: CleanSheet
) -> tuple[Floats, float] | None:
    """The (2,) px where the ink lies farthest beside a line, and by how many px."""
    places, across = _places(line, placement)
    aside, stated = _centroids(places, across, sheet)
    places, aside = places[stated], aside[stated]
    if len(aside) < FEWEST_PLACES:
        return None
    size = max(3, len(aside) // _PARTS)
    half = size // 2
    means = np.abs(uniform_filter1d(aside, size))[half : len(aside) - half]
    worst = int(means.argmax())
    return places[worst + half], float(means[worst])


def _places(line: DrawnStroke, placement: Placement) -> tuple[Floats, Floats]:
    """(n, 2) px of places along a line, and (n, 2) unit vectors across it there."""
    # Chords this short miss a curve by less than what is measured.
    points = placement.to_sheet(line.sample(line.length / 400.0))
    along = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(points, axis=0).T))])
    count = int(along[-1] / _STEP)
    at = (np.arange(count) + 0.5) * along[-1] / max(count, 1)
    places, before, after = (
        np.stack([np.interp(at + shift, along, points[:, k]) for k in range(2)], axis=1)
        for shift in (0.0, -0.5 * _STEP, 0.5 * _STEP)
    )
    way = after - before
    way /= np.maximum(np.hypot(*way.T), 1e-12)[:, None]
    return places, np.stack([-way[:, 1], way[:, 0]], axis=1)


def _centroids(
    places: Floats, across: Floats, sheet: CleanSheet
) -> tuple[Floats, npt.NDArray[np.bool_]]:
    """(n,) px across from places to the middle of the ink, and whether that is one pen's alone."""
    width = sheet.stroke_width
    reach = 0.5 * width + AROUND
    shifts = np.arange(-reach, reach + 1e-9, _ACROSS)
    # Pixels are weighed at their middles.
    x, y = np.moveaxis(places[:, None] + shifts[None, :, None] * across[:, None] - 0.5, 2, 0)
    ink = map_coordinates(sheet.weight, [y, x], order=1, mode="constant", output=np.float64)
    total = ink.sum(axis=1)
    ends = np.maximum(ink[:, 0], ink[:, -1])
    stated = (np.abs(total * _ACROSS - width) < _SAME_WIDTH * width) & (ends < EVEN)
    return (ink * shifts).sum(axis=1) / np.maximum(total, 1e-9), stated
