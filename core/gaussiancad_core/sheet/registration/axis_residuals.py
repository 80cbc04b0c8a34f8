"""How far what the views show of an axis is from the coordinates that they share."""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.registration.axis_clusters import AxisFit, SeenCoordinates


@dataclass(frozen=True)
class Residual:
    """Distances of what the views show from the shared coordinates.

    Attributes:
        median, largest: px.
        coordinates: that two views or more show.
    """

    median: float
    largest: float
    coordinates: int = 0


def axis_residual(
    seen: SeenCoordinates, fit: AxisFit, levels: npt.NDArray[np.float64], zero: float
) -> Residual | None:
    """How far the views are from the coordinates that they share; None if they share none.

    Args:
        seen: what each view shows of the axis, px.
        fit: which coordinate each of these is.
        levels: (n,) px, the coordinates, rising from 0.
        zero: px, what was taken off for that.
    """
    common = fit.common(seen) - zero
    away = []
    coordinates = 0
    for cluster, level in enumerate(levels):
        item = fit.cluster == cluster
        views = np.unique(seen.view[item])
        coordinates += len(views) > 1
        for view in views if len(views) > 1 else ():
            of = item & (seen.view == view)
            away.append(abs(float(np.average(common[of], weights=seen.weight[of])) - level))
    return Residual(float(np.median(away)), float(max(away)), coordinates) if away else None
