"""*Install Engine…*: makes the environment that the addon manages."""

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP


class InstallEngineCommand:
    """Opens a dialog that says what would be downloaded, and does it on request."""

    name = "GaussianCAD_InstallEngine"

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {
            "Pixmap": self.name,
            "MenuText": QT_TRANSLATE_NOOP("GaussianCAD_InstallEngine", "Install Engine…"),
            "ToolTip": QT_TRANSLATE_NOOP(
                "GaussianCAD_InstallEngine",
                "Downloads and installs the engine into an environment of its own",
            ),
        }

    def IsActive(self) -> bool:
        """Always."""
        return True

    def Activated(self) -> None:
        """Open the dialog."""
        from freecad.gaussiancad.panels.install_engine import InstallEngineDialog

        InstallEngineDialog.open_now()
