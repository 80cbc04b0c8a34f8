"""What the engine and those who start it agree on: codes, exit codes, modes, kinds.

The workbench uses this package inside FreeCAD's Python, the engine in a process of its own.  It
needs Python's standard library alone, from 3.10 on.
"""
