"""Find, start, watch and stop the engine, and read what it leaves.  No FreeCAD in here."""
