"""``check.json``: whether a solid agrees with a drawing, as data."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import msgspec
import numpy as np

from gaussiancad_core.judging.difference_kinds import Kind
from gaussiancad_core.judging.difference_places import Difference
from gaussiancad_core.judging.faceted_solids import Floats
from gaussiancad_core.judging.laying import Laid, Pose
from gaussiancad_core.judging.model_edits import Edit, as_message
from gaussiancad_core.judging.note_tally import Tally
from gaussiancad_core.judging.number_tally import Ends, NumberDifference
from gaussiancad_core.judging.sheet_judgement import SheetJudgement
from gaussiancad_core.messages import event_fields
from gaussiancad_core.model.axes import Role

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
    places = _Places(found, to_stored)
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
            *(_note(each, places) for each in found.tally if not each.agrees),
            *(_difference(each, places) for each in found.differences if each.kind in _KINDS),
            *(_number(each, places) for each in found.numbers),
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


@dataclass(frozen=True, eq=False)
class _Places:
    """Where places of views lie.

    Attributes:
        found: the solid against the sheet.
        to_stored: places of the upright sheet to the sheet as stored.
    """

    found: SheetJudgement
    to_stored: ToStored

    def on_sheet(self, role: Role, points: Floats) -> Floats:
        """(n, 2) px of the sheet as stored."""
        if self.found.evidence is None:
            return points
        return self.to_stored(self.found.evidence.ink.placements[role].to_sheet(points))

    def on_model(self, role: Role, pieces: Floats) -> list[Any]:
        """(n, 2, 3) mm in the model's own coordinates, ends of the pieces of line.

        A view tells no depth: they lie on the side of the model's box that is nearest to the
        viewer.
        """
        if self.found.laid is None:
            return []
        frame, laid = role.frame, self.found.laid
        right, up, look = (np.array(way, np.float64) for way in (frame.right, frame.up, frame.look))
        nearest = float(np.minimum(*(laid.solid.box * look)).sum())
        places = pieces @ np.stack([right, up]) + nearest * look
        return _model_points(places, laid.pose)


def _placed(role: Role, pieces: Floats, ends: Ends, places: _Places) -> dict[str, Any]:
    """Where a difference is, and nothing of what it is about."""
    on_sheet = places.on_sheet(role, pieces.reshape(-1, 2))
    return {
        "view": role.value,
        "ends": np.round(places.on_sheet(role, np.array(ends)), 2).tolist(),
        "off_mm": None,
        "on_ink": None,
        "pieces": np.round(on_sheet.reshape(-1, 2, 2), 1).tolist(),
        "model": places.on_model(role, pieces),
        "text": None,
        "stated": None,
        "measured": None,
    }


def _difference(each: Difference, places: _Places) -> dict[str, Any]:
    kind, what = _KINDS[each.kind]
    return {
        **_placed(each.view.role, each.pieces, each.ends, places),
        "kind": kind,
        "of": what,
        "length_mm": round(each.mm, 4),
        "on_ink": None if each.on_ink is None else round(each.on_ink, 3),
    }


def _number(each: NumberDifference, places: _Places) -> dict[str, Any]:
    factor, what = (2.0, "diameter") if each.is_radius else (1.0, "length")
    stated, measured = factor * each.stated, factor * each.measured
    return {
        **_placed(each.role, np.array([each.ends]), each.ends, places),
        "kind": "number",
        "of": what,
        "length_mm": round(stated, 4),
        "off_mm": round(measured - stated, 4),
        "text": f"{stated:.6g}",
        "stated": round(stated, 4),
        "measured": round(measured, 4),
    }


def _note(each: Tally, places: _Places) -> dict[str, Any]:
    ends = each.at, each.at
    return {
        **_placed(Role(each.role), np.array([ends]), ends, places),
        "kind": "note",
        "of": each.kind,
        "length_mm": 0.0,
        "text": each.text,
        "stated": each.count_stated,
        "measured": each.count_found,
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


def _model_points(places: Floats, pose: Pose) -> list[Any]:
    """(..., 3) mm on the sheet's axes -> the same in the model's own coordinates."""
    points = (places - pose.offset) @ np.linalg.inv(pose.matrix).T
    return (np.round(points, 4) + 0.0).tolist()
