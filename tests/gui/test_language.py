"""The window in other languages."""

import FreeCAD
import FreeCADGui
from window import WindowCase, spin, widget

from freecad.gaussiancad.engine.wording import worded
from freecad.gaussiancad.qt import QtWidgets


class Languages(WindowCase):
    def speak(self, language: str) -> None:
        """Switch FreeCAD to a language, by its locale, until the end of the test."""
        self.addCleanup(FreeCADGui.setLocale, "English")
        FreeCADGui.setLocale(language)
        spin(200)

    def run_the_sheet(self, name: str) -> str:
        """Run the sheet in a document of that name; the headline at the end."""
        FreeCAD.newDocument(name)
        self.open_panel("GaussianCAD_Reconstruct")
        self.choose_sheet(self.sheet)
        button = self.start()
        self.wait_for(button.isEnabled)
        self.picture(f"panel-{name.lower()}")
        return widget(QtWidgets.QLabel, "stage").text()

    def test_menu_panel_and_result_speak_german(self) -> None:
        self.speak("de")
        info = FreeCADGui.Command.get("GaussianCAD_Compare")
        texts = [action.text().replace("&", "") for action in info.getAction()]
        self.assertEqual(texts, ["Mit Referenz vergleichen…"])
        self.assertIn("Form bestätigt.", self.run_the_sheet("German"))
        self.assertEqual(widget(QtWidgets.QComboBox, "outcome").itemText(1), "Nur Festkörper")
        document = FreeCAD.ActiveDocument
        self.assertEqual(document.getObject("Part").Label, "Bauteil")
        self.assertEqual(document.UndoNames, ["Aus Zeichnung rekonstruieren"])

    def test_menu_panel_and_result_speak_chinese(self) -> None:
        self.speak("zh-CN")
        info = FreeCADGui.Command.get("GaussianCAD_Compare")
        texts = [action.text().replace("&", "") for action in info.getAction()]
        self.assertEqual(texts, ["与参考比较…"])
        self.assertIn("形状已验证。", self.run_the_sheet("Chinese"))
        self.assertEqual(widget(QtWidgets.QComboBox, "outcome").itemText(1), "仅实体")
        document = FreeCAD.ActiveDocument
        self.assertEqual(document.getObject("Part").Label, "零件")
        self.assertEqual(document.UndoNames, ["由图纸重建"])

    def test_what_the_engine_refuses_is_told_in_the_users_language(self) -> None:
        self.speak("de")
        values = {"view": "top", "case": "gap"}
        stated = worded("open-outline", "the outline of the top view is not closed", values)
        self.assertTrue(stated.startswith("Der Umriss der Ansicht „oben“ ist nicht geschlossen."))
        self.behave("refuse")
        FreeCAD.newDocument("Refused")
        self.open_panel("GaussianCAD_Reconstruct")
        self.choose_sheet(self.sheet)
        self.start()
        self.wait_for(self.boxes)
        (box,) = self.boxes()
        self.assertTrue(box.text().startswith("Es wurde nur eine Ansicht gefunden."), box.text())
        self.picture("refused-german")
