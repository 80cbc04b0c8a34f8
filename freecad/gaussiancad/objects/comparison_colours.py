"""The colours of a comparison's mesh and its legend, for a range that the user chooses."""

import tempfile
from pathlib import Path

import FreeCAD

from freecad.gaussiancad.objects.appearance import show_vertex_colours
from freecad.gaussiancad.objects.legend import DeviationRange, colour_at, legend_image

Colour = tuple[float, float, float]

_STEPS = 512
"""Colours on either side of the middle: more than eyes or screens tell apart."""


def colours_of(values: list[float], limit: float) -> list[Colour]:
    """The colour of each value in mm; those beyond the limit get the end's."""
    table = [
        tuple(channel / 255.0 for channel in colour_at(place / _STEPS))
        for place in range(-_STEPS, _STEPS + 1)
    ]
    scale, most = _STEPS / limit, 2 * _STEPS
    return [table[min(max(round(value * scale) + _STEPS, 0), most)] for value in values]


def recolour(group: FreeCAD.DocumentObject, limit: float) -> None:
    """Colour a comparison's mesh anew, and write its legend; nothing where values are missing."""
    mesh = next((each for each in group.Group if hasattr(each, "Deviations")), None)
    if mesh is None or limit <= 0.0 or len(mesh.Deviations) != mesh.Mesh.CountPoints:
        return
    mesh.VertexColors = colours_of(mesh.Deviations, limit)
    signed = min(mesh.Deviations, default=0.0) < 0.0
    legend = next((each for each in group.Group if each.TypeId == "Image::ImagePlane"), None)
    if legend is not None:
        with tempfile.TemporaryDirectory(prefix="gaussiancad-") as folder:
            path = Path(folder) / "legend.png"
            scale = DeviationRange(limit, signed)
            legend_image(scale, with_text=bool(FreeCAD.GuiUp)).save(str(path))
            legend.ImageFile = str(path)
    if FreeCAD.GuiUp:
        show_vertex_colours(mesh)
