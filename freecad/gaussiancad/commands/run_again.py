"""*Run Again*: reads the drawing of a reconstruction once more, with the settings of then."""

import FreeCADGui

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP
from freecad.gaussiancad.objects.known_sheets import reconstruction_among


class RunAgainCommand:
    """Opens the task panel on the selected reconstruction, and starts."""

    name = "GaussianCAD_RunAgain"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": "GaussianCAD_Reconstruct",
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_RunAgain", "Run Again"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_RunAgain",
                "Reconstructs the drawing of what is selected again and updates the result",
            ),
        }

    def IsActive(self) -> bool:
        """Whenever a reconstruction is selected, or something of it, and no panel is open."""
        chosen = reconstruction_among(FreeCADGui.Selection.getSelection())
        return chosen is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Open the panel, and start."""
        from freecad.gaussiancad.panels.reconstruct import run_again

        chosen = reconstruction_among(FreeCADGui.Selection.getSelection())
        if chosen is not None:
            run_again(chosen)
