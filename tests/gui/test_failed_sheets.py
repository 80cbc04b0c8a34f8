"""*Open Failed Sheets…*, with the real engine; left out where it is not installed."""

import json
import os
import shutil
import unittest
from pathlib import Path

import FreeCAD
from test_real_engine import PLAIN, engine
from window import WindowCase, spin

from freecad.gaussiancad.panels import correct
from freecad.gaussiancad.panels.failed_sheets import open_report
from freecad.gaussiancad.qt import QtWidgets

GIVEN = os.environ.get("GAUSSIANCAD_PYTHON")


@unittest.skipIf(engine() is None, "the engine is not installed")
class FailedSheets(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.set_variable("GAUSSIANCAD_PYTHON", GIVEN)
        self.sheets = [Path(shutil.copy(PLAIN, self.folder / name)) for name in ("a.png", "b.png")]
        rows = [
            {"name": sheet.stem, "sheet": str(sheet), "status": "approximate", "folder": ""}
            for sheet in self.sheets
        ]
        self.report = self.folder / "report.json"
        self.report.write_text(json.dumps({"sheets": rows}), encoding="utf-8")
        self.addCleanup(self.close_docks)

    def close_docks(self) -> None:
        for dock in correct.open_docks():
            dock.close()
        spin(200)

    def test_each_opens_in_a_document_of_its_own(self) -> None:
        dock = open_report(self.report)
        self.addCleanup(dock.close)
        (first,) = correct.open_docks()
        self.assertEqual(first.canvas.session.path, self.sheets[0])
        self.wait_for(lambda: dock.list.sheets[0].status == "verified", 120.0)
        self.picture("failed-sheets")
        dock.list.open_next()
        self.assertEqual(len(correct.open_docks()), 2)
        self.assertEqual(len(FreeCAD.listDocuments()), 2)
        self.wait_for(lambda: dock.list.sheets[1].status == "verified", 120.0)
        self.assertFalse(dock.list.next_button.isEnabled())

    def test_what_is_no_report_is_told(self) -> None:
        self.report.write_text("{", encoding="utf-8")
        stated = []
        original = QtWidgets.QMessageBox.warning
        QtWidgets.QMessageBox.warning = lambda _parent, _title, text: stated.append(text)
        try:
            self.assertIsNone(open_report(self.report))
        finally:
            QtWidgets.QMessageBox.warning = original
        self.assertIn("no report of a batch", stated[0])
