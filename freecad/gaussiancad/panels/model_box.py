"""Where one side of a comparison is chosen: an object of the document, or a file."""

from collections.abc import Sequence
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.known_sheets import reconstruction_among
from freecad.gaussiancad.objects.sources import MODEL_SUFFIXES, Source
from freecad.gaussiancad.qt import QtCore, QtWidgets


class ModelBox(QtWidgets.QComboBox):
    """The objects of a document, then the files that were chosen, then an entry to choose one.

    Args:
        name: of the widget.
        features: the objects that are offered.
    """

    def __init__(self, name: str, features: Sequence[FreeCAD.DocumentObject]) -> None:
        super().__init__()
        self.setObjectName(name)
        policy = QtWidgets.QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        self.setSizeAdjustPolicy(policy)
        self.setMinimumContentsLength(8)
        for feature in features:
            self.addItem(_name_of(feature), ("object", feature.Name))
        self.addItem(translate("GaussianCAD", "File…"), ("ask", ""))
        self._last = 0
        if not features:
            self.setCurrentIndex(-1)
        self.activated.connect(self._take)

    def choose(self, name: str) -> None:
        """Choose an object by its name."""
        for index in range(self.count()):
            if tuple(self.itemData(index)) == ("object", name):
                self.setCurrentIndex(index)
                self._last = index

    def choose_file(self, path: Path) -> None:
        """Offer a file, and choose it."""
        index = self.count() - 1
        self.insertItem(index, path.name, ("file", str(path)))
        self.setItemData(index, str(path), QtCore.Qt.ItemDataRole.ToolTipRole)
        self.setCurrentIndex(index)
        self._last = index

    def source(self, document: FreeCAD.Document) -> Source | None:
        """What is chosen, or None."""
        kind, name = self.itemData(self.currentIndex()) or ("", "")
        if kind == "file":
            return Source(path=name)
        feature = document.getObject(name) if kind == "object" else None
        return None if feature is None else Source(feature)

    def _take(self, index: int) -> None:
        if tuple(self.itemData(index)) != ("ask", ""):
            self._last = index
            return
        patterns = " ".join(f"*.{suffix} *.{suffix.upper()}" for suffix in MODEL_SUFFIXES)
        path, _ = QtWidgets.QFileDialog.getOpenFileName(
            self,
            translate("GaussianCAD", "Model to Compare"),
            "",
            translate("GaussianCAD", "Models ({patterns})").format(patterns=patterns),
        )
        if path:
            self.choose_file(Path(path))
        else:
            self.setCurrentIndex(self._last if self.count() > 1 else -1)


def _name_of(feature: FreeCAD.DocumentObject) -> str:
    """What an object is called, with the drawing that it was made from."""
    group = reconstruction_among([feature])
    if group is None:
        return feature.Label
    return f"{feature.Label} \u2013 {Path(group.SheetPath).name}"
