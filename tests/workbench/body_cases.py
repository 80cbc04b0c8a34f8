"""What the tests of bodies share: features as the engine writes them, shapes, a document."""

import json
from pathlib import Path
from typing import Any

import FreeCAD
import Part
from FreeCAD import Vector
from support import FolderCase

from freecad.gaussiancad.objects.bodies import MadeBody, add_bodies
from freecad.gaussiancad.objects.body_check import check_body
from freecad.gaussiancad.objects.body_numbers import set_value
from freecad.gaussiancad.objects.feature_file import read_features

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


def arc(start: list, end: list, centre: list, counterclockwise: bool) -> dict[str, Any]:
    radius = ((start[0] - centre[0]) ** 2 + (start[1] - centre[1]) ** 2) ** 0.5
    ends = {"start": start, "end": end, "centre": centre}
    return {"kind": "arc", **ends, "radius": radius, "counterclockwise": counterclockwise}


def number(kind: str, of: list, value: float, name: str, source: str = "sheet") -> dict[str, Any]:
    return {"kind": kind, "of": of, "value": value, "name": name, "source": source}


def bracket() -> Part.Shape:
    """What the fake engine knows the features of."""
    return prism(
        [(0, 0, 0), (60, 0, 0), (60, 0, 10), (15, 0, 10), (15, 0, 30), (0, 0, 30)], (0, 40, 0)
    )


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

    def assert_is(self, made: MadeBody, shape: Part.Shape) -> None:
        self.assertEqual(check_body(made.body.Shape, shape).words, "")
        self.assertAlmostEqual(made.body.Shape.Volume / shape.Volume, 1.0, places=6)


class ChangedCase(BodyCase):
    """Bodies with numbers that are changed."""

    def change(self, feature: str, name: str, value: float) -> None:
        set_value(self.document.getObject(feature), name, value)
        self.document.recompute()

    def assert_volume(self, made: MadeBody, volume: float) -> None:
        shape = made.body.Shape
        self.assertEqual((len(shape.Solids), shape.isValid()), (1, True))
        self.assertAlmostEqual(shape.Volume, volume, places=4)
        self.assertEqual(
            [each.Name for each in (*made.body.Group, made.body) if not each.isValid()], []
        )

    def offset(self, sketch: str) -> float:
        return self.document.getObject(sketch).AttachmentOffset.Base.z
