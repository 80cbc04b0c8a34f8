"""A reading of a sheet as a file: written, corrected by a person, taken instead of reading."""
