"""Clean sheets of three views in third angle."""

from pathlib import Path

from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.draw_command import write_image
from gaussiancad_core.drawing.drawn_sheet import draw_sheet
from gaussiancad_core.drawing.sheet_style import parse_style
from gaussiancad_core.model.axes import Projection, Role

ROLES = (Role.FRONT, Role.TOP, Role.RIGHT)
"""The views that drawings in third angle have."""


def draw_clean(part: TopoDS_Shape, path: Path) -> Path:
    """Draw a part into a file."""
    write_image(draw_sheet(part, ROLES, Projection.THIRD, parse_style("clean")).image, path)
    return path
