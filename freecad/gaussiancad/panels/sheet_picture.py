"""The sheet with a result's redrawn lines over it, as wide as the panel."""

from pathlib import Path

from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets


class SheetPicture(QtWidgets.QLabel):
    """A picture that keeps its proportions; a tooltip shows it larger.

    Args:
        path: of the picture.
    """

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.setObjectName("sheetPicture")
        self._image = QtGui.QPixmap(str(path))
        self.setMinimumSize(120, 120)
        self.setAlignment(QtCore.Qt.AlignmentFlag.AlignHCenter | QtCore.Qt.AlignmentFlag.AlignTop)
        self.setToolTip(f'<img src="{path}" width="900">')

    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:
        """Fit the picture into the new width."""
        super().resizeEvent(event)
        if not self._image.isNull():
            self.setPixmap(
                self._image.scaled(
                    self.size(),
                    QtCore.Qt.AspectRatioMode.KeepAspectRatio,
                    QtCore.Qt.TransformationMode.SmoothTransformation,
                )
            )
