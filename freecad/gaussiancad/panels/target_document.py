"""The document into which a part goes: one that is open, or a new one."""

from pathlib import Path

import FreeCAD

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.known_sheets import group_of
from freecad.gaussiancad.qt import QtWidgets


class TargetDocument(QtWidgets.QWidget):
    """A list of the documents; which are open is looked up whenever it is asked.

    Unless a person chose one, it is the document that is active, where that is empty or has the
    drawing already: another drawing's part would lie over what is there.
    """

    def __init__(self) -> None:
        super().__init__()
        self.box = QtWidgets.QComboBox()
        self.box.setObjectName("target")
        self.box.setToolTip(translate("GaussianCAD", "The document into which the part goes"))
        self.box.activated.connect(self._choose)
        layout = QtWidgets.QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(QtWidgets.QLabel(translate("GaussianCAD", "Into")))
        layout.addWidget(self.box, 1)
        self._chosen = False
        self._fill("")

    @property
    def name(self) -> str:
        """Name of the document; empty for a new one, as where the chosen one was closed."""
        name = self.box.currentData() or ""
        return name if name in FreeCAD.listDocuments() else ""

    def suggest(self, sheet: str, page: int, holder: str) -> None:
        """Show where the part of a drawing goes, unless a person said it.

        Args:
            sheet: path of the drawing.
            page: of a file with pages.
            holder: name of the document that holds the drawing; empty where none does.
        """
        if self._chosen and self.name:
            self._fill(self.name)
            return
        self._chosen = False
        active = FreeCAD.ActiveDocument
        if holder:
            self._fill(holder)
        elif active is not None and (
            not active.Objects or group_of(active, Path(sheet), page) is not None
        ):
            self._fill(active.Name)
        else:
            self._fill("")

    def take(self, name: str) -> None:
        """Show the document in which a run put its part."""
        self._chosen = False
        self._fill(name)

    def _choose(self, _index: int) -> None:
        self._chosen = True

    def _fill(self, name: str) -> None:
        self.box.clear()
        self.box.addItem(translate("GaussianCAD", "A new document"), "")
        for known, document in FreeCAD.listDocuments().items():
            self.box.addItem(document.Label, known)
        self.box.setCurrentIndex(max(0, self.box.findData(name)))
