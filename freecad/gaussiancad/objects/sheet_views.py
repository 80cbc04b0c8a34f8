"""The sheet's views as image planes around the part."""

from dataclasses import dataclass
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.engine.job import VECTOR_SUFFIXES
from freecad.gaussiancad.engine.report import Report, ViewBox, ViewReport
from freecad.gaussiancad.objects.placing import PlanePlacement, part_size, place_view
from freecad.gaussiancad.qt import QtCore, QtGui

MARGIN_SHARE = 0.04
"""Paper around a view, as a share of its box's longer edge."""


@dataclass(frozen=True)
class ViewImage:
    """A piece of the sheet, cut out.

    Attributes:
        role: of the view.
        path: of the PNG file.
        plane: where it stands.
    """

    role: str
    path: Path
    plane: PlanePlacement


def read_sheet_image(path: Path) -> QtGui.QImage | None:
    """The sheet's pixels, turned as its EXIF data say; None if Qt cannot read this format.

    Vector files are left to the engine: Qt reads some of them too, but draws them at another size,
    and opens what they refer to.
    """
    if path.suffix.lower().lstrip(".") in VECTOR_SUFFIXES:
        return None
    reader = QtGui.QImageReader(str(path))
    reader.setAutoTransform(True)
    if hasattr(reader, "setAllocationLimit"):
        # Qt 6 refuses images above 256 MB by default; large scans are larger.
        reader.setAllocationLimit(0)
    image = reader.read()
    return None if image.isNull() else image


def cut_views(sheet: QtGui.QImage, report: Report, folder: Path) -> list[ViewImage]:
    """Cut the views out of the sheet.

    Args:
        sheet: pixels of the whole sheet.
        report: says where the views are and how large a pixel is.
        folder: receives a PNG file for each view.

    Returns:
        One entry for each view that lies on the sheet; none without a scale.
    """
    scale = report.mm_per_pixel
    if not scale or scale <= 0:
        return []
    size = part_size(report.views, scale)
    images: list[ViewImage] = []
    for view in report.views:
        crop = _crop(view, sheet)
        plane = place_view(view, crop, size, scale) if crop is not None else None
        if plane is None:
            continue
        path = folder / f"{view.role}.png"
        x0, y0, x1, y1 = (round(value) for value in crop)
        if sheet.copy(QtCore.QRect(x0, y0, x1 - x0, y1 - y0)).save(str(path)):
            images.append(ViewImage(view.role, path, plane))
    return images


def add_image_plane(
    document: FreeCAD.Document, name: str, image: Path, plane: PlanePlacement
) -> FreeCAD.DocumentObject:
    """Add an image plane; the image's file becomes part of the document."""
    feature = document.addObject("Image::ImagePlane", name)
    fill_image_plane(feature, image, plane)
    return feature


def fill_image_plane(feature: FreeCAD.DocumentObject, image: Path, plane: PlanePlacement) -> None:
    """Give an image plane its image, its size and its place."""
    feature.ImageFile = str(image)
    feature.XSize, feature.YSize = plane.width, plane.height
    rotation = FreeCAD.Rotation(
        FreeCAD.Vector(*plane.right), FreeCAD.Vector(*plane.up), FreeCAD.Vector(*plane.towards)
    )
    feature.Placement = FreeCAD.Placement(FreeCAD.Vector(*plane.centre), rotation)


def _crop(view: ViewReport, sheet: QtGui.QImage) -> ViewBox | None:
    """Whole pixels around a view, within the sheet; None if the view is not on it."""
    if view.box is None:
        return None
    x0, y0, x1, y1 = view.box
    margin = MARGIN_SHARE * max(x1 - x0, y1 - y0)
    crop = (
        float(max(0, round(x0 - margin))),
        float(max(0, round(y0 - margin))),
        float(min(sheet.width(), round(x1 + margin))),
        float(min(sheet.height(), round(y1 + margin))),
    )
    return crop if crop[0] < crop[2] and crop[1] < crop[3] else None
