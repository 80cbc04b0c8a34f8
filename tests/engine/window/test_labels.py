"""Numbers and notes on the canvas: which are written all the time, and which at the mouse."""

import pytest

from freecad.gaussiancad.canvas.labels import labels_of
from freecad.gaussiancad.canvas.sheet import Sheet, sheet_of
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets


@pytest.fixture
def doubted(reading: dict) -> Sheet:
    """A sheet of three numbers, of which the second and the third contradict each other, and a
    note."""
    boxes = [[190, 60, 210, 75], [20, 60, 40, 75], [20, 160, 40, 175]]
    reading["dimensions"] = [
        {"id": f"d{n}", "text": str(40 + n), "value_mm": 40.0 + n, "box": box, "used": n < 2}
        for n, box in enumerate(boxes)
    ]
    reading["notes"] = [{"text": "THRU", "box": [400, 10, 440, 25]}]
    reading["problems"].append(
        {
            "code": "dimensions-disagree",
            "message": "two scales",
            "severity": "doubt",
            "at": boxes[1:],
            "offers": ["dimension", "scale"],
        }
    )
    return sheet_of(reading)


def _written(window: SheetWindow) -> list[str]:
    """Texts that can be seen, but for the names of views."""
    items = window.canvas_view.scene().items()
    kind = QtWidgets.QGraphicsSimpleTextItem
    texts = [item.text() for item in items if isinstance(item, kind) and item.isVisible()]
    return sorted(text for text in texts if text != "front")


def _move(window: SheetWindow, place: tuple[float, float]) -> None:
    at = QtCore.QPointF(window.canvas_view.mapFromScene(*place))
    none = QtCore.Qt.MouseButton.NoButton
    view = window.canvas_view.viewport()
    event = QtGui.QMouseEvent(
        QtCore.QEvent.Type.MouseMove,
        at,
        QtCore.QPointF(view.mapToGlobal(at.toPoint())),
        none,
        none,
        QtCore.Qt.KeyboardModifier.NoModifier,
    )
    QtWidgets.QApplication.sendEvent(view, event)


def test_numbers_in_doubt_are_loud(doubted: Sheet) -> None:
    quiet = {label.text: label.quiet for label in labels_of(doubted)}
    assert quiet == {"40": True, "41": False, "42": False, "THRU": True}


def test_a_quiet_number_is_written_while_the_mouse_is_at_it(window: SheetWindow) -> None:
    assert _written(window) == []
    _move(window, (200, 68))
    assert _written(window) == ["40"]
    window.canvas_view.set_layer("numbers", False)
    assert _written(window) == []
    window.canvas_view.set_layer("numbers", True)
    assert _written(window) == ["40"]
    _move(window, (200, 130))
    assert _written(window) == []
    _move(window, (200, 68))
    QtWidgets.QApplication.sendEvent(window.canvas_view, QtCore.QEvent(QtCore.QEvent.Type.Leave))
    assert _written(window) == []


def test_what_a_person_said_stays_written(window: SheetWindow) -> None:
    window.say_value(window.sheet.numbers[0], 45.0)
    window.canvas_view.set_hole_depth((160.0, 180.0, 20.0), 12.0)
    assert _written(window) == ["45", "\u21a712"]
