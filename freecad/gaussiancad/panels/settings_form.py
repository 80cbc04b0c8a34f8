"""The settings of a reconstruction, as widgets."""

import FreeCADGui

from freecad.gaussiancad.engine.job import (
    Outcome,
    Preset,
    Projection,
    Recipe,
    ReconstructJob,
    Scale,
    ScaleKind,
)
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.panels.training_images import TrainingImages
from freecad.gaussiancad.panels.widgets import ColourButton, ModeBox, PathField
from freecad.gaussiancad.preferences import Preferences
from freecad.gaussiancad.qt import QtWidgets

_DEFAULT_LENGTH_MM = 100.0
_DEFAULT_MM_PER_PIXEL = 0.1


class SettingsForm(QtWidgets.QWidget):
    """What is to be made, and how.

    Args:
        preferences: what the form starts with.
    """

    def __init__(self, preferences: Preferences) -> None:
        super().__init__()
        self.setWindowTitle(translate("GaussianCAD", "Settings"))
        self.projection = _projection_box(preferences.projection)
        self.preset = _preset_box(preferences.preset)
        self.outcome = _outcome_box()
        self.recipe = _recipe_box()
        self.images = TrainingImages(preferences.preset)
        self.scale = _scale_box()
        self.length = FreeCADGui.UiLoader().createWidget("Gui::QuantitySpinBox")
        self.length.setObjectName("length")
        self.length.setProperty("unit", "mm")
        self.length.setProperty("minimum", 1e-6)
        self.length.setProperty("rawValue", _DEFAULT_LENGTH_MM)
        self.mm_per_pixel = QtWidgets.QDoubleSpinBox()
        self.mm_per_pixel.setObjectName("mmPerPixel")
        self.mm_per_pixel.setDecimals(9)
        self.mm_per_pixel.setRange(1e-6, 1e4)
        self.mm_per_pixel.setSingleStep(0.01)
        self.mm_per_pixel.setValue(_DEFAULT_MM_PER_PIXEL)
        self.mm_per_pixel.setSuffix(" mm")
        for box in (self.length, self.mm_per_pixel):
            box.setMinimumWidth(60)
        self.colour = ColourButton(ReconstructJob.colour)
        self.page = QtWidgets.QSpinBox()
        self.page.setObjectName("page")
        self.page.setRange(1, 9999)
        self.output = PathField("output", self._browse_folder)
        self.output.line.setText(preferences.output_folder)
        self.output.line.setPlaceholderText(translate("GaussianCAD", "Temporary"))
        self._lay_out()
        self.scale.currentIndexChanged.connect(self._show_scale)
        self._show_scale()
        self.recipe.currentIndexChanged.connect(self._show_images)
        self.outcome.currentIndexChanged.connect(self._show_images)
        self.preset.currentIndexChanged.connect(lambda: self.images.show_preset(self.preset.mode))
        self._show_images()

    def job(self, sheet: str, output: str) -> ReconstructJob:
        """The job that the widgets describe.

        Args:
            sheet: path of the drawing.
            output: folder for the engine's files.
        """
        return ReconstructJob(
            sheet,
            output,
            self.projection.mode,
            self.preset.mode,
            self.outcome.mode,
            self.recipe.mode,
            self._scale(),
            self.colour.colour,
            self.page.value(),
            scale_down=self.images.scale_down if self._perspective else 1,
        )

    def tell_mm_per_pixel(self, value: float) -> None:
        """Set a scale that is known."""
        self.scale.choose(ScaleKind.MM_PER_PIXEL)
        self.mm_per_pixel.setValue(value)

    def forget_scale(self) -> None:
        """Take back a scale that is not known any more."""
        self.scale.choose(ScaleKind.UNKNOWN)

    def show_page(self, paged: bool) -> None:
        """Offer the page's number for files that have pages only."""
        self._page_label.setVisible(paged)
        self.page.setVisible(paged)

    def _scale(self) -> Scale:
        kind = self.scale.mode
        if kind is ScaleKind.UNKNOWN:
            return Scale()
        if kind is ScaleKind.MM_PER_PIXEL:
            return Scale(kind, self.mm_per_pixel.value())
        return Scale(kind, float(self.length.property("rawValue")))

    def _show_scale(self) -> None:
        kind = self.scale.mode
        self.mm_per_pixel.setVisible(kind is ScaleKind.MM_PER_PIXEL)
        along_axis = kind not in (ScaleKind.MM_PER_PIXEL, ScaleKind.UNKNOWN)
        self.length.setVisible(along_axis)
        self._value_label.setVisible(kind is not ScaleKind.UNKNOWN)

    @property
    def _perspective(self) -> bool:
        """Whether Gaussians are trained with the paper's cameras."""
        return self.recipe.mode is Recipe.PAPER and self.outcome.mode is not Outcome.SOLID

    def _show_images(self) -> None:
        self._images_label.setVisible(self._perspective)
        self.images.setVisible(self._perspective)

    def _lay_out(self) -> None:
        layout = QtWidgets.QFormLayout(self)
        grow = QtWidgets.QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow
        layout.setFieldGrowthPolicy(grow)
        self._page_label = QtWidgets.QLabel(translate("GaussianCAD", "Page"))
        self._value_label = QtWidgets.QLabel(translate("GaussianCAD", "Value"))
        self._images_label = QtWidgets.QLabel(translate("GaussianCAD", "Image size"))
        values = QtWidgets.QVBoxLayout()
        values.addWidget(self.length)
        values.addWidget(self.mm_per_pixel)
        layout.addRow(self._page_label, self.page)
        layout.addRow(translate("GaussianCAD", "Projection"), self.projection)
        layout.addRow(translate("GaussianCAD", "Scale"), self.scale)
        layout.addRow(self._value_label, values)
        layout.addRow(translate("GaussianCAD", "Result"), self.outcome)
        layout.addRow(translate("GaussianCAD", "Quality"), self.preset)
        layout.addRow(translate("GaussianCAD", "Cameras"), self.recipe)
        layout.addRow(self._images_label, self.images)
        layout.addRow(translate("GaussianCAD", "Colour"), self.colour)
        layout.addRow(translate("GaussianCAD", "Folder"), self.output)
        self.output.line.setToolTip(
            translate(
                "GaussianCAD",
                "Keeps the engine's files in a folder named after the drawing. If empty, they "
                "are removed once the document holds the result.",
            )
        )
        self.show_page(False)

    def _browse_folder(self) -> str:
        title = translate("GaussianCAD", "Folder for the Engine's Files")
        return QtWidgets.QFileDialog.getExistingDirectory(self, title, self.output.path)


def _projection_box(start: Projection) -> ModeBox[Projection]:
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


def _preset_box(start: Preset) -> ModeBox[Preset]:
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


def _outcome_box() -> ModeBox[Outcome]:
    box = ModeBox(
        [
            (Outcome.BOTH, translate("GaussianCAD", "Solid and surface")),
            (Outcome.SOLID, translate("GaussianCAD", "Solid only")),
            (Outcome.SURFACE, translate("GaussianCAD", "Surface only")),
        ],
        "outcome",
    )
    box.setToolTip(
        translate(
            "GaussianCAD",
            "Chooses the exact solid, the mesh from trained Gaussians, or both of them",
        )
    )
    return box


def _recipe_box() -> ModeBox[Recipe]:
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
    return box


def _scale_box() -> ModeBox[ScaleKind]:
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
