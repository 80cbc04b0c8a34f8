"""What one solid has and another has not."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from OCP.BRepClass3d import BRepClass3d_SolidClassifier
from OCP.gp import gp_Pnt
from OCP.TopAbs import TopAbs_ShapeEnum, TopAbs_State
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.kernel.booleans import common, fused, unified, without
from gaussiancad_core.kernel.brep import bounding_box, exact_volume, faces_of, is_valid, subshapes
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES

Points = npt.NDArray[np.float64]

_EXACT = 1e-6
"""Share of a solid's volume up to which a difference is none."""

_MEASURED = 1e-5
"""Share of a volume by which equal solids may measure apart, however well faces are integrated: the
curves in which faces meet are approximations, which end the faces otherwise where they are split
otherwise."""

_ONE_FACE = 1e-5, 1e-4
"""Units and radians within which faces continue each other: what was cut from different sides
agrees to the last digits only."""

_TRIES = 40
"""Points at which a body is looked for the inside of."""


@dataclass(frozen=True, eq=False)
class Difference:
    """How a solid that was built differs from the one that it should be.

    Attributes:
        share: volume of what either has alone, of that of the solid; infinite where the built one
            is no valid single solid.
        faces: of the built one, less those of the solid.
        points: (n, 3) mm, one in each piece that either has alone.
        is_inside: (n,) whether they are in the solid.
    """

    share: float
    faces: int
    points: Points
    is_inside: npt.NDArray[np.bool_]

    @property
    def is_none(self) -> bool:
        """Whether the two are the same solid with the same faces."""
        return self.share <= _EXACT and self.faces == 0


def difference(solid: TopoDS_Shape, built: TopoDS_Shape) -> Difference:
    """Compare two solids in place."""
    points: Points = np.zeros((0, 3))
    is_inside: npt.NDArray[np.bool_] = np.zeros(0, dtype=bool)
    share, faces = np.inf, 0
    try:
        simple = unified(built)
        faces = min(_more_faces(solid, built), key=abs)
        alone = list(_alone(solid, built))
        whole, made = exact_volume(solid), exact_volume(built)
        if is_valid(simple) and len(subshapes(simple, TopAbs_ShapeEnum.TopAbs_SOLID)) == 1:
            share = sum(abs(exact_volume(body)) for body, _ in alone) / whole
        # What either has alone is at least the difference of their volumes, whatever cuts say.
        least = abs(whole - made) / whole
        if np.isfinite(share) and least <= _MEASURED and share > _EXACT:
            # Where bodies share faces the kernel may fail to cut them, and still tell what they
            # have in common, or what they are together.
            shared, together = _met(solid, built)
            share = min(share, abs(whole + made - 2.0 * shared) / whole)
            if together >= (1.0 - _EXACT) * whole:
                share = min(share, abs(2.0 * together - whole - made) / whole)
        share = max(share, least) if least > _MEASURED else share
        found = [(_within(body), inside) for body, inside in alone]
        found = [(point, inside) for point, inside in found if point is not None]
        points = np.array([point for point, _ in found]).reshape(-1, 3)
        is_inside = np.array([inside for _, inside in found], dtype=bool)
    except KERNEL_FAILURES:
        return Difference(np.inf, faces, points, is_inside)
    return Difference(float(share), faces, points, is_inside)


def _more_faces(solid: TopoDS_Shape, built: TopoDS_Shape) -> Iterator[int]:
    """How many faces more the built one has, by the kernel's tolerance of one face and by a wider
    one."""
    for one_face in ((), _ONE_FACE):
        yield len(faces_of(unified(built, *one_face))) - len(faces_of(unified(solid, *one_face)))


def _met(solid: TopoDS_Shape, built: TopoDS_Shape) -> tuple[float, float]:
    """Volumes of what two solids share, and of both together."""
    return exact_volume(common(solid, built)), exact_volume(fused([solid, built]))


def _alone(solid: TopoDS_Shape, built: TopoDS_Shape) -> Iterator[tuple[TopoDS_Shape, bool]]:
    """What either has alone, and whether that is in the solid."""
    for body in subshapes(without(solid, [built]), TopAbs_ShapeEnum.TopAbs_SOLID):
        yield body, True
    for body in subshapes(without(built, [solid]), TopAbs_ShapeEnum.TopAbs_SOLID):
        yield body, False


def _within(body: TopoDS_Shape) -> Points | None:
    """A point inside of a body; None where none is met."""
    low, high = bounding_box(body)
    shares = [np.full(3, 0.5), *np.random.default_rng(0).random((_TRIES, 3))]
    classifier = BRepClass3d_SolidClassifier(body)
    for share in shares:
        point = low + share * (high - low)
        classifier.Perform(gp_Pnt(*point.tolist()), 1e-6)
        if classifier.State() == TopAbs_State.TopAbs_IN:
            return point
    return None
