"""Strokes as shapes of a reading, and back."""

import msgspec
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke
from gaussiancad_core.readings.reading_schema import StrokeEntry
from gaussiancad_core.readings.reading_shapes import shape_of, stroke_of
from gaussiancad_core.readings.stroke_anchors import matching, overlap, points_of
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_protocol.reading_kinds import StrokeKind

_PLACE = st.floats(0.0, 3000.0)
_POINT = st.tuples(_PLACE, _PLACE)
_ANGLE = st.floats(0.0, 6.28)
_SWEEP = st.floats(0.05, 2.0 * np.pi)
_RADIUS = st.floats(5.0, 900.0)
_LINETYPE = st.sampled_from(Linetype)

_SEGMENTS = st.builds(Segment, _POINT, _POINT, _LINETYPE).filter(lambda item: item.length > 2.0)
_ARCS = st.builds(Arc, _POINT, _RADIUS, _ANGLE, _SWEEP, _LINETYPE)
_ELLIPSES = st.tuples(_RADIUS, st.floats(0.2, 0.95)).flatmap(
    lambda axes: st.builds(
        Ellipse,
        _POINT,
        st.just(axes[0]),
        st.just(axes[0] * axes[1]),
        _ANGLE,
        _ANGLE,
        _SWEEP,
        _LINETYPE,
    )
)
_STROKES = st.one_of(_SEGMENTS, _ARCS, _ELLIPSES)
_TURNS = st.builds(Turn, st.floats(-0.1, 0.1), _POINT, st.floats(1.0, 4.0))


def _entry(stroke: Stroke, turn: Turn, name: str = "s1") -> StrokeEntry:
    kind = StrokeKind(stroke.linetype.value)
    return StrokeEntry(id=name, view="front", kind=kind, **shape_of(stroke, turn))


@given(_STROKES, _TURNS)
def test_a_stroke_comes_back_where_it_was(stroke: Stroke, turn: Turn) -> None:
    entry = _entry(stroke, turn)
    found = stroke_of(entry, turn)
    assert type(found) is type(stroke) and found.linetype is stroke.linetype
    shares = np.linspace(0.0, 1.0, 9)
    expected, item = (_along(each, shares) for each in (stroke, found))
    assert np.abs(expected - item).max() < 0.002
    # Its points on the sheet as stored are those of the shape itself.
    assert np.abs(points_of(entry)[[0, -1]] - turn.to_stored(expected[[0, -1]])).max() < 0.01


def _along(stroke: Stroke, shares: np.ndarray) -> np.ndarray:
    if isinstance(stroke, Segment):
        start, end = np.array(stroke.start), np.array(stroke.end)
        return start + shares[:, None] * (end - start)
    if isinstance(stroke, Arc):
        angles = stroke.start_angle + shares * stroke.sweep
        around = np.stack([np.cos(angles), np.sin(angles)], 1)
        return np.array(stroke.centre) + stroke.radius * around
    return stroke.carrier.at(stroke.start + shares * stroke.sweep)


@given(_STROKES, st.tuples(st.floats(-1.5, 1.5), st.floats(-1.5, 1.5)))
def test_a_shape_is_found_again_a_little_aside_and_not_far_away(
    stroke: Stroke, aside: tuple[float, float]
) -> None:
    still = Turn(0.0, (0.0, 0.0))
    entry = _entry(stroke, still)
    near = _moved(entry, *aside)
    far = _moved(entry, 5000.0, 0.0)
    assert overlap(entry, near) == pytest.approx(1.0)
    assert matching(entry, [far, near]) is near and matching(entry, [far]) is None


def _moved(entry: StrokeEntry, dx: float, dy: float) -> StrokeEntry:
    from msgspec.structs import replace

    if entry.line is not None:
        return replace(entry, line=tuple((x + dx, y + dy) for x, y in entry.line))
    name = "arc" if entry.arc is not None else "ellipse"
    x, y, *rest = getattr(entry, name)
    return replace(entry, **{name: (x + dx, y + dy, *rest)})


def test_a_line_of_which_little_is_left_is_another_one() -> None:
    whole = StrokeEntry(
        id="s1", view=None, kind=StrokeKind.VISIBLE, line=((0.0, 0.0), (100.0, 0.0))
    )
    for length, same in ((70.0, True), (50.0, False)):
        part = StrokeEntry(
            id="s2", view=None, kind=StrokeKind.VISIBLE, line=((0.0, 1.0), (length, 1.0))
        )
        assert (matching(whole, [part]) is part) is same
    arc = StrokeEntry(
        id="s3", view=None, kind=StrokeKind.VISIBLE, arc=(50.0, 1e5, 1e5, -1.5712963, 0.001)
    )
    assert overlap(whole, arc) == 0.0


def test_what_is_smaller_than_all_decimals_is_written_so_that_it_is_read_again() -> None:
    still = Turn(0.0, (0.0, 0.0))
    tiny = _entry(Arc((1.0, 1.0), 1e-6, 0.0, 1e-10, Linetype.VISIBLE), still)
    assert msgspec.json.decode(msgspec.json.encode(tiny), type=StrokeEntry) == tiny
