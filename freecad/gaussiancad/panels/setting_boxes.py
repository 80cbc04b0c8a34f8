"""The combo boxes of a reconstruction's settings."""

from freecad.gaussiancad.engine.job import Projection, ScaleKind
from freecad.gaussiancad.engine.protocol import Preset, Recipe, ResultKind
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.panels.widgets import ModeBox
from freecad.gaussiancad.qt import QtWidgets


def projection_box(start: Projection) -> ModeBox[Projection]:
    """How the views are arranged."""
    box = ModeBox(
        [
            (Projection.AUTO, translate("GaussianCAD", "Automatic")),
            (Projection.FIRST, translate("GaussianCAD", "First angle")),
            (Projection.THIRD, translate("GaussianCAD", "Third angle")),
        ],
        "projection",
    )
    box.setToolTip(
        translate(
            "GaussianCAD",
            "Tells how the views are arranged: third angle has the top view above the front view, "
            "first angle below it",
        )
    )
    box.choose(start)
    return box


def body_box(checked: bool) -> QtWidgets.QCheckBox:
    """Whether an exact solid becomes an editable body."""
    box = QtWidgets.QCheckBox(translate("GaussianCAD", "Make an editable body"))
    box.setObjectName("body")
    box.setChecked(checked)
    box.setToolTip(
        translate(
            "GaussianCAD",
            "Makes a body with sketches, pads and holes of an exact solid, once that is shown; the "
            "solid stays beside it, hidden",
        )
    )
    return box


def preset_box(start: Preset) -> ModeBox[Preset]:
    """How much work is done."""
    box = ModeBox(
        [
            (Preset.DRAFT, translate("GaussianCAD", "Draft")),
            (Preset.STANDARD, translate("GaussianCAD", "Standard")),
            (Preset.FINE, translate("GaussianCAD", "Fine")),
        ],
        "preset",
    )
    box.setToolTip(
        translate(
            "GaussianCAD",
            "Trades time for detail of the surface and effort of the search",
        )
    )
    box.choose(start)
    return box


def outcome_box(start: ResultKind) -> ModeBox[ResultKind]:
    """What is made."""
    box = ModeBox(
        [
            (ResultKind.BOTH, translate("GaussianCAD", "Solid and surface")),
            (ResultKind.SOLID, translate("GaussianCAD", "Solid only")),
            (ResultKind.SURFACE, translate("GaussianCAD", "Surface only")),
        ],
        "outcome",
    )
    box.setToolTip(
        translate(
            "GaussianCAD",
            "Chooses the exact solid, the mesh from trained Gaussians, or both of them",
        )
    )
    box.choose(start)
    return box


def recipe_box(start: Recipe) -> ModeBox[Recipe]:
    """Which cameras train."""
    box = ModeBox(
        [
            (
                Recipe.ORTHOGRAPHIC,
                translate("GaussianCAD", "Parallel, as drawings are"),
            ),
            (Recipe.PAPER, translate("GaussianCAD", "Perspective, as in the paper")),
        ],
        "recipe",
    )
    box.setToolTip(translate("GaussianCAD", "Chooses the cameras that train the Gaussians"))
    box.choose(start)
    return box


def scale_box() -> ModeBox[ScaleKind]:
    """What is known of the size."""
    box = ModeBox(
        [
            (ScaleKind.UNKNOWN, translate("GaussianCAD", "Unknown or on the sheet")),
            (ScaleKind.LENGTH_X, translate("GaussianCAD", "Length along X")),
            (ScaleKind.LENGTH_Y, translate("GaussianCAD", "Length along Y")),
            (ScaleKind.LENGTH_Z, translate("GaussianCAD", "Length along Z")),
            (ScaleKind.MM_PER_PIXEL, translate("GaussianCAD", "Millimetres per pixel")),
        ],
        "scale",
    )
    box.setToolTip(
        translate(
            "GaussianCAD",
            "Tells how large the part is. X runs along the front view's width, Z up its height, "
            "Y into depth",
        )
    )
    return box
