"""What is compared: an object of the document or a model file, and whether it changed since."""

import re
from dataclasses import dataclass
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.comparable import export_geometry, global_shape

MODEL_SUFFIXES = ("step", "stp", "brep", "brp", "stl", "ply", "obj")
"""Files that the engine compares."""

_UNSAFE = re.compile(r"[^\w .()-]")
"""What no file's name should have."""

_LONGEST_STEM = 60


@dataclass(frozen=True)
class Source:
    """One side of a comparison.

    Attributes:
        feature: the object, or None where it is a file.
        path: of the file, empty where it is an object.
    """

    feature: FreeCAD.DocumentObject | None = None
    path: str = ""

    @property
    def label(self) -> str:
        """What people call it."""
        return Path(self.path).name if self.feature is None else self.feature.Label

    def sheet(self) -> Path | None:
        """The drawing that it was made from, with its lines over it, or None."""
        if self.feature is None:
            path = Path(self.path).parent / "overlay.png"
            return path if path.is_file() else None
        overlays = [getattr(each, "Overlay", "") for each in self.feature.InList]
        return next((Path(each) for each in overlays if each and Path(each).is_file()), None)

    def box(self) -> FreeCAD.BoundBox:
        """The box around it in global coordinates; an empty one where it is a file."""
        if self.feature is None:
            return FreeCAD.BoundBox()
        if self.feature.isDerivedFrom("Mesh::Feature"):
            mesh = self.feature.Mesh.copy()
            mesh.Placement = self.feature.getGlobalPlacement()
            return mesh.BoundBox
        return global_shape(self.feature).BoundBox

    def state(self) -> str:
        """A text that changes when the geometry does; empty where there is none any more."""
        if self.feature is None:
            return _file_state(Path(self.path))
        return _feature_state(self.feature)

    def file(self, folder: Path) -> Path:
        """A file with the geometry: the file itself, or one of the object's name in the folder.

        Raises:
            WorkbenchError: there is no geometry.
        """
        if self.feature is not None:
            folder.mkdir(exist_ok=True)
            stem = _UNSAFE.sub("_", self.label).strip(" .")[:_LONGEST_STEM] or self.feature.Name
            return export_geometry(self.feature, folder, stem)
        path = Path(self.path)
        if not path.is_file():
            text = translate("GaussianCAD", "There is no file {path}. Choose another one.")
            raise WorkbenchError(ErrorCode.NOTHING_TO_COMPARE, text.format(path=path))
        return path


def _file_state(path: Path) -> str:
    try:
        facts = path.stat()
    except OSError:
        return ""
    return f"{facts.st_size} {facts.st_mtime_ns}"


def _feature_state(feature: FreeCAD.DocumentObject) -> str:
    try:
        if feature.isDerivedFrom("Mesh::Feature"):
            geometry, place = feature.Mesh, feature.getGlobalPlacement()
            counts = [geometry.CountPoints, geometry.CountFacets]
        else:
            geometry = global_shape(feature)
            place = geometry.Placement
            counts = [len(geometry.Faces), len(geometry.Edges), len(geometry.Vertexes)]
        box, numbers = geometry.BoundBox, [geometry.Area, geometry.Volume]
    except (AttributeError, ReferenceError):
        return ""
    corners = (box.XMin, box.YMin, box.ZMin, box.XMax, box.YMax, box.ZMax)
    values = " ".join(f"{value:.9g}" for value in (*numbers, *corners, *place.toMatrix().A))
    return f"{' '.join(map(str, counts))} {values}"
