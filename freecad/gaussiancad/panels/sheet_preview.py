"""A picture of the sheet, onto which a file can be dropped."""

from collections.abc import Callable
from pathlib import Path

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.sheet_views import read_sheet_image
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_LARGEST_PREVIEW = 1600


class SheetPreview(QtWidgets.QLabel):
    """Shows a sheet, fitted into the widget.

    Args:
        on_dropped: is told the path of a file that was dropped here; None takes no files.
    """

    def __init__(self, on_dropped: Callable[[str], None] | None = None) -> None:
        super().__init__()
        self.setObjectName("preview")
        self.setAlignment(QtCore.Qt.AlignmentFlag.AlignCenter)
        self.setFrameShape(QtWidgets.QFrame.Shape.StyledPanel)
        self.setMinimumHeight(150)
        self.setWordWrap(True)
        ignored = QtWidgets.QSizePolicy.Policy.Ignored
        self.setSizePolicy(ignored, QtWidgets.QSizePolicy.Policy.Fixed)
        self._on_dropped = on_dropped
        self.setAcceptDrops(on_dropped is not None)
        self._image: QtGui.QPixmap | None = None
        self.show_file("")

    def show_file(self, path: str) -> None:
        """Show the picture at a path, or say why there is none."""
        self._image = None
        if not path:
            self.setText(translate("GaussianCAD", "Drop a drawing here"))
            return
        image = read_sheet_image(Path(path)) if Path(path).is_file() else None
        if image is None:
            text = translate(
                "GaussianCAD", "No preview of {name} here; the engine shows it when it is done"
            )
            self.setText(text.format(name=Path(path).name))
            return
        if max(image.width(), image.height()) > _LARGEST_PREVIEW:
            image = image.scaled(
                _LARGEST_PREVIEW,
                _LARGEST_PREVIEW,
                QtCore.Qt.AspectRatioMode.KeepAspectRatio,
                QtCore.Qt.TransformationMode.SmoothTransformation,
            )
        self._image = QtGui.QPixmap.fromImage(image)
        self._fit()

    @property
    def has_picture(self) -> bool:
        """Whether a picture is shown."""
        return self._image is not None

    def resizeEvent(self, event: QtGui.QResizeEvent) -> None:
        """Fit the picture to the new size."""
        super().resizeEvent(event)
        self._fit()

    def dragEnterEvent(self, event: QtGui.QDragEnterEvent) -> None:
        """Accept files of this machine."""
        if _first_file(event.mimeData()):
            event.acceptProposedAction()

    def dropEvent(self, event: QtGui.QDropEvent) -> None:
        """Take the first file."""
        if path := _first_file(event.mimeData()):
            event.acceptProposedAction()
            self._on_dropped(path)

    def _fit(self) -> None:
        if self._image is None:
            return
        room = self.contentsRect().size() - QtCore.QSize(8, 8)
        self.setPixmap(
            self._image.scaled(
                room,
                QtCore.Qt.AspectRatioMode.KeepAspectRatio,
                QtCore.Qt.TransformationMode.SmoothTransformation,
            )
        )


def _first_file(data: QtCore.QMimeData) -> str:
    return next((url.toLocalFile() for url in data.urls() if url.isLocalFile()), "")
