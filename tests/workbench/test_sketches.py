"""The cleaned lines of a reading as sketches: planes, arcs, construction, size, undo."""

import hashlib
import json
from itertools import pairwise
from math import cos, pi, radians, sin
from pathlib import Path
from typing import Any

import FreeCAD
from fake_part import SIZE
from support import FAKE_ENGINE, FolderCase, draw_sheet

from freecad.gaussiancad.engine.read_job import ReadJob
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.cleaned_lines import read_cleaned
from freecad.gaussiancad.objects.corrected_sheet import kept_corrections, open_in
from freecad.gaussiancad.objects.meeting_ends import meeting_ends
from freecad.gaussiancad.objects.sketches import add_sketches
from freecad.gaussiancad.sketching import sketch_drawing

READING = Path(__file__).parent / "data" / "reading.json"

Values = dict[str, Any]

BOX = [100, 100, 340, 220]
"""A view of 240 x 120 px."""


def rectangle(view: str, box: list[float]) -> list[Values]:
    """A view's outline, and a line from its lower left corner half way up to its right side."""
    x0, y0, x1, y1 = box
    corners = [(x0, y1), (x1, y1), (x1, y0), (x0, y0), (x0, y1)]
    lines = [*pairwise(corners), ((x0, y1), (x1, (y0 + y1) / 2))]
    return [
        {"id": f"{view}-{n}", "view": view, "kind": "visible", "line": line}
        for n, line in enumerate(lines)
    ]


class Sketches(FolderCase):
    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Sketches")
        self.addCleanup(FreeCAD.closeDocument, "Sketches")
        self.values: Values = json.loads(READING.read_text(encoding="utf-8"))

    def written(self) -> Path:
        path = self.folder / "reading.json"
        path.write_text(json.dumps(self.values), encoding="utf-8")
        return path

    def made(self) -> dict[str, FreeCAD.DocumentObject]:
        """The sketches of the values, by label."""
        group = add_sketches(self.document, self.written(), "part 图")
        self.assertEqual((group.TypeId, group.Label), ("App::DocumentObjectGroup", "part 图"))
        return {item.Label: item for item in group.Group}

    def shows(self, *views: Values) -> None:
        """Let the sheet have these views, each a rectangle with a slanted line."""
        self.values["views"] = [*views]
        self.values["strokes"] = [
            stroke for view in views for stroke in rectangle(view["id"], view["box"])
        ]

    def assert_near(self, found: FreeCAD.Vector, expected: tuple[float, ...]) -> None:
        self.assertLess((found - FreeCAD.Vector(*expected)).Length, 1e-6, (found, expected))

    def test_views_stand_on_the_origins_planes_and_share_their_axes(self) -> None:
        made = self.made()
        self.assertEqual([*made], ["Lines front", "Lines top", "Lines right"])
        x, y, z = SIZE
        boxes = {
            "Lines front": (0, 0, 0, x, 0, z),
            "Lines top": (0, 0, 0, x, y, 0),
            "Lines right": (0, 0, 0, 0, y, z),
        }
        for name, (x0, y0, z0, x1, y1, z1) in boxes.items():
            box = made[name].Shape.BoundBox
            self.assert_near(FreeCAD.Vector(box.XMin, box.YMin, box.ZMin), (x0, y0, z0))
            self.assert_near(FreeCAD.Vector(box.XMax, box.YMax, box.ZMax), (x1, y1, z1))
        step = next(
            edge for edge in made["Lines front"].Shape.Edges if abs(edge.Length - 45.0) < 1e-6
        )
        self.assertEqual({round(vertex.Z, 6) for vertex in step.Vertexes}, {10.0})
        self.assertEqual({round(vertex.X, 6) for vertex in step.Vertexes}, {15.0, 60.0})

    def test_each_role_has_its_plane_and_its_right_and_up(self) -> None:
        """The slanted line runs from the corner that is lower left to the eye."""
        self.values["scale"] = {"source": "given", "mm_per_px": 0.5}
        x, y = 120.0, 60.0
        slanted = {
            "front": ((0, 0, 0), (x, 0, y / 2)),
            "top": ((0, 0, 0), (x, y / 2, 0)),
            "right": ((0, 0, 0), (0, x, y / 2)),
            "left": ((0, x, 0), (0, 0, y / 2)),
            "bottom": ((0, y, 0), (x, y / 2, 0)),
            "rear": ((x, 0, 0), (0, 0, y / 2)),
        }
        for role, (start, end) in slanted.items():
            with self.subTest(role):
                self.shows({"id": "v", "role": role, "box": BOX})
                (sketch,) = self.made().values()
                line = max(sketch.Geometry, key=lambda item: item.length())
                place = sketch.Placement
                self.assert_near(place.multVec(line.StartPoint), start)
                self.assert_near(place.multVec(line.EndPoint), end)
                FreeCAD.closeDocument("Sketches")
                self.document = FreeCAD.newDocument("Sketches")

    def test_of_opposite_views_one_stands_at_the_far_end(self) -> None:
        self.values["scale"] = {"source": "given", "mm_per_px": 0.5}
        roles = ("front", "top", "right", "left", "bottom", "rear")
        self.shows(*({"id": role, "role": role, "box": [0, 0, 200, 200]} for role in roles))
        bases = {name: tuple(item.Placement.Base) for name, item in self.made().items()}
        self.assertEqual(bases["Lines front"], (0, 0, 0))
        self.assertEqual(bases["Lines left"], (0, 0, 0))
        self.assertEqual(bases["Lines bottom"], (0, 0, 0))
        self.assertEqual(bases["Lines rear"], (0, 100, 0))
        self.assertEqual(bases["Lines right"], (100, 0, 0))
        self.assertEqual(bases["Lines top"], (0, 0, 100))

    def test_sections_lie_where_they_look_and_others_beside(self) -> None:
        self.values["scale"] = {"source": "given", "mm_per_px": 0.5}
        self.shows(
            {"id": "s1", "role": "section", "box": [600, 100, 800, 220], "looks": "right"},
            {"id": "s2", "role": "section", "box": [600, 400, 700, 500], "used": False},
            {"id": "s3", "role": "section", "box": [600, 800, 700, 900]},
            {"id": "front", "role": "front", "box": BOX},
            {"id": "top", "role": "top", "box": BOX, "used": False},
            {"id": "detail", "role": "detail", "box": BOX},
        )
        self.values["strokes"] = [item for item in self.values["strokes"] if item["view"] != "s3"]
        self.values["sections"] = [{"label": "A", "box": [590, 90, 810, 230]}]
        made = self.made()
        self.assertEqual([*made], ["Lines front", "Lines section A", "Lines section"])
        box = made["Lines section A"].Shape.BoundBox
        self.assertEqual([round(v, 6) for v in (box.XMax, box.YMax, box.ZMax)], [0, 100, 60])
        box = made["Lines section"].Shape.BoundBox
        self.assertGreater(box.XMin, 120.0)
        self.assertEqual([round(v, 6) for v in (box.XLength, box.YLength, box.ZMin)], [50, 0, 0])
        self.assertTrue(any("section" in doubt for doubt in read_cleaned(self.written()).doubts))

    def test_arcs_run_the_same_way_to_the_eye(self) -> None:
        geometry = self.made()["Lines top"].Geometry
        (arc,) = (item for item in geometry if item.TypeId == "Part::GeomArcOfCircle")
        self.assert_near(arc.Center, (50, 30, 0))
        self.assertAlmostEqual(arc.Radius, 10.0)
        # From above the centre to the right of it, which is against the clock from right to up.
        self.assert_near(arc.StartPoint, (60, 30, 0))
        self.assert_near(arc.EndPoint, (50, 40, 0))
        self.assertAlmostEqual(arc.length(), 5.0 * pi, places=5)
        (circle,) = (item for item in geometry if item.TypeId == "Part::GeomCircle")
        self.assert_near(circle.Center, (35, 20, 0))
        self.assertAlmostEqual(circle.Radius, 5.0)

    def test_ellipses_stay_ellipses_and_turn_with_the_flip(self) -> None:
        geometry = self.made()["Lines top"].Geometry
        (whole,) = (item for item in geometry if item.TypeId == "Part::GeomEllipse")
        self.assert_near(whole.Center, (10, 20, 0))
        self.assertAlmostEqual(whole.MajorRadius, 7.5)
        self.assertAlmostEqual(whole.MinorRadius, 2.5)
        far = FreeCAD.Vector(10 + 7.5 * cos(-0.5), 20 + 7.5 * sin(-0.5), 0)
        self.assert_near(whole.value(whole.parameter(far)), tuple(far))
        (part,) = (item for item in geometry if item.TypeId == "Part::GeomArcOfEllipse")
        for point, angle in ((part.EndPoint, 0.2), (part.StartPoint, 1.2)):
            a, b = 7.5 * cos(angle), 2.5 * sin(angle)
            x, y = a * cos(0.5) - b * sin(0.5), a * sin(0.5) + b * cos(0.5)
            self.assert_near(point, (10 + x, 20 - y, 0))

    def test_what_is_not_visible_is_construction_geometry(self) -> None:
        made = self.made()
        for name, edges, helpers in (
            ("Lines front", 6, 2),
            ("Lines top", 5, 2),
            ("Lines right", 2, 0),
        ):
            sketch = made[name]
            flags = [is_helper(sketch, number) for number in range(len(sketch.Geometry))]
            self.assertEqual(flags, [False] * edges + [True] * helpers, name)
            self.assertEqual(len(sketch.Shape.Edges), edges)

    def test_ends_that_meet_are_joined(self) -> None:
        front = self.made()["Lines front"]
        self.assertEqual({Constraint.Type for Constraint in front.Constraints}, {"Coincident"})
        self.assertEqual(len(front.Constraints), 6)
        self.assertTrue(front.Shape.Wires[0].isClosed())
        apart = [("line", ((0.0, 0.0), (1.0, 0.0))), ("line", ((1.01, 0.0), (2.0, 0.0)))]
        self.assertEqual(list(meeting_ends(apart, 0.001)), [])
        self.assertEqual(list(meeting_ends(apart, 0.02)), [(0, 2, 1, 1)])

    def test_a_told_extent_gives_the_scale(self) -> None:
        self.values["scale"] = {"source": "given", "axis": "z", "length_mm": 15.0}
        box = self.made()["Lines front"].Shape.BoundBox
        self.assertAlmostEqual(box.XLength, 30.0)
        self.assertAlmostEqual(box.ZLength, 15.0)

    def test_without_a_scale_the_longest_extent_is_100_mm_and_that_is_told(self) -> None:
        self.values["scale"] = {"source": "default"}
        self.values["problems"] = [
            {"code": "scale-assumed", "message": "made 100 mm", "severity": "warning"}
        ]
        sheet = read_cleaned(self.written())
        self.assertEqual(len(sheet.doubts), 1)
        self.assertIn("100 mm", sheet.doubts[0])
        self.assertAlmostEqual(self.made()["Lines front"].Shape.BoundBox.XLength, 100.0)
        self.assertAlmostEqual(self.document.Objects[-1].Shape.BoundBox.YLength, 40 / 0.6)

    def test_a_loose_box_does_not_move_a_view(self) -> None:
        for view in self.values["views"]:
            x0, y0, x1, y1 = view["box"]
            view["box"] = [x0 - 40, y0 - 10, x1 + 5, y1 + 20]
        box = self.made()["Lines front"].Shape.BoundBox
        self.assert_near(FreeCAD.Vector(box.XMin, box.YMin, box.ZMin), (0, 0, 0))

    def test_a_turned_sheet_is_turned_back(self) -> None:
        angle = radians(2.0)

        def turned(point: list[float]) -> list[float]:
            x, y = point
            return [x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle)]

        self.values["sheet"]["turn"] = angle
        for item in self.values["strokes"]:
            if "line" in item:
                item["line"] = [turned(point) for point in item["line"]]
            if "arc" in item:
                x, y, radius, first, sweep = item["arc"]
                item["arc"] = [*turned([x, y]), radius, first + angle, sweep]
        self.values["strokes"] = [
            entry for entry in self.values["strokes"] if "ellipse" not in entry
        ]
        made = self.made()
        box = made["Lines front"].Shape.BoundBox
        self.assertAlmostEqual(box.XLength, 60.0)
        self.assertAlmostEqual(box.ZLength, 30.0)
        (arc,) = (
            entry for entry in made["Lines top"].Geometry if entry.TypeId == "Part::GeomArcOfCircle"
        )
        self.assert_near(arc.StartPoint, (60, 30, 0))

    def test_one_step_is_undone_and_done_again(self) -> None:
        self.document.UndoMode = 1
        self.made()
        self.assertEqual(self.document.UndoNames, ["Lines to Sketches"])
        self.document.undo()
        self.assertEqual(self.document.Objects, [])
        self.document.redo()
        self.assertEqual(len(self.document.Objects), 4)

    def test_nothing_to_sketch_leaves_the_document_alone(self) -> None:
        for change, code in (
            ({"views": []}, ErrorCode.NO_VIEWS),
            ({"strokes": []}, ErrorCode.NO_VIEWS),
            ({"views": [{"id": "front"}]}, ErrorCode.RESULT_UNREADABLE),
            ({"views": 3}, ErrorCode.RESULT_UNREADABLE),
        ):
            before, self.values = self.values, {**self.values, **change}
            with self.subTest(change), self.assertRaises(WorkbenchError) as caught:
                self.made()
            self.values = before
            self.assertIs(caught.exception.code, code)
            self.assertIn(
                "Correct Sheet" if code is ErrorCode.NO_VIEWS else "again", str(caught.exception)
            )
        with self.assertRaises(WorkbenchError):
            add_sketches(self.document, self.folder / "none.json")
        self.assertEqual(self.document.Objects, [])

    def test_many_lines_are_added_at_once(self) -> None:
        self.shows({"id": "front", "role": "front", "box": [0, 0, 5000, 5000]})
        self.values["strokes"] = [
            {"id": f"s{n}", "view": "front", "kind": "visible", "line": [[n, n], [n + 1, n + 1]]}
            for n in range(800)
        ]
        (sketch,) = self.made().values()
        self.assertEqual((len(sketch.Geometry), len(sketch.Constraints)), (800, 0))


class Kept(FolderCase):
    def test_corrections_of_a_documents_own_copy_go_to_the_engine(self) -> None:
        document = FreeCAD.newDocument("Kept")
        self.addCleanup(FreeCAD.closeDocument, "Kept")
        sheet = draw_sheet(self.folder / "bracket.png")
        group = open_in(document, sheet, 1)
        copy = Path(group.Sheet)
        self.assertIsNone(kept_corrections(group, copy, self.folder))
        group.Corrections = json.dumps([{"op": "unit", "to": "in"}])
        self.assertIsNone(kept_corrections(group, sheet, self.folder))
        stated = json.loads(kept_corrections(group, copy, self.folder).read_text(encoding="utf-8"))
        self.assertEqual(stated["ops"], [{"op": "unit", "to": "in"}])
        self.assertEqual(stated["sheet_sha256"], hashlib.sha256(sheet.read_bytes()).hexdigest())


class Script(FolderCase):
    def test_a_drawing_is_read_and_sketched_in_a_document_of_its_name(self) -> None:
        self.set_variable("GAUSSIANCAD_PYTHON", FAKE_ENGINE.python)
        group = sketch_drawing(self.folder / "bracket.png")
        self.addCleanup(FreeCAD.closeDocument, group.Document.Name)
        self.assertEqual((group.Label, len(group.Group)), ("bracket", 3))
        self.assertEqual(group.Document.Label, "bracket")
        self.behave("no-views")
        count = len(FreeCAD.listDocuments())
        with self.assertRaises(WorkbenchError):
            sketch_drawing(self.folder / "bracket.png")
        self.assertEqual(len(FreeCAD.listDocuments()), count)

    def test_the_engines_arguments(self) -> None:
        plain = ["read", "--output", "o", "--page", "1", "--events", "--", "-s.png"]
        self.assertEqual(ReadJob("-s.png", "o").arguments(), plain)
        stated = ReadJob("s.pdf", "o", 2, "c.json").arguments()
        self.assertEqual(stated[3:7], ["--page", "2", "--corrections", "c.json"])


def is_helper(sketch: FreeCAD.DocumentObject, number: int) -> bool:
    """Whether a line of a sketch is construction geometry, in any FreeCAD."""
    return bool(sketch.getConstruction(number))
