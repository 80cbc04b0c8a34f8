"""The drawing that a command is about: of what is selected, or a file that is asked for."""

from collections.abc import Sequence
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.engine.job import SHEET_SUFFIXES
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.document_sheets import export_sheet, first_sheet_object
from freecad.gaussiancad.objects.known_sheets import page_of, reconstruction_among, sheet_of
from freecad.gaussiancad.qt import QtWidgets

_LAST_FOLDER = "FileOpenSavePath"
"""FreeCAD's parameter with the folder of the last file dialog."""


def sheet_among(selected: Sequence[FreeCAD.DocumentObject]) -> tuple[Path, int] | None:
    """The drawing, and its page, of a reconstruction among some objects, or of a TechDraw page or a
    picture on a plane; None where none of them has one.

    Raises:
        WorkbenchError, OSError: an object's drawing cannot be written to a file.
    """
    group = reconstruction_among(selected)
    path = sheet_of(group) if group is not None else None
    if path is not None:
        return path, page_of(group)
    source = first_sheet_object(list(selected))
    if source is None:
        return None
    folder = Path(FreeCAD.getUserAppDataDir()) / "GaussianCAD" / "sheets"
    folder.mkdir(parents=True, exist_ok=True)
    return export_sheet(source, folder).path, 1


def ask_sheet(parent: QtWidgets.QWidget, start: str = "") -> Path | None:
    """Ask for the file of a drawing, where FreeCAD's own dialogs were last.

    Args:
        parent: window of the dialog.
        start: path of the drawing that was chosen before; empty where none was.
    """
    drawings = translate("GaussianCAD", "Drawings")
    everything = translate("GaussianCAD", "All files")
    patterns = " ".join(f"*.{suffix} *.{suffix.upper()}" for suffix in SHEET_SUFFIXES)
    general = FreeCAD.ParamGet("User parameter:BaseApp/Preferences/General")
    path, _ = QtWidgets.QFileDialog.getOpenFileName(
        parent,
        translate("GaussianCAD", "Choose a Drawing"),
        start or general.GetString(_LAST_FOLDER, ""),
        f"{drawings} ({patterns});;{everything} (*)",
        options=QtWidgets.QFileDialog.Option.HideNameFilterDetails,
    )
    if not path:
        return None
    general.SetString(_LAST_FOLDER, str(Path(path).parent))
    return Path(path)
