"""Lines of a solid that the sheet has as ink, though it was taken for annotation.

A label is a guess; a sound solid that all other lines tell, and that has an edge just where a line
was dropped, knows better.  Such a line is no longer one that the sheet lacks; that its label was
wrong is said instead.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace

import numpy as np
import numpy.typing as npt
from scipy.spatial import cKDTree

from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Role
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.labels.label_evidence import SheetLabels
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.sheet_stages import RegisteredSheet
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.verify import Flaw
from gaussiancad_protocol.codes import Code

_STEP = 1.0
"""px between the places along a line that are asked for."""

_SHARE = 0.9
"""Share of a line that lies along dropped ones at least: they end short where others cross."""

_MOST_PLACES = 5
"""Boxes that the message names at most."""


def with_dropped_lines(result: ExactResult, registered: RegisteredSheet, turn: Turn) -> ExactResult:
    """The same, lines that lie along dropped ones no longer counted as what the sheet lacks.

    Args:
        result: the solid of the sheet.
        registered: its views, with the labels of their lines.
        turn: of the sheet.
    """
    verification = result.verification
    if verification is None or not verification.flaws:
        return result
    dropped = _dropped_points(registered)
    found = {
        flaw: box
        for flaw in verification.flaws
        if (box := _box_along(flaw, registered, dropped)) is not None
    }
    if not found:
        return result
    rest = tuple(flaw for flaw in verification.flaws if flaw not in found)
    reasons = [reason for reason in result.reasons if reason[0] != Code.LINES_UNEXPLAINED]
    if rest:
        reasons = list(result.reasons)
    message = _doubt([turn.box_to_stored(box) for box in found.values()])
    return replace(
        result,
        verification=replace(verification, flaws=rest),
        reasons=(*reasons, (Code.LABELS_DOUBTFUL, message)),
    )


def _dropped_points(registered: RegisteredSheet) -> Mapping[Role, cKDTree]:
    """The points, px of the upright sheet, of what was taken for annotation in each view."""
    points = {view.role: list(_points_of(view.labels)) for view in registered.drawn}
    return {role: cKDTree(np.concatenate(each)) for role, each in points.items() if each}


def _points_of(labels: SheetLabels) -> Iterator[npt.NDArray[np.float64]]:
    return (line.points for line in labels.lines if not line.is_part)


def _box_along(
    flaw: Flaw, registered: RegisteredSheet, dropped: Mapping[Role, cKDTree]
) -> Box | None:
    """Where a straight line that the sheet lacks lies along dropped ones, px; None elsewhere."""
    if flaw.missing or flaw.ends is None or flaw.role not in dropped:
        return None
    ends = registered.placements[flaw.role].to_sheet(np.array(flaw.ends))
    count = max(2, int(np.hypot(*(ends[1] - ends[0])) / _STEP) + 1)
    places = ends[0] + np.linspace(0.0, 1.0, count)[:, None] * (ends[1] - ends[0])
    width = next(view.labels.stroke_width for view in registered.drawn if view.role is flaw.role)
    away = dropped[flaw.role].query(places)[0]
    if (away <= width).mean() < _SHARE:
        return None
    (x0, y0), (x1, y1) = places.min(axis=0).tolist(), places.max(axis=0).tolist()
    return x0, y0, x1, y1


def _doubt(boxes: list[Box]) -> Message:
    places = ("({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*box) for box in boxes[:_MOST_PLACES])
    return Message(
        "{count} line(s) may be edges of the part or annotation, at {places} px",
        boxes=boxes,
        count=len(boxes),
        places="; ".join(places),
    )
