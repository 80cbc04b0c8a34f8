"""How much of a solid is in doubt whose measures are round but for a few.

What a picture tells to a tenth of a pixel is known exactly where it was rounded to the step that
the part was designed in.  A plane across an axis lies at such a multiple, a slanted one goes
through two edges or three corners that do, a cylinder has such an axis and radius.  Other faces may
lie as far from where they were read as numbers were rounded at most.

Where a measure is odd, another one may be near a round one by chance, and odd as well.  How likely
that is follows from how many odd ones were seen: where more than one is unlikely, the largest face
is in doubt, too, whichever it may be.  Where all faces are round, odd coordinates are none of
these: an edge in which faces meet, as that of a flat on a cylinder, is where they have it.
"""

from collections import defaultdict
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_SurfaceType
from OCP.gp import gp_Ax1, gp_Pnt
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS, TopoDS_Face, TopoDS_Shape

from gaussiancad_core.drawing.brep import area, faces_of, subshapes
from gaussiancad_core.reasoning.nominal import ROUND_MM

Points = npt.NDArray[np.float64]

_ON = 1e-4
"""Share of the step within which a number is a multiple of it: what was rounded is exact but for
rounding errors, what was not is one to this by chance in one of five thousand."""

_USUAL = 1e-6
"""Share of a step by which it may miss a round number of mm."""

_MOST_BY_CHANCE = 0.1
"""Odd measures that are taken for round ones by chance, on average, up to which two are not to be
expected."""

_ALONG = 1e-7
"""Component of a unit vector across an axis, at most, of what runs along it."""

_APART = 1e-3
"""mm from which points are different ones."""


@dataclass(frozen=True)
class RoundMeasures:
    """What is known of a part most of whose measures are multiples of a step.

    Attributes:
        step: mm.
        reach: mm by which measures were moved to become multiples, at most.
        odd: how many are none.
    """

    step: float
    reach: float
    odd: int

    @property
    def is_usual(self) -> bool:
        """Whether the step is one that most parts are designed in.

        Others are parts of the longest extent.  Where that is odd itself, what is round otherwise
        may be near multiples of such a part, at a scale that is a little wrong.
        """
        return any(abs(self.step - usual) <= _USUAL * usual for usual in ROUND_MM)

    @property
    def by_chance(self) -> float:
        """How many odd ones were taken for multiples, on average."""
        share = min(2.0 * self.reach / self.step, 0.99)
        return self.odd * share / (1.0 - share)


def is_round(shape: TopoDS_Shape, step: float) -> bool:
    """Whether all faces of a solid follow from multiples of a step in mm."""
    return all(_is_known(face, step) for face in faces_of(shape))


def volume_in_doubt(shape: TopoDS_Shape, measures: RoundMeasures) -> float:
    """mm3 by which a solid may be wrong, or infinity where too much may be round by chance.

    Args:
        shape: mm; its bounding box starts at the origin.
        measures: of the part.
    """
    if measures.by_chance > _MOST_BY_CHANCE:
        return np.inf
    doubtful = 0.0
    known: dict[tuple[object, ...], float] = defaultdict(float)
    for face in faces_of(shape):
        if _is_known(face, measures.step):
            known[_surface(face)] += area(face)
        else:
            doubtful += area(face)
    return measures.reach * (doubtful + max(known.values(), default=0.0))


def _surface(face: TopoDS_Face) -> tuple[object, ...]:
    """What faces of one plane or cylinder have in common."""
    surface = BRepAdaptor_Surface(face)
    kind = surface.GetType()
    if kind == GeomAbs_SurfaceType.GeomAbs_Plane:
        normal = _direction(surface.Plane().Axis())
        place = float(normal @ _coordinates(surface.Plane().Location()))
        if normal[np.abs(normal).argmax()] < 0.0:
            normal, place = -normal, -place
        return kind, *np.round(normal, 4).tolist(), round(place / _APART)
    if kind == GeomAbs_SurfaceType.GeomAbs_Cylinder:
        # Bores of one radius may have been given it by one number.
        return kind, round(surface.Cylinder().Radius() / _APART)
    return (kind,)


def _is_known(face: TopoDS_Face, step: float) -> bool:
    surface = BRepAdaptor_Surface(face)
    kind = surface.GetType()
    if kind == GeomAbs_SurfaceType.GeomAbs_Plane:
        return _is_plane_known(_corners(face), _direction(surface.Plane().Axis()), step)
    if kind == GeomAbs_SurfaceType.GeomAbs_Cylinder:
        cylinder = surface.Cylinder()
        return _is_axis_known(cylinder.Axis(), step) and _fits(step, cylinder.Radius())
    if kind == GeomAbs_SurfaceType.GeomAbs_Sphere:
        sphere = surface.Sphere()
        return _fits(step, *_coordinates(sphere.Location()), sphere.Radius())
    if kind == GeomAbs_SurfaceType.GeomAbs_Torus:
        torus = surface.Torus()
        place = _coordinates(torus.Location())
        return _along_axis(torus.Axis()) is not None and _fits(
            step, *place, torus.MajorRadius(), torus.MinorRadius()
        )
    if kind == GeomAbs_SurfaceType.GeomAbs_Cone:
        return _is_cone_known(face, surface.Cone().Axis(), step)
    return False


def _is_plane_known(corners: Points, normal: Points, step: float) -> bool:
    """Whether a plane goes through enough corners that are multiples of the step."""
    across = [k for k in range(3) if abs(normal[k]) > _ALONG]
    # In the coordinates that tell where the plane is, known corners have to span it.
    known = corners[_fits_each(corners[:, across], step)][:, across]
    return len(known) > 0 and np.linalg.matrix_rank(known - known[0], tol=_APART) >= len(across) - 1


def _is_cone_known(face: TopoDS_Face, axis: gp_Ax1, step: float) -> bool:
    """Whether a cone has a known axis, and corners at two heights that are multiples of it."""
    along = _along_axis(axis)
    if along is None or not _is_axis_known(axis, step):
        return False
    place = np.delete(_coordinates(axis.Location()), along)
    corners = _corners(face)
    away = np.hypot(*(np.delete(corners, along, axis=1) - place).T)
    profile = np.stack([away, corners[:, along]], axis=1)
    known = profile[_fits_each(profile, step)]
    return len(known) > 0 and bool(np.ptp(known[:, 1]) > _APART)


def _is_axis_known(axis: gp_Ax1, step: float) -> bool:
    along = _along_axis(axis)
    return along is not None and _fits(step, *np.delete(_coordinates(axis.Location()), along))


def _along_axis(axis: gp_Ax1) -> int | None:
    """Along which axis of the model something runs, or None."""
    direction = np.abs(_direction(axis))
    return int(direction.argmax()) if np.sort(direction)[1] <= _ALONG else None


def _direction(axis: gp_Ax1) -> Points:
    way = axis.Direction()
    return np.array([way.X(), way.Y(), way.Z()])


def _coordinates(point: gp_Pnt) -> Points:
    return np.array([point.X(), point.Y(), point.Z()])


def _corners(face: TopoDS_Face) -> Points:
    """(n, 3) mm of a face's corners; of a whole circle one point counts."""
    vertices = subshapes(face, TopAbs_ShapeEnum.TopAbs_VERTEX)
    found = [_coordinates(BRep_Tool.Pnt_s(TopoDS.Vertex(vertex))) for vertex in vertices]
    return np.array(found).reshape(-1, 3)


def _fits(step: float, *numbers: float) -> bool:
    return bool(_fits_each(np.array([numbers]), step).all())


def _fits_each(rows: Points, step: float) -> npt.NDArray[np.bool_]:
    """(n,) whether all numbers of each row are multiples of the step."""
    return (np.abs(rows - step * np.round(rows / step)) <= _ON * step).all(axis=1)
