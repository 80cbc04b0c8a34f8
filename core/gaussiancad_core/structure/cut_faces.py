"""The areas of a sheet that are cut, told by the hatching in them (ISO 128-3)."""

import numpy as np
import shapely
from shapely import Polygon

from gaussiancad_core.sheet_model.labelled_strokes import Label, LabelledStrokes
from gaussiancad_core.structure.closed_outlines import faces_of

_WALLS = (Label.EDGE, Label.CENTRE, Label.EXTENSION)
"""What bounds hatching: edges, and in half sections the centre line, which a dimension's extension
line may run along."""

_STEP = 0.25
"""mm between the places along hatching that are asked where they lie."""


def cut_faces(labelled: LabelledStrokes) -> list[Polygon]:
    """The faces between edges and centre lines in which hatching runs, mm.

    Args:
        labelled: all strokes, each with what it stands for.
    """
    hatches = labelled.of(Label.HATCH)
    if not hatches:
        return []
    faces = np.array(faces_of(labelled.of(*_WALLS)).faces, dtype=object)
    # Its ends lie on the walls: no telling on which side.
    places = [
        shapely.line_interpolate_point(stroke.line, np.arange(_STEP, stroke.length - _STEP, _STEP))
        for stroke in hatches
    ]
    if not len(faces):
        return []
    hit = shapely.STRtree(faces).query(np.concatenate(places), "within")[1]
    return list(faces[np.unique(hit)])
