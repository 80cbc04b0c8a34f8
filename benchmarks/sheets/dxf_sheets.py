"""DXF files of three views, as programs write them that know kinds of lines."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from types import MappingProxyType

import ezdxf
import numpy as np

from gaussiancad_core.drawing.drawn_sheet import PartLines
from gaussiancad_core.lines.strokes import Polyline
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment

_GAP = 0.25
"""Between views, as a share of the longest extent."""


_HATCHING = "HATCHING"


def write_dxf(
    lines: PartLines,
    projection: Projection,
    path: Path,
    hatching: Mapping[Role, Sequence[Segment]] = MappingProxyType({}),
) -> None:
    """A DXF file in mm: views in their places, kinds of lines as layers and linetypes.

    Args:
        lines: of the views.
        projection: which tells their places.
        path: of the file.
        hatching: of views that are cut open, mm of their planes.
    """
    document = ezdxf.new("R2010", setup=True)
    document.header["$INSUNITS"] = 4
    document.linetypes.add("DASHED4", [4.5, 3.0, -1.5])
    document.layers.add(Linetype.VISIBLE.name)
    document.layers.add(Linetype.HIDDEN.name, linetype="DASHED4")
    document.layers.add(_HATCHING, lineweight=13)
    space = document.modelspace()
    wide, deep, high = (float(extent) for extent in lines.size)
    gap = _GAP * max(wide, deep, high)
    third = projection is Projection.THIRD
    places = {
        Role.FRONT: (0.0, 0.0),
        Role.TOP: (0.0, high + gap if third else -gap - deep),
        Role.RIGHT: (wide + gap if third else -gap - deep, 0.0),
    }
    for role, strokes in lines.views.items():
        x, y = places[role]
        for stroke in strokes:
            layer = {"layer": stroke.linetype.name}
            if isinstance(stroke, Segment):
                ends = ((px + x, py + y) for px, py in (stroke.start, stroke.end))
                space.add_line(*ends, dxfattribs=layer)
            elif isinstance(stroke, Arc):
                centre = (stroke.centre[0] + x, stroke.centre[1] + y)
                if stroke.is_closed:
                    space.add_circle(centre, stroke.radius, dxfattribs=layer)
                    continue
                start, sweep = np.degrees([stroke.start_angle, stroke.sweep]).tolist()
                space.add_arc(centre, stroke.radius, start, start + sweep, dxfattribs=layer)
            elif isinstance(stroke, Polyline):
                points = [(px + x, py + y) for px, py in stroke.points]
                space.add_lwpolyline(points, dxfattribs=layer)
        for line in hatching.get(role, ()):
            ends = ((px + x, py + y) for px, py in (line.start, line.end))
            space.add_line(*ends, dxfattribs={"layer": _HATCHING})
    document.saveas(path)
