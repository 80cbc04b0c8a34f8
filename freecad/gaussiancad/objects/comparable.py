"""Which objects of a document can be compared, and their geometry as files."""

from pathlib import Path

import FreeCAD

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate

_DEVIATION_PROPERTY = "VertexColors"


def comparable_objects(document: FreeCAD.Document) -> list[FreeCAD.DocumentObject]:
    """Meshes, solids and bodies; of a body the whole, not its features."""
    return [candidate for candidate in document.Objects if _is_comparable(candidate)]


def export_geometry(source: FreeCAD.DocumentObject, folder: Path, stem: str) -> Path:
    """Write an object's geometry in global coordinates, exact where it is exact.

    Args:
        source: one of :func:`comparable_objects`.
        folder: receives the file.
        stem: of the file's name.

    Returns:
        The path of a BREP or STL file.

    Raises:
        WorkbenchError: the object has no geometry, or it cannot be written.
    """
    try:
        if source.isDerivedFrom("Mesh::Feature"):
            path = folder / f"{stem}.stl"
            mesh = source.Mesh.copy()
            mesh.Placement = source.getGlobalPlacement()
            mesh.write(str(path))
        else:
            path = folder / f"{stem}.brep"
            shape = source.Shape.copy()
            shape.Placement = source.getGlobalPlacement()
            shape.exportBrep(str(path))
    except Exception as error:  # FreeCAD raises its own types, which differ between versions
        text = translate("GaussianCAD", "{name} cannot be written for the comparison: {reason}")
        message = text.format(name=source.Label, reason=error)
        raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, message) from error
    return path


def _is_comparable(candidate: FreeCAD.DocumentObject) -> bool:
    if candidate.isDerivedFrom("Mesh::Feature"):
        return candidate.Mesh.CountFacets > 0 and not hasattr(candidate, _DEVIATION_PROPERTY)
    if not candidate.isDerivedFrom("Part::Feature"):
        return False
    if candidate.TypeId.startswith("PartDesign::") and candidate.TypeId != "PartDesign::Body":
        return False
    return not candidate.TypeId.startswith("Part::Datum") and bool(candidate.Shape.Faces)
