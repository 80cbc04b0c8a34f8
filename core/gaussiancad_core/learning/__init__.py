"""How the labels network comes about: sheets are drawn, it is trained on them, checked, written.

    python -m gaussiancad_core.learning --help

Nothing here is needed to read a sheet.
"""
