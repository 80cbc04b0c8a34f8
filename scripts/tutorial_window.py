"""Follow the tutorial in FreeCAD's window, by the events of a mouse and keys, and take pictures.

``tutorial_pictures.py`` starts it: FreeCAD imports this file.  The sheets are in the folder
GAUSSIANCAD_SHEETS, the pictures go to GAUSSIANCAD_PICTURES.
"""

import os
import sys
import time
import traceback
from collections.abc import Callable
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

from freecad.gaussiancad.panels import correct  # noqa: E402
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets  # noqa: E402

SHEETS = Path(os.environ["GAUSSIANCAD_SHEETS"])
PICTURES = Path(os.environ["GAUSSIANCAD_PICTURES"])

PATIENCE_SECONDS = 120.0

Point = tuple[float, float]

_LEFT = QtCore.Qt.MouseButton.LeftButton
_NO_BUTTON = QtCore.Qt.MouseButton.NoButton
_NO_KEYS = QtCore.Qt.KeyboardModifier.NoModifier
_EVENTS = QtCore.QEvent.Type
_KEYS = QtCore.Qt.Key

HOLE = (((741.0, 909.0), (741.0, 1000.0)), ((892.0, 909.0), (892.0, 1000.0)))
"""Where the second sheet lacks lines, px of the sheet."""

FRAMES = (
    ((424.0, 1001.0), _KEYS.Key_1),
    ((554.0, 59.0), _KEYS.Key_2),
    ((1576.0, 831.0), _KEYS.Key_3),
)
"""A corner of each view on the third sheet, and the keys that say front, top, right."""

LENGTH, LENGTH_MM = ((424.0, 1000.0), (1028.0, 1000.0)), 80.0
"""Both ends of the bracket's foot on the third sheet, and how long it is."""


def spin(seconds: float) -> None:
    """Let the window live for a while."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        QtWidgets.QApplication.processEvents()
        time.sleep(0.01)


def wait_for(condition: Callable[[], object]) -> None:
    """Let the window live until a condition holds."""
    end = time.monotonic() + PATIENCE_SECONDS
    while not condition():
        if time.monotonic() > end:
            raise TimeoutError("the window did not come that far")
        spin(0.05)


def send_mouse(target: QtWidgets.QWidget, kind: QtCore.QEvent.Type, at: QtCore.QPoint) -> None:
    """A mouse event at a place of a widget."""
    held = _NO_BUTTON if kind == _EVENTS.MouseButtonRelease else _LEFT
    event = QtGui.QMouseEvent(
        kind, QtCore.QPointF(at), QtCore.QPointF(target.mapToGlobal(at)), _LEFT, held, _NO_KEYS
    )
    QtWidgets.QApplication.sendEvent(target, event)
    spin(0.05)


def send_key(target: QtWidgets.QWidget, key: QtCore.Qt.Key, text: str = "") -> None:
    """Press a key and let it go."""
    for kind in (_EVENTS.ShortcutOverride, _EVENTS.KeyPress, _EVENTS.KeyRelease):
        QtWidgets.QApplication.sendEvent(target, QtGui.QKeyEvent(kind, key, _NO_KEYS, text))
    spin(0.05)


def visible(kind: type) -> list:
    """Windows of a kind that are open."""
    tops = QtWidgets.QApplication.topLevelWidgets()
    return [top for top in tops if isinstance(top, kind) and top.isVisible()]


class ScriptedUser:
    """A person at the canvas of one sheet.

    Args:
        name: of the sheet, without ``.png``.
    """

    def __init__(self, name: str) -> None:
        FreeCAD.newDocument(name.split("-", 1)[1].title().replace("-", ""))
        spin(0.3)
        self.dock = correct.open_sheet(SHEETS / f"{name}.png")
        self.canvas_view = self.dock.canvas.canvas_view
        arrange(self.dock)
        wait_for(lambda: self.dock.canvas.sheet is not None)
        self.settle()

    def settle(self) -> None:
        """Wait until the part follows from what was said."""
        spin(1.0)
        wait_for(lambda: not self.dock.canvas.busy)
        spin(0.5)

    def press(self, key: QtCore.Qt.Key) -> None:
        """A key on the canvas."""
        send_key(self.canvas_view, key)

    def drag(self, start: Point, end: Point) -> None:
        """Drag over the sheet; a click where start and end are the same."""
        target = self.canvas_view.viewport()
        first, last = self.canvas_view.mapFromScene(*start), self.canvas_view.mapFromScene(*end)
        send_mouse(target, _EVENTS.MouseButtonPress, first)
        if first != last:
            send_mouse(target, _EVENTS.MouseMove, last)
        send_mouse(target, _EVENTS.MouseButtonRelease, last)

    def click_frame(self, corner: Point) -> None:
        """Click on the upper edge of the frame around a place."""
        views = [view.frame for view in self.dock.canvas.sheet.views]
        x0, y0, x1, _ = next(view for view in views if _holds(view, corner))
        self.drag(((x0 + x1) / 2.0, y0), ((x0 + x1) / 2.0, y0))

    def tell_length(self, ends: tuple[Point, Point], length: float) -> None:
        """Click at two points and type how far they are apart."""
        self.press(_KEYS.Key_M)
        QtCore.QTimer.singleShot(500, lambda: _type_number(length))
        for end in ends:
            self.drag(end, end)
        self.settle()

    def verdict(self) -> str:
        """The first row of the list."""
        return self.dock.canvas.problems.lines[0].text

    def rows(self) -> str:
        """All of the list."""
        return "\n".join(
            f"   {line.text} {[text for text, _ in line.buttons]}"
            for line in self.dock.canvas.problems.lines
        )

    def picture(self, name: str) -> None:
        """Take a picture of the screen; the window's own would lack the 3D view."""
        self.show_views()
        spin(0.8)
        QtWidgets.QApplication.primaryScreen().grabWindow(0).save(str(PICTURES / f"{name}.png"))
        tell_terminal(f"{name}:\n{self.rows()}")

    def film(self, number: int) -> None:
        """Take a picture of the film strip: the canvas beside the part, as they are now."""
        spin(0.3)
        path = PICTURES / f"film-{number}.png"
        QtWidgets.QApplication.primaryScreen().grabWindow(0).save(str(path))

    def show_views(self) -> None:
        """The canvas shows all views, and the 3D view the part as large as it can."""
        views = [this_view.box for this_view in self.dock.canvas.sheet.views if this_view.shown]
        if views:
            x0, y0, x1, y1 = zip(*views, strict=True)
            self.canvas_view.zoom_to((min(x0), min(y0), max(x1), max(y1)))
        else:
            self.canvas_view.fit()
        view = FreeCADGui.ActiveDocument.ActiveView
        if hasattr(view, "fitAll"):
            view.viewIsometric()
            view.fitAll()

    def close(self) -> None:
        """Close the canvas and the document."""
        self.dock.close()
        spin(0.3)
        FreeCAD.closeDocument(FreeCAD.ActiveDocument.Name)
        spin(0.3)


def _holds(frame: tuple[float, float, float, float], at: Point) -> bool:
    """Whether a place lies in a frame."""
    x0, y0, x1, y1 = frame
    return x0 <= at[0] <= x1 and y0 <= at[1] <= y1


def _type_number(value: float) -> None:
    """Fill in the box that asks for a number, and press Enter."""
    (box,) = visible(QtWidgets.QInputDialog)
    field = box.findChild(QtWidgets.QDoubleSpinBox)
    field.selectAll()
    for item in f"{value:g}":
        send_key(field, _KEYS(ord(item)), item)
    send_key(field, _KEYS.Key_Return)


def tell_terminal(text: str) -> None:
    """Tell the terminal, past FreeCAD's own report."""
    with open(2, "w", encoding="utf-8", closefd=False) as stream:
        stream.write(text + "\n")


def arrange(dock: QtWidgets.QDockWidget) -> None:
    """Fill the screen; beside the canvas is the 3D view alone."""
    main = FreeCADGui.getMainWindow()
    main.setGeometry(QtWidgets.QApplication.primaryScreen().geometry())
    for item in main.findChildren(QtWidgets.QDockWidget):
        if item is not dock:
            item.hide()
    for view in main.findChildren(QtWidgets.QMdiSubWindow):
        view.showMaximized()
    main.resizeDocks([dock], [700], QtCore.Qt.Orientation.Horizontal)
    spin(0.3)


def whole() -> None:
    """The first sheet."""
    user = ScriptedUser("1-whole")
    user.picture("1-part")
    user.picture("canvas")
    user.close()


def lines_missing() -> None:
    """The second sheet: two hidden lines are drawn."""
    user = ScriptedUser("2-lines-missing")
    user.picture("2-before")
    user.film(1)
    for number, (start, end) in enumerate(HOLE, start=2):
        user.press(_KEYS.Key_L)
        user.drag(start, end)
        user.film(number)
        user.press(_KEYS.Key_H)
    user.press(_KEYS.Key_Escape)
    user.settle()
    user.picture("2-after")
    user.tell_length(LENGTH, LENGTH_MM)
    user.film(4)
    user.close()


def views_moved() -> None:
    """The third sheet: views are boxed, and a length is told."""
    user = ScriptedUser("3-views-moved")
    user.picture("3-before")
    for corner, key in FRAMES:
        user.click_frame(corner)
        user.press(key)
        user.settle()
    user.press(_KEYS.Key_Escape)
    user.tell_length(LENGTH, LENGTH_MM)
    user.picture("3-after")
    user.close()


def follow() -> None:
    """All sheets; then FreeCAD ends."""
    status = 1
    try:
        PICTURES.mkdir(parents=True, exist_ok=True)
        FreeCADGui.activateWorkbench("GaussianCADWorkbench")
        for item in (whole, lines_missing, views_moved):
            item()
        status = 0
    except Exception:
        tell_terminal(traceback.format_exc())
    finally:
        sys.stdout.flush()
        os._exit(status)


QtCore.QTimer.singleShot(1500, follow)
