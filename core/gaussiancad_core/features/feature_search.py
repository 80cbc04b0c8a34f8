"""The features of a solid: its holes and edge breaks are set aside, the rest is decomposed, and all
of it is built again."""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.features.blends import blends_of
from gaussiancad_core.features.decomposing import decomposed
from gaussiancad_core.features.defeaturing import without_faces, without_holes
from gaussiancad_core.features.difference import difference
from gaussiancad_core.features.dressing import breaks_of, dressed
from gaussiancad_core.features.drilling import body_of_holes
from gaussiancad_core.features.feature_model import EdgeBreak, Feature, FeatureList, Holes
from gaussiancad_core.features.solid_faces import solid_faces
from gaussiancad_core.features.supporting_faces import beginning_on_faces
from gaussiancad_core.features.unit_scaling import scaled, scaled_shape
from gaussiancad_core.kernel.booleans import without
from gaussiancad_core.kernel.brep import bounding_box
from gaussiancad_core.kernel.kernel_failures import KERNEL_FAILURES
from gaussiancad_core.model.projection_planes import UNITS


@dataclass(frozen=True, eq=False)
class _Stripped:
    """A solid without what is put on last.

    Attributes:
        body: that is left; units.
        breaks: of its edges.
        holes: in it.
        reach: units that a hole through it is long.
    """

    body: TopoDS_Shape
    breaks: tuple[EdgeBreak, ...]
    holes: tuple[Holes, ...]
    reach: float

    def finished(self, body: TopoDS_Shape) -> TopoDS_Shape | None:
        """A body with all that is put on last; None where the kernel cannot."""
        made = dressed(body, self.breaks) if self.breaks else body
        if made is None or not self.holes:
            return made
        try:
            return without(made, [body_of_holes(holes, self.reach) for holes in self.holes])
        except KERNEL_FAILURES:
            return None


def features_of(shape: TopoDS_Shape) -> FeatureList:
    """The features that make up one solid, mm.

    What is found is built again and compared with the solid.  Where nothing that is found makes it
    up, as many holes and edge breaks as possible stand over a base.
    """
    box = bounding_box(shape)
    factor = UNITS / float((box[1] - box[0]).max())
    solid = scaled_shape(shape, factor)
    over: _Stripped | None = None
    for stripped in _ways(solid):
        last: tuple[Feature, ...] = (*stripped.breaks, *stripped.holes)
        found = decomposed(stripped.body)
        if found is not None and _is_made(stripped, found.shape, solid):
            every: tuple[Feature, ...] = (*found.bodies, *last)
            features = tuple(scaled(each, 1.0 / factor) for each in every)
            return FeatureList(beginning_on_faces(features))
        if over is None and last and _is_made(stripped, stripped.body, solid):
            over = stripped
    if over is None:
        return FeatureList((), shape)
    last = (*over.breaks, *over.holes)
    base = scaled_shape(over.body, 1.0 / factor)
    return FeatureList(tuple(scaled(feature, 1.0 / factor) for feature in last), base)


def _is_made(stripped: _Stripped, body: TopoDS_Shape, solid: TopoDS_Shape) -> bool:
    """Whether a body becomes the solid with what is put on last."""
    made = stripped.finished(body)
    return made is not None and difference(solid, made).is_none


def _ways(solid: TopoDS_Shape) -> Iterator[_Stripped]:
    """A solid without holes and edge breaks; then without holes alone; then as it is."""
    reach = 4.0 * float(np.abs(bounding_box(solid)).max() + 1.0)
    filled, holes = without_holes(solid, reach)
    groups = blends_of(filled, solid_faces(filled))
    undressed, kept = without_faces(filled, [[blend.face for blend in g] for g in groups])
    if kept:
        breaks = breaks_of([blend for k in kept for blend in groups[k]], undressed)
        yield _Stripped(undressed, breaks, holes, reach)
    yield _Stripped(filled, (), holes, reach)
    if holes:
        yield _Stripped(solid, (), (), reach)
