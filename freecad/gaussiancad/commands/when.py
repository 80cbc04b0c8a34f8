"""When a command can be used."""

import FreeCAD
import FreeCADGui

from freecad.gaussiancad.objects.known_sheets import reconstruction_among
from freecad.gaussiancad.objects.solutions import group_with_choice, has_choice


def always() -> bool:
    """Its window stands beside the others."""
    return True


def no_panel_is_open() -> bool:
    """No other task panel is open; a document is made if there is none."""
    return not FreeCADGui.Control.activeDialog()


def document_has_no_panel() -> bool:
    """A document is open, and no task panel."""
    return FreeCAD.ActiveDocument is not None and no_panel_is_open()


def selected_reconstruction() -> FreeCAD.DocumentObject | None:
    """The reconstruction that is selected, or of which something is."""
    return reconstruction_among(FreeCADGui.Selection.getSelection())


def reconstruction_is_selected() -> bool:
    """A reconstruction is selected, or something of it."""
    return selected_reconstruction() is not None


def reconstruction_can_run() -> bool:
    """The same, and no task panel is open."""
    return reconstruction_is_selected() and no_panel_is_open()


def group_with_solutions() -> FreeCAD.DocumentObject | None:
    """The selected reconstruction if it has a choice, else the last one that has."""
    selected = selected_reconstruction()
    if selected is not None and has_choice(selected):
        return selected
    return group_with_choice(FreeCAD.ActiveDocument)


def solutions_are_open() -> bool:
    """The document has a reconstruction with a choice, and no task panel is open."""
    return group_with_solutions() is not None and no_panel_is_open()


def body_has_sheet_numbers() -> bool:
    """The document has a body with numbers of a drawing."""
    from freecad.gaussiancad.objects.sheet_numbers import bodies_meant

    document = FreeCAD.ActiveDocument
    return document is not None and bool(bodies_meant(document, ()))
