"""The legend of the canvas, and whether its words can be read in a dark window."""

from collections.abc import Iterator
from dataclasses import replace

import pytest

from freecad.gaussiancad.canvas.legend import entries_of
from freecad.gaussiancad.canvas.legible import LEGIBLE, contrast, ink_on
from freecad.gaussiancad.canvas.rows import Line
from freecad.gaussiancad.canvas.sheet import sheet_of
from freecad.gaussiancad.canvas.verdict import verdict_line
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

_DARK = {
    "Window": "#2b2b2b",
    "WindowText": "#2b2b2b",
    "Base": "#1e1e1e",
    "Text": "#e0e0e0",
    "Button": "#3a3a3a",
    "ButtonText": "#e0e0e0",
}
"""A dark window; its own text is as dark, to tell which words stand on what."""


@pytest.fixture
def dark(window: SheetWindow) -> Iterator[SheetWindow]:
    palette = window.palette()
    for role, colour in _DARK.items():
        palette.setColor(getattr(QtGui.QPalette.ColorRole, role), QtGui.QColor(colour))
    window.setPalette(palette)
    yield window


def _pixels(widget: QtWidgets.QWidget) -> QtGui.QImage:
    return widget.grab().toImage().convertToFormat(QtGui.QImage.Format.Format_RGB32)


def test_it_has_the_kinds_of_the_sheet(reading: dict) -> None:
    reading["strokes"][4]["confidence"] = 0.4
    reading["strokes"].append({"id": "s7", "kind": "text", "line": [[1, 1], [9, 9]]})
    texts = [entry.text for entry in entries_of(sheet_of(reading))]
    assert texts == ["visible", "hidden", "in doubt", "other lines"]


def test_it_follows_what_is_said(window: SheetWindow) -> None:
    legend = window.canvas_view.legend
    assert [entry.text for entry in legend.entries] == ["visible", "hidden", "centre line"]
    window.canvas_view.select({"s5"})
    window.canvas_view.set_kind("hidden")
    assert [entry.text for entry in legend.entries] == ["visible", "hidden"]


@pytest.mark.parametrize(
    ("projection", "corner"), [("third", "topRight"), ("first", "bottomRight")]
)
def test_it_stays_in_its_corner(window: SheetWindow, projection: str, corner: str) -> None:
    legend, canvas_view = window.canvas_view.legend, window.canvas_view
    canvas_view.show_sheet(replace(window.sheet, projection=projection))

    def away() -> QtCore.QPoint:
        inner, outer = (part.geometry() for part in (legend, canvas_view.viewport()))
        return getattr(inner, corner)() - getattr(outer, corner)()

    size, before = legend.size(), away()
    assert abs(before.x()) == abs(before.y()) < 10
    canvas_view.scale(3.0, 3.0)
    canvas_view.horizontalScrollBar().setValue(canvas_view.horizontalScrollBar().value() + 40)
    canvas_view.verticalScrollBar().setValue(canvas_view.verticalScrollBar().value() + 40)
    assert away() == before
    window.resize(700, 600)
    QtWidgets.QApplication.processEvents()
    assert away() == before
    assert legend.size() == size
    assert legend.isVisible()


def test_it_can_be_left_out(window: SheetWindow) -> None:
    action = next(
        action for action in window.findChildren(QtGui.QAction) if action.text() == "Legend"
    )
    action.trigger()
    assert not window.canvas_view.legend.isVisible()
    window.canvas_view.show_sheet(window.sheet)
    assert not window.canvas_view.legend.isVisible()
    action.trigger()
    assert window.canvas_view.legend.isVisible()


def test_the_mouse_goes_through_it(window: SheetWindow) -> None:
    at = window.canvas_view.legend.geometry().center()
    assert window.canvas_view.childAt(at) is window.canvas_view.viewport()


def test_a_dark_window_leaves_it_as_it_is(window: SheetWindow, request: object) -> None:
    before = _pixels(window.canvas_view.legend)
    request.getfixturevalue("dark")
    assert _pixels(window.canvas_view.legend) == before


def test_rows_have_the_text_of_the_list(dark: SheetWindow) -> None:
    dark.problems.show_lines([Line("MMMM " * 20)])
    image = _pixels(dark.problems)
    colours = {
        QtGui.QColor(image.pixel(x, y)).name()
        for x in range(image.width())
        for y in range(image.height())
    }
    assert max(contrast(colour, _DARK["Base"]) for colour in colours) > LEGIBLE


def test_words_on_the_sheet_and_verdicts_can_be_read(dark: SheetWindow) -> None:
    kind = QtWidgets.QGraphicsSimpleTextItem
    words = [word for word in dark.canvas_view.scene().items() if isinstance(word, kind)]
    assert len(words) == 2
    for word in words:
        (plate,) = word.childItems()
        assert contrast(word.brush().color().name(), plate.brush().color().name()) >= LEGIBLE
        assert plate.rect() == word.boundingRect()
        assert plate.flags() & QtWidgets.QGraphicsItem.GraphicsItemFlag.ItemStacksBehindParent
    for status in ("verified", "approximate", "failed"):
        assert contrast(verdict_line(status).colour, "#ffffff") >= LEGIBLE


def test_contrast_is_that_of_the_standard() -> None:
    assert contrast("#000000", "#ffffff") == pytest.approx(21.0)
    assert contrast("#777777", "#ffffff") == pytest.approx(4.48, abs=0.005)


def test_ink_keeps_what_can_be_read_and_darkens_the_rest() -> None:
    assert ink_on("#ffffff", "#145ac8") == "#145ac8"
    grey = ink_on("#ffffff", "#bebebe")
    assert LEGIBLE <= contrast(grey, "#ffffff") < 5.0
    assert len({grey[1:3], grey[3:5], grey[5:7]}) == 1
