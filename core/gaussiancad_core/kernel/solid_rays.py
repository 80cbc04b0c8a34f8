"""What a viewer's line of sight meets: the faces of a solid in their order of depth."""

from dataclasses import dataclass
from itertools import pairwise, product

import numpy as np
import numpy.typing as npt
from OCP.gp import gp_Pnt2d
from OCP.IntTools import IntTools_FClass2d
from OCP.TopAbs import TopAbs_Orientation, TopAbs_State
from OCP.TopoDS import TopoDS_Face, TopoDS_Shape

from gaussiancad_core.kernel.brep import bounding_box, faces_of
from gaussiancad_core.kernel.surface_crossings import Array, Crossings, Surface, surface_of
from gaussiancad_core.model.axes import ViewFrame

_UV_TOLERANCE = 1e-9


@dataclass(frozen=True)
class RayCrossings:
    """The hits of one line of sight, nearest first.

    Attributes:
        depth: (k,) mm along the look direction.
        normal: (k, 3) outward unit normals.
        face: (k,) numbers of the faces.
        sound: the line enters and leaves material in turn.
    """

    depth: Array
    normal: Array
    face: npt.NDArray[np.int64]
    sound: bool


@dataclass(frozen=True)
class _Patch:
    surface: Surface
    inside: IntTools_FClass2d
    sign: float
    box: Array


class SolidRays:
    """Lines of sight through one solid in one view.

    Args:
        shape: solid in mm.
        frame: the view.
        tolerance: mm, for surfaces without a closed form.
    """

    def __init__(self, shape: TopoDS_Shape, frame: ViewFrame, tolerance: float) -> None:
        self._right, self._up, self._look = (
            np.array(vector, dtype=np.float64) for vector in (frame.right, frame.up, frame.look)
        )
        self._patches = [self._patch(face, tolerance) for face in faces_of(shape)]

    def _patch(self, face: TopoDS_Face, tolerance: float) -> _Patch:
        low, high = bounding_box(face)
        all_corners = np.array(list(product(*zip(low, high, strict=True))))
        corners = all_corners @ np.stack([self._right, self._up], axis=1)
        reversed_face = face.Orientation() == TopAbs_Orientation.TopAbs_REVERSED
        return _Patch(
            surface_of(face, tolerance),
            IntTools_FClass2d(face, _UV_TOLERANCE),
            -1.0 if reversed_face else 1.0,
            np.stack([corners.min(axis=0) - tolerance, corners.max(axis=0) + tolerance]),
        )

    def crossings_at(self, points: Array) -> list[RayCrossings]:
        """What is met at (n, 2) points of the view's plane."""
        lines: list[npt.NDArray[np.int64]] = []
        depths: list[Array] = []
        normals: list[Array] = []
        faces: list[npt.NDArray[np.int64]] = []
        for number, patch in enumerate(self._patches):
            low, high = patch.box
            chosen = np.flatnonzero(np.all((points >= low) & (points <= high), axis=1))
            if not len(chosen):
                continue
            origins = points[chosen, :1] * self._right + points[chosen, 1:] * self._up
            hits = patch.surface.crossings(origins, self._look)
            kept = _inside(patch, hits)
            lines.append(chosen[hits.line[kept]])
            depths.append(hits.depth[kept])
            normals.append(patch.sign * hits.normal[kept])
            faces.append(np.full(int(kept.sum()), number))
        return self._sorted(len(points), lines, depths, normals, faces)

    def _sorted(
        self,
        count: int,
        lines: list[npt.NDArray[np.int64]],
        depths: list[Array],
        normals: list[Array],
        faces: list[npt.NDArray[np.int64]],
    ) -> list[RayCrossings]:
        if not lines:
            empty = RayCrossings(np.zeros(0), np.zeros((0, 3)), np.zeros(0, int), True)
            return [empty] * count
        line, depth = np.concatenate(lines), np.concatenate(depths)
        normal, face = np.concatenate(normals), np.concatenate(faces)
        order = np.lexsort((depth, line))
        line, depth, normal, face = (
            line[order],
            depth[order],
            normal[order],
            face[order],
        )
        bounds = np.searchsorted(line, np.arange(count + 1))
        columns = []
        for start, end in pairwise(bounds):
            this_slice = slice(start, end)
            entering = normal[this_slice] @ self._look < 0.0
            alternates = bool(np.all(entering[0::2]) and not np.any(entering[1::2]))
            sound = (end - start) % 2 == 0 and alternates
            columns.append(
                RayCrossings(depth[this_slice], normal[this_slice], face[this_slice], sound)
            )
        return columns


def _inside(patch: _Patch, hits: Crossings) -> npt.NDArray[np.bool_]:
    """Which crossings lie on the trimmed face."""
    wanted = (TopAbs_State.TopAbs_IN, TopAbs_State.TopAbs_ON)
    return np.array(
        [patch.inside.Perform(gp_Pnt2d(u, v), True) in wanted for u, v in hits.parameters.tolist()],
        dtype=bool,
    )
