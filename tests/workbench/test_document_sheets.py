"""Drawings in a document as files for the engine."""

import re
import time
from pathlib import Path
from xml.etree import ElementTree

import FreeCAD
import Part
from support import FolderCase, draw_sheet

from freecad.gaussiancad.engine.job import Projection
from freecad.gaussiancad.errors import ErrorCode, WorkbenchError
from freecad.gaussiancad.objects.document_sheets import (
    export_sheet,
    first_sheet_object,
    sheet_objects,
)
from freecad.gaussiancad.objects.edge_paths import edge_path
from freecad.gaussiancad.objects.proxies import GroupProxy

SVG = "{http://www.w3.org/2000/svg}"
BLANK = (
    '<svg xmlns="http://www.w3.org/2000/svg" width="297mm" height="210mm" viewBox="0 0 297 210"/>'
)
PATIENCE_SECONDS = 60.0
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")


def bracket() -> Part.Shape:
    """An L of 60 x 40 x 30 mm with a hole through its foot."""
    foot, wall = Part.makeBox(60, 40, 10), Part.makeBox(15, 40, 30)
    hole = Part.makeCylinder(5, 40, FreeCAD.Vector(45, 25, -5))
    return foot.fuse(wall).cut(hole).removeSplitter()


def numbers(text: str) -> list[float]:
    return [float(value) for value in NUMBER.findall(text)]


class DocumentCase(FolderCase):
    def setUp(self) -> None:
        super().setUp()
        self.document = FreeCAD.newDocument("Sheets")
        self.addCleanup(FreeCAD.closeDocument, self.document.Name)


class Pages(DocumentCase):
    def add_page(self, scale: float = 1.5) -> FreeCAD.DocumentObject:
        """A page with a front view at (90, 70) and a top view at (90, 140) mm."""
        part = self.document.addObject("Part::Feature", "Bracket")
        part.Shape = bracket()
        page = self.blank_page()
        for name, direction, y in (("Front", (0, -1, 0), 70), ("Top", (0, 0, 1), 140)):
            view = self.document.addObject("TechDraw::DrawViewPart", name)
            page.addView(view)
            view.Source = [part]
            view.Direction, view.XDirection = direction, (1, 0, 0)
            view.HardHidden = True
            view.ScaleType, view.Scale = "Custom", scale
            view.X, view.Y = 90, y
        self.document.recompute()
        self.wait_for_edges()
        return page

    def blank_page(self) -> FreeCAD.DocumentObject:
        page = self.document.addObject("TechDraw::DrawPage", "Page")
        template = self.document.addObject("TechDraw::DrawSVGTemplate", "Template")
        blank = self.folder / "A4.svg"
        blank.write_text(BLANK, encoding="utf-8")
        template.Template = str(blank)
        page.Template = template
        return page

    def wait_for_edges(self) -> None:
        """FreeCAD 1.x finds hidden lines in threads of its own."""
        views = [view for view in self.document.Objects if view.Name in ("Front", "Top")]
        end = time.monotonic() + PATIENCE_SECONDS
        while not all(view.getVisibleEdges() and view.getHiddenEdges() for view in views):
            self.assertLess(time.monotonic(), end, "TechDraw drew nothing")
            time.sleep(0.05)

    def paths(self, file: Path) -> dict[str, list[ElementTree.Element]]:
        found: dict[str, list[ElementTree.Element]] = {"visible": [], "hidden": []}
        for path in ElementTree.parse(file).getroot().iter(SVG + "path"):
            found[path.get("class")].append(path)
        return found

    def test_a_page_keeps_its_edges_and_which_are_hidden(self) -> None:
        exported = export_sheet(self.add_page(), self.folder)
        self.assertEqual(exported.path, self.folder / "Page.svg")
        self.assertAlmostEqual(exported.mm_per_pixel, 25.4 / 200 / 1.5)
        root = ElementTree.parse(exported.path).getroot()
        self.assertEqual((root.get("width"), root.get("height")), ("297mm", "210mm"))
        self.assertEqual(numbers(root.get("viewBox")), [0, 0, 297, 210])
        paths = self.paths(exported.path)
        lines = {
            tuple(sorted(((a, b), (c, d))))
            for path in paths["visible"]
            if "A" not in path.get("d")
            for a, b, c, d in [[round(value, 6) for value in numbers(path.get("d"))]]
        }
        # The front view is 90 x 45 mm around (90, 210 - 70), the wall on the left.
        for line in (
            ((45, 117.5), (67.5, 117.5)),
            ((45, 117.5), (45, 162.5)),
            ((45, 162.5), (135, 162.5)),
            ((67.5, 147.5), (135, 147.5)),
        ):
            self.assertIn(line, lines)
        hidden = [
            numbers(path.get("d"))
            for path in paths["hidden"]
            if abs(numbers(path.get("d"))[0] - numbers(path.get("d"))[2]) < 1e-6
        ]
        # The hole's sides stand 5 mm to each side of x = 45 mm.
        self.assertEqual(sorted(round(values[0], 6) for values in hidden), [105.0, 120.0])
        self.assertTrue(all(path.get("stroke-dasharray") for path in paths["hidden"]))
        circle = next(path.get("d") for path in paths["visible"] if "A" in path.get("d"))
        self.assertEqual(len(numbers(circle)), 2 + 4 * 7)
        self.assertAlmostEqual(numbers(circle)[2], 7.5)

    def test_views_of_different_scales_tell_none(self) -> None:
        page = self.add_page()
        self.document.Top.Scale = 1.0
        self.document.recompute()
        self.wait_for_edges()
        self.assertIsNone(export_sheet(page, self.folder).mm_per_pixel)

    def texts(self, file: Path) -> list[ElementTree.Element]:
        return list(ElementTree.parse(file).getroot().iter(SVG + "text"))

    def test_a_page_tells_its_scale_and_unit_in_the_file(self) -> None:
        exported = export_sheet(self.add_page(), self.folder)
        stated = [text.text for text in self.texts(exported.path)]
        self.assertEqual(stated, ["DIMENSIONS IN MM", "SCALE 1.5 : 1"])
        # Views that stand by themselves may be placed anyhow.
        self.assertIsNone(exported.projection)

    def test_a_projection_group_tells_how_it_is_projected(self) -> None:
        part = self.document.addObject("Part::Feature", "Bracket")
        part.Shape = bracket()
        page = self.blank_page()
        group = self.document.addObject("TechDraw::DrawProjGroup", "Group")
        page.addView(group)
        group.Source = [part]
        group.addProjection("Front")
        group.Anchor.Direction, group.Anchor.XDirection = (0, -1, 0), (1, 0, 0)
        group.addProjection("Top")
        group.ScaleType, group.Scale = "Custom", 0.5
        group.X, group.Y = 120, 100
        kinds = group.getEnumerationsOfProperty("ProjectionType")
        for projection in (Projection.FIRST, Projection.THIRD):
            named = [kind for kind in kinds if kind.lower() == f"{projection.value} angle"]
            self.assertEqual(len(named), 1, kinds)
            group.ProjectionType = named[0]
            for item in group.Views:
                item.touch()
            self.document.recompute()
            end = time.monotonic() + PATIENCE_SECONDS
            while not all(view.getVisibleEdges() for view in group.Views):
                self.assertLess(time.monotonic(), end, "TechDraw drew nothing")
                time.sleep(0.05)
            exported = export_sheet(page, self.folder)
            self.assertIs(exported.projection, projection)
            self.assertAlmostEqual(exported.mm_per_pixel, 25.4 / 200 * 2)
            stated = [text.text for text in self.texts(exported.path)]
            self.assertIn("SCALE 1 : 2", stated)
            self.assertIn(f"{projection.value.upper()} ANGLE PROJECTION", stated)

    def test_dimensions_have_their_number_lines_and_a_pen_of_their_own(self) -> None:
        page = self.add_page()
        front = self.document.Front
        edges = [front.getEdgeByIndex(index) for index in range(4)]
        level = next(i for i, edge in enumerate(edges) if abs(edge.BoundBox.YLength) < 1e-6)
        dimension = self.document.addObject("TechDraw::DrawViewDimension", "Width")
        dimension.Type = "DistanceX"
        dimension.References2D = [(front, f"Edge{level}")]
        page.addView(dimension)
        dimension.X, dimension.Y = 0, 40
        self.document.recompute()
        exported = export_sheet(page, self.folder)
        box = edges[level].BoundBox
        (text,) = (this_text for this_text in self.texts(exported.path) if this_text.text.isdigit())
        self.assertEqual(float(text.text), round(box.XLength, 4))
        self.assertEqual(float(text.get("x")), 90.0)
        root = ElementTree.parse(exported.path).getroot()
        pieces = [item for item in root.iter(SVG + "path") if item.get("class") == "dimension"]
        lines = [numbers(piece.get("d")) for piece in pieces if piece.get("stroke") != "none"]
        # Edges by their index are those of the part; the page's are 1.5 times as long.
        # The dimension line stands 40 mm above the view's centre at (90, 210 - 70).
        (stated,) = (line for line in lines if line[1] == line[3])
        self.assertEqual(stated, [90 + 1.5 * box.XMin, 100.0, 90 + 1.5 * box.XMax, 100.0])
        self.assertEqual(len(lines), 3)
        self.assertEqual(len(pieces), 5)

    def test_an_empty_page_is_told(self) -> None:
        page = self.document.addObject("TechDraw::DrawPage", "Page")
        page.Label = "Blatt 1/2"
        with self.assertRaises(WorkbenchError) as caught:
            export_sheet(page, self.folder)
        self.assertIs(caught.exception.code, ErrorCode.SHEET_MISSING)
        self.assertIn("Blatt 1/2", caught.exception.message)

    def test_names_that_no_file_may_have(self) -> None:
        page = self.add_page()
        page.Label = "Blatt 1/2: 零件"
        self.assertEqual(export_sheet(page, self.folder).path.name, "Blatt 1_2_ 零件.svg")

    def test_a_selected_view_means_its_page(self) -> None:
        page = self.add_page()
        chosen = [self.document.Bracket, self.document.Front]
        self.assertEqual(first_sheet_object(chosen).Name, page.Name)
        self.assertIsNone(first_sheet_object([self.document.Bracket]))
        self.assertIsNone(first_sheet_object([]))


class Images(DocumentCase):
    def add_image(self) -> FreeCAD.DocumentObject:
        plane = self.document.addObject("Image::ImagePlane", "Scan")
        plane.ImageFile = str(draw_sheet(self.folder / "Zeichnung.png"))
        return plane

    def test_an_image_becomes_a_file_that_outlives_the_document(self) -> None:
        plane = self.add_image()
        target = self.folder / "exports"
        target.mkdir()
        exported = export_sheet(plane, target)
        self.assertEqual(exported.path.parent, target)
        self.assertIsNone(exported.mm_per_pixel)
        drawn = (self.folder / "Zeichnung.png").read_bytes()
        self.assertEqual(exported.path.read_bytes(), drawn)

    def test_an_image_without_a_picture_is_told(self) -> None:
        plane = self.document.addObject("Image::ImagePlane", "Scan")
        with self.assertRaises(WorkbenchError):
            export_sheet(plane, self.folder)

    def test_pages_are_offered_before_images(self) -> None:
        plane = self.add_image()
        page = self.document.addObject("TechDraw::DrawPage", "Page")
        self.document.addObject("Part::Feature", "Other")
        # The views of an earlier result are no drawings.
        group = self.document.addObject("App::DocumentObjectGroupPython", "Reconstruction")
        GroupProxy(group)
        group.addObject(self.document.addObject("Image::ImagePlane", "front"))
        names = [found.Name for found in sheet_objects(self.document)]
        self.assertEqual(names, [page.Name, plane.Name])
        self.assertEqual(sheet_objects(None), [])


class Edges(FolderCase):
    def test_arcs_turn_the_way_they_run(self) -> None:
        circle = Part.Circle(FreeCAD.Vector(5, 6, 0), FreeCAD.Vector(0, 0, 1), 4)
        for curve, flag in ((circle, 1), (_reversed(circle), 0)):
            data = edge_path(curve.toShape(0.5, 2.5), (10.0, 20.0))
            values = numbers(data)
            arcs = [values[2 + 7 * index : 9 + 7 * index] for index in range(4)]
            self.assertEqual([arc[4] for arc in arcs], [flag] * 4)
            self.assertTrue(all(arc[:2] == [4.0, 4.0] for arc in arcs))
            end = curve.value(2.5)
            self.assertAlmostEqual(arcs[-1][5], end.x + 10, places=6)
            self.assertAlmostEqual(arcs[-1][6], end.y + 20, places=6)

    def test_ellipses_keep_their_axes(self) -> None:
        ellipse = Part.Ellipse(
            FreeCAD.Vector(3, 4, 0), FreeCAD.Vector(-2, 1.5, 0), FreeCAD.Vector(0, 0, 0)
        )
        values = numbers(edge_path(ellipse.toShape(), (0.0, 0.0)))
        self.assertAlmostEqual(values[2], 5.0)
        self.assertAlmostEqual(values[3], 2.5)
        self.assertAlmostEqual(values[4] % 180, 53.13010235, places=6)

    def test_free_curves_become_cubics(self) -> None:
        spline = Part.BSplineCurve()
        spline.interpolate([FreeCAD.Vector(*p) for p in ((0, 0), (10, 5), (20, -5), (30, 0))])
        edge = spline.toShape()
        data = edge_path(edge, (0.0, 0.0))
        start, *pieces = data.split("C")
        here = FreeCAD.Vector(*numbers(start))
        for piece in pieces:
            values = numbers(piece)
            poles = [here, *(FreeCAD.Vector(*values[i : i + 2]) for i in (0, 2, 4))]
            bezier = Part.BezierCurve()
            bezier.setPoles(poles)
            for step in range(11):
                point = Part.Vertex(bezier.value(step / 10))
                self.assertLess(point.distToShape(edge)[0], 2e-3)
            here = poles[-1]
        self.assertAlmostEqual(here.x, 30.0)

    def test_a_circle_seen_from_the_side_is_a_line(self) -> None:
        flat = Part.BSplineCurve()
        flat.buildFromPolesMultsKnots(
            [FreeCAD.Vector(x, 0) for x in (0, 0, 10, 20, 20)], (4, 1, 4), (0, 0.5, 1), False, 3
        )
        values = numbers(edge_path(flat.toShape(), (1.0, 2.0)))
        self.assertEqual([round(value, 6) for value in values], [1.0, 2.0, 21.0, 2.0])


def _reversed(circle: Part.Circle) -> Part.Circle:
    turned = Part.Circle(circle.Center, FreeCAD.Vector(0, 0, -1), circle.Radius)
    return turned
