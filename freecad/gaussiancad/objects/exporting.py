"""Exchange files where the engine left none of that kind."""

from pathlib import Path

import Mesh
import Part

_DEVIATION_SHARE = 5e-4
"""Sag of a facet, as a share of the part's longest edge."""

_SEWING_MM = 1e-6


def write_stl(shape: Part.Shape, path: Path) -> None:
    """Tessellate a part into an STL file."""
    box = shape.BoundBox
    longest = max(box.XLength, box.YLength, box.ZLength)
    Mesh.Mesh(shape.tessellate(_DEVIATION_SHARE * longest)).write(str(path))


def write_step(mesh: Mesh.Mesh, path: Path) -> None:
    """Write a mesh as a faceted STEP file; a solid if it is closed."""
    shape = Part.Shape()
    shape.makeShapeFromMesh(mesh.Topology, _SEWING_MM)
    if mesh.isSolid():
        shape = Part.makeSolid(shape)
    shape.exportStep(str(path))
