"""*Open Failed Sheets…*: steps through the sheets of a batch that need a person."""

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP


class FailedSheetsCommand:
    """Asks for the report of a batch, and lists its sheets that are not verified."""

    name = "GaussianCAD_FailedSheets"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_FailedSheets", "Open Failed Sheets…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_FailedSheets",
                "Steps through the sheets of a batch that failed or are approximate",
            ),
        }

    def IsActive(self) -> bool:
        """Always: the list stands beside the others."""
        return True

    def Activated(self) -> None:
        """Ask for the report, and list its sheets."""
        from freecad.gaussiancad.panels.failed_sheets import ask_report

        ask_report()
