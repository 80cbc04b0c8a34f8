"""*Reconstruct from Drawing…* in a real window, with the fake engine."""

import json
import os
import shutil
import subprocess
import tempfile

import fake_part
import FreeCAD
import FreeCADGui
from support import alive
from window import WindowCase, dropped, spin, widget

from freecad.gaussiancad.engine.job import ScaleKind
from freecad.gaussiancad.objects.properties import texts_of
from freecad.gaussiancad.panels.correct import open_docks
from freecad.gaussiancad.paths import ADDON_ROOT
from freecad.gaussiancad.qt import QtWidgets

SCRIPT = ADDON_ROOT / "resources" / "scripts" / "gaussiancad_batch.py"


class Panel(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Test")
        self.open_panel("GaussianCAD_Reconstruct")

    def finish(self) -> None:
        button = self.start()
        self.assertFalse(button.isEnabled())
        self.wait_for(button.isEnabled)

    def reconstruct(self) -> None:
        self.choose_sheet(self.sheet)
        self.finish()

    def test_from_the_button_to_the_part_and_back_in_one_step(self) -> None:
        self.choose_sheet(self.sheet)
        self.picture("panel-ready")
        self.finish()
        self.assertEqual(self.boxes(), [])
        self.picture("panel-finished")
        part = self.document.getObject("Part")
        self.assertAlmostEqual(part.Shape.Volume, fake_part.VOLUME, places=6)
        self.assertEqual(len(self.document.getObject("Reconstruction").Group), 6)
        self.assertEqual(self.document.UndoNames, ["Reconstruct from Drawing"])
        self.assertIn("Shape verified.", widget(QtWidgets.QLabel, "stage").text())
        self.assertIn("8 faces", widget(QtWidgets.QPlainTextEdit, "log").toPlainText())
        colour = self.document.getObject("Part").ViewObject.ShapeColor[:3]
        self.assertEqual([round(255 * channel) for channel in colour], [0x78, 0xA0, 0xD2])
        points = self.document.getObject("Gaussians")
        self.assertEqual(points.ViewObject.DisplayMode, "Color")
        points.Visibility = True
        part.Visibility = False
        self.picture("gaussians")
        self.document.undo()
        self.assertEqual(self.document.Objects, [])
        self.document.redo()
        self.assertEqual(len(self.document.Objects), 7)

    def test_a_drawing_that_contradicts_itself_is_told_with_the_place(self) -> None:
        self.behave("contradicts")
        self.reconstruct()
        self.assertEqual(self.boxes(), [])
        self.assertIn("Shape not certain", widget(QtWidgets.QLabel, "stage").text())
        log = widget(QtWidgets.QPlainTextEdit, "log")
        self.assertIn("if the view “top” had one more hidden line", log.toPlainText())
        self.picture("panel-contradicts")
        group = self.document.getObject("Reconstruction")
        self.assertTrue(group.Reasons[0].startswith("lines-contradict: "))

    def test_a_drawing_can_be_dropped_on_the_preview(self) -> None:
        preview = widget(QtWidgets.QLabel, "preview")
        self.assertFalse(preview.has_picture)
        preview.dropEvent(dropped(self.sheet))
        self.assertEqual(widget(QtWidgets.QLineEdit, "sheet").text(), str(self.sheet))
        self.assertTrue(preview.has_picture)

    def test_saved_and_opened_again(self) -> None:
        self.reconstruct()
        FreeCADGui.Control.closeDialog()
        path = self.folder / "保存.FCStd"
        self.document.saveAs(str(path))
        FreeCAD.closeDocument(self.document.Name)
        document = FreeCAD.openDocument(str(path))
        spin(300)
        view = FreeCADGui.getDocument(document.Name).ActiveView
        view.viewIsometric()
        view.fitAll()
        self.picture("reopened")
        group = document.getObject("Reconstruction")
        self.assertFalse(group.ViewObject.Proxy.getIcon().isNull())
        planes = [o for o in group.Group if o.TypeId == "Image::ImagePlane"]
        self.assertEqual(len(planes), 3)
        for plane in planes:
            self.assertGreater(os.path.getsize(plane.ImageFile), 100)
        front = document.getObject("View_front")
        margin = round(0.04 * 240)
        self.assertAlmostEqual(front.XSize.Value, (240 + 2 * margin) * 0.25, places=6)
        self.assertAlmostEqual(front.YSize.Value, (120 + 2 * margin) * 0.25, places=6)
        self.assertTrue(group.ViewObject.isVisible())

    def test_what_the_console_made_gets_its_looks_in_the_window(self) -> None:
        output = self.folder / "made"
        arguments = json.dumps([str(self.sheet), "--output", str(output)])
        subprocess.run(
            [shutil.which("freecadcmd"), str(SCRIPT)],
            env={**os.environ, "GAUSSIANCAD_ARGS": arguments},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            check=True,
            timeout=120,
        )
        document = FreeCAD.openDocument(str(output / "bracket.FCStd"))
        group = document.getObject("Reconstruction")
        self.wait_for(lambda: type(group.ViewObject.Proxy).__name__ == "ReconstructionView")
        self.assertEqual(document.getObject("Gaussians").ViewObject.DisplayMode, "Color")
        shown = [name for name in ("Part", "Surface", "Gaussians") if is_shown(document, name)]
        self.assertEqual(shown, ["Part"])
        colour = document.getObject("Part").ViewObject.ShapeColor[:3]
        self.assertEqual([round(255 * channel) for channel in colour], [0x78, 0xA0, 0xD2])

    def test_a_document_is_made_where_there_is_none(self) -> None:
        FreeCAD.closeDocument(self.document.Name)
        if not FreeCADGui.Control.activeDialog():
            self.open_panel("GaussianCAD_Reconstruct")
        self.reconstruct()
        self.assertEqual(len(FreeCAD.listDocuments()), 1)
        self.assertIsNotNone(FreeCAD.ActiveDocument.getObject("Part"))

    def test_the_result_goes_where_the_run_began(self) -> None:
        self.behave("ok")
        self.choose_sheet(self.sheet)
        button = self.start()
        other = FreeCAD.newDocument("Other")
        self.wait_for(button.isEnabled)
        self.assertEqual((len(self.document.Objects), other.Objects), (7, []))

    def test_a_part_goes_to_a_document_of_its_own_where_another_is(self) -> None:
        self.document.addObject("Part::Box", "Box")
        self.choose_sheet(self.sheet)
        target = widget(QtWidgets.QComboBox, "target")
        self.assertEqual(target.currentText(), "A new document")
        self.finish()
        (name,) = set(FreeCAD.listDocuments()) - {self.document.Name}
        self.assertEqual(name, self.sheet.stem)
        self.assertEqual(target.currentData(), name)
        self.assertEqual(len(self.document.Objects), 1)
        self.assertIsNotNone(FreeCAD.getDocument(name).getObject("Part"))

    def test_a_person_says_into_which_document(self) -> None:
        self.document.addObject("Part::Box", "Box")
        self.choose_sheet(self.sheet)
        target = widget(QtWidgets.QComboBox, "target")
        target.setCurrentIndex(target.findData(self.document.Name))
        target.activated.emit(target.currentIndex())
        self.finish()
        self.assertEqual(list(FreeCAD.listDocuments()), [self.document.Name])
        self.assertIsNotNone(self.document.getObject("Part"))

    def wait_for_stage(self, text: str) -> None:
        stage = widget(QtWidgets.QLabel, "stage")
        self.wait_for(lambda: text in stage.text())

    def test_the_window_lives_while_the_engine_works_and_cancel_stops_it(self) -> None:
        self.behave("slow")
        self.choose_sheet(self.sheet)
        button = self.start()
        self.wait_for_stage("Stage 2 of 3: finding the solid")
        self.wait_for(lambda: widget(QtWidgets.QProgressBar, "fraction").value() == 1000)
        self.assertFalse(widget(QtWidgets.QLineEdit, "sheet").isEnabled())
        self.assertIn("Elapsed 0:0", widget(QtWidgets.QLabel, "elapsed").text())
        self.picture("panel-running")
        FreeCADGui.ActiveDocument.ActiveView.viewTop()
        widget(QtWidgets.QPushButton, "cancel").click()
        self.wait_for(button.isEnabled)
        self.assertEqual(widget(QtWidgets.QLabel, "stage").text(), "The run was cancelled.")
        self.assertEqual((self.boxes(), self.document.Objects), ([], []))
        self.assertEqual(self.document.UndoCount, 0)

    def test_the_part_is_there_while_the_engine_works_and_stays_when_it_is_cancelled(self) -> None:
        self.behave("long")
        self.choose_sheet(self.sheet)
        button = self.start()
        self.wait_for(lambda: self.document.getObject("Part"))
        self.wait_for_stage("3 of 3")
        self.assertFalse(button.isEnabled())
        self.assertEqual(len(self.document.Objects), 2)
        self.assertTrue(is_shown(self.document, "Part"))
        self.picture("panel-part-early")
        widget(QtWidgets.QPushButton, "cancel").click()
        self.wait_for(button.isEnabled)
        self.assertEqual(
            widget(QtWidgets.QLabel, "stage").text(),
            "The run was cancelled. The part stays in the document.",
        )
        self.assertEqual(self.boxes(), [])
        group = self.document.getObject("Reconstruction")
        self.assertEqual(group.Reasons, ["The run was cancelled."])
        group.ViewObject.Proxy.doubleClicked(group.ViewObject)
        dialog = widget(QtWidgets.QDialog, "GaussianCADReport")
        text = dialog.findChild(QtWidgets.QPlainTextEdit, "text")
        self.assertIn("cancelled", text.toPlainText())
        dialog.reject()
        self.assertEqual(self.document.UndoNames, ["Reconstruct from Drawing"])
        self.document.undo()
        self.assertEqual(self.document.Objects, [])

    def test_an_engine_that_dies_later_leaves_its_part_with_a_note(self) -> None:
        self.behave("dies-late")
        self.reconstruct()
        (box,) = self.boxes()
        self.assertIn("ended from outside", box.text())
        self.assertEqual(
            widget(QtWidgets.QLabel, "stage").text(), "Stopped. The part stays in the document."
        )
        group = self.document.getObject("Reconstruction")
        self.assertIn("ended from outside", group.Reasons[0])
        box.close()
        # The next run completes it.
        self.behave("ok")
        self.finish()
        self.assertEqual(len(self.document.Objects), 7)

    def test_closing_the_panel_cancels_first(self) -> None:
        self.behave("slow")
        self.choose_sheet(self.sheet)
        button = self.start()
        self.wait_for_stage("2 of 3")
        close = self.close_button()
        close.click()
        self.assertTrue(FreeCADGui.Control.activeDialog())
        self.wait_for(button.isEnabled)
        self.close_button().click()
        self.wait_for(lambda: not FreeCADGui.Control.activeDialog())

    def close_button(self) -> QtWidgets.QAbstractButton:
        boxes = self.window.findChildren(QtWidgets.QDialogButtonBox)
        kind = QtWidgets.QDialogButtonBox.StandardButton.Close
        return next(box.button(kind) for box in boxes if box.button(kind) and box.isVisible())

    def test_what_goes_wrong_is_told_in_a_box(self) -> None:
        text = self.folder / "text.png"
        text.write_text("this is no picture")
        missing = self.folder / "gone.png"
        cases = (
            ("ok", text, "The file is no PNG, JPEG,"),
            ("ok", missing, str(missing)),
            ("refuse", self.sheet, "Only one view was found. A part follows from two"),
            ("liar", self.sheet, "report.json"),
            ("half", self.sheet, "surface.stl"),
            ("broken", self.sheet, "No module named gaussiancad_core"),
            ("dies", self.sheet, "ended from outside"),
        )
        for behaviour, sheet, expected in cases:
            self.behave(behaviour)
            self.choose_sheet(sheet)
            button = self.start()
            self.wait_for(button.isEnabled)
            (box,) = self.boxes()
            self.assertIn(expected, box.text())
            self.assertNotIn("Traceback", box.text())
            box.close()
            self.assertEqual((self.document.Objects, self.document.UndoCount), ([], 0))
        self.behave("ok")
        self.finish()
        self.assertEqual(len(self.document.Objects), 7)

    def test_a_refusal_offers_the_canvas(self) -> None:
        self.behave("refuse")
        self.reconstruct()
        (box,) = self.boxes()
        (correct,) = (
            this_button
            for this_button in box.buttons()
            if this_button.text().startswith("Correct Sheet")
        )
        correct.click()
        (dock,) = open_docks()
        self.addCleanup(dock.close)
        self.assertEqual(dock.canvas.session.path, self.sheet)
        self.assertEqual(widget(QtWidgets.QPushButton, "followUp").text(), "Correct Sheet…")

    def test_of_one_view_the_panel_asks_how_thick_the_part_is(self) -> None:
        self.behave("plate")
        self.choose_sheet(self.sheet)
        again = widget(QtWidgets.QPushButton, "runWithThickness")
        self.assertFalse(again.isVisible())
        self.finish()
        self.assertEqual((self.boxes(), self.document.Objects), ([], []))
        self.assertTrue(again.isVisible())
        self.assertEqual(widget(QtWidgets.QPushButton, "followUp").text(), "Correct Sheet…")
        widget(QtWidgets.QDoubleSpinBox, "thickness").setValue(7.5)
        self.picture("panel-how-thick")
        again.click()
        self.assertFalse(again.isEnabled())
        self.wait_for(again.isEnabled)
        self.assertEqual(self.boxes(), [])
        group = self.document.getObject("Reconstruction")
        self.assertEqual(texts_of(group, "Settings")["thickness"], "y = 7.5")
        # It holds for this drawing, and goes with it.
        self.finish()
        self.assertEqual(self.boxes(), [])
        self.choose_sheet(self.folder / "other.png")
        self.assertFalse(again.isVisible())

    def test_without_an_engine_the_box_says_what_to_do(self) -> None:
        self.set_variable("GAUSSIANCAD_PYTHON", str(self.folder / "no python"))
        self.choose_sheet(self.sheet)
        self.start()
        (box,) = self.boxes()
        self.assertIn(str(self.folder / "no python"), box.text())
        self.picture("engine-missing")

    def test_settings_reach_the_engine(self) -> None:
        output = self.folder / "kept files"
        self.choose_sheet(self.sheet)
        widget(QtWidgets.QLineEdit, "output").setText(str(output))
        scale = widget(QtWidgets.QComboBox, "scale")
        scale.setCurrentIndex(list(ScaleKind).index(ScaleKind.LENGTH_Y))
        spin(100)
        length = widget(QtWidgets.QAbstractSpinBox, "length")
        self.assertTrue(length.isVisible())
        length.setProperty("rawValue", 42.5)
        self.open_more()
        widget(QtWidgets.QComboBox, "preset").setCurrentIndex(2)
        self.picture("panel-settings")
        self.finish()
        group = self.document.getObject("Reconstruction")
        self.assertEqual(texts_of(group, "Settings")["scale"], "y = 42.5")
        self.assertEqual(texts_of(group, "Settings")["preset"], "fine")
        self.assertTrue((output / "bracket" / "report.json").is_file())

    def test_the_papers_cameras_start_small_and_say_what_they_cost(self) -> None:
        size = widget(QtWidgets.QSpinBox, "scaleDown")
        effort = widget(QtWidgets.QLabel, "effort")
        recipe = widget(QtWidgets.QComboBox, "recipe")
        self.open_more()
        self.assertFalse(size.isVisible())
        recipe.setCurrentIndex(1)
        self.assertTrue(size.isVisible())
        self.assertEqual((size.value(), effort.text()[:12]), (6, "320 x 180 px"))
        self.picture("panel-perspective")
        widget(QtWidgets.QComboBox, "preset").setCurrentIndex(0)
        self.assertEqual((size.value(), effort.text()[:12]), (1, "240 x 135 px"))
        size.setValue(2)
        widget(QtWidgets.QComboBox, "preset").setCurrentIndex(1)
        self.assertEqual((size.value(), effort.text()[:12]), (2, "960 x 540 px"))
        self.reconstruct()
        settings = texts_of(self.document.getObject("Reconstruction"), "Settings")
        self.assertEqual((settings["recipe"], settings["scale-down"]), ("paper", "2"))
        widget(QtWidgets.QComboBox, "outcome").setCurrentIndex(1)
        self.assertFalse(size.isVisible())

    def test_temporary_files_are_removed(self) -> None:
        place = self.folder / "temporary"
        place.mkdir()
        self.addCleanup(setattr, tempfile, "tempdir", tempfile.tempdir)
        tempfile.tempdir = str(place)
        self.behave("slow")
        self.choose_sheet(self.sheet)
        button = self.start()
        self.wait_for_stage("2 of 3")
        self.assertEqual(len(list(place.iterdir())), 1)
        widget(QtWidgets.QPushButton, "cancel").click()
        self.wait_for(button.isEnabled)
        self.assertEqual(list(place.iterdir()), [])
        self.behave("ok")
        self.finish()
        self.assertEqual(list(place.iterdir()), [])

    def test_a_panel_closed_from_outside_stops_its_engine(self) -> None:
        self.behave("slow")
        self.choose_sheet(self.sheet)
        self.start()
        self.wait_for_stage("2 of 3")
        pid = self.engine_pid()
        FreeCADGui.Control.closeDialog()
        self.wait_for(lambda: not alive(pid))

    def engine_pid(self) -> int:
        children = []
        for entry in filter(str.isdigit, os.listdir("/proc")):
            try:
                with open(f"/proc/{entry}/cmdline", "rb") as file:
                    command = file.read()
            except OSError:
                continue
            if b"fake_engine.py" in command and str(self.sheet).encode() in command:
                children.append(int(entry))
        self.assertEqual(len(children), 1)
        return children[0]


def is_shown(document: FreeCAD.Document, name: str) -> bool:
    return document.getObject(name).ViewObject.isVisible()
