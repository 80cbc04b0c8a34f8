"""What lengths are in: one inch is defined by millimetres."""

MM_PER_INCH = 25.4
