"""The features of a solid: its holes are set aside, the rest is decomposed, and all of it is built
again."""

import numpy as np
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.booleans import without
from gaussiancad_core.drawing.brep import bounding_box
from gaussiancad_core.features.building import combined
from gaussiancad_core.features.decomposing import decomposed
from gaussiancad_core.features.difference import difference
from gaussiancad_core.features.drilling import body_of_holes, holes_of
from gaussiancad_core.features.filling import without_faces
from gaussiancad_core.features.model import FeatureList
from gaussiancad_core.features.rays import Rays
from gaussiancad_core.features.round_holes import bores_of
from gaussiancad_core.features.scaling import scaled, scaled_shape
from gaussiancad_core.features.solid_faces import solid_faces
from gaussiancad_core.reasoning.planes import UNITS


def features_of(shape: TopoDS_Shape) -> FeatureList:
    """The features that make up one solid, mm."""
    box = bounding_box(shape)
    factor = UNITS / float((box[1] - box[0]).max())
    shape = scaled_shape(shape, factor)
    reach = 4.0 * float(np.abs(box).max() * factor + 1.0)
    faces = solid_faces(shape)
    bores = bores_of(faces, Rays(shape, reach))
    filled, done = without_faces(shape, [bore.faces for bore in bores])
    holes = holes_of([bores[k] for k in done])
    found = decomposed(filled)
    if found is None:
        return FeatureList(holes, False, "nothing")
    body = combined(found.bodies)
    if holes:
        body = without(body, [body_of_holes(own, reach) for own in holes])
    apart = difference(shape, body)
    features = tuple(scaled(own, 1.0 / factor) for own in (*found.bodies, *holes))
    return FeatureList(
        features,
        apart.is_none,
        f"{found.difference.share:.2g} {found.difference.faces}; {apart.share:.2g} {apart.faces}; "
        f"{len(bores)} {len(done)}",
    )
