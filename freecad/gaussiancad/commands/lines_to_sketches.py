"""*Lines to Sketches…*: the cleaned lines of a drawing as sketches."""

import FreeCADGui

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP


class LinesToSketchesCommand:
    """Reads a drawing, and adds a sketch for each of its views."""

    name = "GaussianCAD_LinesToSketches"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_LinesToSketches", "Lines to Sketches…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_LinesToSketches",
                "Makes a sketch on its plane of the lines of each view, to model from by hand",
            ),
        }

    def IsActive(self) -> bool:
        """Whenever no other task panel is open; a document is made if there is none."""
        return not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Read the selected reconstruction's drawing, or a file."""
        from freecad.gaussiancad.panels.lines_to_sketches import open_sketches

        open_sketches(FreeCADGui.Selection.getSelection())
