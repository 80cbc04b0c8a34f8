"""What the commands do: each loads its panel only now, so that FreeCAD starts quickly."""

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.commands.when import group_with_solutions, selected_reconstruction


def reconstruct() -> None:
    """Open the panel."""
    from freecad.gaussiancad.panels.reconstruct import ReconstructPanel

    FreeCADGui.Control.showDialog(ReconstructPanel())


def correct() -> None:
    """Open the canvas on the selected reconstruction's drawing, or on a file."""
    from freecad.gaussiancad.panels.correct import open_canvas

    open_canvas(FreeCADGui.Selection.getSelection())


def lines_to_sketches() -> None:
    """Read the selected reconstruction's drawing, or a file."""
    from freecad.gaussiancad.panels.lines_to_sketches import open_sketches

    open_sketches(FreeCADGui.Selection.getSelection())


def to_body() -> None:
    """Make a body of the selected solid, or say what to select."""
    from freecad.gaussiancad.panels.to_body import open_body

    open_body(FreeCADGui.Selection.getSelection())


def sheet_numbers() -> None:
    """Set the numbers back, of what is selected, or of all bodies."""
    from freecad.gaussiancad.objects.sheet_numbers import bodies_meant
    from freecad.gaussiancad.panels.numbers_back import take_back

    take_back(bodies_meant(FreeCAD.ActiveDocument, FreeCADGui.Selection.getSelection()))


def solutions() -> None:
    """Open the panel on the selected reconstruction, or on the last one."""
    from freecad.gaussiancad.panels.solutions import open_solutions

    group = group_with_solutions()
    if group is not None:
        open_solutions(group)


def compare() -> None:
    """Open the panel on the active document."""
    from freecad.gaussiancad.panels.compare import ComparePanel

    FreeCADGui.Control.showDialog(ComparePanel(FreeCAD.ActiveDocument))


def check() -> None:
    """Open the panel on the active document."""
    from freecad.gaussiancad.panels.check_drawing import CheckPanel

    FreeCADGui.Control.showDialog(CheckPanel(FreeCAD.ActiveDocument))


def failed_sheets() -> None:
    """Ask for the report of a batch, and list its sheets."""
    from freecad.gaussiancad.panels.failed_sheets import ask_report

    ask_report()


def run_again() -> None:
    """Open the panel on the selected reconstruction, and start."""
    from freecad.gaussiancad.panels.reconstruct import run_again as start

    chosen = selected_reconstruction()
    if chosen is not None:
        start(chosen)


def report() -> None:
    """Open the report of the selected reconstruction."""
    from freecad.gaussiancad.panels.report import ReportDialog

    chosen = selected_reconstruction()
    if chosen is not None:
        ReportDialog.open_for(chosen)


def check_engine() -> None:
    """Open the dialog."""
    from freecad.gaussiancad.panels.check_engine import CheckEngineDialog

    CheckEngineDialog.open_now()


def install_engine() -> None:
    """Open the dialog."""
    from freecad.gaussiancad.panels.install_engine import InstallEngineDialog

    InstallEngineDialog.open_now()
