"""What lengths are in, and how long they may be."""

MM_PER_INCH = 25.4
"""An inch is defined by millimetres."""

LEAST_MM = 1e-9
"""Of anything that is told, mm a pixel as well."""

SHORTEST_MM, LONGEST_MM = 1e-3, 1e6
"""Longest side of the parts that are built: the kernel tells points apart that are 1e-7 mm apart,
and computes with sixteen digits."""
