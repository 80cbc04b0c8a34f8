"""The window in other languages."""

import FreeCAD
import FreeCADGui
from window import WindowCase, spin, widget

from freecad.gaussiancad.engine.wording import worded
from freecad.gaussiancad.qt import QtWidgets

SPOKEN = {
    "de": "Mit Referenz vergleichen…|Form bestätigt.|Nur Festkörper|Bauteil|"
    "Aus Zeichnung rekonstruieren",
    "zh-CN": "与参考比较…|形状已验证。|仅实体|零件|由图纸重建",
}
"""An entry of the menu, a verdict, a choice, the part, and the step that makes it."""


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

    def test_menu_panel_and_result_speak_german_and_chinese(self) -> None:
        for language, texts in SPOKEN.items():
            compare, verdict, solid, part, step = texts.split("|")
            self.speak(language)
            info = FreeCADGui.Command.get("GaussianCAD_Compare")
            said = [action.text().replace("&", "") for action in info.getAction()]
            self.assertEqual(said, [compare])
            self.assertIn(verdict, self.run_the_sheet(language.partition("-")[0]))
            self.assertEqual(widget(QtWidgets.QComboBox, "outcome").itemText(1), solid)
            document = FreeCAD.ActiveDocument
            self.assertEqual(document.getObject("Part").Label, part)
            self.assertEqual(document.UndoNames, [step])
            self.close_all()

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
