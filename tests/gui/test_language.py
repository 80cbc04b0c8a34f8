"""The window in German."""

import FreeCAD
import FreeCADGui
from window import WindowCase, spin, widget

from freecad.gaussiancad.qt import QtWidgets


class German(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        self.addCleanup(FreeCADGui.setLocale, "English")
        FreeCADGui.setLocale("German")
        spin(200)

    def test_menu_panel_and_result_speak_german(self) -> None:
        info = FreeCADGui.Command.get("GaussianCAD_Compare")
        texts = [action.text().replace("&", "") for action in info.getAction()]
        self.assertEqual(texts, ["Mit Referenz vergleichen…"])
        document = FreeCAD.newDocument("Deutsch")
        self.open_panel("GaussianCAD_Reconstruct")
        self.choose_sheet(self.sheet)
        self.assertEqual(widget(QtWidgets.QComboBox, "outcome").itemText(1), "Nur Festkörper")
        button = self.start()
        self.wait_for(button.isEnabled)
        self.picture("panel-german")
        self.assertIn("Form bestätigt.", widget(QtWidgets.QLabel, "stage").text())
        self.assertEqual(document.getObject("Part").Label, "Bauteil")
        self.assertEqual(document.UndoNames, ["Aus Zeichnung rekonstruieren"])
