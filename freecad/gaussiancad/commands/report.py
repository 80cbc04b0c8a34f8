"""*Report*: shows what is known of a reconstruction."""

import FreeCADGui

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP
from freecad.gaussiancad.objects.known_sheets import reconstruction_among


class ReportCommand:
    """Opens the report of the selected reconstruction, as a double click on it does."""

    name = "GaussianCAD_Report"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": "GaussianCAD_Reconstruct",
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_Report", "Report"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_Report",
                "Shows how far the part can be trusted, why, and what was read of the drawing",
            ),
        }

    def IsActive(self) -> bool:
        """Whenever a reconstruction is selected, or something of it."""
        return reconstruction_among(FreeCADGui.Selection.getSelection()) is not None

    def Activated(self) -> None:
        """Open the dialog."""
        from freecad.gaussiancad.panels.report import ReportDialog

        chosen = reconstruction_among(FreeCADGui.Selection.getSelection())
        if chosen is not None:
            ReportDialog.open_for(chosen)
