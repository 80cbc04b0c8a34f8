"""*To Body…*: a solid as an editable body."""

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP


class ToBodyCommand:
    """Finds the features of a solid, and makes a body of them."""

    name = "GaussianCAD_ToBody"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_ToBody", "To Body…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_ToBody",
                "Makes an editable body, with sketches, pads and holes, of the selected solid",
            ),
        }

    def IsActive(self) -> bool:
        """Whenever a document is open and no other task panel is."""
        return FreeCAD.ActiveDocument is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Make a body of the selected solid, or say what to select."""
        from freecad.gaussiancad.panels.to_body import open_body

        open_body(FreeCADGui.Selection.getSelection())
