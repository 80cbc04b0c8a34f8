"""How a part is put together of features, as data: ``construction.json``.

Features in order, each with the outlines between its ends or the profile that is turned, and the
breaks of edges that are put on last: what a body needs that one can edit.
"""

from collections.abc import Iterable
from typing import Any

from gaussiancad_core.model.axes import Axis
from gaussiancad_core.proposing.edge_runs import EdgeRun, prism_rings, profile_runs
from gaussiancad_core.proposing.lines_by_plane import PlaneSheet
from gaussiancad_core.proposing.part_features import Prism, Turned, single_features
from gaussiancad_core.proposing.proposed_part import ProposedPart

SCHEMA = "gaussiancad-construction/2"

_DIGITS = 6
"""Decimal places of its numbers, mm."""

Values = dict[str, Any]


def construction_of(part: ProposedPart) -> Values:
    """How a part is put together, as plain values.

    Coordinates of outlines are mm in the plane across their axis, in the order x, y, z; those of
    profiles are mm away from the axis and along it.
    """
    return {
        "schema": SCHEMA,
        "unexplained_mm": round(part.cost, 3),
        "features": [
            {
                "operation": operation.name.lower(),
                "parts": [_part(each, part.sheet) for each in single_features(feature)],
            }
            for operation, feature in part.features
        ],
        "breaks": [
            {
                "axis": _name(each.axis),
                "at": round(each.at, 3),
                "width": round(each.width, 3),
                "height": round(each.height, 3),
                "is_round": each.is_round,
            }
            for each in part.breaks
        ],
    }


def _part(feature: Prism | Turned, sheet: PlaneSheet) -> Values:
    axis = _name(feature.axis)
    if isinstance(feature, Turned):
        edges = _edges(profile_runs(feature, sheet.tolerance))
        return {"kind": "turned", "axis": axis, "centre": _rounded(feature.centre), "edges": edges}
    loops = [
        {"is_hole": number > 0, "edges": _edges(runs)}
        for number, runs in enumerate(prism_rings(feature, sheet))
    ]
    low, high = _rounded((feature.low, feature.high))
    return {"kind": "prism", "axis": axis, "low": low, "high": high, "loops": loops}


def _edges(runs: Iterable[EdgeRun]) -> list[Values]:
    return [_edge(run) for run in runs]


def _edge(run: EdgeRun) -> Values:
    """An edge's kind and ends, of an arc or a circle what it lies on, of a curve its corners."""
    first, *between, last = ([*_rounded(corner)] for corner in run.corners.tolist())
    found: Values = {"kind": run.kind.value, "start": first, "end": last}
    if run.circle is not None:
        x, y, radius = _rounded(run.circle)
        found |= {"centre": [x, y], "radius": radius, "middle": [*_rounded(run.middle.tolist())]}
    elif between:
        found["through"] = between
    return found


def _name(axis: Axis) -> str:
    return axis.name.lower()


def _rounded(values: Iterable[float]) -> tuple[float, ...]:
    return tuple(round(float(value), _DIGITS) for value in values)
