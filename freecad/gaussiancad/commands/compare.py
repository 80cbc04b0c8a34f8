"""*Compare with Reference…*: opens the task panel."""

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP


class CompareCommand:
    """Opens the task panel that measures a result against a reference."""

    name = "GaussianCAD_Compare"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_Compare", "Compare with Reference…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_Compare",
                "Measures how far a part or mesh is from another one and colours the difference",
            ),
        }

    def IsActive(self) -> bool:
        """Whenever a document is open and no other task panel is."""
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Open the panel on the active document."""
        from freecad.gaussiancad.panels.compare import ComparePanel

        FreeCADGui.Control.showDialog(ComparePanel(FreeCAD.ActiveDocument))
