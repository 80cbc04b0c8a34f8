"""The drawing's numbers in a body: which were changed, and the way back to them."""

import FreeCAD
from body_cases import DATA, BodyCase, bracket

from freecad.gaussiancad.objects.bodies import add_bodies
from freecad.gaussiancad.objects.body_check import check_body
from freecad.gaussiancad.objects.feature_file import read_features
from freecad.gaussiancad.objects.sheet_numbers import (
    ChangedNumber,
    bodies_meant,
    changed_numbers,
    set_back,
)


class SheetNumbers(BodyCase):
    def setUp(self) -> None:
        super().setUp()
        self.document.UndoMode = 1
        (made,) = add_bodies(self.part(bracket()), read_features(DATA / "bracket.json"))
        self.body = made.body
        self.sketch = self.document.getObject("Pad1Sketch")

    def change(self, name: str, value: float) -> None:
        self.sketch.setDatum(name, FreeCAD.Units.Quantity(value, FreeCAD.Units.Length))
        self.document.recompute()

    def test_numbers_that_were_changed_are_told_those_that_were_measured_are_not(self) -> None:
        self.assertEqual(changed_numbers(self.body), ())
        self.change("Height", 35.0)
        self.change("WallThickness", 12.0)
        self.assertEqual(changed_numbers(self.body), (ChangedNumber("Pad1.Height", 30.0, 35.0),))

    def test_all_are_set_back_in_one_undo_step(self) -> None:
        for name, value in (("Height", 90.0), ("BaseThickness", 35.0), ("Width", 20.0)):
            self.change(name, value)
        steps = self.document.UndoCount
        self.assertEqual(set_back([self.body]), 3)
        self.assertEqual(self.document.UndoCount, steps + 1)
        self.assertEqual(self.document.UndoNames[0], "Back to the Sheet's Numbers")
        self.assertEqual(check_body(self.body.Shape, bracket()).words, "")
        self.document.undo()
        self.document.recompute()
        self.assertEqual(len(changed_numbers(self.body)), 3)
        self.document.redo()
        self.document.recompute()
        self.assertEqual(changed_numbers(self.body), ())

    def test_nothing_to_set_back_is_no_step(self) -> None:
        steps = self.document.UndoCount
        self.assertEqual(set_back([self.body]), 0)
        self.assertEqual(self.document.UndoCount, steps)

    def test_a_number_that_is_gone_is_left_out(self) -> None:
        self.change("Height", 35.0)
        place = next(n for n, each in enumerate(self.sketch.Constraints) if each.Name == "Height")
        self.sketch.delConstraint(place)
        self.document.recompute()
        self.assertEqual(changed_numbers(self.body), ())

    def test_they_stay_in_a_document_that_is_saved(self) -> None:
        self.change("Height", 35.0)
        path = str(self.folder / "kept.FCStd")
        self.document.saveAs(path)
        self.close()
        self.document = FreeCAD.openDocument(path)
        (body,) = bodies_meant(self.document, ())
        self.assertEqual([each.path for each in changed_numbers(body)], ["Pad1.Height"])
        self.assertEqual(set_back([body]), 1)
        self.assertEqual(check_body(body.Shape, bracket()).words, "")
