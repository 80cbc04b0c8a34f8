"""FreeCAD runs this when its window opens."""

from freecad.gaussiancad import workbench

workbench.register()
