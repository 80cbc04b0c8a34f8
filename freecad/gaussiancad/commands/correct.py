"""*Correct Sheet…*: opens the canvas on a drawing."""

import FreeCADGui

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP


class CorrectCommand:
    """Opens the window that shows what was read of a drawing, and takes corrections."""

    name = "GaussianCAD_Correct"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_Correct", "Correct Sheet…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_Correct",
                "Shows what was understood of a drawing, lets it be corrected, and makes the part",
            ),
        }

    def IsActive(self) -> bool:
        """Always: the window stands beside the others."""
        return True

    def Activated(self) -> None:
        """Open the window on the selected reconstruction's drawing, or on a file."""
        from freecad.gaussiancad.panels.correct import open_canvas

        open_canvas(FreeCADGui.Selection.getSelection())
