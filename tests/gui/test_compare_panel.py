"""*Compare with Reference…* in a real window, with the fake engine."""

import os
from pathlib import Path

import fake_part
import FreeCAD
import FreeCADGui
import Mesh
import Part
from window import WindowCase, spin, widget

from freecad.gaussiancad.qt import QtGui, QtWidgets


class Panel(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Test")
        part = self.document.addObject("Part::Feature", "Model")
        part.Shape = Part.read(str(fake_part.STEP_FILE))
        scan = self.document.addObject("Mesh::Feature", "Scan")
        path = self.folder / "scan.stl"
        path.write_text(fake_part.stl_text())
        scan.Mesh = Mesh.Mesh(str(path))
        body = self.document.addObject("PartDesign::Body", "Body")
        box = self.document.addObject("PartDesign::AdditiveBox", "Box")
        body.addObject(box)
        self.document.recompute()
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(scan)
        FreeCADGui.Selection.addSelection(part)
        self.open_panel("GaussianCAD_Compare")
        self.count = len(self.document.Objects)

    def compare(self) -> None:
        button = self.start()
        self.wait_for(button.isEnabled)

    def colourful(self) -> int:
        """Number of saturated pixels in the 3D view's picture."""
        view = FreeCADGui.getDocument(FreeCAD.ActiveDocument.Name).ActiveView
        view.viewIsometric()
        view.fitAll()
        spin(500)
        path = str(self.folder / "view.png")
        view.saveImage(path, 200, 150, "White")
        image = QtGui.QImage(path)
        count = 0
        for y in range(image.height()):
            for x in range(image.width()):
                colour = image.pixelColor(x, y)
                channels = (colour.red(), colour.green(), colour.blue())
                count += max(channels) - min(channels) > 60
        return count

    def test_whole_objects_are_offered_and_the_selected_ones_chosen(self) -> None:
        result, reference = (widget(QtWidgets.QComboBox, n) for n in ("result", "reference"))
        offered = [result.itemText(index) for index in range(result.count())]
        self.assertEqual(offered, ["Model", "Scan", "Body", "File…"])
        self.assertEqual((result.currentText(), reference.currentText()), ("Scan", "Model"))

    def test_distances_beside_their_floor_millimetres_and_a_coloured_mesh(self) -> None:
        self.compare()
        self.assertEqual(self.boxes(), [])
        table = widget(QtWidgets.QTableWidget, "distances")
        shown = [
            [table.item(row, column).text() for column in range(2)]
            for row in range(table.rowCount())
        ]
        self.assertEqual(
            shown,
            [
                ["0.0312", "0.03"],
                ["0.12", "0.1"],
                ["0.056", "0.05"],
                ["0.004", "–"],
                ["0.991", "–"],
            ],
        )
        log = widget(QtWidgets.QPlainTextEdit, "log").toPlainText()
        self.assertIn("Hausdorff: 1.44 mm", log)
        table = widget(QtWidgets.QTableWidget, "engineering")
        rows = [[table.item(row, k).text() for k in range(2)] for row in range(table.rowCount())]
        self.assertEqual(rows[:3], [["-0.01", "-0.01"], ["0.05", "0.05"], ["-0.75", "-0.75"]])
        self.assertEqual(rows[3:], [["0.5", "1"], ["87.5", "87.5"], ["-2", ""], ["–", ""]])
        self.assertIn("Not closed: the result (open edges: 3).", log)
        shown = {o.Name: o.Visibility for o in self.document.Objects}
        self.assertEqual((shown["Model"], shown["Scan"], shown["Deviation"]), (False, False, True))
        for name in ("Body", "Legend"):
            self.document.getObject(name).Visibility = False
        self.assertGreater(self.colourful(), 1000)
        self.document.getObject("Legend").Visibility = True
        FreeCADGui.getDocument("Test").ActiveView.fitAll()
        self.picture("compare-finished")
        self.assertEqual(self.document.UndoNames[0], "Compare with Reference")
        self.document.undo()
        self.assertTrue(self.document.getObject("Model").Visibility)
        self.assertEqual(len(self.document.Objects), self.count)

    def test_no_number_is_cut_short(self) -> None:
        self.compare()
        for name in ("distances", "engineering"):
            table = widget(QtWidgets.QTableWidget, name)
            columns = range(table.columnCount())
            for column in columns:
                self.assertGreaterEqual(table.columnWidth(column), table.sizeHintForColumn(column))
            wide = sum(table.columnWidth(column) for column in columns)
            self.assertLessEqual(wide, table.viewport().width())
        self.picture("compare-numbers")
        self.assertEqual(
            widget(QtWidgets.QTableWidget, "distances").item(0, 0).toolTip(),
            "Chamfer distance: 0.0312",
        )

    def test_the_view_flies_to_a_worst_point(self) -> None:
        self.compare()
        view = FreeCADGui.getDocument("Test").ActiveView
        view.viewIsometric()
        view.fitAll()
        spin(300)
        graph = view.getSceneGraph()
        children, height = graph.getNumChildren(), view.getCameraNode().height.getValue()
        table = widget(QtWidgets.QTableWidget, "worst")
        self.assertEqual([table.item(k, 0).text() for k in range(2)], ["-1", "-0.75"])
        self.assertEqual([table.item(k, 1).text() for k in range(2)], ["nothing", "too little"])
        self.assertEqual(table.item(1, 2).text(), "0, 0, 30")
        widget(QtWidgets.QTabWidget, "comparisonTabs").setCurrentIndex(1)
        table.selectRow(1)

        def centred() -> bool:
            across, up = view.getPointOnScreen(FreeCAD.Vector(0, 0, 30))
            width, tall = view.getSize()
            return abs(across / width - 0.5) < 0.02 and abs(up / tall - 0.5) < 0.02

        self.wait_for(centred)
        self.wait_for(lambda: view.getCameraNode().height.getValue() < 0.5 * height)
        self.assertEqual(graph.getNumChildren(), children + 1)
        self.picture("compare-worst")
        FreeCADGui.Control.closeDialog()
        spin(200)
        self.assertEqual(graph.getNumChildren(), children)

    def test_the_range_is_undone_as_one_step(self) -> None:
        self.compare()
        steps = self.document.UndoCount
        widget(QtWidgets.QDoubleSpinBox, "range").setValue(0.25)
        spin(200)
        group = self.document.getObject("Comparison")
        self.assertEqual(group.ColourRange.Value, 0.25)
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.picture("compare-range")
        self.document.undo()
        self.assertEqual(group.ColourRange.Value, 1.0)

    def test_a_section_shows_both_outlines(self) -> None:
        self.compare()
        view = FreeCADGui.getDocument("Test").ActiveView
        self.document.getObject("Body").Visibility = False
        view.viewFront()
        view.fitAll()
        graph = view.getSceneGraph()
        children = graph.getNumChildren()
        axis = widget(QtWidgets.QComboBox, "sectionAxis")
        axis.setCurrentIndex(2)
        spin(300)
        self.assertEqual(graph.getNumChildren(), children + 2)
        self.picture("compare-section")
        widget(QtWidgets.QSlider, "sectionPlace").setValue(100)
        spin(100)
        self.assertEqual(graph.getNumChildren(), children + 2)
        axis.setCurrentIndex(0)
        self.assertEqual(graph.getNumChildren(), children)

    def test_a_file_is_a_reference(self) -> None:
        box = widget(QtWidgets.QComboBox, "reference")
        box.choose_file(fake_part.STEP_FILE)
        self.compare()
        self.assertEqual(self.boxes(), [])
        group = self.document.getObject("Comparison")
        self.assertEqual(group.ReferenceFile, str(fake_part.STEP_FILE))
        widget(QtWidgets.QComboBox, "sectionAxis").setCurrentIndex(1)
        spin(200)
        self.assertEqual(self.boxes(), [])

    def test_with_the_sheet_of_a_reconstruction_it_is_shown_and_saved_as_table_json_page_and_pdf(
        self,
    ) -> None:
        group = self.document.addObject("App::DocumentObjectGroup", "Reconstruction")
        group.addProperty("App::PropertyFileIncluded", "Overlay")
        group.Overlay = str(self.sheet)
        group.addObject(self.document.getObject("Scan"))
        self.compare()
        tabs = widget(QtWidgets.QTabWidget, "comparisonTabs")
        self.assertEqual([tabs.tabText(k) for k in range(tabs.count())][2:], ["Sheet"])
        tabs.setCurrentIndex(2)
        spin(200)
        self.assertFalse(widget(QtWidgets.QLabel, "sheetPicture").pixmap().isNull())
        self.picture("compare-sheet")
        view = widget(QtWidgets.QPushButton, "saveComparison").parentWidget()
        for name, start in (
            ("a.csv", b"\xef\xbb\xbfmeasure"),
            ("b.json", b"{"),
            ("c.html", b"<!"),
            ("Träger – 支架.pdf", b"%PDF-"),
        ):
            view.save_as(self.folder / name)
            self.assertTrue((self.folder / name).read_bytes().startswith(start), name)
        content = (self.folder / name).read_bytes()
        self.assertTrue(content.rstrip().endswith(b"%%EOF"))
        # The histogram, the sheet and the coloured result.
        self.assertGreaterEqual(content.count(b"/Subtype /Image"), 3)
        kept = Path(os.environ.get("GAUSSIANCAD_ARTIFACTS", str(self.folder)))
        (kept / f"comparison-{FreeCAD.Version()[0]}.pdf").write_bytes(content)
        with self.assertRaises(OSError):
            view.save_as(self.folder / "missing" / "a.pdf")

    def test_a_changed_object_is_compared_again(self) -> None:
        self.compare()
        group, part = self.document.getObject("Comparison"), self.document.getObject("Model")
        self.assertFalse(group.Stale)
        state = group.ReferenceState
        part.Placement.Base = FreeCAD.Vector(0, 0, 3)
        self.document.recompute()
        self.assertTrue(group.Stale)
        self.wait_for(lambda: not group.Stale)
        self.assertNotEqual(group.ReferenceState, state)
        self.assertEqual(self.document.UndoNames[0], "Compare Again")

    def test_a_comparison_is_shown_again(self) -> None:
        self.compare()
        FreeCADGui.Control.closeDialog()
        spin(200)
        group = self.document.getObject("Comparison")
        FreeCADGui.Selection.clearSelection()
        FreeCADGui.Selection.addSelection(group)
        self.open_panel("GaussianCAD_Compare")
        self.assertEqual(widget(QtWidgets.QComboBox, "result").currentText(), "Scan")
        table = widget(QtWidgets.QTableWidget, "distances")
        self.assertEqual(table.item(0, 0).text(), "0.0312")
        count = len(self.document.Objects)
        self.compare()
        self.assertEqual(len(self.document.Objects), count)

    def test_the_colours_survive_saving(self) -> None:
        self.compare()
        FreeCADGui.Control.closeDialog()
        for name in ("Model", "Scan", "Body", "Legend"):
            self.document.getObject(name).Visibility = False
        path = self.folder / "compared.FCStd"
        self.document.saveAs(str(path))
        FreeCAD.closeDocument("Test")
        document = FreeCAD.openDocument(str(path))
        spin(500)
        self.assertEqual(len(document.getObject("Deviation").VertexColors), 12)
        self.assertGreater(self.colourful(), 1000)
        self.assertFalse(FreeCADGui.getDocument(document.Name).Modified)

    def test_cancelling_leaves_the_document_alone(self) -> None:
        self.behave("slow")
        button = self.start()
        spin(500)
        self.picture("compare-running")
        widget(QtWidgets.QPushButton, "cancel").click()
        self.wait_for(button.isEnabled)
        self.assertEqual((len(self.document.Objects), self.boxes()), (self.count, []))

    def test_one_object_cannot_be_compared_with_itself(self) -> None:
        widget(QtWidgets.QComboBox, "reference").setCurrentIndex(1)
        self.start()
        (box,) = self.boxes()
        self.assertIn("two different", box.text())

    def test_a_document_that_was_closed_is_told(self) -> None:
        self.behave("ok")
        button = self.start()
        FreeCAD.closeDocument("Test")
        if FreeCADGui.Control.activeDialog():
            self.wait_for(button.isEnabled)
            (box,) = self.boxes()
            self.assertIn("closed", box.text())


class EmptyDocument(WindowCase):
    def test_nothing_to_compare_is_told(self) -> None:
        FreeCAD.newDocument("Empty")
        self.open_panel("GaussianCAD_Compare")
        self.picture("compare-empty")
        self.start()
        (box,) = self.boxes()
        self.assertIn("nothing to compare", box.text())
