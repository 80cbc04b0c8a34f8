"""``check.json``: whether a solid agrees with a drawing, as data."""

from collections.abc import Callable
from typing import Any

import msgspec
import numpy as np

from gaussiancad_core.judging.difference_kinds import Kind
from gaussiancad_core.judging.difference_places import Difference
from gaussiancad_core.judging.faceted_solids import Floats
from gaussiancad_core.judging.laying import Laid, Pose
from gaussiancad_core.judging.model_edits import Edit, as_message
from gaussiancad_core.judging.sheet_judgement import SheetJudgement
from gaussiancad_core.messages import event_fields

SCHEMA = 1

_KINDS = {
    Kind.MISSING: ("missing", "visible line"),
    Kind.MISSING_HIDDEN: ("missing", "hidden line"),
    Kind.EXTRA: ("extra", "visible line"),
    Kind.EXTRA_HIDDEN: ("extra", "hidden line"),
    Kind.LINETYPE: ("linetype", "line"),
    Kind.HATCHING: ("place", "hatched area"),
}
"""How kinds are named in the file, and of what they speak.  Smooth edges are no difference."""

_SILENT = {
    "fill": "the sheet shows the same without it",
    "move": "the sheet shows the same with it elsewhere",
    "shift": "no line of the sheet tells where along its axis it lies",
}
"""Why the sheet tells nothing of a feature, by the change that no line told."""

ToStored = Callable[[np.ndarray], np.ndarray]
"""(n, 2) px of the upright sheet to px of the sheet as stored."""


def check_values(
    found: SheetJudgement, to_stored: ToStored, scale_source: str, unused: list[dict[str, Any]]
) -> dict[str, Any]:
    """The content of ``check.json``.

    Args:
        found: the solid against the sheet.
        to_stored: places of the upright sheet to the sheet as stored.
        scale_source: how the sheet's scale is known.
        unused: what on the sheet was not used, as in ``report.json``.
    """
    return {
        "schema": SCHEMA,
        "verdict": found.judgement.verdict.value,
        "reasons": [
            event_fields(reason.code, reason.message) for reason in found.judgement.reasons
        ],
        "share": None if found.laid is None else round(found.laid.misfit.share, 5),
        "projection": None if found.evidence is None else found.evidence.projection.value,
        "pose": None if found.laid is None else _pose(found.laid, scale_source),
        "differences": [
            _difference(each, found, to_stored) for each in found.differences if each.kind in _KINDS
        ],
        "tally": [
            {
                "text": each.text,
                "kind": each.kind,
                "view": each.role,
                "at": [round(value, 4) for value in each.at],
                "count_stated": each.count_stated,
                "count_found": each.count_found,
                "agrees": each.agrees,
            }
            for each in found.tally
        ],
        "edits": [_edit(each, found.laid) for each in found.edits],
        "silent": [
            {"feature": each.feature, "at": each.start, "why": _SILENT[each.what]}
            for each in found.silent
        ],
        "unused": unused,
    }


def check_json(values: dict[str, Any]) -> bytes:
    """The file."""
    return msgspec.json.format(msgspec.json.encode(values), indent=2) + b"\n"


def _pose(laid: Laid, scale_source: str) -> dict[str, Any]:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = laid.pose.matrix, laid.pose.offset
    return {
        "matrix": [[round(value, 9) for value in row] for row in matrix.tolist()],
        "scale": round(laid.pose.scale, 6),
        "scale_source": scale_source,
    }


def _difference(each: Difference, found: SheetJudgement, to_stored: ToStored) -> dict[str, Any]:
    kind, what = _KINDS[each.kind]
    ends, pieces = np.array(each.ends), each.pieces.reshape(-1, 2)
    if found.evidence is not None:
        place = found.evidence.ink.placements[each.view.role]
        ends, pieces = (to_stored(place.to_sheet(points)) for points in (ends, pieces))
    return {
        "view": each.view.role.value,
        "kind": kind,
        "of": what,
        "ends": [[round(value, 2) for value in end] for end in ends.tolist()],
        "length_mm": round(each.mm, 4),
        "off_mm": None,
        "on_ink": None if each.on_ink is None else round(each.on_ink, 3),
        "pieces": np.round(pieces.reshape(-1, 2, 2), 1).tolist(),
        "model": [] if found.laid is None else _model_pieces(each, found.laid),
        "text": None,
        "stated": None,
        "measured": None,
    }


def _edit(each: Edit, laid: Laid | None) -> dict[str, Any]:
    start, end = (
        None if laid is None or place is None else _model_points(np.array(place), laid.pose)
        for place in (each.start, each.end)
    )
    return {
        "what": each.what,
        "feature": each.feature,
        "diameter_mm": None if each.diameter is None else round(each.diameter, 4),
        "from": each.start,
        "to": each.end,
        "model_from": start,
        "model_to": end,
        "mm": round(each.mm, 4),
        "message": str(as_message(each)),
    }


def _model_pieces(each: Difference, laid: Laid) -> list[Any]:
    """(n, 2, 3) mm in the model's own coordinates, ends of the pieces of line.

    A view tells no depth: they lie on the side of the model's box that is nearest to the viewer.
    """
    frame = each.view.role.frame
    right, up, look = (np.array(way, np.float64) for way in (frame.right, frame.up, frame.look))
    nearest = float(np.minimum(*(laid.solid.box * look)).sum())
    places = each.pieces @ np.stack([right, up]) + nearest * look
    return _model_points(places, laid.pose)


def _model_points(places: Floats, pose: Pose) -> list[Any]:
    """(..., 3) mm on the sheet's axes -> the same in the model's own coordinates."""
    points = (places - pose.offset) @ np.linalg.inv(pose.matrix).T
    return (np.round(points, 4) + 0.0).tolist()
