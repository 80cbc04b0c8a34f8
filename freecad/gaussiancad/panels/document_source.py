"""A button that offers the drawings of the open document: TechDraw pages and images."""

from collections.abc import Callable

import FreeCAD

from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.document_sheets import sheet_objects
from freecad.gaussiancad.qt import QtWidgets


class DocumentSource(QtWidgets.QToolButton):
    """The button; its menu is made anew whenever it opens.

    Args:
        on_chosen: is told the object that was chosen.
    """

    def __init__(self, on_chosen: Callable[[FreeCAD.DocumentObject], None]) -> None:
        super().__init__()
        self.setObjectName("source")
        self.setText(translate("GaussianCAD", "From the Document"))
        self.setToolTip(
            translate("GaussianCAD", "Takes a TechDraw page or an image of the active document")
        )
        self.setPopupMode(QtWidgets.QToolButton.ToolButtonPopupMode.InstantPopup)
        self._on_chosen = on_chosen
        menu = QtWidgets.QMenu(self)
        menu.aboutToShow.connect(self.offer)
        self.setMenu(menu)

    def offer(self) -> None:
        """Fill the menu with what the active document holds now."""
        menu = self.menu()
        menu.clear()
        for source in sheet_objects(FreeCAD.ActiveDocument):
            action = menu.addAction(source.Label)
            action.triggered.connect(lambda _=False, chosen=source: self._on_chosen(chosen))
        if menu.isEmpty():
            menu.addAction(
                translate("GaussianCAD", "The document has no TechDraw pages and no images")
            ).setEnabled(False)
