"""The settings of a reconstruction, as widgets."""

import FreeCADGui

from freecad.gaussiancad.engine.job import Projection, ReconstructJob, Scale, ScaleKind
from freecad.gaussiancad.engine.protocol import Recipe, ResultKind
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.panels.more_settings import MoreSettings, narrow_rows
from freecad.gaussiancad.panels.setting_boxes import (
    body_box,
    outcome_box,
    preset_box,
    projection_box,
    recipe_box,
    scale_box,
)
from freecad.gaussiancad.panels.training_images import TrainingImages
from freecad.gaussiancad.panels.widgets import ColourButton, PathField
from freecad.gaussiancad.qt import QtWidgets
from freecad.gaussiancad.remembered import Choices, is_more_open, remember_more_open

_DEFAULT_LENGTH_MM = 100.0
_DEFAULT_MM_PER_PIXEL = 0.1


class SettingsForm(QtWidgets.QWidget):
    """What is to be made, and how: what most need stands open, the rest is a click away.

    Args:
        start: what the form starts with.
    """

    def __init__(self, start: Choices) -> None:
        super().__init__()
        self.setWindowTitle(translate("GaussianCAD", "Settings"))
        self.projection = projection_box(start.projection)
        self._usual_projection: Projection | None = None
        self._is_projection_chosen = False
        self.projection.activated.connect(self._choose_projection)
        self.preset = preset_box(start.preset)
        self.outcome = outcome_box(start.outcome)
        self.recipe = recipe_box(start.recipe)
        self.images = TrainingImages(start.preset, start.scale_down)
        self.scale = scale_box()
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
        self.colour = ColourButton(start.colour)
        self.body = body_box(start.body)
        self.page = QtWidgets.QSpinBox()
        self.page.setObjectName("page")
        self.page.setRange(1, 9999)
        self.output = PathField("output", self._browse_folder)
        self.output.line.setText(start.output_folder)
        self.output.line.setPlaceholderText(translate("GaussianCAD", "Temporary"))
        self.more = MoreSettings(is_more_open(), remember_more_open)
        self._lay_out()
        self.scale.currentIndexChanged.connect(self._show_scale)
        self._show_scale()
        self.recipe.currentIndexChanged.connect(self._show_images)
        self.outcome.currentIndexChanged.connect(self._show_images)
        self.preset.currentIndexChanged.connect(lambda: self.images.show_preset(self.preset.mode))
        self._show_images()

    @property
    def choices(self) -> Choices:
        """What the widgets say, without what belongs to one sheet."""
        return Choices(
            self._usual_projection or self.projection.mode,
            self.preset.mode,
            self.outcome.mode,
            self.recipe.mode,
            self.images.chosen,
            self.colour.colour,
            self.output.path,
            self.body.isChecked(),
        )

    @property
    def wants_body(self) -> bool:
        """Whether an exact solid becomes a body."""
        return self.body.isChecked() and self.outcome.mode is not ResultKind.SURFACE

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

    def take_job(self, job: ReconstructJob) -> None:
        """Show the settings of a job, but for its paths."""
        self.projection.choose(job.projection)
        self.preset.choose(job.preset)
        self.outcome.choose(job.outcome)
        self.recipe.choose(job.recipe)
        self.colour.set_colour(job.colour)
        self.page.setValue(job.page)
        if self._perspective:
            self.images.factor.setValue(job.scale_down)
        self.scale.choose(job.scale.kind)
        if job.scale.kind is ScaleKind.MM_PER_PIXEL:
            self.mm_per_pixel.setValue(job.scale.value)
        elif job.scale.kind is not ScaleKind.UNKNOWN:
            self.length.setProperty("rawValue", job.scale.value)

    def tell_mm_per_pixel(self, value: float) -> None:
        """Set a scale that is known."""
        self.scale.choose(ScaleKind.MM_PER_PIXEL)
        self.mm_per_pixel.setValue(value)

    def tell_projection(self, value: Projection) -> None:
        """Set the projection that a sheet tells, unless a person chose one in this panel."""
        if not self._is_projection_chosen:
            self._usual_projection = self._usual_projection or self.projection.mode
            self.projection.choose(value)

    def forget_projection(self) -> None:
        """Take back the projection that another sheet told."""
        if self._usual_projection is not None:
            self.projection.choose(self._usual_projection)
            self._usual_projection = None

    def forget_scale(self) -> None:
        """Take back a scale that is not known any more."""
        self.scale.choose(ScaleKind.UNKNOWN)

    def show_page(self, paged: bool) -> None:
        """Offer the page's number for files that have pages only; its place stays."""
        self._page_label.setEnabled(paged)
        self.page.setEnabled(paged)

    def _scale(self) -> Scale:
        kind = self.scale.mode
        if kind is ScaleKind.UNKNOWN:
            return Scale()
        if kind is ScaleKind.MM_PER_PIXEL:
            return Scale(kind, self.mm_per_pixel.value())
        return Scale(kind, float(self.length.property("rawValue")))

    def _choose_projection(self) -> None:
        """A person chose, whatever a sheet tells."""
        self._usual_projection = None
        self._is_projection_chosen = True

    def _show_scale(self) -> None:
        kind = self.scale.mode
        self.mm_per_pixel.setVisible(kind is ScaleKind.MM_PER_PIXEL)
        along_axis = kind not in (ScaleKind.MM_PER_PIXEL, ScaleKind.UNKNOWN)
        self.length.setVisible(along_axis)
        self._value_label.setVisible(kind is not ScaleKind.UNKNOWN)

    @property
    def _perspective(self) -> bool:
        """Whether Gaussians are trained with the paper's cameras."""
        return self.recipe.mode is Recipe.PAPER and self.outcome.mode is not ResultKind.SOLID

    def _show_images(self) -> None:
        self._images_label.setVisible(self._perspective)
        self.images.setVisible(self._perspective)
        self.body.setEnabled(self.outcome.mode is not ResultKind.SURFACE)

    def _lay_out(self) -> None:
        self._page_label = QtWidgets.QLabel(translate("GaussianCAD", "Page"))
        self._value_label = QtWidgets.QLabel(translate("GaussianCAD", "Value"))
        self._images_label = QtWidgets.QLabel(translate("GaussianCAD", "Image size"))
        values = QtWidgets.QVBoxLayout()
        values.addWidget(self.length)
        values.addWidget(self.mm_per_pixel)
        few = narrow_rows()
        few.addRow(self._page_label, self.page)
        few.addRow(translate("GaussianCAD", "Scale"), self.scale)
        few.addRow(self._value_label, values)
        few.addRow(translate("GaussianCAD", "Result"), self.outcome)
        few.addRow(self.body)
        more = self.more.rows
        more.addRow(translate("GaussianCAD", "Projection"), self.projection)
        more.addRow(translate("GaussianCAD", "Quality"), self.preset)
        more.addRow(translate("GaussianCAD", "Cameras"), self.recipe)
        more.addRow(self._images_label, self.images)
        more.addRow(translate("GaussianCAD", "Colour"), self.colour)
        more.addRow(translate("GaussianCAD", "Folder"), self.output)
        layout = QtWidgets.QVBoxLayout(self)
        layout.addLayout(few)
        layout.addWidget(self.more)
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
