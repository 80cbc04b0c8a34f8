"""A solid laid on the axes of a sheet: turned by quarters, at the sheet's scale or its own."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
import numpy.typing as npt

from gaussiancad_core.judging.drawn_lines import DrawnSheet
from gaussiancad_core.judging.faceted_solids import FacetedSolid, Floats
from gaussiancad_core.judging.misfits import Judge, Misfit

_FITS = 0.06
"""Share by which an extent of a solid may differ from the sheet's to be laid on it at all."""

_SNAP = 0.008
"""Share within which an extent is the sheet's: what was drawn and read is a little off."""

_OTHER = 0.5
"""Share by which extents may differ where one is the sheet's."""

_SNAP_TOLERANCES = 3.0

_EVERY = 8
"""One of so many pairs tells which poses are worth a closer look."""

_CLOSER = 2
"""Poses that get one."""


def _turns() -> list[Floats]:
    """The 24 turns of a cube."""
    found = []
    for order, signs in product(permutations(range(3)), product((1.0, -1.0), repeat=3)):
        turn = np.eye(3)[list(order)] * np.array(signs)[:, None]
        if np.linalg.det(turn) > 0.0:
            found.append(turn)
    return found


_TURNS = tuple(_turns())


@dataclass(frozen=True, eq=False)
class Pose:
    """How a solid lies on a sheet's axes.

    Attributes:
        matrix: (3, 3) of a turn, and what it stretches.
        offset: (3,) mm.
        scale: the solid's mm for a mm of the sheet.
        deviation: (3,) share by which the solid's extent is longer than the sheet's, along the
            sheet's axes.
        stretches: whether an extent is another one than the sheet's.
    """

    matrix: Floats
    offset: Floats
    scale: float
    deviation: Floats
    stretches: bool = False

    def laid(self, solid: FacetedSolid) -> FacetedSolid:
        """The solid in mm of the sheet."""
        return solid.mapped(self.matrix, self.offset)


@dataclass(frozen=True, eq=False)
class Laid:
    """A solid on a sheet.

    Attributes:
        pose: of the solid.
        solid: in mm of the sheet.
        misfit: of both.
        stretched: share of the lines that the misfit costs where the solid is stretched to the
            extents of the sheet; None where its extents are those.
    """

    pose: Pose
    solid: FacetedSolid
    misfit: Misfit
    stretched: float | None = None

    @property
    def least(self) -> float:
        """Share of the lines that the solid leaves unexplained, as it is or stretched."""
        return min(self.misfit.share, np.inf if self.stretched is None else self.stretched)


def lay(solid: FacetedSolid, judge: Judge) -> Laid | None:
    """The pose in which a solid explains a sheet best; None where its extents fit in none.

    Args:
        solid: mm.
        judge: of the sheet.
    """
    found = list(poses(solid, judge.sheet)) if len(solid.triangles) else []
    if not found:
        return None
    rough = []
    for pose in found:
        laid = pose.laid(solid)
        both = (laid, _stretched(laid, judge.sheet)) if pose.stretches else (laid,)
        rough.append(min(judge.rough_cost(each, _EVERY) for each in both))
    order = np.argsort(rough, kind="stable")[:_CLOSER]
    tried = [_laid(solid, found[number], judge) for number in order.tolist()]
    return min(tried, key=lambda each: each.least)


def as_it_lies(solid: FacetedSolid, judge: Judge) -> Laid:
    """A solid that was made in mm of the sheet, on its axes."""
    deviation = solid.extent / judge.sheet.size - 1.0
    stretches = not _snaps(deviation, judge.sheet).all()
    pose = Pose(np.eye(3), np.zeros(3), 1.0, deviation, stretches)
    return Laid(pose, solid, judge.misfit(solid))


def _laid(solid: FacetedSolid, pose: Pose, judge: Judge) -> Laid:
    laid = pose.laid(solid)
    stretched = None
    if pose.stretches:
        stretched = judge.misfit(_stretched(laid, judge.sheet)).share
    return Laid(pose, laid, judge.misfit(laid), stretched)


def _stretched(laid: FacetedSolid, sheet: DrawnSheet) -> FacetedSolid:
    """A solid stretched to the extents of a sheet."""
    factor = sheet.size / laid.extent
    return laid.mapped(np.diag(factor), -factor * laid.box[0])


def poses(solid: FacetedSolid, sheet: DrawnSheet) -> Iterator[Pose]:
    """The poses in which a solid's extents are about the sheet's: at the sheet's scale, else at the
    scale that makes the longest extents one, else those in which one extent is the sheet's."""
    longest = float(solid.extent.max() / sheet.longest)
    for scale, fits in ((1.0, _fits), (longest, _fits), (1.0, _fits_once)):
        found = list(_at_scale(solid, sheet, scale, fits))
        if found:
            return iter(found)
    return iter(())


def _snaps(deviation: Floats, sheet: DrawnSheet) -> npt.NDArray[np.bool_]:
    """(3,) whether an extent is the sheet's."""
    return np.abs(deviation) <= np.maximum(_SNAP, _SNAP_TOLERANCES * sheet.tolerance / sheet.size)


def _fits(deviation: Floats) -> bool:
    return bool(np.abs(deviation).max() <= _FITS)


def _fits_once(deviation: Floats) -> bool:
    """Whether one extent is the sheet's, and the others are not wholly other ones."""
    away = np.abs(deviation)
    return bool(away.min() <= _SNAP and away.max() <= _OTHER)


def _at_scale(
    solid: FacetedSolid, sheet: DrawnSheet, scale: float, fits: Callable[[Floats], bool]
) -> Iterator[Pose]:
    low, extent = solid.box[0], solid.extent
    for turn in _TURNS:
        turned = np.abs(turn @ extent)
        size = scale * sheet.size
        deviation = turned / size - 1.0
        if not fits(deviation):
            continue
        snaps = _snaps(deviation, sheet)
        factor = np.where(snaps, sheet.size / turned, 1.0 / scale)
        matrix = turn * factor[:, None]
        start = np.minimum(matrix @ extent, 0.0)
        rest = np.where(snaps, 0.0, sheet.size - turned / scale)
        # An extent that is another one starts at either end, or in the middle.
        for share in (0.0,) if snaps.all() else (0.0, 0.5, 1.0):
            offset = share * rest - start - matrix @ low
            yield Pose(matrix, offset, scale, deviation, not snaps.all())
