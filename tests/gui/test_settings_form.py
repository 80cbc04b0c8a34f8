"""The settings: few of them stand open, all are whole in a narrow panel, choices come back."""

import FreeCAD
import FreeCADGui
from window import WindowCase, spin, widget

from freecad.gaussiancad.engine.job import Projection, ScaleKind
from freecad.gaussiancad.engine.protocol import Preset, ResultKind
from freecad.gaussiancad.panels.reconstruct import ReconstructPanel
from freecad.gaussiancad.panels.settings_form import SettingsForm
from freecad.gaussiancad.preferences import GROUP, read_preferences
from freecad.gaussiancad.qt import QtWidgets
from freecad.gaussiancad.remembered import LAST, Choices, remember, starting_choices

NARROW = 300
"""px of a task panel that a person made small."""

FEW = {"page", "scale", "outcome"}
MORE = {"projection", "preset", "recipe", "colour", "output"}


def visible(form: QtWidgets.QWidget) -> set[str]:
    names = FEW | MORE | {"length", "mmPerPixel", "scaleDown"}
    return {name for name in names if form.findChild(QtWidgets.QWidget, name).isVisible()}


class Settings(WindowCase):
    def setUp(self) -> None:
        super().setUp()
        FreeCAD.ParamGet(LAST).RemBool("Body")
        FreeCAD.newDocument("Test")

    def opened(self) -> SettingsForm:
        FreeCADGui.Control.closeDialog()
        spin(100)
        panel = ReconstructPanel()
        FreeCADGui.Control.showDialog(panel)
        spin(300)
        return panel.settings

    def test_few_stand_open_and_a_click_shows_the_rest(self) -> None:
        form = self.opened()
        self.assertEqual(visible(form), FEW)
        self.picture("settings-few")
        form.more.heading.click()
        spin(100)
        self.assertEqual(visible(form), FEW | MORE)
        self.assertEqual(visible(self.opened()), FEW | MORE)
        page = widget(QtWidgets.QSpinBox, "page")
        self.assertFalse(page.isEnabled())
        self.choose_sheet(self.folder / "drawing.pdf")
        self.assertTrue(page.isEnabled())
        widget(QtWidgets.QToolButton, "moreSettings").click()
        self.assertEqual(visible(self.opened()), FEW)

    def test_no_value_is_clipped_in_a_narrow_panel(self) -> None:
        self.addCleanup(FreeCADGui.setLocale, "English")
        for language in ("English", "de", "zh-CN"):
            FreeCADGui.setLocale(language)
            spin(200)
            self.check_narrow(language)

    def check_narrow(self, language: str) -> None:
        form = SettingsForm(starting_choices(read_preferences()))
        form.more.heading.setChecked(True)
        form.resize(NARROW, 600)
        form.show()
        self.addCleanup(form.close)
        boxes = form.findChildren(QtWidgets.QComboBox)
        self.assertEqual(len(boxes), 5)
        for box in boxes:
            for index in range(box.count()):
                box.setCurrentIndex(index)
                spin(20)
                self.assertLessEqual(form.minimumSizeHint().width(), NARROW)
                self.assertLessEqual(text_width(box), edit_width(box), box.currentText())
                right = box.mapTo(form, box.rect().topRight()).x()
                self.assertLess(right, form.width())
        form.resize(NARROW, form.sizeHint().height())
        form.grab().save(str(self.picture(f"settings-narrow-{language}")))

    def test_what_was_chosen_comes_back_but_not_what_belongs_to_the_sheet(self) -> None:
        form = self.opened()
        self.choose_sheet(self.sheet)
        form.outcome.choose(ResultKind.SOLID)
        form.projection.choose(Projection.FIRST)
        form.colour.set_colour("#102030")
        form.scale.choose(ScaleKind.LENGTH_Z)
        button = self.start()
        self.wait_for(button.isEnabled)
        again = self.opened()
        self.assertEqual(again.choices, form_choices(ResultKind.SOLID, Projection.FIRST, "#102030"))
        self.assertIs(again.scale.mode, ScaleKind.UNKNOWN)
        self.assertEqual(again.page.value(), 1)

    def test_what_a_sheet_tells_of_its_projection_is_of_that_sheet_alone(self) -> None:
        form = SettingsForm(starting_choices(read_preferences()))
        usual = form.projection.mode
        form.tell_projection(Projection.FIRST)
        self.assertIs(form.job("", "").projection, Projection.FIRST)
        self.assertIs(form.choices.projection, usual)
        form.forget_projection()
        self.assertIs(form.projection.mode, usual)
        # What a person chose stands whatever a sheet tells.
        form.projection.choose(Projection.THIRD)
        form.projection.activated.emit(form.projection.currentIndex())
        form.tell_projection(Projection.FIRST)
        self.assertIs(form.projection.mode, Projection.THIRD)
        self.assertIs(form.choices.projection, Projection.THIRD)

    def test_a_changed_preference_counts_more_than_what_was_chosen_before(self) -> None:
        group = FreeCAD.ParamGet(GROUP)
        chosen = form_choices(ResultKind.SURFACE, Projection.FIRST, "#405060")
        remember(chosen, read_preferences())
        self.assertEqual(starting_choices(read_preferences()), chosen)
        group.SetInt("Outcome", 1)
        expected = form_choices(ResultKind.SOLID, Projection.FIRST, "#405060")
        self.assertEqual(starting_choices(read_preferences()), expected)

    def test_what_is_damaged_counts_as_never_chosen(self) -> None:
        remember(form_choices(ResultKind.SOLID, Projection.FIRST, "#102030"), read_preferences())
        last = FreeCAD.ParamGet(LAST)
        last.SetString("Outcome", "everything")
        last.SetString("Recipe", "cake")
        last.SetString("Colour", "red")
        last.SetInt("ScaleDown", -4)
        start = starting_choices(read_preferences())
        self.assertEqual(start, Choices(Projection.FIRST, Preset.STANDARD, ResultKind.BOTH))

    def test_views_are_added_unless_the_preferences_say_no(self) -> None:
        FreeCAD.ParamGet(GROUP).SetBool("ViewPlanes", False)
        self.opened()
        self.choose_sheet(self.sheet)
        button = self.start()
        self.wait_for(button.isEnabled)
        kinds = {found.TypeId for found in FreeCAD.ActiveDocument.Objects}
        self.assertIn("Part::Feature", kinds)
        self.assertNotIn("Image::ImagePlane", kinds)


def form_choices(outcome: ResultKind, projection: Projection, colour: str) -> Choices:
    return Choices(projection, Preset.STANDARD, outcome, colour=colour)


def text_width(box: QtWidgets.QComboBox) -> int:
    return box.fontMetrics().horizontalAdvance(box.currentText())


def edit_width(box: QtWidgets.QComboBox) -> int:
    option = QtWidgets.QStyleOptionComboBox()
    box.initStyleOption(option)
    style = QtWidgets.QStyle
    return (
        box.style()
        .subControlRect(
            style.ComplexControl.CC_ComboBox, option, style.SubControl.SC_ComboBoxEditField, box
        )
        .width()
    )
