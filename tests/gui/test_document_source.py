"""Drawings of the open document as the source of a reconstruction, in a real window."""

from pathlib import Path

import FreeCAD
import FreeCADGui
from window import WindowCase, spin, widget

from freecad.gaussiancad.qt import QtWidgets


class Source(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Test")
        self.plane = self.document.addObject("Image::ImagePlane", "Scan")
        self.plane.ImageFile = str(self.sheet)
        self.document.addObject("TechDraw::DrawPage", "Page")
        self.document.recompute()

    def sheet_line(self) -> QtWidgets.QLineEdit:
        return widget(QtWidgets.QLineEdit, "sheet")

    def test_a_selected_image_is_taken(self) -> None:
        FreeCADGui.Selection.addSelection(self.plane)
        self.open_panel("GaussianCAD_Reconstruct")
        taken = Path(self.sheet_line().text())
        self.assertEqual(taken.read_bytes(), self.sheet.read_bytes())
        self.assertTrue(widget(QtWidgets.QLabel, "preview").has_picture)
        self.picture("panel-image-plane")
        FreeCADGui.Control.closeDialog()
        self.wait_for(lambda: not taken.exists())

    def test_a_second_panel_on_the_same_image_updates_its_group(self) -> None:
        for _ in range(2):
            FreeCADGui.Selection.addSelection(self.plane)
            self.open_panel("GaussianCAD_Reconstruct")
            widget(QtWidgets.QPushButton, "start").click()
            self.wait_for(widget(QtWidgets.QPushButton, "start").isEnabled)
            FreeCADGui.Control.closeDialog()
            spin(200)
        groups = [found for found in self.document.Objects if hasattr(found, "SheetPath")]
        self.assertEqual(len(groups), 1)

    def test_the_menu_offers_pages_and_images(self) -> None:
        self.open_panel("GaussianCAD_Reconstruct")
        self.assertEqual(self.sheet_line().text(), "")
        button = widget(QtWidgets.QToolButton, "source")
        button.offer()
        page, scan = button.menu().actions()
        self.assertEqual([page.text(), scan.text()], ["Page", "Scan"])
        scan.trigger()
        self.assertEqual(Path(self.sheet_line().text()).read_bytes(), self.sheet.read_bytes())
        self.assertEqual(self.boxes(), [])

    def test_a_page_without_views_is_told(self) -> None:
        self.open_panel("GaussianCAD_Reconstruct")
        button = widget(QtWidgets.QToolButton, "source")
        button.offer()
        button.menu().actions()[0].trigger()
        self.assertEqual(self.sheet_line().text(), "")
        self.assertIn("Page", self.boxes()[0].text())

    def test_vector_files_have_no_preview_here(self) -> None:
        self.open_panel("GaussianCAD_Reconstruct")
        preview = widget(QtWidgets.QLabel, "preview")
        for suffix in ("svg", "dxf", "pdf"):
            path = self.folder / f"sheet.{suffix}"
            path.write_text("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'/>")
            self.choose_sheet(path)
            self.assertFalse(preview.has_picture)
            self.assertIn(path.name, preview.text())
            self.assertEqual(widget(QtWidgets.QSpinBox, "page").isEnabled(), suffix != "svg")
