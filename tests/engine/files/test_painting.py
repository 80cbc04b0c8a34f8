from collections.abc import Callable

import numpy as np
import pytest

from gaussiancad_core.files.fonts import known_font
from gaussiancad_core.files.painting import paint, render_svg, unturned_size
from gaussiancad_core.files.shown import shown_shares
from gaussiancad_core.files.vectors import (
    StrokeKind,
    StrokeRole,
    VectorDrawing,
    VectorStroke,
    VectorText,
)
from gaussiancad_core.geometry.arcs import CircularArc, EllipticArc
from gaussiancad_core.geometry.chains import Chain, LineSegment

TURN = 2 * np.pi

STROKES = (
    VectorStroke(LineSegment((20.3, 30.1), (380.7, 250.9)), 2.0),
    VectorStroke(CircularArc((200.2, 150.7), 90.4, 0.3, TURN), 2.0),
    VectorStroke(CircularArc((200.2, 150.7), 60.4, 0.5, 2.0), 3.0),
    VectorStroke(EllipticArc((200.0, 150.0), 126.5, 38.0, 0.32, 0.2, 4.0), 2.0),
    VectorStroke(Chain(((20.0, 250.0), (60.0, 220.0), (120.0, 280.0))), 2.0),
)


def test_ink_lies_on_the_curves(ink_offsets: Callable) -> None:
    for stroke in STROKES:
        grey = paint(VectorDrawing((stroke,), ()), 400, 300)
        offsets = ink_offsets(grey, stroke)
        assert len(offsets) > 20
        assert abs(float(np.median(offsets))) < 0.08
        assert shown_shares([stroke], grey) == [1.0]
        assert shown_shares([VectorStroke(LineSegment((390, 5), (399, 5)), None)], grey) == [0.0]
        ink = (255.0 - grey).sum() / 255.0
        assert ink == pytest.approx(stroke.curve.length * stroke.width, rel=0.05)


def test_strips_are_seamless(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = paint(VectorDrawing(STROKES, ()), 400, 300)
    monkeypatch.setattr("gaussiancad_core.files.painting.MOST_WORKED_ON", 400 * 37)
    strips = paint(VectorDrawing(STROKES, ()), 400, 300)
    differences = np.abs(strips.astype(int) - whole)
    # Where a strip cuts a line, its slope is rounded anew: to sixteenths of ink in a few pixels.
    assert differences.max() <= 16
    assert np.count_nonzero(differences) < 50


@pytest.mark.parametrize(
    ("dashes", "share"), [((), 1.0), ((12.0, 6.0), 2 / 3), ((0.2, 0.1), 0.6), ((0.0, 8.0), 0.2)]
)
def test_dashes_can_be_told_apart(dashes: tuple[float, ...], share: float) -> None:
    stroke = VectorStroke(LineSegment((10, 20.5), (390, 20.5)), 2.0, dashes, StrokeRole.HIDDEN)
    row = paint(VectorDrawing((stroke,), ()), 400, 40)[20, 12:388] < 128
    assert row.mean() == pytest.approx(share, abs=0.08)
    if dashes:
        assert np.count_nonzero(np.diff(row.astype(int))) > 20


def test_edges_are_drawn_heavier_than_other_lines() -> None:
    line = LineSegment((10, 20), (190, 20))
    strokes = {
        role: VectorStroke(line, None, (), role) for role in (StrokeRole.VISIBLE, StrokeRole.CENTRE)
    }
    ink = {
        role: (255 - paint(VectorDrawing((stroke,), ()), 200, 40).astype(int)).sum()
        for role, stroke in strokes.items()
    }
    assert ink[StrokeRole.VISIBLE] > 1.2 * ink[StrokeRole.CENTRE]


def test_fills_are_filled() -> None:
    square = Chain(((10, 10), (50, 10), (50, 30), (10, 30), (10, 10)))
    stroke = VectorStroke(square, None, kind=StrokeKind.FILL)
    grey = paint(VectorDrawing((stroke,), ()), 60, 40)
    assert (grey[11:29, 11:49] == 0).all()
    assert (255.0 - grey).sum() / 255.0 == pytest.approx(800, rel=0.01)


@pytest.mark.skipif(known_font() is None, reason="no known font is installed")
@pytest.mark.parametrize("angle", [0.0, -np.pi / 2, 0.4])
def test_texts_fill_their_boxes(angle: float) -> None:
    length, height = 160.0, 30.0
    c, s = abs(np.cos(angle)), abs(np.sin(angle))
    half = np.array([length * c + height * s, length * s + height * c]) / 2
    box = (*(np.array([200, 150]) - half), *(np.array([200, 150]) + half))
    text = VectorText("<25.4 & Ø", tuple(float(v) for v in box), angle)
    assert unturned_size(text) == pytest.approx((length, height))
    grey = paint(VectorDrawing((), (text,)), 400, 300)
    rows, columns = np.nonzero(grey < 128)
    low, high = np.array(box[:2]), np.array(box[2:])
    spread = np.array([np.ptp(columns), np.ptp(rows)])
    assert ((columns > low[0] - 4) & (columns < high[0] + 4)).all()
    assert ((rows > low[1] - 4) & (rows < high[1] + 4)).all()
    assert (spread > 0.55 * (high - low)).all()


def test_nonsense_is_refused() -> None:
    with pytest.raises(ValueError, match=r"\w"):
        render_svg("<path", 100, 100)


def test_only_what_is_drawn_on_is_painted_and_is_the_same() -> None:
    stroke = VectorStroke(CircularArc((210.3, 140.7), 31.4, 0.5, 4.0), 9.0)
    line = VectorStroke(LineSegment((180.2, 100.9), (260.6, 190.1)), None, (6.0, 3.0))
    far = VectorStroke(LineSegment((-50.0, -50.0), (450.0, 350.0)), 1.0)
    apart = VectorStroke(LineSegment((20.0, 280.5), (60.0, 280.5)), 3.0)
    beyond = VectorStroke(LineSegment((500.0, 10.0), (600.0, 10.0)), 2.0)
    # A text may be as wide as its sheet: with one all of it is painted.
    blank = VectorText(" ", (0.0, 0.0, 9.0, 9.0))
    for strokes in (
        (stroke,),
        (line,),
        (line, stroke),
        (line, far),
        (apart, stroke, beyond),
        (beyond,),
        (),
    ):
        alone = paint(VectorDrawing(strokes, ()), 400, 300)
        assert np.array_equal(alone, paint(VectorDrawing(strokes, (blank,)), 400, 300))
