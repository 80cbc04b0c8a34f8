"""A drawing sheet: from a raster file to clean strokes and masks of named views."""
