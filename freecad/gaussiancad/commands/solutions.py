"""*Choose among Solutions…*: opens the task panel."""

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP
from freecad.gaussiancad.objects.known_sheets import reconstruction_among
from freecad.gaussiancad.objects.solutions import group_with_choice, has_choice


class SolutionsCommand:
    """Opens the task panel that flips through the solids which fit one drawing."""

    name = "GaussianCAD_Solutions"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_Solutions", "Choose among Solutions…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_Solutions",
                "Flips through the solids that all have the drawing's lines and keeps one",
            ),
        }

    def IsActive(self) -> bool:
        """Whenever the document has a reconstruction with a choice, and no panel is open."""
        return _chosen_group() is not None and not FreeCADGui.Control.activeDialog()

    def Activated(self) -> None:
        """Open the panel on the selected reconstruction, or on the last one."""
        from freecad.gaussiancad.panels.solutions import open_solutions

        group = _chosen_group()
        if group is not None:
            open_solutions(group)


def _chosen_group() -> FreeCAD.DocumentObject | None:
    selected = reconstruction_among(FreeCADGui.Selection.getSelection())
    if selected is not None and has_choice(selected):
        return selected
    return group_with_choice(FreeCAD.ActiveDocument)
