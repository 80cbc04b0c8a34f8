"""Drawings in a document that can be reconstructed: TechDraw pages and images on planes."""

import shutil
from dataclasses import dataclass
from enum import Enum
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.engine.job import Projection
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.proxies import GroupProxy


class SheetObject(Enum):
    """Kinds of objects that hold a drawing, by their type in FreeCAD."""

    PAGE = "TechDraw::DrawPage"
    IMAGE = "Image::ImagePlane"


@dataclass(frozen=True)
class ExportedSheet:
    """A drawing of a document as a file.

    Attributes:
        path: of the file.
        mm_per_pixel: of the part, or None if the object does not tell.
        projection: of its views, or None if the object does not tell.
    """

    path: Path
    mm_per_pixel: float | None = None
    projection: Projection | None = None


def sheet_objects(document: FreeCAD.Document | None) -> list[FreeCAD.DocumentObject]:
    """The objects of a document that hold a drawing, pages first."""
    objects = [] if document is None else document.Objects
    pages = [found for found in objects if found.isDerivedFrom(SheetObject.PAGE.value)]
    return pages + [found for found in objects if found not in pages and _is_sheet(found)]


def first_sheet_object(objects: list[FreeCAD.DocumentObject]) -> FreeCAD.DocumentObject | None:
    """The first of some objects that holds a drawing, a view's page too; None if none does."""
    for candidate in objects:
        above = candidate.InListRecursive if candidate.TypeId.startswith("TechDraw::") else []
        for found in (candidate, *above):
            if _is_sheet(found):
                return found
    return None


def _is_sheet(candidate: FreeCAD.DocumentObject) -> bool:
    """Whether an object holds a drawing, and not just a view that was cut out of one."""
    if not any(candidate.isDerivedFrom(kind.value) for kind in SheetObject):
        return False
    return not any(
        isinstance(getattr(parent, "Proxy", None), GroupProxy) for parent in candidate.InList
    )


def export_sheet(source: FreeCAD.DocumentObject, folder: Path) -> ExportedSheet:
    """Write the drawing that an object holds into a file.

    Args:
        source: one of :func:`sheet_objects`.
        folder: receives the file.

    Raises:
        WorkbenchError: the object holds no drawing.
    """
    if source.isDerivedFrom(SheetObject.PAGE.value):
        # TechDraw takes a while to load, and not every document has pages.
        from freecad.gaussiancad.objects.techdraw_sheet import export_page

        exported = export_page(source, folder)
        return ExportedSheet(exported.path, exported.mm_per_pixel, exported.projection)
    image = Path(source.ImageFile)
    if not source.ImageFile or not image.is_file():
        text = translate(
            "GaussianCAD", "The picture of {name} is missing. Choose the drawing's file instead."
        )
        raise WorkbenchError(ErrorCode.SHEET_MISSING, text.format(name=source.Label))
    # The document's own copy goes when the document is closed.
    return ExportedSheet(Path(shutil.copy(image, folder / image.name)))
