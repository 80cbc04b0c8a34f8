"""The cleaned lines of a drawing as sketches in a document, one for each view on its plane.

In ``freecadcmd``, of a drawing that ``gaussiancad read`` has read::

    from pathlib import Path
    from freecad.gaussiancad.objects.sketches import add_sketches

    group = add_sketches(FreeCAD.newDocument("part"), Path("read/reading.json"))

:func:`freecad.gaussiancad.sketching.sketch_drawing` runs the engine as well.
"""

from collections.abc import Sequence
from math import degrees
from pathlib import Path

import FreeCAD
import Part
import Sketcher

from freecad.gaussiancad.engine.wording import drawing_name, role_name
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.cleaned_lines import CleanedSheet, CleanedView, read_cleaned
from freecad.gaussiancad.objects.meeting_ends import meeting_ends
from freecad.gaussiancad.objects.placing import PlanePlacement, place_plane
from freecad.gaussiancad.objects.plane_shapes import Shape, is_whole, length_of_line
from freecad.gaussiancad.objects.transaction import transaction

_SHORTEST_MM = 1e-5
"""Length under which FreeCAD takes a line for a point."""

_SAME_PX = 1e-3
"""Distance of ends that are one: readings have places to 1e-4 px."""

_MOST_JOINED = 300
"""Lines of a sketch whose ends are joined: FreeCAD's solver takes under half a second for these,
and eight times as long for twice as many, each time the sketch is computed."""


def add_sketches(
    document: FreeCAD.Document, reading: str | Path, name: str = ""
) -> FreeCAD.DocumentObject:
    """Add the lines of a ``reading.json`` to a document, in one undo step.

    Args:
        document: receives a group with a sketch for each view and each section that has lines.
        reading: path of the file.
        name: of the group; that of the file's folder where it is empty.

    Returns:
        The group.

    Raises:
        WorkbenchError: the file cannot be read, or no view has lines.
    """
    path = Path(reading).absolute()
    return add_cleaned(document, read_cleaned(path), name or path.parent.name)


def add_cleaned(
    document: FreeCAD.Document, sheet: CleanedSheet, name: str
) -> FreeCAD.DocumentObject:
    """The same of lines that were read already."""
    with transaction(document, translate("GaussianCAD", "Lines to Sketches")):
        group = document.addObject("App::DocumentObjectGroup", "Drawing")
        group.Label = name
        for view in sheet.views:
            sketch = document.addObject("Sketcher::SketchObject", _name(view))
            sketch.Label = _label(view)
            sketch.Placement = _placement(place_plane(view.role, sheet.roles, sheet.size))
            group.addObject(sketch)
            _fill(sketch, view, _SAME_PX * sheet.mm_per_px)
        document.recompute()
    return group


def _fill(sketch: FreeCAD.DocumentObject, view: CleanedView, reach: float) -> None:
    edges, helpers = (
        [line for line in lines if line[0] != "line" or length_of_line(line) > _SHORTEST_MM]
        for lines in (view.edges, view.helpers)
    )
    if edges:
        sketch.addGeometry([_geometry(edge) for edge in edges], False)
    if helpers:
        sketch.addGeometry([_geometry(helper) for helper in helpers], True)
    lines = [*edges, *helpers]
    if len(lines) <= _MOST_JOINED:
        _join(sketch, lines, reach)


def _join(sketch: FreeCAD.DocumentObject, lines: Sequence[Shape], reach: float) -> None:
    """Have ends that meet stay together; where the solver cannot, nothing is joined."""
    joined = [
        Sketcher.Constraint("Coincident", *meeting_end)
        for meeting_end in meeting_ends(lines, reach)
    ]
    if not joined:
        return
    sketch.addConstraint(joined)
    if sketch.solve() != 0:
        sketch.Constraints = []


def _geometry(shape: Shape) -> object:
    name, numbers = shape
    if name == "line":
        return Part.LineSegment(*(FreeCAD.Vector(*number, 0.0) for number in numbers))
    centre, (first, sweep) = FreeCAD.Vector(*numbers[:2], 0.0), numbers[-2:]
    if name == "arc":
        curve = Part.Circle(centre, FreeCAD.Vector(0.0, 0.0, 1.0), numbers[2])
        return curve if is_whole(shape) else Part.ArcOfCircle(curve, first, first + sweep)
    major, minor, rotation = numbers[2:5]
    turn = FreeCAD.Rotation(FreeCAD.Vector(0.0, 0.0, 1.0), degrees(rotation))
    ends = (FreeCAD.Vector(major, 0.0, 0.0), FreeCAD.Vector(0.0, minor, 0.0))
    curve = Part.Ellipse(*(centre + turn.multVec(end) for end in ends), centre)
    return curve if is_whole(shape) else Part.ArcOfEllipse(curve, first, first + sweep)


def _placement(plane: PlanePlacement) -> FreeCAD.Placement:
    rotation = FreeCAD.Rotation(
        FreeCAD.Vector(*plane.right), FreeCAD.Vector(*plane.up), FreeCAD.Vector(*plane.towards)
    )
    return FreeCAD.Placement(FreeCAD.Vector(*plane.centre), rotation)


def _name(view: CleanedView) -> str:
    return f"Lines_{view.role if view.section is None else 'section'}"


def _label(view: CleanedView) -> str:
    name = role_name(view.role)
    if view.section is not None:
        name = f"{drawing_name('section')} {view.section}".rstrip()
    return translate("GaussianCAD", "Lines {name}").format(name=name)
