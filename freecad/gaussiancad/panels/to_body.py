"""The task panel of *To Body…*: finds the features of a solid, and shows how far that is."""

from collections.abc import Sequence
from pathlib import Path

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.engine.features_job import FeaturesJob
from freecad.gaussiancad.language import translate
from freecad.gaussiancad.objects.bodies import MadeBody, add_bodies, undo_step
from freecad.gaussiancad.objects.feature_file import FEATURES_FILE, read_features
from freecad.gaussiancad.objects.solid_parts import part_named, solid_among, write_solid
from freecad.gaussiancad.panels.engine_panel import EnginePanel, PanelTexts
from freecad.gaussiancad.panels.follow_up import Success
from freecad.gaussiancad.panels.messages import show_error
from freecad.gaussiancad.panels.number_stage import NumberStage
from freecad.gaussiancad.qt import QtWidgets


def open_body(selected: Sequence[FreeCAD.DocumentObject]) -> "BodyPanel | None":
    """Find the features of the solid that is selected, and add a body with them.

    Args:
        selected: objects of the document; the part of a reconstruction among them is taken, or
            another part with one solid.

    Returns:
        The panel, at work; None where no solid is selected, which is told.
    """
    part = solid_among(selected)
    if part is None:
        text = translate(
            "GaussianCAD", "Select a reconstruction, or another part with one solid, first."
        )
        show_error(undo_step(), text)
        return None
    panel = BodyPanel(part)
    FreeCADGui.Control.showDialog(panel)
    panel.start()
    return panel


class BodyPanel(EnginePanel):
    """The panel; FreeCAD shows the widgets in ``form``.

    Args:
        part: with one solid.
    """

    def __init__(self, part: FreeCAD.DocumentObject) -> None:
        super().__init__(
            PanelTexts(
                undo_step(),
                translate("GaussianCAD", "Make Body"),
                translate("GaussianCAD", "Looking for features"),
                "GaussianCAD_ToBody",
            )
        )
        self._document_name, self._part_name = part.Document.Name, part.Name
        self._made: tuple[MadeBody, ...] = ()
        self.form = [_part_box(part.Label), self.run_view]
        self.dress()

    def prepare(self, scratch: Path) -> list[str]:
        """Write the solid, and ask for its features."""
        return FeaturesJob(str(write_solid(self._part(), scratch)), str(scratch)).arguments()

    def absorb(self, scratch: Path) -> Success:
        """Add the body to the document in one step."""
        self._made = add_bodies(self._part(), read_features(scratch / FEATURES_FILE))
        return Success("")

    def follow_up(self, success: Success) -> NumberStage:
        """Try the body's numbers; the end tells all of it."""
        return NumberStage(self._made, self.run_view)

    def set_editable(self, editable: bool) -> None:
        """There is nothing to choose."""

    def _part(self) -> FreeCAD.DocumentObject:
        return part_named(self._document_name, self._part_name)


def _part_box(label: str) -> QtWidgets.QWidget:
    box = QtWidgets.QWidget()
    box.setWindowTitle(translate("GaussianCAD", "Solid"))
    layout = QtWidgets.QVBoxLayout(box)
    name = QtWidgets.QLabel(label)
    name.setWordWrap(True)
    layout.addWidget(name)
    return box
