"""FreeCAD runs this at every start, with and without a window; there is nothing to prepare."""
