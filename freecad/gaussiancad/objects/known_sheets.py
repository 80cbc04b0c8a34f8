"""The drawings that a document has reconstructions of."""

import filecmp
from collections.abc import Iterable
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.objects.properties import texts_of


def group_of(document: FreeCAD.Document, sheet: Path, page: int) -> FreeCAD.DocumentObject | None:
    """The group of a drawing in a document, or None.

    A drawing is known by its place, else by its name and its bytes: what a panel takes from the
    document itself lies in another folder each time.

    Args:
        document: is searched.
        sheet: path of the drawing, or of the copy of it that the document holds.
        page: of a file with pages.
    """
    groups = [found for found in document.Objects if hasattr(found, "SheetPath")]
    groups = [group for group in groups if page_of(group) == page]
    for is_same in (_is_at, _is_copy_of):
        for this_group in groups:
            if is_same(this_group, sheet):
                return this_group
    return None


def is_of(group: FreeCAD.DocumentObject, sheet: Path, page: int) -> bool:
    """Whether an object is the group of a drawing; as of :func:`group_of`."""
    known = hasattr(group, "SheetPath") and page_of(group) == page
    return known and (_is_at(group, sheet) or _is_copy_of(group, sheet))


def _is_at(group: FreeCAD.DocumentObject, sheet: Path) -> bool:
    return str(sheet.absolute()) in (group.SheetPath, getattr(group, "Sheet", ""))


def _is_copy_of(group: FreeCAD.DocumentObject, sheet: Path) -> bool:
    kept = getattr(group, "Sheet", "")
    if not kept or Path(group.SheetPath).name != sheet.name:
        return False
    try:
        return filecmp.cmp(kept, sheet, shallow=False)
    except OSError:
        return False


def page_of(group: FreeCAD.DocumentObject) -> int:
    """The page of the drawing's file that a group is of."""
    stated = texts_of(group, "Settings").get("page", "1")
    return int(stated) if stated.isdigit() else 1


def sheet_of(group: FreeCAD.DocumentObject) -> Path | None:
    """The drawing's file, or the document's copy where that is gone; None where both are."""
    for name in ("SheetPath", "Sheet"):
        path = getattr(group, name, "")
        if isinstance(path, str) and path and Path(path).is_file():
            return Path(path)
    return None


def reconstruction_among(
    selected: Iterable[FreeCAD.DocumentObject],
) -> FreeCAD.DocumentObject | None:
    """The reconstruction that is selected, or whose part, surface or view is; None without one."""
    for item in selected:
        for candidate in (item, *item.InList):
            if hasattr(candidate, "SheetPath"):
                return candidate
    return None
