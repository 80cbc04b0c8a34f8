"""*Reconstruct from Drawing…*: opens the task panel."""

import FreeCADGui

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP


class ReconstructCommand:
    """Opens the task panel that turns a drawing into a part."""

    name = "GaussianCAD_Reconstruct"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_Reconstruct", "Reconstruct from Drawing…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_Reconstruct",
                "Creates a 3D part from a drawing with two or more views",
            ),
        }

    def IsActive(self) -> bool:
        """Whenever no other task panel is open; a document is made if there is none."""
        return not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Open the panel."""
        from freecad.gaussiancad.panels.reconstruct import ReconstructPanel

        FreeCADGui.Control.showDialog(ReconstructPanel())
