"""*Check Engine…*: shows what the engine says of itself."""

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP


class CheckEngineCommand:
    """Opens a dialog with the engine's place and its own diagnosis."""

    name = "GaussianCAD_CheckEngine"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_CheckEngine", "Check Engine…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_CheckEngine",
                "Shows where the engine is, what it lacks and what to do about it",
            ),
        }

    def IsActive(self) -> bool:
        """Always."""
        return True

    def Activated(self) -> None:
        """Open the dialog."""
        from freecad.gaussiancad.panels.check_engine import CheckEngineDialog

        CheckEngineDialog.open_now()
