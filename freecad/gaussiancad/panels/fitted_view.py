"""The 3D view of a document, turned and fitted to all that is in it."""

import FreeCAD
import FreeCADGui


def show_all(document: FreeCAD.Document) -> None:
    """Fit the document's 3D view; a window that shows something else stays as it is."""
    view = FreeCADGui.getDocument(document.Name).ActiveView
    # A drawing page can be fitted too, but not turned.
    if not hasattr(view, "viewIsometric"):
        return
    # An animated turn would overtake the fit (FreeCAD 1.1).
    animated = view.isAnimationEnabled()
    view.setAnimationEnabled(False)
    view.viewIsometric()
    view.fitAll()
    view.setAnimationEnabled(animated)
