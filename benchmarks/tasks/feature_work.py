"""One part: its features are found, counted, changed; in a process that can be ended."""

import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from OCP.BOPTools import BOPTools_AlgoTools3D
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeVertex
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.gp import gp_Pnt, gp_Pnt2d
from OCP.IntTools import IntTools_Context
from OCP.TopAbs import TopAbs_ShapeEnum
from OCP.TopoDS import TopoDS_Shape

from benchmarks.parts.exact_cases import Case
from benchmarks.run.workers import FIRST, SOLVE, Row
from benchmarks.tasks.feature_changes import Number, failure_of, numbers_of, outlines, rebuilt
from benchmarks.tasks.feature_sketches import freedom
from gaussiancad_core.features.as_json import kind_of
from gaussiancad_core.features.constraints import Numbers, constraints_of
from gaussiancad_core.features.difference import difference
from gaussiancad_core.features.feature_model import EdgeBreak, FeatureList
from gaussiancad_core.features.feature_search import features_of
from gaussiancad_core.kernel.booleans import unified
from gaussiancad_core.kernel.brep import compound_of, faces_of, subshapes, volume
from gaussiancad_core.processes.library_behaviour import silence_opencascade
from sample_parts import sample

SAMPLES = "samples"

_PREPARING_S, _CHANGING_S = 60.0, 15.0
_ON = 1e-5
"""Share of a part's extent up to which a point is on its base."""


@dataclass(frozen=True)
class Task:
    """A part.

    Attributes:
        case: where it is from; the name of a sample of the group of samples.
        limit: s for its features.
        factor: by which numbers are changed.
        numbers: how many of them at most.
    """

    case: Case
    limit: float
    factor: float
    numbers: int

    @property
    def known(self) -> Row:
        """What its row begins with."""
        return {"group": self.case.group, "name": self.case.name}

    @property
    def allowed(self) -> dict[str, float]:
        """s for each stage."""
        return {FIRST: _PREPARING_S, SOLVE: self.limit, "change": _CHANGING_S}

    def solid(self) -> TopoDS_Shape:
        """The part; of several solids the largest one."""
        if self.case.group == SAMPLES:
            return sample(self.case.name).build()
        solids = subshapes(self.case.truth(), TopAbs_ShapeEnum.TopAbs_SOLID)
        return max(solids, key=volume)


def worked(task: Task) -> Iterator[Row]:
    """What becomes known of a part."""
    silence_opencascade()
    solid = task.solid()
    yield {"faces": len(faces_of(unified(solid))), "stage": SOLVE}
    began = time.monotonic()
    found = features_of(solid)
    yield {"seconds": time.monotonic() - began, "whole": found.is_whole}
    yield _counted(found, solid)
    yield {"stage": "change"}
    yield from _changed(task, found)


def _counted(found: FeatureList, solid: TopoDS_Shape) -> Row:
    """How many features there are of which kind, and how well they fix what they make."""
    free = [
        freedom(outlines(feature), constraints_of(outlines(feature), Numbers()))
        for feature in found.features
        if not isinstance(feature, EdgeBreak)
    ]
    made = rebuilt(found.features, found.base)
    return {
        "features": dict(Counter(kind_of(feature) for feature in found.features)),
        "freedom": sum(each.left for each in free),
        "redundant": sum(each.redundant for each in free),
        "same": made is not None and difference(solid, made).is_none,
        "by_features": 1.0 if found.is_whole else _share(solid, found.base),
    }


def _share(solid: TopoDS_Shape, base: TopoDS_Shape | None) -> float:
    """The share of a solid's faces that do not lie on the faces of its base."""
    assert base is not None
    shell = compound_of(faces_of(base))
    faces = faces_of(unified(solid))
    context = IntTools_Context()
    size = volume(solid) ** (1.0 / 3.0)
    apart = []
    for face in faces:
        point, flat = gp_Pnt(), gp_Pnt2d()
        if BOPTools_AlgoTools3D.PointInFace_s(face, point, flat, context):
            continue
        vertex = BRepBuilderAPI_MakeVertex(point).Vertex()
        apart.append(BRepExtrema_DistShapeShape(vertex, shell).Value())
    return float((np.array(apart) > _ON * size).mean()) if apart else 0.0


def _changed(task: Task, found: FeatureList) -> Iterator[Row]:
    """How many numbers can be changed, number by number."""
    numbers = list(numbers_of(found.features))
    yield {"numbers": len(numbers)}
    failed: list[str] = []
    for count, number in enumerate(_some(numbers, task.numbers), 1):
        failure = failure_of(found, number, task.factor)
        if failure is not None:
            kind = kind_of(found.features[number.feature])
            failed.append(f"{kind} {number.kind} {failure}")
        yield {"tried": count, "failed": dict(Counter(failed))}


def _some(numbers: list[Number], count: int) -> list[Number]:
    """As many of them, spread evenly."""
    if len(numbers) <= count:
        return numbers
    return [numbers[int(k)] for k in np.linspace(0, len(numbers) - 1, count)]
