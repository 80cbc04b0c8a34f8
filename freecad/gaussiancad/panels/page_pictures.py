"""Pictures of files that FreeCAD cannot show, made by the engine: PDF, SVG and DXF."""

import tempfile
from collections.abc import Callable

from freecad.gaussiancad.canvas.engine_server import Engine, Server
from freecad.gaussiancad.errors import WorkbenchError
from freecad.gaussiancad.panels.engine_program import engine_program
from freecad.gaussiancad.qt import QtCore

_LONGEST = 1200
"""px of the longer side of a picture."""

_REST_MS = 400
"""Milliseconds for which a path or page stays the same before its picture is asked for."""


class PagePictures(QtCore.QObject):
    """Asks for one picture at a time; the engine starts with the first, and ends with the panel.

    Args:
        show: is told the path of the picture that was asked for last.
    """

    def __init__(self, show: Callable[[str], None]) -> None:
        super().__init__()
        self._show = show
        self._server: Server | None = None
        self._folder: tempfile.TemporaryDirectory[str] | None = None
        self._wanted: tuple[str, int] | None = None
        self._rest = QtCore.QTimer(self)
        self._rest.setSingleShot(True)
        self._rest.setInterval(_REST_MS)
        self._rest.timeout.connect(self._ask)

    def ask(self, path: str, page: int) -> None:
        """Ask for the picture of a page; without an engine none comes."""
        self._wanted = path, page
        self._rest.start()

    def forget(self) -> None:
        """Want no picture any more."""
        self._wanted = None
        self._rest.stop()

    def close(self) -> None:
        """End the engine, and remove the pictures."""
        self.forget()
        if self._server is not None:
            self._server.close()
            self._server = None
        if self._folder is not None:
            self._folder.cleanup()
            self._folder = None

    def _ask(self) -> None:
        if self._wanted is None:
            return
        if self._server is None:
            try:
                self._server = Server(Engine(engine_program()), self)
            except WorkbenchError:
                return
            self._folder = tempfile.TemporaryDirectory(
                prefix="gaussiancad-", ignore_cleanup_errors=True
            )
        wanted = path, page = self._wanted

        def done(answer: dict) -> None:
            if "picture" in answer and wanted == self._wanted:
                self._show(answer["picture"])

        self._server.stop()
        asked = {"sheet": path, "page": page, "output": self._folder.name, "most": _LONGEST}
        self._server.ask("thumbnail", done, **asked)
