"""Why a model differs from its drawing, or why nobody can tell."""

from freecad.gaussiancad.language import QT_TRANSLATE_NOOP

REASONS = {
    "extents-differ": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The model fits the views in no position: it is another part, or the views were read "
        "wrong. Check {canvas} how they were read.",
    ),
    "extents-differ:axis": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The views are {stated_mm} mm long along {axis} (x runs along the front view's width, z up "
        "its height), the model is {measured_mm} mm long.",
    ),
    "size-differs": QT_TRANSLATE_NOOP(
        "GaussianCAD", "The model has {factor} times the size that the drawing's numbers say."
    ),
    "circle-missing": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The view “{view}” has a circle of {diameter_mm} mm that the model does not show.",
    ),
    "edge-not-drawn": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The model shows an edge of {length_mm} mm in the view “{view}” that is not drawn there. "
        "Such edges are {total_mm} mm long in all.",
    ),
    "section-differs": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The section in the view “{view}” is hatched where the model is not cut, or the other way "
        "round.",
    ),
    "shaded-views": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The drawing shows shaded pictures in place of lines. They are not read surely enough to "
        "say that the model differs.",
    ),
    "note-not-kept": QT_TRANSLATE_NOOP(
        "GaussianCAD", "Note “{text}”: the drawing says {stated}, the model has {found}."
    ),
    "explained-better": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "With a single change the model explains the drawing better: it is the first one among "
        "the changes.",
    ),
    "lines-unexplained:check": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "{percent} % of the lines that were read disagree with the model, and nothing tells "
        "whether the model or the reading is wrong. Check {canvas} how the lines were read.",
    ),
    "solid-unsound:model": QT_TRANSLATE_NOOP(
        "GaussianCAD",
        "The model is not closed, or damaged: what it is full of is not certain.",
    ),
}
