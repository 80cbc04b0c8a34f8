"""How well a solid explains a sheet, in mm of line, and why."""
