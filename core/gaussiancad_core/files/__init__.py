"""File formats of sheets, one module a kind; :func:`gaussiancad_core.sheet.read.read_sheet` is the
only way in."""
