"""Ellipses fitted to the ink below them."""

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.ellipses import WholeEllipse, refined
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import AROUND, FEWEST_PIXELS, ONE_PLACE
from gaussiancad_core.sheet.tracing.ink_shapes import sample

Floats = npt.NDArray[np.float64]

_CUTOFFS = (1.5, 1.0, 0.7, 0.5)
"""Of each step of a fit: px beside the ellipse from which ink is not its own (Tukey)."""


def ellipse_profile(sheet: CleanSheet, ellipse: WholeEllipse) -> tuple[Floats, Floats]:
    """Every px around an ellipse where there is a stroke: the position, and how far outside of the
    ellipse the stroke's centre line is, in px."""
    along = np.arange(0.0, ellipse.around)
    points, tangents = ellipse.points_at(along), ellipse.tangents_at(along)
    reach = sheet.stroke_width / 2 + AROUND
    offsets = np.arange(-reach, reach + 0.25, 0.5)
    # Parameters grow from x to y: outside is to the tangent's right.
    xs = points[:, :1] + tangents[:, 1:] * offsets
    ys = points[:, 1:] - tangents[:, :1] * offsets
    profile = sample(sheet.weight, xs, ys)
    total = profile.sum(1)
    # A profile that is inked at both ends crosses another stroke, or several.
    clear = (total > 0.8) & (np.minimum(profile[:, 0], profile[:, -1]) < 0.5)
    return along[clear], (profile[clear] * offsets).sum(1) / total[clear]


def refit_ellipse(
    sheet: CleanSheet, ellipse: WholeEllipse, spans: list[tuple[float, float]]
) -> WholeEllipse:
    """Fit an ellipse again to the centroids of its profiles.

    Args:
        sheet: the ink.
        ellipse: a fit to ridge points.
        spans: of its strokes, px along it; without any it stays as it is.
    """
    if not spans:
        return ellipse
    fitted = ellipse
    inside = np.concatenate([np.arange(start, end) for start, end in spans])
    inside = np.unique(np.floor(np.mod(inside, ellipse.around)).astype(int))
    for cutoff in _CUTOFFS:
        along, outside = ellipse_profile(sheet, fitted)
        places = np.floor(along * (ellipse.around / fitted.around)).astype(int)
        used = np.isin(places, inside) & (np.abs(outside) < cutoff)
        if used.sum() < FEWEST_PIXELS:
            return ellipse
        tangents = fitted.tangents_at(along[used])
        normals = np.stack([tangents[:, 1], -tangents[:, 0]], 1)
        points = fitted.points_at(along[used]) + outside[used, None] * normals
        fitted = refined(fitted, points, 1.0 - (outside[used] / cutoff) ** 2)
    moved = fitted.distances(ellipse.points_at(inside.astype(float)))
    return fitted if moved.max() < ONE_PLACE else ellipse
