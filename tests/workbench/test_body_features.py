"""Each kind of feature of a body makes what it should."""

from math import pi

import FreeCAD
import Part
from body_cases import XY, XZ, YZ, BodyCase, arc, box_of, cylinder, hole, lines, number, pad
from FreeCAD import Vector


class Kinds(BodyCase):
    def test_a_turned_part_with_a_groove(self) -> None:
        axis = {"point": [0.0, 0.0], "direction": [0.0, 1.0]}
        outline = {"plane": XZ, "geometry": lines((0, 0), (10, 0), (10, 30), (0, 30))}
        groove = {"plane": XZ, "geometry": lines((8, 12), (12, 12), (12, 16), (8, 16))}
        exact = cylinder(10, 30, (0, 0, 0)).cut(
            cylinder(12, 4, (0, 0, 12)).cut(cylinder(8, 4, (0, 0, 12)))
        )
        made = self.made(
            exact,
            {"kind": "revolution", "name": "Turned", "sketch": outline, "axis": axis},
            {"kind": "groove", "name": "Groove", "sketch": groove, "axis": axis},
        )
        self.assert_is(made, exact)

    def test_an_axis_goes_with_the_outline(self) -> None:
        axis = {"point": [0.0, 10.0], "direction": [1.0, 0.0]}
        numbers = [
            *({"kind": "coincident", "of": [[n, "end"], [(n + 1) % 4, "start"]]} for n in range(4)),
            *({"kind": "horizontal", "of": [[n, None]]} for n in (0, 2)),
            *({"kind": "vertical", "of": [[n, None]]} for n in (1, 3)),
            {"kind": "coincident", "of": [[-1, "start"], [0, "start"]]},
            number("distance-y", [[0, "start"], [2, "start"]], 10.0, "Height"),
            number("distance-x", [[0, "start"], [1, "start"]], 30.0, "Width"),
        ]
        outline = {"plane": XY, "geometry": lines((0, 0), (30, 0), (30, 10), (0, 10))}
        outline["constraints"] = numbers
        exact = cylinder(10, 30, (0, 10, 0), (1, 0, 0))
        made = self.made(
            exact, {"kind": "revolution", "name": "Turned", "sketch": outline, "axis": axis}
        )
        self.assert_is(made, exact)
        sketch = self.document.getObject("TurnedSketch")
        sketch.setDatum("Height", FreeCAD.Units.Quantity("12 mm"))
        self.document.recompute()
        self.assertAlmostEqual(made.body.Shape.Volume, 30 * pi * 144, places=3)

    def test_an_axis_beside_the_origin(self) -> None:
        axis = {"point": [5.0, 7.0], "direction": [-1.0, 0.0]}
        outline = {
            "plane": {**YZ, "offset": 3.0},
            "geometry": lines((0, 9), (4, 9), (4, 11), (0, 11)),
        }
        exact = cylinder(4, 4, (3, 0, 7), (0, 1, 0)).cut(cylinder(2, 4, (3, 0, 7), (0, 1, 0)))
        turned = {"kind": "revolution", "name": "Ring", "sketch": outline, "axis": axis}
        self.assert_is(self.made(exact, turned), exact)

    def test_holes_to_a_depth_both_ways(self) -> None:
        box = Part.makeBox(40, 30, 20)
        tip = 3.0
        for downward, bottom, along in ((True, 20, -1), (False, 0, 1)):
            for depth, degrees in ((8.0, 0.0), (8.0, 90.0)):
                with self.subTest(downward=downward, degrees=degrees):
                    drill = cylinder(3, 8, (10, 10, bottom), (0, 0, along))
                    if degrees:
                        at = Vector(10, 10, bottom + along * 8)
                        drill = drill.fuse(Part.makeCone(3, 0, tip, at, Vector(0, 0, along)))
                    exact = box.cut(drill)
                    plane = {**XY, "offset": float(bottom)}
                    drilled = hole(
                        plane, (10, 10), downward=downward, depth=depth, tip_degrees=degrees
                    )
                    self.assert_is(self.made(exact, *box_of(40, 30, 20), drilled), exact)

    def test_holes_with_wider_mouths(self) -> None:
        box, top = Part.makeBox(40, 30, 20), {**XY, "offset": 20.0}
        through = cylinder(3, 20, (10, 10, 0)).fuse(cylinder(3, 20, (30, 10, 0)))
        bored = box.cut(through).cut(cylinder(6, 5, (10, 10, 15))).cut(cylinder(6, 5, (30, 10, 15)))
        sink = {"diameter": 12.0, "depth": 5.0, "degrees": 0.0}
        made = self.made(bored, *box_of(40, 30, 20), hole(top, (10, 10), (30, 10), sink=sink))
        self.assert_is(made, bored)
        (feature,) = (each for each in made.body.Group if each.TypeId == "PartDesign::Hole")
        self.assertEqual(
            (feature.HoleCutType, len(feature.Profile[0].Geometry)), ("Counterbore", 2)
        )
        sunk = box.cut(through)
        for x in (10, 30):
            sunk = sunk.cut(Part.makeCone(6, 0, 6, Vector(x, 10, 20), Vector(0, 0, -1)))
        sink = {"diameter": 12.0, "depth": 0.0, "degrees": 90.0}
        made = self.made(sunk, *box_of(40, 30, 20), hole(top, (10, 10), (30, 10), sink=sink))
        self.assert_is(made, sunk)

    def test_broken_edges(self) -> None:
        box = Part.makeBox(40, 30, 20)
        for kind, dress in (("fillet", box.makeFillet), ("chamfer", box.makeChamfer)):
            upright = [edge for edge in box.Edges if edge.BoundBox.ZLength > 19][:2]
            exact = dress(4.0, upright)
            places = [list(edge.valueAt(edge.FirstParameter + 9.0)) for edge in upright]
            broken = {"kind": kind, "name": "Edges", "size": 4.0, "places": places}
            with self.subTest(kind):
                made = self.made(exact, *box_of(40, 30, 20), broken)
                self.assert_is(made, exact)
                self.assertEqual(len(made.body.Tip.Base[1]), 2)

    def test_the_seam_of_a_cylinder_is_no_edge(self) -> None:
        rod = cylinder(10, 30, (0, 0, 0))
        exact = rod.makeChamfer(
            1.0, [edge for edge in rod.Edges if edge.Closed and edge.BoundBox.ZMin > 29]
        )
        circle = {"kind": "circle", "centre": [0, 0], "radius": 10.0}
        broken = {"kind": "chamfer", "name": "Edges", "size": 1.0, "places": [[10.0, 0.0, 30.0]]}
        self.assert_is(self.made(exact, pad(XY, [circle], 30.0), broken), exact)

    def test_an_oblique_plane_and_arcs_both_ways(self) -> None:
        half = 0.5**0.5
        plane = {
            "name": None,
            "right": [0.0, 1.0, 0.0],
            "up": [-half, 0.0, half],
            "normal": [half, 0.0, half],
            "offset": 11.0,
        }
        outline = [
            {"kind": "line", "start": [0, 0], "end": [10, 0]},
            arc([10, 0], [10, 8], [10, 4], counterclockwise=True),
            {"kind": "line", "start": [10, 8], "end": [0, 8]},
            arc([0, 8], [0, 0], [0, 4], counterclockwise=False),
        ]
        exact = (
            Part.makeBox(10, 8, 6).fuse(cylinder(4, 6, (10, 4, 0))).cut(cylinder(4, 6, (0, 4, 0)))
        )
        exact = exact.removeSplitter().Solids[0]
        turn = FreeCAD.Rotation(*(Vector(*plane[name]) for name in ("right", "up", "normal")))
        exact.Placement = FreeCAD.Placement(Vector(*plane["normal"]) * 11.0, turn)
        compound = Part.makeCompound([exact])
        self.assert_is(self.made(compound, pad(plane, outline, 6.0)), exact)

    def test_features_over_a_base(self) -> None:
        ball = Part.makeSphere(20)
        ball.exportStep(str(self.folder / "base-1.step"))
        exact = ball.cut(cylinder(3, 60, (0, 0, -30)))
        made = self.made(exact, hole({**XY, "offset": 20.0}, (0, 0)), base="base-1.step")
        self.assert_is(made, exact)
        self.assertTrue(made.over_base)
        self.assertEqual(made.body.BaseFeature.TypeId, "Part::Feature")


class Numbers(BodyCase):
    """The numbers of features themselves, under the names of FreeCAD's properties."""

    def test_lengths_diameters_and_depths_say_where_they_are_from(self) -> None:
        exact = Part.makeBox(40, 30, 20).cut(cylinder(3, 20, (10, 10, 0)))
        exact = exact.cut(cylinder(6, 5, (10, 10, 15))).cut(cylinder(2, 8, (30, 20, 12)))
        (box,) = box_of(40, 30, 20)
        top = {**XY, "offset": 20.0}
        sink = {"diameter": 12.0, "depth": 5.0, "degrees": 0.0}
        sink["sources"] = {"diameter": "sheet", "depth": "measured"}
        made = self.made(
            exact,
            {**box, "length": 20.0, "sources": {"length": "sheet"}},
            hole(top, (10, 10), sink=sink, sources={"diameter": "sheet"}),
            hole(
                top,
                (30, 20),
                name="Hole2",
                diameter=4.0,
                depth=8.0,
                sources={"diameter": "measured", "depth": "sheet"},
            ),
        )
        self.assert_is(made, exact)
        self.assertEqual(
            made.from_sheet,
            (
                "Pad1.Length = 20 mm",
                "Hole1.Diameter = 6 mm",
                "Hole1.HoleCutDiameter = 12 mm",
                "Hole2.Depth = 8 mm",
            ),
        )
        self.assertEqual(made.measured, ("Hole1.HoleCutDepth = 5 mm", "Hole2.Diameter = 4 mm"))
        for line in (*made.from_sheet, *made.measured):
            path, value = line.split(" = ")
            name, number = path.split(".")
            found = getattr(self.document.getObject(name), number)
            self.assertAlmostEqual(found.Value, float(value.removesuffix(" mm")))

    def test_an_angle_makes_a_countersink_and_its_depth_of_zero_is_no_number(self) -> None:
        exact = Part.makeBox(40, 30, 20).cut(cylinder(3, 20, (10, 10, 0)))
        exact = exact.cut(Part.makeCone(6, 0, 6, Vector(10, 10, 20), Vector(0, 0, -1)))
        sink = {"diameter": 12.0, "depth": 0.0, "degrees": 90.0}
        sink["sources"] = {"diameter": "measured", "depth": "measured"}
        drilled = hole({**XY, "offset": 20.0}, (10, 10), sink=sink)
        made = self.made(exact, *box_of(40, 30, 20), drilled)
        self.assertEqual((made.from_sheet, made.measured), ((), ("Hole1.HoleCutDiameter = 12 mm",)))

    def test_sizes_of_broken_edges(self) -> None:
        box = Part.makeBox(40, 30, 20)
        for kind, dress, name in (
            ("fillet", box.makeFillet, "Radius"),
            ("chamfer", box.makeChamfer, "Size"),
        ):
            exact = dress(4.0, [edge for edge in box.Edges if edge.BoundBox.ZLength > 19][:1])
            broken = {
                "kind": kind,
                "name": f"Edges{kind}",
                "size": 4.0,
                "places": [[0.0, 0.0, 9.0]],
            }
            with self.subTest(kind):
                made = self.made(
                    exact, *box_of(40, 30, 20), {**broken, "sources": {"size": "sheet"}}
                )
                self.assertEqual(made.from_sheet, (f"Edges{kind}.{name} = 4 mm",))
