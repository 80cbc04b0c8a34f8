"""The workbench: its toolbar, its menu, its preferences page, its translations."""

import FreeCADGui

from freecad.gaussiancad import paths
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP, translate
from freecad.gaussiancad.workbench_names import MENU, OF_A_RECONSTRUCTION, TOOLBAR


class GaussianCADWorkbench(FreeCADGui.Workbench):
    """What FreeCAD's list of workbenches shows; the class's name is in ``package.xml``."""

    MenuText = "GaussianCAD"
    ToolTip = QT_TRANSLATE_NOOP("Workbench", "Turns drawings with three views into 3D parts")
    Icon = paths.icon("GaussianCAD_Workbench")

    def GetClassName(self) -> str:
        """FreeCAD's class for workbenches in Python."""
        return "Gui::PythonWorkbench"

    def Initialize(self) -> None:
        """Make toolbar and menu, when the workbench is shown for the first time."""
        from freecad.gaussiancad import commands

        commands.register()
        name = QT_TRANSLATE_NOOP("Workbench", "GaussianCAD")
        self.appendToolbar(name, list(TOOLBAR))
        self.appendMenu(name, list(MENU))

    def ContextMenu(self, recipient: str) -> None:
        """Offer what can be done with what is selected."""
        from freecad.gaussiancad.objects.known_sheets import reconstruction_among
        from freecad.gaussiancad.objects.solid_parts import solid_among

        chosen = FreeCADGui.Selection.getSelection()
        commands = OF_A_RECONSTRUCTION if reconstruction_among(chosen) is not None else ()
        if solid_among(chosen) is not None:
            commands = (*commands, "GaussianCAD_ToBody")
        if chosen:
            self.appendContextMenu("", [*commands, "GaussianCAD_Compare", "GaussianCAD_Check"])


def register() -> None:
    """Make the workbench known to FreeCAD; a second call does nothing."""
    if GaussianCADWorkbench.__name__ in FreeCADGui.listWorkbenches():
        return
    FreeCADGui.addLanguagePath(str(paths.TRANSLATIONS))
    FreeCADGui.updateLocale()
    FreeCADGui.addIconPath(str(paths.ICONS))
    FreeCADGui.addPreferencePage(
        str(paths.UI / "preferences.ui"), translate("GaussianCAD", "GaussianCAD")
    )
    FreeCADGui.addWorkbench(GaussianCADWorkbench())
