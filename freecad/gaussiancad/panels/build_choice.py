"""The choice between the engines: with either build of PyTorch, or without it."""

from freecad.gaussiancad.engine.locks import EngineBuild
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtCore, QtWidgets


class BuildChoice(QtWidgets.QWidget):
    """One entry a build, with what it takes.

    Args:
        build: that is chosen at first.
        has_card: whether an NVIDIA card was seen.
    """

    changed = QtCore.Signal()

    def __init__(self, build: EngineBuild, has_card: bool) -> None:
        super().__init__()
        self._buttons: dict[EngineBuild, QtWidgets.QRadioButton] = {}
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        for each in EngineBuild:
            text = _solid_text() if each is EngineBuild.SOLID else _torch_text(each, has_card)
            button = QtWidgets.QRadioButton(text)
            button.setObjectName(each.value)
            button.setChecked(each is build)
            button.toggled.connect(self._tell)
            layout.addWidget(button)
            self._buttons[each] = button

    @property
    def build(self) -> EngineBuild:
        """The build that is chosen."""
        return next(each for each, button in self._buttons.items() if button.isChecked())

    def _tell(self, on: bool) -> None:
        if on:
            self.changed.emit()


def _torch_text(build: EngineBuild, has_card: bool) -> str:
    """What an engine with PyTorch takes, and what speaks for it."""
    if build is EngineBuild.CPU:
        sizes, seen = translate("GaussianCAD", "0.7 GB to download, 3 GB on disk"), ""
    else:
        sizes = translate("GaussianCAD", "3.3 GB to download, 7 GB on disk")
        card = (
            translate("GaussianCAD", "an NVIDIA card was found")
            if has_card
            else translate("GaussianCAD", "no NVIDIA card was found")
        )
        seen = f" ({card})"
    text = translate("GaussianCAD", "PyTorch for {build}: {sizes}")
    return text.format(build=build_name(build), sizes=sizes) + seen


def _solid_text() -> str:
    """What the engine without PyTorch takes, and what it lacks."""
    text = translate("GaussianCAD", "Exact solids only, without surfaces: {sizes}")
    sizes = translate("GaussianCAD", "0.4 GB to download, 1.5 GB on disk")
    lacks = translate(
        "GaussianCAD",
        "Reads drawings, makes solids and bodies. Gaussians, their mesh, and Compare with "
        "Reference need one of the others.",
    )
    return f"{text.format(sizes=sizes)}\n{lacks}"


def build_name(build: EngineBuild) -> str:
    """What a build is for, as the user reads it within a sentence."""
    names = {
        EngineBuild.CPU: translate("GaussianCAD", "the processor (CPU)"),
        EngineBuild.CUDA: translate("GaussianCAD", "NVIDIA cards (CUDA)"),
        EngineBuild.SOLID: translate("GaussianCAD", "exact solids only"),
    }
    return names[build]
