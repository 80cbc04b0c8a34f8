"""Tells once that an object of a document has another geometry than it had."""

from collections.abc import Callable

import FreeCAD

from freecad.gaussiancad.objects.sources import Source
from freecad.gaussiancad.qt import QtCore

_PAUSE_MILLISECONDS = 400
"""After the last change: who drags a dimension changes it often."""

_GEOMETRY = ("Shape", "Mesh", "Placement")


class ModelWatch:
    """Watches one object.

    Args:
        source: the object; a file is not watched.
        on_changed: is told, once.
    """

    def __init__(self, source: Source, on_changed: Callable[[], None]) -> None:
        self._source, self._on_changed = source, on_changed
        self._state = source.state()
        self._timer = QtCore.QTimer()
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._look)
        self._is_watching = source.feature is not None
        if self._is_watching:
            FreeCAD.addDocumentObserver(self)

    @property
    def is_changed(self) -> bool:
        """Whether the geometry is another one now."""
        return self._source.state() != self._state

    def slotChangedObject(self, changed: FreeCAD.DocumentObject, name: str) -> None:
        """Look after a pause, whichever object it was: what is watched may lie in it."""
        if name in _GEOMETRY:
            self._timer.start(_PAUSE_MILLISECONDS)

    def stop(self) -> None:
        """Watch no more."""
        self._timer.stop()
        if self._is_watching:
            self._is_watching = False
            FreeCAD.removeDocumentObserver(self)

    def _look(self) -> None:
        if self._is_watching and self.is_changed:
            self.stop()
            self._on_changed()
