"""The trained Gaussians as a point cloud with colours."""

from dataclasses import dataclass
from pathlib import Path

import FreeCAD
import Points

from freecad.gaussiancad.objects.ply import read_vertices

_SH_BAND_0 = 0.28209479177387814
"""The constant spherical harmonic, 1 / (2 sqrt(pi)): 3DGS stores colours as its coefficients."""

_Triple = tuple[float, float, float]


@dataclass(frozen=True)
class GaussianCloud:
    """Centres and colours of Gaussians.

    Attributes:
        centres: (x, y, z) in mm.
        colours: (red, green, blue), 0 to 1.
    """

    centres: list[_Triple]
    colours: list[_Triple]


def read_gaussians(path: Path) -> GaussianCloud:
    """Read centres and view-independent colours from a 3DGS PLY file.

    Raises:
        WorkbenchError: the file cannot be read.
    """
    vertices = read_vertices(path)
    centres = vertices.columns("x", "y", "z")
    try:
        coefficients = vertices.columns("f_dc_0", "f_dc_1", "f_dc_2")
    except KeyError:
        return GaussianCloud(centres, [])
    return GaussianCloud(centres, [_colour(entry) for entry in coefficients])


def fill_points(feature: FreeCAD.DocumentObject, cloud: GaussianCloud) -> None:
    """Put the cloud into a points feature, which stays where it is."""
    placement = feature.Placement
    kernel = Points.Points()
    kernel.addPoints(cloud.centres)
    feature.Points = kernel
    feature.Placement = placement
    if cloud.colours and not hasattr(feature, "Color"):
        feature.addProperty("App::PropertyColorList", "Color", "Points", "Colour of each point")
    if hasattr(feature, "Color"):
        feature.Color = cloud.colours


def _colour(coefficients: tuple[float, ...]) -> _Triple:
    red, green, blue = (min(max(0.5 + _SH_BAND_0 * value, 0.0), 1.0) for value in coefficients)
    return (red, green, blue)
