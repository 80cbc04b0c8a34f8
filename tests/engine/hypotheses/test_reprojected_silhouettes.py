"""Slanted lines that follow from the oblique planes whose edges they are, or from cones."""

from itertools import pairwise
from math import pi

import numpy as np
import pytest

from gaussiancad_core.coordinates.carriers import PartCarriers, find_carriers
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.hypotheses.oblique_planes import find_half_spaces
from gaussiancad_core.hypotheses.reprojected_silhouettes import retraced
from gaussiancad_core.hypotheses.revolution_candidates import find_bodies
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.projection_planes import IN_PLANE
from gaussiancad_core.model.views import Arc, Linetype, Segment

_ROLES = {Role.FRONT: (100.0, 60.0), Role.TOP: (100.0, 80.0), Role.RIGHT: (80.0, 60.0)}
"""Extents of the views of a block of 100 x 80 x 60 mm, which are units as well."""


def _supports(misread: float, tolerance: float) -> PartCarriers:
    """A block whose corner is cut off; the views tell where the cut ends with opposite errors."""
    cuts = {
        Role.FRONT: ((70.0 + misread, 60.0), (100.0, 42.0 - misread)),
        Role.TOP: ((70.0 - misread, 0.0), (100.0, 36.0 + misread)),
        Role.RIGHT: ((0.0, 42.0 + misread), (36.0 - misread, 60.0)),
    }
    strokes = {}
    for role, (a, b) in _ROLES.items():
        corners = [(0.0, 0.0), (a, 0.0), (a, b), (0.0, b), (0.0, 0.0)]
        ends = [*pairwise(corners), cuts[role]]
        strokes[role] = tuple(Segment(p, q, Linetype.VISIBLE) for p, q in ends)
    return find_carriers(DrawnViews(strokes, (100.0, 80.0, 60.0), tolerance))


def _slant(carriers: PartCarriers, axis: Axis) -> tuple[Line, list[tuple[float, float]]]:
    """The slanted line of a view, and its two ends."""
    (found,) = (s for s in carriers.planes[axis].carriers if s.curve.axis is None)
    assert isinstance(found.curve, Line)
    ((low, high),) = found.drawn()
    return found.curve, [found.curve.at(low), found.curve.at(high)]


def test_views_that_disagree_a_little_show_the_edges_of_one_plane() -> None:
    carriers = _supports(0.1, 0.2)
    bodies = find_half_spaces(carriers)
    assert len(bodies) == 1
    moved = retraced(carriers, bodies)
    corners = np.array(bodies[0].hulls[0])
    assert corners @ np.array(bodies[0].normal) == pytest.approx(bodies[0].offset, abs=1e-9)
    for axis in Axis:
        curve, ends = _slant(moved, axis)
        shown = corners[:, IN_PLANE[axis]]
        for end in ends:
            # The ends of the line are two corners of the plane, in each view the same ones.
            assert np.hypot(*(shown - end).T).min() < 1e-6
        assert sum(curve.distance((a, b)) < 1e-6 for a, b in shown) == 2


def test_exact_lines_stay_as_they_are() -> None:
    carriers = _supports(0.0, 2e-4)
    bodies = find_half_spaces(carriers)
    assert len(bodies) == 1
    assert retraced(carriers, bodies).planes == carriers.planes


def test_without_half_spaces_nothing_moves() -> None:
    carriers = _supports(0.1, 0.2)
    assert retraced(carriers, ()) is carriers


def test_lines_that_are_no_edges_stay() -> None:
    carriers = _supports(0.1, 0.2)
    moved = retraced(carriers, find_half_spaces(carriers))
    for axis in Axis:
        before = [s.curve for s in carriers.planes[axis].carriers if s.curve.axis is not None]
        after = [s.curve for s in moved.planes[axis].carriers if s.curve.axis is not None]
        assert before == after


def _cut_cone(misread: float, tolerance: float) -> PartCarriers:
    """A cone of radius 40 and 16 at heights 0 and 60; above 40 a groove cuts its left and right.

    The right view has its outline up to there, and a little steeper.
    """
    outlines = {
        Role.FRONT: [((0.0, 0.0), (24.0, 60.0)), ((80.0, 0.0), (56.0, 60.0))],
        Role.RIGHT: [
            ((0.0, 0.0), (16.0 - misread, 40.0)),
            ((80.0, 0.0), (64.0 + misread, 40.0)),
        ],
    }
    level = [((0.0, 0.0), (80.0, 0.0))]
    strokes = {
        role: tuple(Segment(p, q, Linetype.VISIBLE) for p, q in (*level, *outline))
        for role, outline in outlines.items()
    }
    circles = tuple(Arc((40.0, 40.0), r, 0.0, 2.0 * pi, Linetype.VISIBLE) for r in (40.0, 16.0))
    views = DrawnViews({**strokes, Role.TOP: circles}, (80.0, 80.0, 60.0), tolerance)
    return find_carriers(views)


def test_outlines_of_a_cone_are_the_same_in_all_views() -> None:
    carriers = _cut_cone(0.04, 0.08)
    (body,) = find_bodies(carriers)
    rims = [rim for rim, _ in body.rims(Axis.X)]

    def offsets(part_supports: PartCarriers) -> list[float]:
        """Units from the ends of the right view's outlines to those of the cone."""
        slants = [s for s in part_supports.planes[Axis.X].carriers if s.curve.axis is None]
        return [
            min(rim.distance(s.curve.at(end)) for rim in rims)
            for s in slants
            for stretch in s.drawn()
            for end in stretch
        ]

    before, after = offsets(carriers), offsets(retraced(carriers, (), [body]))
    assert len(before) == len(after) == 4
    assert max(before) > 0.01
    assert max(after) < 1e-9
