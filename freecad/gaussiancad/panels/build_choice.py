"""The choice between the builds of PyTorch."""

from freecad.gaussiancad.engine.locks import TorchBuild
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtWidgets


class BuildChoice(QtWidgets.QWidget):
    """One entry a build, with what it takes.

    Args:
        build: that is chosen at first.
        has_card: whether an NVIDIA card was seen.
    """

    changed = QtCore.Signal()

    def __init__(self, build: TorchBuild, has_card: bool) -> None:
        super().__init__()
        seen = (
            translate("GaussianCAD", "an NVIDIA card was found")
            if has_card
            else translate("GaussianCAD", "no NVIDIA card was found")
        )
        sizes = {
            TorchBuild.CPU: translate("GaussianCAD", "0.7 GB to download, 3 GB on disk"),
            TorchBuild.CUDA: translate("GaussianCAD", "3.3 GB to download, 7 GB on disk"),
        }
        self._buttons: dict[TorchBuild, QtWidgets.QRadioButton] = {}
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for item in TorchBuild:
            text = translate("GaussianCAD", "PyTorch for {build}: {sizes}")
            text = text.format(build=build_name(item), sizes=sizes[item])
            if item is TorchBuild.CUDA:
                text += f" ({seen})"
            button = QtWidgets.QRadioButton(text)
            button.setObjectName(item.value)
            button.setChecked(item is build)
            button.toggled.connect(self._tell)
            layout.addWidget(button)
            self._buttons[item] = button

    @property
    def build(self) -> TorchBuild:
        """The build that is chosen."""
        return next(item for item, button in self._buttons.items() if button.isChecked())

    def _tell(self, on: bool) -> None:
        if on:
            self.changed.emit()


def build_name(build: TorchBuild) -> str:
    """What a build is for, as the user reads it within a sentence."""
    names = {
        TorchBuild.CPU: translate("GaussianCAD", "the processor (CPU)"),
        TorchBuild.CUDA: translate("GaussianCAD", "NVIDIA cards (CUDA)"),
    }
    return names[build]
