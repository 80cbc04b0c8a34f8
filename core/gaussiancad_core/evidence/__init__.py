"""What a sheet says of its part in millimetres: sections, notes, dimensions, projection, noise."""
