"""From the strokes of a file to those of a sheet: in mm of paper, whole, each with its label."""
