"""Files with coordinates in other units: recognised by their size, never corrected silently."""

import numpy as np

from gaussiancad_core.model.meshes import TriangleMesh

_FACTORS = (1000.0, 25.4, 10.0, 304.8, 1000.0 / 25.4)
"""mm per metre, inch, centimetre and foot; inches per metre."""

_EXTENT_SHARE = 0.05
"""Sorted extents may leave the factor by this share: results are not exact."""


def unit_factor(result: TriangleMesh, reference: TriangleMesh) -> float | None:
    """By what the result's coordinates must be multiplied to have the reference's size.

    None unless all three sorted extents differ by the same factor between units of length.
    """
    first, second = (np.sort(np.ptp(mesh.bounds, axis=0)) for mesh in (result, reference))
    if first.min() <= 0.0 or second.min() <= 0.0:
        # What is flat has two extents to tell by.
        first, second = first[1:], second[1:]
        if first.min() <= 0.0 or second.min() <= 0.0:
            return None
    ratios = np.log(second / first)
    for factor in _FACTORS:
        for candidate in (factor, 1.0 / factor):
            if np.abs(ratios - np.log(candidate)).max() < _EXTENT_SHARE:
                return candidate
    return None
