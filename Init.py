"""FreeCAD runs this at every start: it opens drawings, and lists the tests of the installation."""

import FreeCAD

FreeCAD.addImportType(
    "Engineering drawing to part (*.pdf *.dxf *.svg *.png *.jpg *.jpeg *.tif *.tiff *.bmp *.webp)",
    "freecad.gaussiancad.opening",
)
FreeCAD.__unit_test__ += ["freecad.gaussiancad.installed"]
