"""GaussianCAD inside FreeCAD: from a three-view drawing to a measured part.

This package starts the engine in a process of its own and imports nothing heavy.  FreeCAD imports
it at every start, with and without a window, so that it must stay empty.
"""
