"""Gestures on the canvas, without FreeCAD: each means operations of ``corrections.json``."""

import json
from dataclasses import replace
from pathlib import Path

import msgspec
import pytest

from freecad.gaussiancad.canvas.corrections_preview import corrected
from freecad.gaussiancad.canvas.corrections_storage import (
    CorrectionsFile,
    corrections_path,
    read_again,
    read_corrections,
    write_corrections,
)
from freecad.gaussiancad.canvas.engine_server import Engines, Program
from freecad.gaussiancad.canvas.sheet import Sheet, Stroke, View, arc_through, sheet_of
from freecad.gaussiancad.canvas.window import SheetWindow
from freecad.gaussiancad.qt import QtCore, QtGui, QtWidgets
from gaussiancad_core.readings.correction_operations import Corrections

_LEFT = QtCore.Qt.MouseButton.LeftButton
_NONE = QtCore.Qt.KeyboardModifier.NoModifier
_SHIFT = QtCore.Qt.KeyboardModifier.ShiftModifier
_ALT = QtCore.Qt.KeyboardModifier.AltModifier


Keys = QtCore.Qt.KeyboardModifier
Place = tuple[float, float]


def _mouse(window: SheetWindow, kind: QtCore.QEvent.Type, place: Place, keys: Keys) -> None:
    at = QtCore.QPointF(window.canvas_view.mapFromScene(*place))
    released = kind is QtCore.QEvent.Type.MouseButtonRelease
    held = QtCore.Qt.MouseButton.NoButton if released else _LEFT
    view = window.canvas_view.viewport()
    event = QtGui.QMouseEvent(kind, at, view.mapToGlobal(at), _LEFT, held, keys)
    QtWidgets.QApplication.sendEvent(view, event)


def _drag(window: SheetWindow, start: Place, end: Place, keys: Keys = _NONE) -> None:
    _mouse(window, QtCore.QEvent.Type.MouseButtonPress, start, keys)
    _mouse(window, QtCore.QEvent.Type.MouseMove, end, keys)
    _mouse(window, QtCore.QEvent.Type.MouseButtonRelease, end, keys)


def _click(window: SheetWindow, at: Place, keys: Keys = _NONE) -> None:
    _drag(window, at, at, keys)


def _key(window: SheetWindow, key: QtCore.Qt.Key) -> None:
    for kind in (QtCore.QEvent.Type.KeyPress, QtCore.QEvent.Type.KeyRelease):
        QtWidgets.QApplication.sendEvent(window.canvas_view, QtGui.QKeyEvent(kind, key, _NONE))


def test_a_click_and_a_key_give_a_kind(window: SheetWindow) -> None:
    _click(window, (200, 130))
    _key(window, QtCore.Qt.Key.Key_H)
    (item,) = window.operations
    assert item["op"] == "kind"
    assert item["target"]["id"] == "s5"
    assert item["to"] == "hidden"


def test_a_stroke_of_the_part_is_chosen_before_others(window: SheetWindow) -> None:
    _click(window, (200, 100))
    assert [item.id for item in window.canvas_view.selected] == ["s1"]
    _click(window, (140, 180), _SHIFT)
    assert [item.id for item in window.canvas_view.selected] == ["s1", "s6"]


def test_bands_select_what_is_inside_or_touched(window: SheetWindow) -> None:
    _drag(window, (130, 150), (190, 210))
    assert [item.id for item in window.canvas_view.selected] == ["s6"]
    _drag(window, (310, 140), (290, 90))
    assert {item.id for item in window.canvas_view.selected} == {"s1", "s2"}


def test_delete_erases_and_undo_brings_back(window: SheetWindow) -> None:
    _click(window, (140, 180))
    _key(window, QtCore.Qt.Key.Key_Delete)
    assert [operation["op"] for operation in window.operations] == ["erase"]
    window.undo()
    assert window.operations == []
    assert not corrections_path(window.session.path).exists()
    window.redo()
    assert [operation["target"]["id"] for operation in window.operations] == ["s6"]


def test_a_line_is_square_and_snaps_to_ends(window: SheetWindow) -> None:
    _key(window, QtCore.Qt.Key.Key_L)
    _drag(window, (102, 102), (298, 111))
    (item,) = window.operations
    assert item["op"] == "draw"
    assert item["view"] == "front"
    assert item["line"] == ((100.0, 100.0), (300.0, 100.0))


def test_a_circle_and_an_arc_are_drawn(window: SheetWindow) -> None:
    _key(window, QtCore.Qt.Key.Key_O)
    _drag(window, (240, 180), (240, 205))
    _key(window, QtCore.Qt.Key.Key_A)
    for at in ((100, 250), (200, 250), (150, 200)):
        _click(window, at)
    circle, arc = (operation["arc"] for operation in window.operations)
    assert circle[2] == pytest.approx(25.0, abs=1.5)
    assert arc[:3] == pytest.approx((150.0, 250.0, 50.0), abs=1.5)


def test_a_box_becomes_a_view_and_two_points_a_scale(window: SheetWindow) -> None:
    asked: list[tuple] = []
    window.canvas_view.asked_role.disconnect()
    window.canvas_view.asked_role.connect(asked.append)
    _key(window, QtCore.Qt.Key.Key_B)
    _drag(window, (400, 100), (500, 200))
    window.say_view("top", asked[0])
    window.canvas_view.asked_length.disconnect()
    window.canvas_view.asked_length.connect(lambda points: window.say_length(points, 50.0))
    _key(window, QtCore.Qt.Key.Key_M)
    _click(window, (100, 300))
    _click(window, (300, 300))
    view, scale = window.operations
    assert (view["op"], view["role"]) == ("view", "top")
    assert scale["length_mm"] == 50.0


def test_an_area_is_ignored(window: SheetWindow, reading: dict) -> None:
    _key(window, QtCore.Qt.Key.Key_R)
    _drag(window, (130, 150), (190, 210))
    assert window.operations[0]["kind"] == "ignore"
    shown = corrected(sheet_of(reading), window.operations)
    assert {stroke.id: stroke.kind for stroke in shown.strokes}["s6"] == "ignore"


def test_what_gestures_say_is_what_the_engine_takes(window: SheetWindow) -> None:
    _click(window, (200, 130))
    _key(window, QtCore.Qt.Key.Key_H)
    _key(window, QtCore.Qt.Key.Key_L)
    _drag(window, (100, 150), (300, 150), _ALT)
    window.say_view("top", (400.0, 100.0, 500.0, 200.0))
    window.say_length(((100.0, 300.0), (300.0, 300.0)), 50.0)
    content = corrections_path(window.session.path).read_bytes()
    taken = msgspec.json.decode(content, type=Corrections)
    assert len(taken.ops) == 4


def test_single_keys_do_not_leave_the_canvas(window: SheetWindow) -> None:
    key = QtCore.Qt.Key.Key_Delete
    event = QtGui.QKeyEvent(QtCore.QEvent.Type.ShortcutOverride, key, _NONE)
    event.ignore()
    QtWidgets.QApplication.sendEvent(window.canvas_view, event)
    assert event.isAccepted()


def test_corrections_lie_beside_the_sheet_whole_or_not_at_all(tmp_path: Path) -> None:
    sheet = tmp_path / "part.pdf"
    items = [{"op": "unit", "value": "in"}]
    write_corrections(corrections_path(sheet), "1" * 64, items)
    assert read_corrections(corrections_path(sheet)) == ("1" * 64, items)
    assert [each.name for each in tmp_path.iterdir()] == ["part.pdf.corrections.json"]
    assert corrections_path(sheet, 3).name == "part.pdf.page-3.corrections.json"


def test_a_step_of_several_operations_is_undone_at_once(tmp_path: Path) -> None:
    sheet = tmp_path / "sheet.png"
    item = CorrectionsFile(sheet)
    item.add([{"op": "unit", "value": "in"}, {"op": "projection", "value": "first"}])
    item.undo()
    assert item.operations == []
    item.undo()
    item.redo()
    assert len(item.operations) == 2
    item.redo()
    assert CorrectionsFile(sheet).operations == item.operations


def test_corrections_of_another_version_of_the_sheet_are_kept_aside(tmp_path: Path) -> None:
    sheet = tmp_path / "sheet.png"
    before = [{"op": "unit", "value": "in"}]
    write_corrections(corrections_path(sheet), "1" * 64, before)
    item = CorrectionsFile(sheet)
    assert item.operations == before
    assert not item.belongs_to("2" * 64)
    assert item.operations == []
    assert read_corrections(corrections_path(sheet)) == ("1" * 64, before)
    item.add([{"op": "projection", "value": "first"}])
    assert read_corrections(corrections_path(sheet))[0] == "2" * 64
    aside = tmp_path / "sheet.png.corrections.json.old"
    assert json.loads(aside.read_text(encoding="utf-8"))["ops"] == before


def test_the_sheet_is_read_again_up_to_the_last_boxed_view() -> None:
    erase = {"op": "erase", "target": {"id": "s1"}}
    box = {"op": "view", "id": "top", "role": "top", "box": [0, 0, 9, 9]}
    named = {"op": "view", "id": "top", "role": "left"}
    assert read_again([erase, named]) == []
    assert read_again([erase, box, named, erase]) == [erase, box]


def test_another_projection_leaves_what_a_person_named() -> None:
    views = (View("top", "top", (0, 0, 9, 9)), View("right", "right", (20, 20, 29, 29)))
    named = {"op": "view", "id": "top", "role": "top"}
    projection = {"op": "projection", "value": "first"}
    after = corrected(Sheet((), views, (), "", None), [named, projection])
    assert {view.id: view.role for view in after.views} == {"top": "top", "right": "left"}


def test_an_arc_runs_through_its_middle() -> None:
    x, y, radius, first, sweep = arc_through((1.0, 0.0), (-1.0, 0.0), (0.0, -1.0))
    stroke = Stroke("s1", "front", "visible", ("arc", (x, y, radius, first, sweep)))
    assert min(py for _, py in stroke.points()) == pytest.approx(-1.0, abs=1e-3)
    assert max(py for _, py in stroke.points()) == pytest.approx(0.0, abs=1e-9)
    assert arc_through((0.0, 0.0), (2.0, 0.0), (1.0, 0.0)) is None


@pytest.mark.parametrize(
    "content",
    [
        "",
        "[]",
        "{",
        '{"schema": "gaussiancad-corrections/1", "ops": 3}',
        '{"schema": "other"}',
        '{"schema": "gaussiancad-corrections/1", "ops": [1]}',
    ],
)
def test_damaged_corrections_are_told(tmp_path: Path, content: str) -> None:
    sheet = tmp_path / "sheet.png"
    corrections_path(sheet).write_text(content, encoding="utf-8")
    with pytest.raises(ValueError, match="no file of corrections"):
        read_corrections(corrections_path(sheet))


def test_an_engine_that_does_not_start_is_told(
    application: QtWidgets.QApplication, tmp_path: Path
) -> None:
    sheet = tmp_path / "sheet.png"
    sheet.write_bytes(b"a sheet")
    sheet_window = SheetWindow(sheet, engines=Engines.of(Program((str(tmp_path / "none"),))))
    sheet_window.start()
    for _ in range(200):
        if not sheet_window.busy:
            break
        application.processEvents(QtCore.QEventLoop.ProcessEventsFlag.AllEvents, 20)
    assert not sheet_window.busy
    assert len(sheet_window.problems.lines) == 1
    sheet_window.session.correct([{"op": "erase", "target": {"id": "s1"}}])
    assert not sheet_window.operations
    assert not corrections_path(sheet).exists()
    sheet_window.close()
    sheet_window.deleteLater()


def test_a_line_that_is_drawn_is_selected_for_its_kind(window: SheetWindow) -> None:
    _key(window, QtCore.Qt.Key.Key_L)
    _drag(window, (100, 150), (300, 150))
    _key(window, QtCore.Qt.Key.Key_H)
    draw, kind = window.operations
    (x0, y0), (x1, y1) = draw["line"]
    assert (x0, x1) == (100.0, 300.0) and y0 == y1 == pytest.approx(150.0, abs=1.5)
    assert kind["target"]["line"] == draw["line"]
    shown = {stroke.shape: stroke.kind for stroke in window.sheet.strokes}
    assert shown["line", draw["line"]] == "hidden"


def test_a_handle_moves_an_end_in_one_step(window: SheetWindow) -> None:
    _click(window, (200, 250))
    _drag(window, (100, 250), (100, 300))
    erase, draw = window.operations
    assert erase["target"]["id"] == "s3"
    assert draw["line"][0] == (300.0, 250.0)
    assert draw["line"][1] == pytest.approx((100.0, 300.0), abs=1.5)
    window.undo()
    assert window.operations == []


def test_a_frame_is_selected_named_and_made_larger(window: SheetWindow) -> None:
    _click(window, (200, 90))
    assert window.canvas_view.selected_view.id == "front"
    _key(window, QtCore.Qt.Key.Key_2)
    assert window.operations[-1] == {"op": "view", "id": "front", "role": "top"}
    _drag(window, (300, 250), (330, 280))
    assert window.operations[-1]["box"] == pytest.approx([100, 100, 330, 280], abs=1.5)


def test_a_number_is_told_anew(window: SheetWindow) -> None:
    asked = []
    window.canvas_view.asked_value.disconnect()
    window.canvas_view.asked_value.connect(asked.append)
    _mouse(window, QtCore.QEvent.Type.MouseButtonDblClick, (200, 66), _NONE)
    window.say_value(asked[0], 45.0)
    assert window.operations == [{"op": "dimension", "id": "d1", "value_mm": 45.0}]
    assert window.sheet.numbers[0].value == 45.0


def test_a_plane_is_set_in_a_view_and_a_hole_told(window: SheetWindow) -> None:
    asked = []
    window.canvas_view.asked_section.disconnect()
    window.canvas_view.asked_section.connect(lambda line, view: asked.append((line, view)))
    _key(window, QtCore.Qt.Key.Key_X)
    _drag(window, (160, 80), (164, 270))
    (line, view) = asked[0]
    assert view == "front" and line[0][0] == line[1][0] == pytest.approx(160.0, abs=0.5)
    window.say_section("right", line, view)
    window.canvas_view.set_hole_depth((160.0, 180.0, 20.0), None)
    window.canvas_view.set_hole_depth((160.0, 180.0, 20.0), 12.0)
    content = corrections_path(window.session.path).read_bytes()
    taken = msgspec.json.decode(content, type=Corrections)
    assert [item.depth_mm for item in taken.ops[1:]] == [None, 12.0]
    assert [note.text for note in window.sheet.notes] == ["\u21a712"]


def test_what_is_picked_from_the_ink_is_drawn(window: SheetWindow) -> None:
    asked = []
    window.canvas_view.asked_trace.disconnect()
    window.canvas_view.asked_trace.connect(asked.append)
    _key(window, QtCore.Qt.Key.Key_P)
    _click(window, (250, 180))
    assert asked[0] == pytest.approx((250.0, 180.0), abs=1.5)
    assert window.canvas_view.take_trace(("line", ((250.0, 100.0), (250.0, 250.0))), asked[0])
    assert [item.kind for item in window.canvas_view.selected] == ["visible"]
    assert not window.canvas_view.take_trace(("line", ((0.0, 0.0), (5.0, 5.0))), (5.0, 5.0))
    assert not window.canvas_view.take_trace(None, (250.0, 180.0))


def test_a_kind_told_while_ink_is_traced_is_the_strokes(window: SheetWindow) -> None:
    asked = []
    window.canvas_view.asked_trace.disconnect()
    window.canvas_view.asked_trace.connect(asked.append)
    _key(window, QtCore.Qt.Key.Key_P)
    _click(window, (250, 180))
    _key(window, QtCore.Qt.Key.Key_H)
    assert window.operations == []
    assert window.canvas_view.take_trace(("line", ((250.0, 100.0), (250.0, 250.0))), asked[0])
    assert [item.kind for item in window.canvas_view.selected] == ["hidden"]
    assert len(window.operations) == 1


def test_problems_lead_to_their_place_and_to_a_tool(window: SheetWindow) -> None:
    problem, count = window.problems.lines
    assert problem.box == (100, 100, 300, 250)
    assert "0" in count.text
    ((_, act),) = problem.buttons
    act()
    assert window.canvas_view.tool == "view"
    before = window.canvas_view.transform().m11()
    _key(window, QtCore.Qt.Key.Key_Tab)
    assert window.canvas_view.transform().m11() > before


def test_a_sheet_without_a_part_says_so_first(window: SheetWindow) -> None:
    (problem,) = window.sheet.problems
    refused = replace(problem, severity="refused")
    window.session._read = replace(window.sheet, problems=(refused,))
    window.session.changed.emit()
    verdict, stated, _ = window.problems.lines
    assert verdict.colour and not stated.colour
    assert stated.box == problem.box


def test_a_group_of_lines_that_becomes_a_view_is_boxed(window: SheetWindow) -> None:
    view = View("lines-1", "ignore", (600.0, 600.0, 700.0, 700.0), used=False)
    window.session._read = replace(window.sheet, views=(*window.sheet.views, view))
    window.session.changed.emit()
    window.canvas_view.select({"lines-1"})
    _key(window, QtCore.Qt.Key.Key_4)
    box = [590.0, 590.0, 710.0, 710.0]
    assert window.operations == [{"op": "view", "id": "left", "role": "left", "box": box}]


def test_a_verdict_leads_and_a_correction_takes_it_back(window: SheetWindow) -> None:
    path = Path(__file__).with_name("doubted_report.json")
    report = json.loads(path.read_text(encoding="utf-8"))
    window.session.solved.emit(report, "")
    verdict, reason, assumed, _two, lacks, beyond, *_ = window.problems.lines
    assert verdict.colour and "0.02" in verdict.text
    assert "two solids" in reason.text
    assert lacks.box == (180.0, 100.0, 220.0, 140.0)
    for line in (lacks, beyond):
        line.buttons[0][1]()
    (kind, draw) = window.operations
    assert (kind["op"], kind["target"]["id"], kind["to"]) == ("kind", "s5", "tangent")
    stated = {"view": "front", "kind": "hidden", "line": [[260, 100], [260, 250]]}
    assert draw == {"op": "draw", **stated}
    window.undo()
    window.undo()
    (_, yes), _no, (_, both) = assumed.buttons
    yes()
    first = {"op": "note", "circle": [160.0, 180.0, 20.0], "through": True}
    assert window.operations == [first]
    window.undo()
    both()
    second = {"op": "note", "circle": [250.0, 170.0, 10.0], "through": True}
    third = {"op": "note", "circle": [250.0, 210.0, 10.0], "through": True}
    assert window.operations == [first, second, third]
    window.undo()
    assert window.operations == []
    yes()
    assert not any(this_line.colour for this_line in window.problems.lines)


def test_a_digit_names_the_view_of_a_selected_line(window: SheetWindow) -> None:
    window.canvas_view.select(set())
    _key(window, QtCore.Qt.Key.Key_4)
    assert window.operations == [] and window.statusBar().currentMessage()
    _click(window, (200, 100))
    _key(window, QtCore.Qt.Key.Key_4)
    assert window.operations == [{"op": "view", "id": "front", "role": "left"}]


def test_a_line_begins_in_the_frame_of_a_view(window: SheetWindow) -> None:
    _key(window, QtCore.Qt.Key.Key_L)
    _drag(window, (95, 130), (280, 130), _ALT)
    _drag(window, (500, 400), (560, 400), _ALT)
    (item,) = window.operations
    assert (item["op"], item["view"]) == ("draw", "front")
    assert window.statusBar().currentMessage()


def test_a_box_around_a_view_is_that_view(window: SheetWindow) -> None:
    window.say_view("left", (90.0, 95.0, 310.0, 260.0))
    window.say_view("top", (90.0, 300.0, 310.0, 400.0))
    ids = [operation["id"] for operation in window.operations]
    assert ids == ["front", "top"]


def test_a_size_that_nobody_told_is_none(window: SheetWindow) -> None:
    measures = {"uncertainty_mm": 0.02}
    report = {"status": "verified", "measures": measures, "scale_source": "default"}
    window.session.solved.emit(report, "")
    assert "0.02" not in window.problems.lines[0].text


def test_layers_and_bare_ink(window: SheetWindow) -> None:
    scene = window.canvas_view.scene()
    strokes = scene._layers["strokes"]
    window.canvas_view.set_layer("strokes", False)
    assert not any(stroke.isVisible() for stroke in strokes)
    window.canvas_view.set_layer("strokes", True)
    key = QtCore.Qt.Key.Key_Space
    press = QtGui.QKeyEvent(QtCore.QEvent.Type.KeyPress, key, _NONE)
    QtWidgets.QApplication.sendEvent(window.canvas_view, press)
    assert not any(stroke.isVisible() for stroke in strokes)
    release = QtGui.QKeyEvent(QtCore.QEvent.Type.KeyRelease, key, _NONE)
    QtWidgets.QApplication.sendEvent(window.canvas_view, release)
    assert all(stroke.isVisible() for stroke in strokes)


def test_a_file_of_many_pages_is_listed_at_once(
    application: QtWidgets.QApplication, window: SheetWindow
) -> None:
    assert not window.pages.isVisible()
    asked, turned = [], []
    window.pages._ask = lambda page, most, done: asked.append((page, most, done))
    window.page_asked.connect(turned.append)
    window.pages.show_pages(200, 1)
    application.processEvents()
    assert window.pages.isVisible() and window.pages.count() == 200
    for _ in range(3):
        window.pages._next()
    assert [item[0] for item in asked] == [1]
    asked[0][2]("")
    window.pages._next()
    assert [item[0] for item in asked] == [1, 2]
    window.pages.itemClicked.emit(window.pages.item(0))
    window.pages.itemClicked.emit(window.pages.item(6))
    assert turned == [7]


def test_a_pale_sheet_is_white_in_a_dark_window(window: SheetWindow) -> None:
    palette = QtGui.QPalette(window.palette())
    palette.setColor(QtGui.QPalette.ColorRole.Base, QtGui.QColor("black"))
    window.canvas_view.setPalette(palette)
    at = window.canvas_view.mapFromScene(400.0, 400.0)
    assert window.canvas_view.grab().toImage().pixelColor(at).lightness() > 250


@pytest.mark.parametrize("place", [(120.0, 90.0), (500.0, 400.0)])
def test_the_wheel_zooms_at_the_cursor(window: SheetWindow, place: Place) -> None:
    canvas_view = window.canvas_view
    at = canvas_view.mapFromScene(*place)
    for _ in range(4):
        turned = QtGui.QWheelEvent(
            QtCore.QPointF(at),
            QtCore.QPointF(canvas_view.viewport().mapToGlobal(at)),
            QtCore.QPoint(),
            QtCore.QPoint(0, 120),
            QtCore.Qt.MouseButton.NoButton,
            _NONE,
            QtCore.Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QtWidgets.QApplication.sendEvent(canvas_view.viewport(), turned)
    assert canvas_view.zoom > 2.0
    assert canvas_view.place(at) == pytest.approx(place, abs=2.0)
