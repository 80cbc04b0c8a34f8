"""The canvas shows which of its sheet's numbers somebody has changed in the body."""

import FreeCAD

from freecad.gaussiancad.canvas.changes import Change
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.objects.bodies_of_parts import bodies_of
from freecad.gaussiancad.objects.corrected_sheet import InDocument
from freecad.gaussiancad.objects.reconstruction_features import find_part
from freecad.gaussiancad.objects.sheet_numbers import changed_numbers
from freecad.gaussiancad.panels.numbers_back import take_back
from freecad.gaussiancad.qt import QtCore


class BodyChanges:
    """Follows the newest body of a canvas's part; FreeCAD calls the slots by their names.

    Args:
        store: knows the reconstruction.
        canvas: shows the numbers.
    """

    def __init__(self, store: InDocument, canvas: SheetWindow) -> None:
        self._store, self._canvas = store, canvas
        self._known: tuple[Change, ...] = ()
        self._open = True
        FreeCAD.addDocumentObserver(self)

    def close(self) -> None:
        """Follow no more."""
        if self._open:
            self._open = False
            FreeCAD.removeDocumentObserver(self)

    def follow(self) -> None:
        """Show the numbers as they are now."""
        if not self._open:
            return
        body = self._body()
        found = () if body is None else changed_numbers(body)
        changes = tuple(Change(each.path, each.on_sheet, each.now) for each in found)
        if changes != self._known:
            self._known = changes
            self._canvas.show_changes(changes, self._set_back)

    def slotRecomputedDocument(self, document: FreeCAD.Document) -> None:
        """Numbers of a body work from now on."""
        self._ask(document)

    def slotUndoDocument(self, document: FreeCAD.Document) -> None:
        """Numbers are what they were."""
        self._ask(document)

    def slotRedoDocument(self, document: FreeCAD.Document) -> None:
        """Numbers are others again."""
        self._ask(document)

    def _ask(self, document: FreeCAD.Document) -> None:
        if document.Name == self._store.document:
            QtCore.QTimer.singleShot(0, self.follow)

    def _body(self) -> FreeCAD.DocumentObject | None:
        group = self._store.find()
        part = None if group is None else find_part(group)
        bodies = () if part is None else bodies_of(part)
        return bodies[-1] if bodies else None

    def _set_back(self) -> None:
        body = self._body()
        if body is not None:
            take_back([body])
