"""How a model's own lines agree with the sheet's, and the pictures of it."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.evidence.projected_reading import drawn_views
from gaussiancad_core.judging.difference_places import Difference
from gaussiancad_core.kernel.brep import bounding_box, soundness, tessellate
from gaussiancad_core.labelling.conflict_lines import Conflict
from gaussiancad_core.lines.line_agreement import STEPS_PER_TOLERANCE, MatchedLines, match_lines
from gaussiancad_core.lines.mesh_lines import redraw_mesh
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.meshes import TriangleMesh
from gaussiancad_core.pictures.overlay import (
    OverlaidLines,
    ViewOverlay,
    draw_overlay,
    matched_overlay,
)
from gaussiancad_core.pictures.png_pictures import png_bytes
from gaussiancad_core.pictures.preview import render_preview
from gaussiancad_core.report.report_entries import SolidReport
from gaussiancad_core.run.exact_stage import ExactModel
from gaussiancad_core.run.solid_judgement import ADDED, counted_differences
from gaussiancad_core.sheet.annotations.annotation_marks import Mark
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_core.sheet.special_views.view_kinds import SpecialView
from gaussiancad_core.solid.verify import matching_tolerance
from gaussiancad_protocol.codes import Code

SURFACE_TOLERANCE_PX = 3.0
"""px of the sheet within which a line of a surface is the sheet's line.

A surface rounds its edges by about a hundredth of its size, so lines are matched to about the
width of a stroke.
"""

_EXPLAINED = 0.95
"""Share of the lines that has to agree for a view to be called explained by a surface."""

_PREVIEW_DEFLECTION = 5e-4
"""Deviation of the preview's triangles, as a share of the longest extent."""

_NO_POINTS = np.zeros((0, 2))

_NO_SOLID = (
    Code.NO_EXACT_SOLID,
    "the model is a surface around the space that the outlines, and depths where they are known, "
    "leave, not an exact solid: measure nothing from it that the sheet dimensions",
)


@dataclass(frozen=True, eq=False)
class CheckedModel:
    """A model beside the sheet.

    Attributes:
        mesh: what the preview shows, mm.
        matched: its lines and the sheet's, of each view.
        overlaid: the same as a picture has them.
        tolerance_px: within which they were matched.
        reasons: (code, sentence) why the model is not verified, beyond what is known.
    """

    mesh: TriangleMesh
    matched: Mapping[Role, MatchedLines]
    overlaid: Mapping[Role, OverlaidLines]
    tolerance_px: float
    reasons: tuple[tuple[str, str], ...] = ()


def check_solid(registered: RegisteredSheet, model: ExactModel) -> CheckedModel:
    """A solid, whose lines were matched when it was found, and that was judged since."""
    result = model.result
    tolerance = matching_tolerance(drawn_views(registered))
    low, high = bounding_box(result.shape)
    deflection = _PREVIEW_DEFLECTION * float((high - low).max())
    vertices, triangles = tessellate(result.shape, deflection)
    mesh = TriangleMesh(vertices.astype(np.float64), triangles)
    matched = result.checked.matched
    differing = counted_differences(model.judged) if model.judged is not None else ()
    overlaid = {
        role: _overlaid(lines, [each for each in differing if each.view.role is role], tolerance)
        for role, lines in matched.items()
    }
    return CheckedModel(mesh, matched, overlaid, round(tolerance / registered.mm_per_pixel, 3))


def _overlaid(
    matched: MatchedLines, differing: Iterable[Difference], tolerance: float
) -> OverlaidLines:
    """The lines of a solid, and where the judge finds that they differ from the sheet's."""
    missing, extra = (
        [_along(each, tolerance) for each in differing if (each.kind in ADDED) is added]
        for added in (False, True)
    )
    beyond = np.concatenate(extra) if extra else _NO_POINTS
    agreeing = (matched.result.visible.points, matched.result.hidden.points)
    if len(beyond):
        tree = cKDTree(beyond)
        agreeing = tuple(points[tree.query(points)[0] > tolerance] for points in agreeing)
    return OverlaidLines(*agreeing, np.concatenate(missing) if missing else _NO_POINTS, beyond)


def _along(difference: Difference, step: float) -> npt.NDArray[np.float64]:
    """(n, 2) points along the pieces of a difference, mm."""
    start, end = difference.pieces[:, 0], difference.pieces[:, 1]
    longest = float(np.hypot(*(end - start).T).max())
    shares = np.linspace(0.0, 1.0, max(2, int(longest / step * STEPS_PER_TOLERANCE)))
    return (start[:, None] + shares[None, :, None] * (end - start)[:, None]).reshape(-1, 2)


def solid_report(model: ExactModel) -> SolidReport:
    """Facts of a solid."""
    result = model.result
    facts = soundness(result.shape)
    low, high = bounding_box(result.shape)
    size = high - low
    return SolidReport(
        facts.valid,
        facts.closed,
        facts.faces,
        facts.volume_mm3,
        (float(size[0]), float(size[1]), float(size[2])),
        len(result.alternatives),
        "sketch" if model.is_sketched else "lines",
        round(result.checked.share, 4),
    )


def check_surface(
    registered: RegisteredSheet, surface: TriangleMesh, progress: Callable[[float], None]
) -> CheckedModel:
    """Draw a surface again and match its lines with the sheet's."""
    pitch = registered.mm_per_pixel
    views = registered.views.views
    matched: dict[Role, MatchedLines] = {}
    for index, view in enumerate(views):
        lines = redraw_mesh(surface, view.role, pitch)
        matched[view.role] = match_lines(view.strokes, lines, SURFACE_TOLERANCE_PX * pitch)
        progress((index + 1) / (len(views) + 1))
    unexplained = [
        role.value for role, match in matched.items() if match.agreement.worst < _EXPLAINED
    ]
    reasons = [_NO_SOLID]
    if unexplained:
        reasons.append(
            (
                Code.LINES_UNEXPLAINED,
                Message(
                    "the surface does not show all lines of the {views} view(s), or shows others: "
                    "see overlay.png",
                    case="surface",
                    views=", ".join(unexplained),
                ),
            )
        )
    overlaid = {role: matched_overlay(lines) for role, lines in matched.items()}
    return CheckedModel(surface, matched, overlaid, SURFACE_TOLERANCE_PX, tuple(reasons))


def overlay_picture(
    checked: CheckedModel,
    registered: RegisteredSheet,
    clean: CleanSheet,
    adjacent: tuple[tuple[Mark, ...], tuple[SpecialView, ...]],
    conflict: Conflict | None = None,
) -> bytes:
    """PNG of the sheet with the model's lines over it, and what else was found on it."""
    contradicting = conflict.lines if conflict else ()
    overlays = [
        ViewOverlay(
            view,
            registered.views.size,
            checked.overlaid[view.role],
            tuple(line for line in contradicting if line.role is view.role),
        )
        for view in registered.views.views
    ]
    return png_bytes(draw_overlay(clean.picture, overlays, *adjacent))


def preview_picture(checked: CheckedModel, colour: tuple[int, int, int]) -> bytes:
    """PNG of the model, shaded."""
    return png_bytes(render_preview(checked.mesh, colour))
