"""File formats of sheets, one module a kind.

:func:`gaussiancad_core.sheet.image.sheet_files.read_sheet` is the only way in.
"""
