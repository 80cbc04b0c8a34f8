"""Bodies from ``features.json``: that they are the solid, can be edited, and leave nothing else."""

import json
from math import pi
from pathlib import Path
from typing import Any

import FreeCAD
import Part
from FreeCAD import Vector
from support import FAKE_ENGINE, FolderCase

from freecad.gaussiancad.engine.features_job import FeaturesJob
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.bodies import MadeBody, add_bodies
from freecad.gaussiancad.objects.body_check import _difference, check_body
from freecad.gaussiancad.objects.feature_file import read_features
from freecad.gaussiancad.objects.smooth_faces import count_faces, have_same_faces
from freecad.gaussiancad.objects.solid_parts import solid_among
from freecad.gaussiancad.remodelling import remodel

DATA = Path(__file__).parent / "data" / "features"

XY = {"name": "XY", "right": [1, 0, 0], "up": [0, 1, 0], "normal": [0, 0, 1], "offset": 0.0}
XZ = {"name": "XZ", "right": [1, 0, 0], "up": [0, 0, 1], "normal": [0, -1, 0], "offset": 0.0}
YZ = {"name": "YZ", "right": [0, 1, 0], "up": [0, 0, 1], "normal": [1, 0, 0], "offset": 0.0}


def lines(*points: tuple[float, float]) -> list[dict[str, Any]]:
    """A closed outline."""
    ends = zip(points, (*points[1:], points[0]), strict=True)
    return [{"kind": "line", "start": list(a), "end": list(b)} for a, b in ends]


def box_of(x: float, y: float, z: float) -> list[dict[str, Any]]:
    """The pad that makes a box at the origin."""
    return [pad(XY, lines((0, 0), (x, 0), (x, y), (0, y)), z)]


def pad(plane: dict[str, Any], geometry: list, length: float, **more: object) -> dict[str, Any]:
    """A pad, or what ``kind`` says."""
    sketch = {"plane": plane, "geometry": geometry, "constraints": more.pop("constraints", None)}
    return {"kind": "pad", "name": "Pad1", "sketch": sketch, "length": length, **more}


def hole(plane: dict[str, Any], *centres: tuple[float, float], **more: object) -> dict[str, Any]:
    """Holes of 6 mm through all, against the normal, or as asked."""
    return {
        "kind": "hole",
        "name": "Hole1",
        "plane": plane,
        "centres": [list(centre) for centre in centres],
        "downward": True,
        "diameter": 6.0,
        "depth": None,
        "tip_degrees": 0.0,
        "sink": None,
        **more,
    }


def cylinder(radius: float, height: float, at: tuple, along: tuple = (0, 0, 1)) -> Part.Shape:
    """A cylinder as a shape."""
    return Part.makeCylinder(radius, height, Vector(*at), Vector(*along))


def prism(plane_points: list[tuple[float, float, float]], along: tuple) -> Part.Shape:
    """A polygon moved along a vector."""
    points = [Vector(*point) for point in (*plane_points, plane_points[0])]
    return Part.Face(Part.makePolygon(points)).extrude(Vector(*along))


def l_bracket() -> Part.Shape:
    profile = [(0, 0, 0), (80, 0, 0), (80, 0, 12), (14, 0, 12), (14, 0, 60), (0, 0, 60)]
    made = prism(profile, (0, 50, 0)).cut(cylinder(10, 20, (52, 25, -4)))
    return made.cut(cylinder(7, 20, (-4, 25, 40), (1, 0, 0)))


def boss_plate() -> Part.Shape:
    made = Part.makeBox(80, 60, 12).fuse(cylinder(18, 40, (34, 30, 0))).removeSplitter()
    for x, y, radius in ((34, 30, 9), (68, 12, 5), (68, 48, 5)):
        made = made.cut(cylinder(radius, 50, (x, y, -5)))
    return made


def wedge_block() -> Part.Shape:
    profile = [(0, 0, 0), (90, 0, 0), (90, 0, 14), (40, 0, 48), (0, 0, 48)]
    slot = Part.makeBox(20, 16, 40, Vector(10, 14, 20))
    return prism(profile, (0, 44, 0)).cut(slot)


SAMPLES = {"l-bracket": l_bracket, "boss-plate": boss_plate, "wedge-block": wedge_block}


class BodyCase(FolderCase):
    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Bodies")
        self.addCleanup(self.close)

    def close(self) -> None:
        FreeCAD.closeDocument(self.document.Name)

    def part(self, shape: Part.Shape) -> FreeCAD.DocumentObject:
        part = self.document.addObject("Part::Feature", "Part")
        part.Shape = shape
        self.document.recompute()
        return part

    def written(self, features: list[dict[str, Any]], base: str | None = None) -> Path:
        path = self.folder / "features.json"
        solid = {"whole": base is None, "base": base, "features": features}
        values = {"schema": "gaussiancad-features/1", "solids": [solid]}
        path.write_text(json.dumps(values), encoding="utf-8")
        return path

    def made(
        self, shape: Part.Shape, *features: dict[str, Any], base: str | None = None
    ) -> MadeBody:
        """The body of features that make the shape."""
        (made,) = add_bodies(self.part(shape), read_features(self.written(list(features), base)))
        return made

    def sample(self, name: str) -> MadeBody:
        (made,) = add_bodies(self.part(SAMPLES[name]()), read_features(DATA / f"{name}.json"))
        return made

    def assert_is(self, made: MadeBody, shape: Part.Shape) -> None:
        self.assertEqual(check_body(made.body.Shape, shape).words, "")
        self.assertAlmostEqual(made.body.Shape.Volume / shape.Volume, 1.0, places=6)


class Samples(BodyCase):
    def test_each_is_its_solid_with_the_features_of_the_file(self) -> None:
        for name, exact in SAMPLES.items():
            with self.subTest(name):
                made = self.sample(name)
                self.assert_is(made, exact())
                written = json.loads((DATA / f"{name}.json").read_text())["solids"][0]["features"]
                features = [
                    each for each in made.body.Group if each.TypeId.startswith("PartDesign")
                ]
                self.assertEqual(
                    [each.Label for each in features], [each["name"] for each in written]
                )
                self.assertEqual(made.features, len(written))
                self.assertEqual((made.from_sheet, made.measured), ((), ()))
                self.assertEqual(
                    [each.Visibility for each in features[:-1]], [False] * (len(written) - 1)
                )
                self.assertFalse(self.document.getObject("Part").Visibility)
                self.close()
                self.document = FreeCAD.newDocument("Bodies")

    def test_sketches_are_hidden_and_stand_on_the_origin(self) -> None:
        body = self.sample("l-bracket").body
        sketches = [each for each in body.Group if each.TypeId == "Sketcher::SketchObject"]
        self.assertEqual(len(sketches), 3)
        for sketch in sketches:
            self.assertFalse(sketch.Visibility)
            self.assertEqual(sketch.solve(), 0)
            name = "AttachmentSupport" if hasattr(sketch, "AttachmentSupport") else "Support"
            ((plane, _),) = getattr(sketch, name)
            self.assertIn(plane, body.Origin.OriginFeatures)

    def test_one_step_is_undone_and_done_again(self) -> None:
        part = self.part(l_bracket())
        self.document.UndoMode = 1
        add_bodies(part, read_features(DATA / "l-bracket.json"))
        self.assertEqual(self.document.UndoNames, ["To Body"])
        self.document.undo()
        self.assertEqual([each.Name for each in self.document.Objects], ["Part"])
        self.assertTrue(part.Visibility)
        self.document.redo()
        self.document.recompute()
        body = next(each for each in self.document.Objects if each.TypeId == "PartDesign::Body")
        self.assertEqual(check_body(body.Shape, l_bracket()).words, "")

    def test_a_document_that_is_saved_and_opened_again_keeps_it(self) -> None:
        label = self.sample("boss-plate").body.Label
        path = str(self.folder / "kept.FCStd")
        self.document.saveAs(path)
        self.close()
        self.document = FreeCAD.openDocument(path)
        (body,) = (each for each in self.document.Objects if each.Label == label)
        self.assertEqual(check_body(body.Shape, boss_plate()).words, "")
        for each in body.Group:
            each.touch()
        self.document.recompute()
        self.assertEqual(check_body(body.Shape, boss_plate()).words, "")


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
            _arc([10, 0], [10, 8], [10, 4], counterclockwise=True),
            {"kind": "line", "start": [10, 8], "end": [0, 8]},
            _arc([0, 8], [0, 0], [0, 4], counterclockwise=False),
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


class Conditions(BodyCase):
    def bracket(self) -> MadeBody:
        (made,) = add_bodies(self.part(bracket()), read_features(DATA / "bracket.json"))
        return made

    def test_numbers_have_names_and_drive_the_body(self) -> None:
        made = self.bracket()
        sketch = self.document.getObject("Pad1Sketch")
        self.assertTrue(getattr(sketch, "FullyConstrained", True))
        self.assertEqual(len(made.from_sheet), 3)
        self.assertEqual(made.measured, ("Pad1.WallThickness = 15 mm",))
        self.assertEqual(made.body.NumbersMeasured, ["Pad1.WallThickness = 15 mm"])
        names = {"Length": 60.0, "BaseThickness": 10.0, "WallThickness": 15.0, "Height": 30.0}
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
        self.assertEqual(len(made.from_sheet) + len(made.measured), 4)
        self.assertEqual(self.document.getObject("Pad1Sketch").solve(), 0)

    def test_a_number_that_is_another_than_drawn_is_left_out(self) -> None:
        values = json.loads((DATA / "bracket.json").read_text())
        (feature,) = values["solids"][0]["features"]
        (wrong,) = (
            each for each in feature["sketch"]["constraints"] if each.get("name") == "BaseThickness"
        )
        wrong["value"] = 10.01
        made = self.made(bracket(), feature)
        self.assertEqual(made.from_sheet, ("Pad1.Length = 60 mm", "Pad1.Height = 30 mm"))
        self.assert_is(made, bracket())

    def test_contours_with_arcs_equal_circles_and_axes(self) -> None:
        geometry = [
            {"kind": "line", "start": [0, 0], "end": [20, 0]},
            _arc([20, 0], [20, 10], [20, 5], counterclockwise=True),
            {"kind": "line", "start": [20, 10], "end": [0, 10]},
            _arc([0, 10], [0, 0], [0, 5], counterclockwise=True),
        ]
        conditions = [
            *({"kind": "tangent", "of": [[n, "end"], [(n + 1) % 4, "start"]]} for n in range(4)),
            {"kind": "horizontal", "of": [[0, None]]},
            {"kind": "point-on-x-axis", "of": [[0, "start"]]},
            {"kind": "point-on-y-axis", "of": [[0, "start"]]},
            _number("distance-x", [[1, "centre"], [3, "centre"]], 20.0, "Between"),
            {"kind": "equal", "of": [[1, None], [3, None]]},
            _number("radius", [[3, None]], 5.0, "Radius"),
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
            _number("diameter", [[0, None]], 6.0, "Diameter"),
            _number("distance-x", [[-1, "start"], [0, "centre"]], 10.0, "FromLeft"),
            _number("distance-y", [[-1, "start"], [0, "centre"]], 10.0, "FromFront"),
            _number("distance-x", [[0, "centre"], [1, "centre"]], 20.0, "Pitch", "measured"),
        ]
        drilled = hole({**XY, "offset": 20.0}, (10, 10), (30, 10), constraints=conditions)
        made = self.made(exact, *box_of(40, 30, 20), drilled)
        self.assertEqual((len(made.from_sheet), len(made.measured)), (3, 1))
        self.document.getObject("Hole1Sketch").setDatum("Pitch", FreeCAD.Units.Quantity("15 mm"))
        self.document.recompute()
        self.document.getObject("Hole1Sketch").setDatum("Diameter", FreeCAD.Units.Quantity("8 mm"))
        self.document.recompute()
        mouths = [each for each in made.body.Shape.Edges if each.Closed]
        self.assertEqual({round(each.Curve.Radius, 6) for each in mouths}, {4.0})
        self.assertEqual({round(each.Curve.Center.x, 6) for each in mouths}, {10.0, 25.0})


class Broken(BodyCase):
    def assert_none(self, *features: dict[str, Any]) -> str:
        part = self.part(Part.makeBox(40, 30, 20))
        self.document.UndoMode = 1
        before = [each.Name for each in self.document.Objects]
        steps = self.document.UndoCount
        with self.assertRaises(WorkbenchError) as caught:
            add_bodies(part, read_features(self.written(list(features))))
        self.assertIs(caught.exception.code, ErrorCode.NO_BODY)
        self.assertEqual([each.Name for each in self.document.Objects], before)
        self.assertEqual(self.document.UndoCount, steps)
        self.assertTrue(part.Visibility)
        return caught.exception.message

    def test_a_feature_that_fails_leaves_nothing(self) -> None:
        box = box_of(40, 30, 20)
        opened = pad(XY, lines((0, 0), (9, 0), (9, 9))[:2], 5.0, name="Open")
        self.assertIn("Open", self.assert_none(*box, opened))
        fillet = {"kind": "fillet", "name": "Wide", "size": 90.0, "places": [[0.0, 0.0, 9.0]]}
        self.assertIn("Wide", self.assert_none(*box, fillet))
        unknown = [{"kind": "woven", "of": [[0, None]]}]
        odd = pad(XY, lines((0, 0), (9, 0), (9, 9)), 5.0, name="Odd", constraints=unknown)
        self.assertIn("woven", self.assert_none(*box, odd))

    def test_a_body_that_is_another_solid_leaves_nothing(self) -> None:
        self.assertIn("%", self.assert_none(*box_of(40, 30, 19.9)))
        away = pad(XY, lines((90, 0), (95, 0), (95, 5)), 5.0, name="Away")
        self.assert_none(*box_of(40, 30, 20), away)

    def test_a_solid_without_features(self) -> None:
        self.assertIn("no features", self.assert_none())

    def test_another_number_of_solids(self) -> None:
        two = Part.makeCompound([Part.makeBox(1, 1, 1), Part.makeBox(1, 1, 1, Vector(5, 0, 0))])
        with self.assertRaises(WorkbenchError):
            add_bodies(self.part(two), read_features(self.written(box_of(1, 1, 1))))

    def test_files_that_cannot_be_read(self) -> None:
        path = self.folder / "features.json"
        with self.assertRaises(WorkbenchError):
            read_features(path)
        for text in (
            "[]",
            "{",
            '{"schema": "other", "solids": []}',
            '{"schema": "gaussiancad-features/1", "solids": []}',
            '{"schema": "gaussiancad-features/1", "solids": [{}]}',
            '{"schema": "gaussiancad-features/1", "solids": [{"features": [{"kind": "loft"}]}]}',
        ):
            path.write_text(text)
            with self.subTest(text), self.assertRaises(WorkbenchError) as caught:
                read_features(path)
            self.assertIs(caught.exception.code, ErrorCode.RESULT_UNREADABLE)


class Faces(FolderCase):
    def test_halves_of_one_surface_count_once(self) -> None:
        for shape, count in (
            (Part.makeCone(5, 2, 8), 3),
            (Part.makeCylinder(5, 8), 3),
            (Part.makeSphere(5), 1),
            (Part.makeTorus(9, 2), 1),
            (Part.makeBox(2, 3, 4, Vector(-1, -1, -1)), 6),
        ):
            halved = [shape.common(Part.makeBox(40, 40, 40, Vector(-20, y, -20))) for y in (-40, 0)]
            both = halved[0].fuse(halved[1])
            self.assertGreater(len(both.Faces), count)
            self.assertEqual(count_faces(shape), count)
            self.assertEqual(count_faces(both), count)
            self.assertTrue(have_same_faces(both, shape))
            moved = shape.copy()
            moved.translate(Vector(0, 0, 0.01))
            self.assertFalse(have_same_faces(both, moved))


class Check(FolderCase):
    def test_solids_that_cannot_be_cut_are_one_where_all_faces_are(self) -> None:
        class Uncut:
            """A solid that the kernel makes nothing of."""

            def __init__(self, shape: Part.Shape) -> None:
                self.Volume, self.Faces = shape.Volume, shape.Faces

            def cut(self, other: object) -> Part.Shape:
                return other

        box, other = Part.makeBox(2, 3, 4), Part.makeBox(2, 4, 3)
        self.assertEqual(_difference(Uncut(box), Uncut(box)), 0.0)
        self.assertGreater(_difference(Uncut(box), Uncut(other)), 0.0)
        self.assertAlmostEqual(_difference(box, other), 12.0)


class WithEngine(BodyCase):
    def setUp(self) -> None:
        super().setUp()
        self.set_variable("GAUSSIANCAD_PYTHON", FAKE_ENGINE.python)

    def test_a_part_becomes_a_body_where_it_is(self) -> None:
        part = self.part(bracket())
        part.Placement = FreeCAD.Placement(Vector(7, 8, 9), FreeCAD.Rotation(10, 20, 30))
        (made,) = remodel(part)
        for corner in part.Shape.Vertexes:
            self.assertLess(made.body.Shape.distToShape(corner)[0], 1e-6)
        self.assertEqual(check_body(made.body.Shape, part.Shape).words, "")
        self.assertEqual((part.Visibility, made.features), (False, 1))

    def test_another_solid_and_no_engine_leave_the_document_alone(self) -> None:
        part = self.part(bracket())
        self.behave("differs")
        with self.assertRaises(WorkbenchError):
            remodel(part)
        self.set_variable("GAUSSIANCAD_PYTHON", str(self.folder / "none"))
        with self.assertRaises(WorkbenchError):
            remodel(part)
        self.assertEqual([each.Name for each in self.document.Objects], ["Part"])

    def test_what_can_become_one(self) -> None:
        part = self.part(bracket())
        mesh = self.document.addObject("Mesh::Feature", "Mesh")
        empty = self.document.addObject("Part::Feature", "Empty")
        self.assertIs(solid_among([mesh, empty, part]), part)
        self.assertIsNone(solid_among([mesh, empty]))
        (made,) = remodel(part)
        self.assertIsNone(solid_among([made.body.Tip]))
        self.assertIs(solid_among([made.body]), made.body)
        self.assertEqual(FeaturesJob("a", "b").arguments(), ["features", "a", "--output", "b"])


def bracket() -> Part.Shape:
    """What the fake engine knows the features of."""
    return prism(
        [(0, 0, 0), (60, 0, 0), (60, 0, 10), (15, 0, 10), (15, 0, 30), (0, 0, 30)], (0, 40, 0)
    )


def _arc(start: list, end: list, centre: list, counterclockwise: bool) -> dict[str, Any]:
    radius = ((start[0] - centre[0]) ** 2 + (start[1] - centre[1]) ** 2) ** 0.5
    ends = {"start": start, "end": end, "centre": centre}
    return {"kind": "arc", **ends, "radius": radius, "counterclockwise": counterclockwise}


def _number(kind: str, of: list, value: float, name: str, source: str = "sheet") -> dict[str, Any]:
    return {"kind": kind, "of": of, "value": value, "name": name, "source": source}
