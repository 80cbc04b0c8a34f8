"""Strokes against what was drawn: the same lines of the same kind, to about a pixel."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from gaussiancad_core.lines.strokes import as_plain_strokes
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

CASES = [
    ("l-bracket", "clean", "front,top,right", "third"),
    ("three-axis-block", "thin", "front,top,left", "first"),
    ("slotted-link", "thick", "front,top,right", "third"),
    ("dovetail-block", "iso", "front,bottom,left", "third"),
    ("pulley", "clean", "front,top,right", "third"),
    ("boss-plate", "even", "front,bottom,left", "third"),
    ("filleted-block", "binary", "front,top,left", "first"),
]


def _points(strokes: tuple, kind: Linetype) -> np.ndarray:
    parts = [stroke.sample(0.5) for stroke in strokes if stroke.linetype is kind]
    return np.concatenate(parts) if parts else np.zeros((0, 2))


def _share(of: np.ndarray, near: np.ndarray) -> float:
    if not len(of):
        return 1.0
    return float((cKDTree(near).query(of)[0] < 1.2).mean()) if len(near) else 0.0


EXACT = [
    *CASES,
    ("bored-plate", "clean", "front,top,right", "third"),
    ("counterbored-block", "clean", "front,top,right", "third"),
    ("rib-bracket", "thin", "front,top,right", "third"),
    ("vee-block", "clean", "front,top,right", "third"),
    # A hidden line goes on where a visible one ends, its first dash without a gap before it.
    ("stepped-block", "iso", "front,bottom,left", "third"),
    # Dashes across dashes.
    ("three-axis-block", "clean", "front,top,left", "first"),
    # Two arcs of one radius that tangents join.
    ("slotted-link", "clean", "front,bottom,left", "third"),
    ("chamfered-block", "iso", "front,top,left", "first"),
    ("countersunk-plate", "even", "front,top,right", "third"),
    # A bore that leans: its rims are ellipses, one of them hidden.
    ("angled-bore-block", "clean", "front,top,right", "third"),
]


def _same(one: Stroke, other: Stroke, within: float) -> bool:
    """Whether two strokes are one: kind, linetype, ends and circle within some px."""
    if type(one) is not type(other) or one.linetype is not other.linetype:
        return False
    if isinstance(one, Arc):
        circles = np.array([(*one.centre, one.radius), (*other.centre, other.radius)])
        if np.abs(circles[0] - circles[1]).max() > within:
            return False
        if one.sweep == pytest.approx(2 * np.pi):
            return other.sweep == pytest.approx(2 * np.pi)
    if isinstance(one, Ellipse):
        if one.carrier.distances(other.sample(1.0)).max() > within:
            return False
        if one.sweep == pytest.approx(2 * np.pi):
            return other.sweep == pytest.approx(2 * np.pi)
    ends = one.sample(1e9)[[0, -1]]
    others = other.sample(1e9)[[0, -1]]
    return any(np.abs(ends - pair).max() <= within for pair in (others, others[::-1]))


@pytest.mark.parametrize("case", EXACT, ids="-".join)
def test_every_stroke_is_read_as_one_stroke(read, case: tuple) -> None:  # noqa: ANN001
    """One for one, lines as lines and arcs as arcs, to a fraction of a pixel."""
    result = read(*case)
    # Without grey edges a line lies up to half a pixel beside its place.
    within = 0.5 if case[1] == "binary" else 0.3
    for view in result.views:
        drawn = list(as_plain_strokes(result.drawn[view.role].strokes))
        unmatched = []
        for stroke in view.strokes:
            found = next((other for other in drawn if _same(other, stroke, within)), None)
            if found is None:
                unmatched.append(stroke)
            else:
                drawn.remove(found)
        assert (drawn, unmatched) == ([], []), view.role
        assert view.box == pytest.approx(
            result.drawn[view.role].box, abs=0.1 if within < 0.5 else 0.5
        )


@pytest.mark.parametrize("case", CASES, ids="-".join)
def test_lines_are_read_as_they_were_drawn(read, case: tuple) -> None:  # noqa: ANN001
    result = read(*case)
    for view in result.views:
        drawn = result.drawn[view.role]
        assert np.abs(np.array(view.box) - np.array(drawn.box)).max() < 0.7
        for kind in Linetype:
            truth, found = _points(drawn.strokes, kind), _points(view.strokes, kind)
            assert _share(truth, found) > 0.98, (view.role, kind, "recall")
            assert _share(found, truth) > 0.98, (view.role, kind, "precision")


def test_a_plate_is_read_as_its_very_lines(read) -> None:  # noqa: ANN001
    strokes = next(v for v in read("bored-plate").views if v.role is Role.TOP).strokes
    arcs = [s for s in strokes if isinstance(s, Arc)]
    assert len(arcs) == 5 and all(arc.sweep == pytest.approx(2 * np.pi) for arc in arcs)
    assert len([s for s in strokes if isinstance(s, Segment)]) == 4
    assert all(s.linetype is Linetype.VISIBLE for s in strokes)
    radii = sorted(arc.radius for arc in arcs)
    assert radii[4] / np.array(radii[:4]) == pytest.approx(18 / 5, rel=0.01)


def test_dashes_are_one_hidden_stroke(read) -> None:  # noqa: ANN001
    front = next(v for v in read("bored-plate").views if v.role is Role.FRONT)
    hidden = [s for s in front.strokes if s.linetype is Linetype.HIDDEN]
    # Two rows of two holes share their walls, the bore adds two.
    assert len(hidden) == 6
    height = front.box[3] - front.box[1]
    assert [stroke.length for stroke in hidden] == pytest.approx([height] * 6, abs=1.5)


def test_the_rhythm_is_the_sheets(read) -> None:  # noqa: ANN001
    case = read("three-axis-block")
    shapes = [find_shapes(case.clean, box) for box in case.layout.boxes.values()]
    rhythm = view_rhythm(shapes, case.clean.stroke_width)
    assert rhythm.dash == pytest.approx(12.0, abs=2.0)
    assert rhythm.gap == pytest.approx(6.0, abs=2.0)
    strokes = [classify_strokes(view, rhythm) for view in shapes]
    assert [len(s) for s in strokes] == [len(v.strokes) for v in case.views]
