"""The commands of toolbar and menus."""


def register() -> None:
    """Make the commands known to FreeCAD; a second call does nothing."""
    import FreeCADGui

    from freecad.gaussiancad.commands.command_table import COMMANDS

    known = FreeCADGui.listCommands()
    for command in COMMANDS:
        if command.name not in known:
            FreeCADGui.addCommand(command.name, command)
