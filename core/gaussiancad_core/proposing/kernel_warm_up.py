"""The kernels of the judge and of the search compiled ahead, on a small part."""

import numpy as np

from gaussiancad_core.coordinates.agreed_places import find_places
from gaussiancad_core.evidence.drawn_views import DrawnViews, exact_views
from gaussiancad_core.judging.faceted_solids import faceted_mesh
from gaussiancad_core.judging.sheet_ink import SheetInk
from gaussiancad_core.judging.sheet_judgement import SheetEvidence, judge_solid
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.meshes import make_mesh
from gaussiancad_core.model.section_planes import SectionRole
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.proposing.part_search import PartSearch
from gaussiancad_core.sheet.registration.view_registration import Placement, placement

_SIZE = (60.0, 40.0, 30.0)

_WORK = 1e6

_CORNERS = np.array([[x, y, z] for x in (0.0, 60.0) for y in (0.0, 40.0) for z in (0.0, 30.0)])

_TRIANGLES = np.array(
    [
        (0, 1, 3), (0, 3, 2), (4, 6, 7), (4, 7, 5), (0, 4, 5), (0, 5, 1),
        (2, 3, 7), (2, 7, 6), (0, 2, 6), (0, 6, 4), (1, 5, 7), (1, 7, 3),
    ]
)  # fmt: skip


def warm_up() -> None:
    """Compile the kernels, or load them from numba's cache, so that the first part is quick."""
    views = _views()
    PartSearch(views, find_places(views, views.tolerance), _WORK).best()
    ink = np.zeros((8, 8), np.float32)
    places: dict[Role | SectionRole, Placement] = {
        role: placement(role, (0.0, 0.0, 1.0, 1.0), _SIZE) for role in views.roles
    }
    evidence = SheetEvidence(views, SheetInk(ink, places), Projection.THIRD)
    judge_solid(faceted_mesh(make_mesh(_CORNERS, _TRIANGLES)), [evidence])


def _views() -> DrawnViews:
    """A block with a bore, and a step that is sunk around it."""
    bore = Arc((20.0, 20.0), 8.0, 0.0, 2.0 * np.pi, Linetype.VISIBLE)
    sink = Arc((20.0, 20.0), 12.0, 0.0, 2.0 * np.pi, Linetype.VISIBLE)
    walls = [Segment((x, 0.0), (x, 26.0), Linetype.HIDDEN) for x in (12.0, 28.0)]
    cone = [
        Segment((12.0, 26.0), (8.0, 30.0), Linetype.HIDDEN),
        Segment((28.0, 26.0), (32.0, 30.0), Linetype.HIDDEN),
    ]
    strokes: dict[Role, tuple[DrawnStroke, ...]] = {
        Role.FRONT: (*_rectangle(60.0, 30.0), *walls, *cone),
        Role.TOP: (*_rectangle(60.0, 40.0), bore, sink),
        Role.RIGHT: (*_rectangle(40.0, 30.0), *walls, *cone),
    }
    return exact_views(strokes, _SIZE)


def _rectangle(width: float, height: float) -> tuple[Segment, ...]:
    corners = ((0.0, 0.0), (width, 0.0), (width, height), (0.0, height))
    return tuple(
        Segment(start, end, Linetype.VISIBLE)
        for start, end in zip(corners, (*corners[1:], corners[0]), strict=True)
    )
