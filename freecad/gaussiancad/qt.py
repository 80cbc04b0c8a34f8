"""Qt through FreeCAD's shim, and through PySide6 where FreeCAD is not around.

FreeCAD 0.20 offers its widgets in ``PySide.QtGui`` only (PySide2 underneath), 1.x in both places
(PySide6).  Everything here imports Qt from this module.  Enums are written with their full scope,
which both accept.
"""

try:
    from PySide import QtCore, QtGui

    QtWidgets = QtGui
except ImportError:
    from PySide6 import QtCore, QtGui, QtWidgets

__all__ = ["QtCore", "QtGui", "QtWidgets"]
