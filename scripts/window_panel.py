"""Reconstructs sheets in the panel of FreeCAD's window and notes the seconds.

``python -m benchmarks seconds`` starts it: FreeCAD imports this file. GAUSSIANCAD_SHEETS are
the paths, one a line; GAUSSIANCAD_SECONDS is the file that receives, a line of JSON for each sheet,
``sheet`` and the seconds from the press of *Start* to what was ``read`` and to the ``solid`` in the
document; null for what did not come. The rest of the run, mesh and Gaussians, is cancelled.
"""

import json
import os
import sys
import time
import traceback
from pathlib import Path

import FreeCAD
import FreeCADGui

ADDON = Path(__file__).resolve().parents[1]


def make_importable() -> None:
    """Put the addon into the ``freecad`` namespace, installed or not."""
    import freecad

    if str(ADDON / "freecad") not in freecad.__path__:
        freecad.__path__.append(str(ADDON / "freecad"))


make_importable()

from freecad.gaussiancad.engine.protocol import Event, EventKind  # noqa: E402
from freecad.gaussiancad.panels.reconstruct import ReconstructPanel  # noqa: E402
from freecad.gaussiancad.qt import QtCore, QtWidgets  # noqa: E402

PATIENCE_SECONDS = 240.0

CANCEL_SECONDS = 30.0
"""s within which a run that is cancelled has to end."""


def spin(seconds: float) -> None:
    """Let the window live for a while."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtWidgets.QApplication.processEvents()
        time.sleep(0.005)


class TimedPanel(ReconstructPanel):
    """The panel; it notes when the engine had read."""

    def __init__(self) -> None:
        super().__init__()
        self.read_at: float | None = None

    def take_event(self, event: Event) -> None:
        """Note the time of what was read."""
        if event.kind is EventKind.READING and self.read_at is None:
            self.read_at = time.monotonic()
        super().take_event(event)


def has_solid(document: FreeCAD.Document) -> bool:
    """Whether a part with a volume is there."""
    shapes = (item.Shape for item in document.Objects if hasattr(item, "Shape"))
    return any(shape.Solids for shape in shapes)


def timed(sheet: Path) -> dict[str, object]:
    """Reconstruct a sheet in a new document, with the settings that a new user has."""
    document = FreeCAD.newDocument(sheet.stem.title().replace("-", ""))
    panel = TimedPanel()
    FreeCADGui.Control.showDialog(panel)
    panel.sheet.line.setText(str(sheet))
    spin(1.0)
    button = FreeCADGui.getMainWindow().findChild(QtWidgets.QPushButton, "start")
    solid_at: float | None = None
    began = time.monotonic()
    button.click()
    while solid_at is None and panel.running and time.monotonic() < began + PATIENCE_SECONDS:
        spin(0.02)
        if has_solid(document):
            solid_at = time.monotonic()
    panel.cancel()
    end = time.monotonic() + CANCEL_SECONDS
    while panel.running and time.monotonic() < end:
        spin(0.02)
    for box in QtWidgets.QApplication.topLevelWidgets():
        if isinstance(box, QtWidgets.QMessageBox):
            box.close()
    FreeCADGui.Control.closeDialog()
    spin(0.3)
    FreeCAD.closeDocument(document.Name)
    return {
        "sheet": str(sheet),
        **{
            name: None if at is None else round(at - began, 2)
            for name, at in (("read", panel.read_at), ("solid", solid_at))
        },
    }


def time_all() -> None:
    """All sheets; then FreeCAD ends."""
    status = 1
    try:
        FreeCADGui.activateWorkbench("GaussianCADWorkbench")
        with Path(os.environ["GAUSSIANCAD_SECONDS"]).open("w", encoding="utf-8") as found:
            for line in os.environ["GAUSSIANCAD_SHEETS"].splitlines():
                found.write(json.dumps(timed(Path(line))) + "\n")
                found.flush()
        status = 0
    except Exception:
        with open(2, "w", encoding="utf-8", closefd=False) as stream:
            stream.write(traceback.format_exc())
    finally:
        sys.stdout.flush()
        os._exit(status)


QtCore.QTimer.singleShot(1500, time_all)
