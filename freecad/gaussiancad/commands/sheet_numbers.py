"""*Back to the Sheet's Numbers*: undoes changes of a body's numbers, whatever was done since."""

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP


class SheetNumbersCommand:
    """Gives bodies the drawing's numbers again."""

    name = "GaussianCAD_SheetNumbers"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP(
                "GaussianCAD_SheetNumbers", "Back to the Sheet's Numbers"
            ),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_SheetNumbers",
                "Sets all numbers of the body that the drawing tells back to the drawing's",
            ),
        }

    def IsActive(self) -> bool:
        """Whenever the document has a body with numbers of a drawing."""
        from freecad.gaussiancad.objects.sheet_numbers import bodies_meant

        document = FreeCAD.ActiveDocument
        return document is not None and bool(bodies_meant(document, ()))

    def Activated(self) -> None:
        """Set them back, of what is selected, or of all bodies."""
        from freecad.gaussiancad.objects.sheet_numbers import bodies_meant
        from freecad.gaussiancad.panels.numbers_back import take_back

        selected = FreeCADGui.Selection.getSelection()
        take_back(bodies_meant(FreeCAD.ActiveDocument, selected))
