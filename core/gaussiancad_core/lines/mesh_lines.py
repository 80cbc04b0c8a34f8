"""A line drawing of a triangle mesh, by rays, for the comparison with a sheet.

Neighbouring pixels are compared; where what their rays cross differs, a line runs between them.
Meshes of Gaussians (Poisson) have no sharp edges: they round them over about 1 % of their size.
In those also pixels a few apart are compared, which finds edges that bend over that distance, and
what lies that close to a step counts as the rounding of the same edge.
"""

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.skeletons import skeleton
from gaussiancad_core.lines.line_points import LinePoints, Lines
from gaussiancad_core.lines.mesh_crossings import (
    Layers,
    Rule,
    compare_columns,
    compare_rows,
    layers_of,
)
from gaussiancad_core.lines.mesh_rays import RayCaster, RayGrid
from gaussiancad_core.lines.tessellation_quality import is_rounded, triangle_normals
from gaussiancad_core.lines.two_rays import Difference
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.meshes import TriangleMesh

Mask = npt.NDArray[np.bool_]

_DRAWN = (
    Difference.VISIBLE_STEP,
    Difference.VISIBLE_BEND,
    Difference.HIDDEN_STEP,
    Difference.HIDDEN_BEND,
)
"""What is drawn of a mesh, which has no smooth edges."""


@dataclass(frozen=True)
class RedrawSettings:
    """How a mesh is drawn.

    Attributes:
        most_pixels: longest side of the ray grid, px; a finer pitch is made coarser.
        sharp_degrees: bend that is a line on a mesh with sharp edges; above that of the facets of
            its curved surfaces.
        round_degrees: bend over the rounding that is a line on a mesh with rounded edges.
        rounding: width of a rounded edge, as a share of the mesh's longest edge.
        shortest: px; shorter lines are taken for noise of the surface.
    """

    most_pixels: int = 900
    sharp_degrees: float = 20.0
    round_degrees: float = 30.0
    rounding: float = 0.012
    shortest: int = 6


def redraw_mesh(
    mesh: TriangleMesh, role: Role, pitch: float, settings: RedrawSettings = RedrawSettings()
) -> Lines:
    """Draw a mesh in a principal view.

    Args:
        mesh: in model axes, mm.
        role: the view.
        pitch: mm per pixel, as of the sheet's view.
        settings: of the drawing.

    Returns:
        One point per pixel of line, in mm of the view's plane.  A hidden line under a visible one
        is left out.
    """
    grid = _grid_around(mesh, role, pitch, settings.most_pixels)
    visible, hidden = line_masks(mesh, grid, settings)
    return Lines(_line_points(visible, grid), _line_points(hidden, grid))


def line_masks(
    mesh: TriangleMesh, grid: RayGrid, settings: RedrawSettings = RedrawSettings()
) -> tuple[Mask, Mask]:
    """(h + 1, w + 1) visible and hidden lines, one wide, at the corners between the grid's pixels.

    Corner (0, 0) is the grid's upper left corner.
    """
    rounded = is_rounded(mesh)
    hits = RayCaster(mesh).all_hits(grid)
    layers = layers_of(hits, triangle_normals(mesh, smoothed=rounded), grid)
    crease = np.cos(np.radians(settings.round_degrees if rounded else settings.sharp_degrees))
    near = _corner_masks(layers, Rule(1, float(crease), True))
    reach = 0
    if rounded:
        size_px = float(np.ptp(mesh.bounds, axis=0).max()) / grid.pitch
        reach = 2 * int(np.ceil(settings.rounding * size_px / 2.0)) + 1
        wide = _corner_masks(layers, Rule(reach, float(crease), False))
        near = {kind: near[kind] | wide[kind] for kind in _DRAWN}
    visible = _thin_lines(near[Difference.VISIBLE_STEP], near[Difference.VISIBLE_BEND], reach)
    hidden = _thin_lines(
        near[Difference.HIDDEN_STEP] & ~_grown(visible, 2 + bool(reach)),
        near[Difference.HIDDEN_BEND] & ~_grown(visible, max(2, 3 * reach // 2)),
        reach,
    )
    shortest = max(settings.shortest, 2 * reach)
    return _without_specks(visible, shortest), _without_specks(hidden, shortest)


def _grid_around(mesh: TriangleMesh, role: Role, pitch: float, most: int) -> RayGrid:
    frame = role.frame
    across, along = mesh.vertices @ frame.right, mesh.vertices @ frame.up
    longest = max(np.ptp(across), np.ptp(along))
    pitch = max(pitch, longest / most)
    margin = 4.0 * pitch
    area = (
        float(across.min()) - margin,
        float(along.min()) - margin,
        float(across.max()) + margin,
        float(along.max()) + margin,
    )
    return RayGrid.of_view(role, area, pitch)


def _corner_masks(layers: Layers, rule: Rule) -> dict[Difference, Mask]:
    """The lines of each kind, marked at both corners of the pixels' common side."""
    upright, level = compare_rows(layers, rule), compare_columns(layers, rule)
    masks = {}
    for kind in _DRAWN:
        mask = np.zeros((layers.height + 1, layers.width + 1), dtype=bool)
        mask[:-1] |= upright == kind
        mask[1:] |= upright == kind
        mask[:, :-1] |= level == kind
        mask[:, 1:] |= level == kind
        masks[kind] = mask
    return masks


def _thin_lines(steps: Mask, bends: Mask, reach: int) -> Mask:
    """Lines one wide; with a reach, bends within it of a step belong to the step."""
    if not reach:
        return skeleton(steps | bends)
    outlines = skeleton(_closed(steps))
    apart = bends & ~_grown(outlines, 3 * reach // 2)
    return outlines | skeleton(_closed(apart))


def _closed(mask: Mask) -> Mask:
    """Without the small holes and notches that bumps of a surface leave."""
    import cv2

    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (5, 5))
    # Padded, or closing would lose what lies at the border.
    padded = np.pad(mask.astype(np.uint8), 4)
    return cv2.morphologyEx(padded, cv2.MORPH_CLOSE, kernel)[4:-4, 4:-4] > 0


def _grown(mask: Mask, radius: int) -> Mask:
    import cv2

    kernel = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (2 * radius + 1, 2 * radius + 1))
    return cv2.dilate(mask.astype(np.uint8), kernel) > 0


def _without_specks(mask: Mask, shortest: int) -> Mask:
    import cv2

    _, labels, facts, _ = cv2.connectedComponentsWithStats(mask.astype(np.uint8), connectivity=8)
    long = facts[:, cv2.CC_STAT_AREA] >= shortest
    long[0] = False
    return long[labels]


def _line_points(mask: Mask, grid: RayGrid) -> LinePoints:
    rows, columns = np.nonzero(mask)
    points = grid.plane(np.stack([columns, rows], axis=1).astype(np.float64))
    return LinePoints(points, np.full(len(points), grid.pitch))
