"""Menus, boxes and buttons of the window: what a person answers becomes a correction."""

from dataclasses import replace

import pytest

from freecad.gaussiancad.canvas.sheet import Row, Stroke, View
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets

Place = tuple[float, float]


def _menu(window: SheetWindow) -> list[QtGui.QAction]:
    """Entries of the menu that was opened last."""
    (item,) = (entry for entry in window.findChildren(QtWidgets.QMenu) if entry.isVisible())
    item.hide()
    return item.actions()


def _at(window: SheetWindow, place: Place) -> list[QtGui.QAction]:
    """Entries of the menu at a place of the sheet."""
    at = QtCore.QPoint(window.canvas_view.mapFromScene(*place))
    reason, view = QtGui.QContextMenuEvent.Reason.Mouse, window.canvas_view.viewport()
    event = QtGui.QContextMenuEvent(reason, at, view.mapToGlobal(at))
    QtWidgets.QApplication.sendEvent(view, event)
    return _menu(window)


def _answer(monkeypatch: pytest.MonkeyPatch, value: float, is_given: bool = True) -> None:
    def get(*_: object) -> tuple[float, bool]:
        return value, is_given

    monkeypatch.setattr(QtWidgets.QInputDialog, "getDouble", get)


def test_a_stroke_under_the_mouse_is_selected_and_given_a_kind(window: SheetWindow) -> None:
    entries = _at(window, (200, 130))
    assert [item.id for item in window.canvas_view.selected] == ["s5"]
    next(entry for entry in entries if entry.text().endswith("\tT")).trigger()
    (element,) = window.operations
    assert (element["op"], element["target"]["id"], element["to"]) == ("kind", "s5", "tangent")


def test_a_hole_goes_through_or_is_so_deep(
    window: SheetWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    _answer(monkeypatch, 7.5)
    entries = {item.text(): item for item in _at(window, (140, 180))}
    entries["Hole Goes Through"].trigger()
    entries["Depth of Hole\u2026"].trigger()
    through, deep = window.operations
    assert through == {"op": "note", "circle": [160, 180, 20], "through": True}
    assert deep == {"op": "note", "circle": [160, 180, 20], "depth_mm": 7.5}
    _answer(monkeypatch, 9.0, is_given=False)
    entries["Depth of Hole\u2026"].trigger()
    assert len(window.operations) == 2


def test_strokes_alike_are_selected_and_erased_from_the_menu(window: SheetWindow) -> None:
    entries = {item.text(): item for item in _at(window, (200, 100))}
    entries["Select all like this"].trigger()
    assert len(window.canvas_view.selected) == 4
    entries["Erase\tDel"].trigger()
    assert [operation["op"] for operation in window.operations] == ["erase"] * 4


def test_a_frame_is_given_a_role_from_the_menu(window: SheetWindow) -> None:
    entries = _at(window, (200, 90))
    next(entry for entry in entries if entry.text().endswith("\t3")).trigger()
    assert window.operations == [{"op": "view", "id": "front", "role": "right"}]


def test_nothing_selected_has_no_menu(window: SheetWindow) -> None:
    with pytest.raises(ValueError):
        _at(window, (450, 350))


def test_a_box_is_given_a_role(window: SheetWindow) -> None:
    window.canvas_view.asked_role.emit((1.0, 2.0, 3.0, 4.0))
    _menu(window)[1].trigger()
    box = [1.0, 2.0, 3.0, 4.0]
    assert window.operations == [{"op": "view", "id": "top", "role": "top", "box": box}]


def test_a_length_and_a_value_are_asked_for(
    window: SheetWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    _answer(monkeypatch, 50.0)
    window.canvas_view.asked_length.emit(((0.0, 0.0), (9.0, 0.0)))
    window.canvas_view.asked_value.emit(window.sheet.numbers[0])
    scale, number = window.operations
    assert scale == {"op": "scale", "points": [[0.0, 0.0], [9.0, 0.0]], "length_mm": 50.0}
    assert number == {"op": "dimension", "id": "d1", "value_mm": 50.0}
    _answer(monkeypatch, 1.0, is_given=False)
    window.canvas_view.asked_length.emit(((0.0, 0.0), (9.0, 0.0)))
    assert len(window.operations) == 2


def test_a_section_is_asked_for_where_several_may_be_meant(window: SheetWindow) -> None:
    one, other = (
        View(name, name, (400.0, y, 500.0, y + 90.0), cut=True)
        for name, y in (("right", 100.0), ("top", 300.0))
    )
    line = ((160.0, 80.0), (160.0, 270.0))
    for views, choose in (((one,), False), ((one, other), True)):
        window.session._read = replace(window.session._read, views=(*window.sheet.views, *views))
        window.canvas_view.asked_section.emit(line, "front")
        if choose:
            _menu(window)[-1].trigger()
    assert [(operation["id"], operation["in_view"]) for operation in window.operations] == [
        ("right", "front"),
        ("top", "front"),
    ]


def test_gaps_are_closed_with_a_button(window: SheetWindow) -> None:
    problem = Row("doubt", "a gap", "open-outline", None, ("draw",))
    corners = [(0.0, 0.0), (90.0, 0.0), (90.0, 60.0), (0.0, 60.0)]
    strokes = tuple(
        Stroke(f"t{n}", "front", "visible", ("line", (corners[n], corners[n + 1])))
        for n in range(3)
    )
    window.session._read = replace(window.session._read, problems=(problem,), strokes=strokes)
    window.session.changed.emit()
    close, draw = window.problems.lines[0].buttons
    draw[1]()
    assert window.canvas_view.tool == "line"
    close[1]()
    (item,) = window.operations
    assert (item["op"], item["view"], item["kind"]) == ("draw", "front", "visible")
    assert set(item["line"]) == {corners[0], corners[3]}


def test_how_thick_a_plate_is_is_asked_for_with_a_button(
    window: SheetWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    _answer(monkeypatch, 5.0)
    offers, place = ("scale", "view"), {"axis": "y", "places": ""}
    problem = Row("refused", "one view", "one-view", None, offers, place)
    window.session._read = replace(window.session._read, problems=(problem,), mm_per_px=0.5)
    window.session.changed.emit()
    verdict, row, *_ = window.problems.lines
    assert verdict.buttons == ()
    assert [text for text, _ in row.buttons] == ["How Thick Is the Part?", "Box a View"]
    row.buttons[0][1]()
    assert window.operations == [{"op": "scale", "axis": "y", "length_mm": 5.0}]
    assert window.sheet.mm_per_px == 0.5
    # The run that follows may lack the scale: another question.
    why = {"code": "one-view", "message": "no scale", "args": {"axis": "y", "case": "scale"}}
    window.session.solved.emit({"status": "failed", "reasons": [why]}, "")
    ((_, tell),) = window.problems.lines[1].buttons
    tell()
    assert window.canvas_view.tool == "scale"


def test_other_help_is_offered_with_what_a_report_says(window: SheetWindow) -> None:
    called = []
    window.add_help("ambiguous", "Choose", lambda: called.append("ambiguous"))
    reasons = [{"code": "ambiguous", "message": "two solids"}]
    warnings = [{"code": "projection-assumed", "message": "third angle"}]
    report = {"status": "approximate", "reasons": reasons, "warnings": warnings}
    window.session.solved.emit(report, "")
    _, reason, warning = window.problems.lines
    ((text, act),) = reason.buttons
    act()
    assert (text, called) == ("Choose", ["ambiguous"])
    ((_, turn),) = warning.buttons
    turn()
    assert window.operations == [{"op": "projection", "value": "first"}]


def test_the_bars_choose_tools_kinds_and_what_holds_for_the_sheet(window: SheetWindow) -> None:
    first, second = window.findChildren(QtWidgets.QToolBar)
    assert (first.objectName(), second.objectName()) == ("GaussianCADCanvas", "GaussianCADRuns")
    entries = {
        action.text(): action
        for menu in window.findChildren(QtWidgets.QMenu)
        for action in menu.actions()
    }
    assert entries["Third angle"].isChecked() and not entries["First angle"].isChecked()
    entries["First angle"].trigger()
    entries["inch"].trigger()
    assert entries["First angle"].isChecked() and not entries["Third angle"].isChecked()
    assert [operation["op"] for operation in window.operations] == ["projection", "unit"]
    entries["Arc\tA"].trigger()
    assert window.canvas_view.tool == "arc"
    steps = {action.text(): action for action in second.actions()}
    steps["Undo"].trigger()
    assert [operation["op"] for operation in window.operations] == ["projection"]
    steps["Redo"].trigger()
    assert [operation["op"] for operation in window.operations] == ["projection", "unit"]
    steps["Solve as I Go"].trigger()
    assert not window.session.live
