"""Which objects of a document can become a body, and their solid as a file."""

from collections.abc import Iterable
from pathlib import Path

import FreeCAD
import Part

from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.reconstruction_features import find_part

SOLID_FILE, REPORT_FILE = "solid.step", "report.json"


def solid_among(selected: Iterable[FreeCAD.DocumentObject]) -> FreeCAD.DocumentObject | None:
    """The part with one solid that is selected, or the part of a selected reconstruction.

    Returns:
        The first one; None where there is none.
    """
    for chosen in selected:
        part = find_part(chosen) if hasattr(chosen, "SheetPath") else chosen
        if part is not None and _has_one_solid(part):
            return part
    return None


def part_named(document: str, name: str) -> FreeCAD.DocumentObject:
    """The part of those internal names.

    Raises:
        WorkbenchError: somebody removed it, or closed its document.
    """
    known = FreeCAD.listDocuments().get(document)
    part = None if known is None else known.getObject(name)
    if part is None:
        text = translate("GaussianCAD", "The part is not in its document any more.")
        raise WorkbenchError(ErrorCode.NO_BODY, text)
    return part


def _has_one_solid(part: FreeCAD.DocumentObject) -> bool:
    """Whether it is a shape of one solid, and no step on the way to a body."""
    if not part.isDerivedFrom("Part::Feature"):
        return False
    if part.TypeId.startswith("PartDesign::") and part.TypeId != "PartDesign::Body":
        return False
    return len(part.Shape.Solids) == 1


def local_shape(part: FreeCAD.DocumentObject) -> Part.Shape:
    """The shape of a feature in its own coordinates."""
    shape = part.Shape.copy()
    shape.Placement = FreeCAD.Placement()
    return shape


def write_solid(part: FreeCAD.DocumentObject, folder: Path) -> Path:
    """Write the solid of a feature in its own coordinates; and beside it, where it is the part of a
    reconstruction, the report, which has the numbers of the drawing.

    Returns:
        Path of a STEP file.

    Raises:
        WorkbenchError: it has no shape, or it cannot be written.
    """
    path = folder / SOLID_FILE
    try:
        local_shape(part).exportStep(str(path))
    except Exception as error:  # FreeCAD raises its own types, which differ between versions
        text = translate("GaussianCAD", "The solid of {name} cannot be written: {reason}")
        message = text.format(name=part.Label, reason=error)
        raise WorkbenchError(ErrorCode.NO_BODY, message) from error
    for group in part.InList:
        if report := getattr(group, "ReportJson", ""):
            (folder / REPORT_FILE).write_text(report, encoding="utf-8")
    return path
