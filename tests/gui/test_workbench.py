"""The workbench in the window: found, registered once, with its pages and buttons."""

import FreeCAD
import FreeCADGui
from window import WindowCase, spin

from freecad.gaussiancad import workbench, workbench_names
from freecad.gaussiancad.preferences import GROUP, read_preferences
from freecad.gaussiancad.qt import QtCore, QtWidgets


class Registration(WindowCase):
    def test_freecad_found_it_and_a_second_registration_does_nothing(self) -> None:
        before = sorted(FreeCADGui.listWorkbenches())
        self.assertEqual(before.count("GaussianCADWorkbench"), 1)
        workbench.register()
        self.assertEqual(sorted(FreeCADGui.listWorkbenches()), before)

    def test_toolbar_and_menu_hold_the_commands(self) -> None:
        active = FreeCADGui.activeWorkbench()
        self.assertEqual(active.name(), "GaussianCADWorkbench")
        self.assertEqual(active.getToolbarItems()["GaussianCAD"], list(workbench_names.TOOLBAR))
        for name in workbench_names.MENU:
            command = FreeCADGui.Command.get(name)
            info = command.getInfo()
            # What is done at once asks nothing.
            asks = name != "GaussianCAD_SheetNumbers"
            self.assertEqual(info["menuText"].endswith("…"), asks, name)
            self.assertFalse(FreeCADGui.getIcon(info["pixmap"]).isNull())
        menus = [action.text() for action in self.window.menuBar().actions()]
        self.assertIn("GaussianCAD", [menu.replace("&", "") for menu in menus])

    def test_the_preferences_page_stores_what_it_shows(self) -> None:
        seen: list[str] = []

        def use_the_page() -> None:
            dialog = QtWidgets.QApplication.activeModalWidget()
            try:
                preset = dialog.findChild(QtWidgets.QComboBox, "preset")
                seen.extend(preset.itemText(i) for i in range(preset.count()))
                seen.append(preset.currentText())
                preset.setCurrentIndex(0)
                dialog.findChild(QtWidgets.QComboBox, "outcome").setCurrentIndex(1)
                planes = dialog.findChild(QtWidgets.QCheckBox, "viewPlanes")
                seen.append(str(planes.isChecked()))
                planes.setChecked(False)
                line = dialog.findChild(QtWidgets.QWidget, "enginePython")
                line.setProperty("fileName", "/somewhere/python")
                self.picture("preferences")
            finally:
                dialog.accept()

        QtCore.QTimer.singleShot(1500, use_the_page)
        FreeCADGui.showPreferences("GaussianCAD", 0)
        spin(200)
        self.assertEqual(seen, ["Draft", "Standard", "Fine", "Standard", "True"])
        preferences = read_preferences()
        self.assertEqual(preferences.preset.value, "draft")
        self.assertEqual(preferences.projection.value, "auto")
        self.assertEqual(preferences.engine_python, "/somewhere/python")
        self.assertEqual((preferences.outcome.value, preferences.view_planes), ("solid", False))

    def test_preferences_out_of_range_fall_back(self) -> None:
        group = FreeCAD.ParamGet(GROUP)
        group.SetInt("Preset", 17)
        group.SetInt("Projection", -1)
        group.SetInt("Outcome", 3)
        preferences = read_preferences()
        self.assertEqual(
            (preferences.preset.value, preferences.projection.value, preferences.outcome.value),
            ("standard", "auto", "both"),
        )
