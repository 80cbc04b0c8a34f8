"""Bodies from ``features.json``: that they are the solid, and leave nothing else."""

import json
from typing import Any

import FreeCAD
import Part
from body_cases import DATA, XY, BodyCase, box_of, bracket, cylinder, lines, pad, prism
from FreeCAD import Vector
from support import FAKE_ENGINE

from freecad.gaussiancad.engine.features_job import FeaturesJob
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.bodies import MadeBody, add_bodies
from freecad.gaussiancad.objects.body_check import check_body
from freecad.gaussiancad.objects.feature_file import read_features
from freecad.gaussiancad.objects.solid_parts import solid_among, write_solid
from freecad.gaussiancad.remodelling import remodel


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


class Samples(BodyCase):
    def sample(self, name: str) -> MadeBody:
        (made,) = add_bodies(self.part(SAMPLES[name]()), read_features(DATA / f"{name}.json"))
        return made

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

    def test_the_report_of_a_reconstruction_goes_with_its_solid(self) -> None:
        part = self.part(bracket())
        write_solid(part, self.folder)
        self.assertEqual([each.name for each in self.folder.iterdir()], ["solid.step"])
        group = self.document.addObject("App::DocumentObjectGroup", "Reconstruction")
        group.addProperty("App::PropertyString", "ReportJson")
        group.ReportJson = '{"dimensions": []}'
        group.addObject(part)
        write_solid(part, self.folder)
        self.assertEqual((self.folder / "report.json").read_text(), group.ReportJson)

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
