"""The sheet as it was understood, and a person's word on it: Qt alone, without FreeCAD."""
