"""What the strokes of a sheet stand for, told by how they lie to each other."""
