"""The numbers of a body's sketches: named, driving, and left out where they cannot hold."""

import json
from math import pi

import FreeCAD
import Part
from body_cases import DATA, XY, BodyCase, arc, box_of, bracket, cylinder, hole, number, pad

from freecad.gaussiancad.objects.bodies import MadeBody, add_bodies
from freecad.gaussiancad.objects.feature_file import read_features


class Conditions(BodyCase):
    def bracket(self) -> MadeBody:
        (made,) = add_bodies(self.part(bracket()), read_features(DATA / "bracket.json"))
        return made

    def test_numbers_have_names_and_drive_the_body(self) -> None:
        made = self.bracket()
        sketch = self.document.getObject("Pad1Sketch")
        self.assertTrue(getattr(sketch, "FullyConstrained", True))
        self.assertEqual(len(made.from_sheet), 3)
        measured = ["Pad1.WallThickness = 15 mm", "Pad1.Length = 40 mm"]
        self.assertEqual(made.measured, tuple(measured))
        self.assertEqual(made.body.NumbersMeasured, measured)
        names = {"Width": 60.0, "BaseThickness": 10.0, "WallThickness": 15.0, "Height": 30.0}
        self.assertEqual({name: sketch.getDatum(name).Value for name in names}, names)
        sketch.setDatum("Height", FreeCAD.Units.Quantity("50 mm"))
        self.document.recompute()
        self.assertAlmostEqual(made.body.Shape.Volume, (60 * 10 + 15 * 40) * 40.0, places=4)

    def test_what_says_nothing_new_is_left_out(self) -> None:
        values = json.loads((DATA / "bracket.json").read_text())
        (feature,) = values["solids"][0]["features"]
        again = {"kind": "distance-x", "of": [[2, None]], "value": 45.0, "name": "Rest"}
        feature["sketch"]["constraints"].append({**again, "source": "sheet"})
        made = self.made(bracket(), feature)
        self.assertEqual(len(made.from_sheet) + len(made.measured), 5)
        self.assertEqual(self.document.getObject("Pad1Sketch").solve(), 0)

    def test_a_number_that_is_another_than_drawn_is_left_out(self) -> None:
        values = json.loads((DATA / "bracket.json").read_text())
        (feature,) = values["solids"][0]["features"]
        (wrong,) = (
            each for each in feature["sketch"]["constraints"] if each.get("name") == "BaseThickness"
        )
        wrong["value"] = 10.01
        made = self.made(bracket(), feature)
        self.assertEqual(made.from_sheet, ("Pad1.Width = 60 mm", "Pad1.Height = 30 mm"))
        self.assert_is(made, bracket())

    def test_contours_with_arcs_equal_circles_and_axes(self) -> None:
        geometry = [
            {"kind": "line", "start": [0, 0], "end": [20, 0]},
            arc([20, 0], [20, 10], [20, 5], counterclockwise=True),
            {"kind": "line", "start": [20, 10], "end": [0, 10]},
            arc([0, 10], [0, 0], [0, 5], counterclockwise=True),
        ]
        conditions = [
            *({"kind": "tangent", "of": [[n, "end"], [(n + 1) % 4, "start"]]} for n in range(4)),
            {"kind": "horizontal", "of": [[0, None]]},
            {"kind": "point-on-x-axis", "of": [[0, "start"]]},
            {"kind": "point-on-y-axis", "of": [[0, "start"]]},
            number("distance-x", [[1, "centre"], [3, "centre"]], 20.0, "Between"),
            {"kind": "equal", "of": [[1, None], [3, None]]},
            number("radius", [[3, None]], 5.0, "Radius"),
        ]
        exact = (
            Part.makeBox(20, 10, 6).fuse(cylinder(5, 6, (0, 5, 0))).fuse(cylinder(5, 6, (20, 5, 0)))
        )
        exact = exact.removeSplitter()
        made = self.made(exact, pad(XY, geometry, 6.0, constraints=conditions))
        self.assert_is(made, exact)
        self.assertEqual(made.from_sheet, ("Pad1.Between = 20 mm", "Pad1.Radius = 5 mm"))
        sketch = self.document.getObject("Pad1Sketch")
        sketch.setDatum("Between", FreeCAD.Units.Quantity("30 mm"))
        self.document.recompute()
        self.assertAlmostEqual(made.body.Shape.Volume, (300 + 25 * pi) * 6, places=3)

    def test_holes_have_conditions_between_their_circles(self) -> None:
        exact = Part.makeBox(40, 30, 20)
        for x in (10, 30):
            exact = exact.cut(cylinder(3, 20, (x, 10, 0)))
        conditions = [
            {"kind": "equal", "of": [[0, None], [1, None]]},
            {"kind": "horizontal", "of": [[0, "centre"], [1, "centre"]]},
            number("diameter", [[0, None]], 6.0, "Diameter"),
            number("distance-x", [[-1, "start"], [0, "centre"]], 10.0, "FromLeft"),
            number("distance-y", [[-1, "start"], [0, "centre"]], 10.0, "FromFront"),
            number("distance-x", [[0, "centre"], [1, "centre"]], 20.0, "Pitch", "measured"),
        ]
        drilled = hole({**XY, "offset": 20.0}, (10, 10), (30, 10), constraints=conditions)
        # It stands in the sketch already, and counts once.
        drilled["sources"] = {"diameter": "sheet"}
        made = self.made(exact, *box_of(40, 30, 20), drilled)
        self.assertEqual((len(made.from_sheet), len(made.measured)), (3, 1))
        self.document.getObject("Hole1Sketch").setDatum("Pitch", FreeCAD.Units.Quantity("15 mm"))
        self.document.recompute()
        self.document.getObject("Hole1Sketch").setDatum("Diameter", FreeCAD.Units.Quantity("8 mm"))
        self.document.recompute()
        mouths = [each for each in made.body.Shape.Edges if each.Closed]
        self.assertEqual({round(each.Curve.Radius, 6) for each in mouths}, {4.0})
        self.assertEqual({round(each.Curve.Center.x, 6) for each in mouths}, {10.0, 25.0})
