"""What to know of two models before believing their distances, and why they are not compared."""

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP

WARNINGS = {
    "result-mirrored": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "A mirror image of the result fits better. Check the projection and the views.",
    ),
    "unit-mismatch": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The result is {ratio} times as large as the reference: their units differ. Scale the "
        "result by {factor} to have it in millimetres.",
    ),
    "model-open": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Not closed: {model} (open edges: {count}). Its volume is not certain, and distances from "
        "it have no sign.",
    ),
    "solid-invalid": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "FreeCAD's geometry check refuses this solid: {model}. Its volume may be wrong.",
    ),
    "surfaces-only": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Only surfaces that do not close up to a solid: {model}. Its volume is not certain, and "
        "distances from it have no sign.",
    ),
    "surfaces-sewn": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Surfaces without a solid: {model}. Sewn together they are closed, and are measured as a "
        "solid.",
    ),
    "surfaces-left-out": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Faces beside the solids are not measured: {model} (faces: {count}). Remove them, or make "
        "solids of them.",
    ),
    "solids-united": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Solids that touch or overlap are measured as one body, without the faces between them: "
        "{model} (solids: {count}).",
    ),
    "no-volume": QT_TRANSLATE_NOOP("GaussianCAD", "Closed, but without a volume: {model}."),
    "topology-differs": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "Result: bodies {result_bodies}, through holes {result_holes}, cavities "
        "{result_cavities}. Reference: bodies {reference_bodies}, through holes "
        "{reference_holes}, cavities {reference_cavities}.",
    ),
}

REFUSALS = {
    "damaged-model": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The models cannot be compared: one is damaged. Export it again."
    ),
    "damaged-model:draw": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The model cannot be drawn: it is damaged. Export it again.",
    ),
    "model-format-unknown": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The file is no model. Choose a STEP, BREP, STL, PLY or OBJ file."
    ),
    "not-a-model": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The model's file is damaged, or of another format. Export it again."
    ),
    "not-a-solid": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The file holds no solid and no surfaces. Export a solid or its faces."
    ),
    "empty-model": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The model has no surface. Export it with its faces."
    ),
    "point-cloud": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The model is points without faces. Make a surface of them first."
    ),
    "file-damaged": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The model's file is cut off or damaged. Export it again."
    ),
    "file-too-large": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The model's file is too large. Export it with fewer triangles."
    ),
    "size-out-of-range": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The model is too small, or too far from the origin, to be measured. Export it in "
        "millimetres, near the origin.",
    ),
    "sizes-too-different": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The models differ too much in size to be compared. Check that these are the right ones.",
    ),
}
