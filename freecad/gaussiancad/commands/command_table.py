"""Every command: its name, its texts, when it is there, and what it does."""

from collections.abc import Callable
from dataclasses import dataclass

from freecad.gaussiancad.commands import opening_panels as panels
from freecad.gaussiancad.commands import when
from freecad.gaussiancad.language import QT_TRANSLATE_NOOP


@dataclass(frozen=True)
class Command:
    """A command as FreeCAD asks for it.

    Attributes:
        name: in FreeCAD, and of the translations.
        text: of the menu.
        tip: of the toolbar.
        active: whether it can be used now.
        activated: what it does.
        icon: its name; that of the command where empty.
    """

    name: str
    text: str
    tip: str
    active: Callable[[], bool]
    activated: Callable[[], None]
    icon: str = ""

    def GetResources(self) -> dict[str, str]:
        """Icon and texts."""
        return {"Pixmap": self.icon or self.name, "MenuText": self.text, "ToolTip": self.tip}

    def IsActive(self) -> bool:
        """Whether the command can be used now."""
        return self.active()

    def Activated(self) -> None:
        """Do what the command is for."""
        self.activated()


COMMANDS = (
    Command(
        "GaussianCAD_Reconstruct",
        QT_TRANSLATE_NOOP("GaussianCAD_Reconstruct", "Reconstruct from Drawing…"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_Reconstruct", "Creates a 3D part from a drawing with two or more views"
        ),
        when.no_panel_is_open,
        panels.reconstruct,
    ),
    Command(
        "GaussianCAD_Correct",
        QT_TRANSLATE_NOOP("GaussianCAD_Correct", "Correct Sheet…"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_Correct",
            "Shows what was understood of a drawing, lets it be corrected, and makes the part",
        ),
        when.always,
        panels.correct,
    ),
    Command(
        "GaussianCAD_LinesToSketches",
        QT_TRANSLATE_NOOP("GaussianCAD_LinesToSketches", "Lines to Sketches…"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_LinesToSketches",
            "Makes a sketch on its plane of the lines of each view, to model from by hand",
        ),
        when.no_panel_is_open,
        panels.lines_to_sketches,
    ),
    Command(
        "GaussianCAD_ToBody",
        QT_TRANSLATE_NOOP("GaussianCAD_ToBody", "To Body…"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_ToBody",
            "Makes an editable body, with sketches, pads and holes, of the selected solid",
        ),
        when.document_has_no_panel,
        panels.to_body,
    ),
    Command(
        "GaussianCAD_SheetNumbers",
        QT_TRANSLATE_NOOP("GaussianCAD_SheetNumbers", "Back to the Sheet's Numbers"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_SheetNumbers",
            "Sets all numbers of the body that the drawing tells back to the drawing's",
        ),
        when.body_has_sheet_numbers,
        panels.sheet_numbers,
    ),
    Command(
        "GaussianCAD_Solutions",
        QT_TRANSLATE_NOOP("GaussianCAD_Solutions", "Choose among Solutions…"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_Solutions",
            "Flips through the solids that all have the drawing's lines and keeps one",
        ),
        when.solutions_are_open,
        panels.solutions,
    ),
    Command(
        "GaussianCAD_Compare",
        QT_TRANSLATE_NOOP("GaussianCAD_Compare", "Compare with Reference…"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_Compare",
            "Measures how far a part or mesh is from another one and colours the difference",
        ),
        when.document_has_no_panel,
        panels.compare,
    ),
    Command(
        "GaussianCAD_Check",
        QT_TRANSLATE_NOOP("GaussianCAD_Check", "Check Against Drawing…"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_Check",
            "Tells whether a part, body or mesh agrees with its drawing, and shows where it does "
            "not",
        ),
        when.document_has_no_panel,
        panels.check,
    ),
    Command(
        "GaussianCAD_FailedSheets",
        QT_TRANSLATE_NOOP("GaussianCAD_FailedSheets", "Open Failed Sheets…"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_FailedSheets",
            "Steps through the sheets of a batch that failed or are approximate",
        ),
        when.always,
        panels.failed_sheets,
    ),
    Command(
        "GaussianCAD_RunAgain",
        QT_TRANSLATE_NOOP("GaussianCAD_RunAgain", "Run Again"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_RunAgain",
            "Reconstructs the drawing of what is selected again and updates the result",
        ),
        when.reconstruction_can_run,
        panels.run_again,
        "GaussianCAD_Reconstruct",
    ),
    Command(
        "GaussianCAD_Report",
        QT_TRANSLATE_NOOP("GaussianCAD_Report", "Report"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_Report",
            "Shows how far the part can be trusted, why, and what was read of the drawing",
        ),
        when.reconstruction_is_selected,
        panels.report,
        "GaussianCAD_Reconstruct",
    ),
    Command(
        "GaussianCAD_CheckEngine",
        QT_TRANSLATE_NOOP("GaussianCAD_CheckEngine", "Check Engine…"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_CheckEngine",
            "Shows where the engine is, what it lacks and what to do about it",
        ),
        when.always,
        panels.check_engine,
    ),
    Command(
        "GaussianCAD_InstallEngine",
        QT_TRANSLATE_NOOP("GaussianCAD_InstallEngine", "Install Engine…"),
        QT_TRANSLATE_NOOP(
            "GaussianCAD_InstallEngine",
            "Downloads and installs the engine into an environment of its own",
        ),
        when.always,
        panels.install_engine,
    ),
)
"""In the order of the toolbar."""
