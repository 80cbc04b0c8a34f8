"""A file to an upright, evenly lit picture of a sheet, and its ink."""
