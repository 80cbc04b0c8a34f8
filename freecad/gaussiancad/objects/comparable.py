"""Which objects of a document can be compared, and their geometry as files."""

from pathlib import Path

import FreeCAD
import Part

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate

_DEVIATION_PROPERTY = "VertexColors"


def comparable_objects(document: FreeCAD.Document) -> list[FreeCAD.DocumentObject]:
    """Meshes, solids, bodies, assemblies; of a body the whole, not its features."""
    return [candidate for candidate in document.Objects if _is_comparable(candidate)]


def global_shape(source: FreeCAD.DocumentObject) -> Part.Shape:
    """The exact geometry of an object in global coordinates; what an assembly holds, as one.

    Raises:
        ReferenceError: the object is not in its document any more.
    """
    shape = _local_shape(source)
    holder = source.getParentGeoFeatureGroup()
    if holder is not None:
        shape.Placement = holder.getGlobalPlacement() * shape.Placement
    return shape


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
            global_shape(source).exportBrep(str(path))
    except Exception as error:  # FreeCAD raises its own types, which differ between versions
        text = translate("GaussianCAD", "{name} cannot be written for the comparison: {reason}")
        message = text.format(name=source.Label, reason=error)
        raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, message) from error
    return path


def _is_comparable(candidate: FreeCAD.DocumentObject) -> bool:
    if candidate.isDerivedFrom("Mesh::Feature"):
        return candidate.Mesh.CountFacets > 0 and not hasattr(candidate, _DEVIATION_PROPERTY)
    if candidate.isDerivedFrom("App::Part") or candidate.isDerivedFrom("App::Link"):
        return bool(_local_shape(candidate).Faces)
    return _is_whole(candidate)


def _is_whole(candidate: FreeCAD.DocumentObject) -> bool:
    """Whether it is a shape with faces, and no step on the way to a body."""
    if not candidate.isDerivedFrom("Part::Feature"):
        return False
    if candidate.TypeId.startswith("PartDesign::") and candidate.TypeId != "PartDesign::Body":
        return False
    return not candidate.TypeId.startswith("Part::Datum") and bool(candidate.Shape.Faces)


def _local_shape(source: FreeCAD.DocumentObject) -> Part.Shape:
    """The geometry in the coordinates of what holds the object; may be empty."""
    if source.isDerivedFrom("App::Link"):
        # A link has a placement of its own, and may point to an assembly.
        return Part.getShape(source)
    if not source.isDerivedFrom("App::Part"):
        return source.Shape.copy()
    shape = Part.makeCompound([_local_shape(each) for each in source.Group if _is_part_of(each)])
    shape.Placement = source.Placement
    return shape


def _is_part_of(child: FreeCAD.DocumentObject) -> bool:
    """Whether a child of an assembly is a piece of it, and not what another piece is made of."""
    if child.isDerivedFrom("App::Part") or child.isDerivedFrom("App::Link"):
        return True
    return _is_whole(child) and not any(
        user.isDerivedFrom("Part::Feature") for user in child.InList
    )
