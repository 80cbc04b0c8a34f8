"""The commands of toolbar and menus, one a file."""


def register() -> None:
    """Make the commands known to FreeCAD; a second call does nothing."""
    import FreeCADGui

    from freecad.gaussiancad.commands.check_engine import CheckEngineCommand
    from freecad.gaussiancad.commands.compare import CompareCommand
    from freecad.gaussiancad.commands.correct import CorrectCommand
    from freecad.gaussiancad.commands.failed_sheets import FailedSheetsCommand
    from freecad.gaussiancad.commands.install_engine import InstallEngineCommand
    from freecad.gaussiancad.commands.lines_to_sketches import LinesToSketchesCommand
    from freecad.gaussiancad.commands.reconstruct import ReconstructCommand
    from freecad.gaussiancad.commands.report import ReportCommand
    from freecad.gaussiancad.commands.run_again import RunAgainCommand
    from freecad.gaussiancad.commands.sheet_numbers import SheetNumbersCommand
    from freecad.gaussiancad.commands.solutions import SolutionsCommand
    from freecad.gaussiancad.commands.to_body import ToBodyCommand

    known = FreeCADGui.listCommands()
    for command in (
        ReconstructCommand,
        CorrectCommand,
        LinesToSketchesCommand,
        ToBodyCommand,
        SheetNumbersCommand,
        SolutionsCommand,
        CompareCommand,
        FailedSheetsCommand,
        RunAgainCommand,
        ReportCommand,
        CheckEngineCommand,
        InstallEngineCommand,
    ):
        if command.name not in known:
            FreeCADGui.addCommand(command.name, command())
