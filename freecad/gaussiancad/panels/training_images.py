"""How large the images are that the paper's cameras train on, with what that costs."""

from freecad.gaussiancad.engine.paper_effort import (
    LARGEST_SCALE_DOWN,
    paper_effort,
    usual_scale_down,
)
from freecad.gaussiancad.engine.protocol import Preset
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.qt import QtWidgets


class TrainingImages(QtWidgets.QWidget):
    """A factor, and below it the size of the images and the time that a processor takes.

    A factor that the user chose stays; another one follows the preset.

    Args:
        preset: to start with.
        chosen: a factor that the user chose before, or None.
    """

    def __init__(self, preset: Preset, chosen: int | None = None) -> None:
        super().__init__()
        self._preset = preset
        self._chosen = chosen is not None
        self.factor = QtWidgets.QSpinBox()
        self.factor.setObjectName("scaleDown")
        self.factor.setRange(1, LARGEST_SCALE_DOWN)
        self.factor.setPrefix("1 / ")
        self.factor.setToolTip(
            translate(
                "GaussianCAD",
                "Divides the edges of the images that train the Gaussians. 1 / 1 is the size in "
                "the paper",
            )
        )
        self._effort = QtWidgets.QLabel()
        self._effort.setObjectName("effort")
        self._effort.setWordWrap(True)
        layout = QtWidgets.QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.factor)
        layout.addWidget(self._effort)
        if chosen is not None:
            self.factor.setValue(chosen)
        self._follow()
        self.factor.valueChanged.connect(self._take)

    @property
    def scale_down(self) -> int:
        """By how much the images' edges are divided."""
        return self.factor.value()

    @property
    def chosen(self) -> int | None:
        """The factor that the user chose, or None where it follows the preset."""
        return self.scale_down if self._chosen else None

    def show_preset(self, preset: Preset) -> None:
        """Tell the effort of another preset."""
        self._preset = preset
        self._follow()

    def _follow(self) -> None:
        if not self._chosen:
            self.factor.blockSignals(True)
            self.factor.setValue(usual_scale_down(self._preset))
            self.factor.blockSignals(False)
        self._tell()

    def _take(self) -> None:
        self._chosen = True
        self._tell()

    def _tell(self) -> None:
        effort = paper_effort(self._preset, self.scale_down)
        text = translate("GaussianCAD", "{width} x {height} px, about {minutes} min on a processor")
        minutes = max(1, round(effort.minutes))
        self._effort.setText(text.format(width=effort.width, height=effort.height, minutes=minutes))
