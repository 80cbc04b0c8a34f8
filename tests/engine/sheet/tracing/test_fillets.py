"""Round corners and run-outs, down to a few px: arcs that touch their lines."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke

Sketch = Any
"""The class that the fixture gives."""

V, H = Linetype.VISIBLE, Linetype.HIDDEN
QUARTER = np.pi / 2.0
RIGHT_ANGLED = [(60.3, 50.6), (340.4, 50.6), (340.4, 220.2), (60.3, 220.2)]
SLANTED = [(70.2, 60.9), (330.5, 90.1), (280.8, 230.4), (110.7, 200.6)]
POCKET = [(100.3, 80.6), (300.4, 80.6), (300.4, 190.2), (100.3, 190.2)]


def _outline(corners: list[tuple[float, float]], kind: Linetype = V) -> list[Stroke]:
    return [Segment(a, b, kind) for a, b in pairwise([*corners, corners[0]])]


def _rounded(corners: list[tuple[float, float]], radius: float, kind: Linetype = V) -> list[Stroke]:
    """A polygon with its corners rounded."""
    points, arcs, touching = np.array(corners), [], []
    for before, corner, after in zip(
        np.roll(points, 1, 0), points, np.roll(points, -1, 0), strict=True
    ):
        ways = [(other - corner) / np.hypot(*(other - corner)) for other in (before, after)]
        half = 0.5 * np.arccos(ways[0] @ ways[1])
        centre = corner + radius / np.sin(half) * sum(ways) / np.hypot(*sum(ways))
        touching.append([corner + radius / np.tan(half) * way for way in ways])
        first, last = (np.arctan2(*(place - centre)[::-1]) for place in touching[-1])
        turn = (last - first) % (2 * np.pi)
        start, sweep = (first, turn) if turn < np.pi else (last, 2 * np.pi - turn)
        arcs.append(Arc(tuple(centre), radius, float(start), float(sweep), kind))
    ends = zip(touching, [*touching[1:], touching[0]], strict=True)
    return [*arcs, *(Segment(tuple(one[1]), tuple(other[0]), kind) for one, other in ends)]


@pytest.mark.parametrize(
    ("corners", "width", "radius", "style"),
    [
        (RIGHT_ANGLED, 1.5, 8.0, ""),
        (RIGHT_ANGLED, 2.0, 6.0, ""),
        (RIGHT_ANGLED, 3.0, 13.0, "scan"),
        (RIGHT_ANGLED, 5.0, 12.0, ""),
        (RIGHT_ANGLED, 3.0, 30.0, ""),
        (SLANTED, 2.0, 6.0, ""),
        (SLANTED, 2.0, 9.0, "scan"),
        (SLANTED, 5.0, 12.0, "scan"),
    ],
)
def test_fillets_are_arcs(
    sketch: Sketch, corners: list[tuple[float, float]], width: float, radius: float, style: str
) -> None:
    drawn = sketch(400, 280).inked(*_rounded(corners, radius), width=width)
    assert drawn.misread(1.0, style) == []


@pytest.mark.parametrize("radius", [9.0, 13.0, 17.0])
def test_small_hidden_fillets_are_arcs(sketch: Sketch, radius: float) -> None:
    drawn = sketch(400, 280).inked(*_outline(RIGHT_ANGLED), *_rounded(POCKET, radius, H))
    assert drawn.misread(1.5) == []


@pytest.mark.parametrize("style", ["", "scan"])
def test_sharp_hidden_corners_stay_sharp(sketch: Sketch, style: str) -> None:
    drawn = sketch(400, 280).inked(*_outline(RIGHT_ANGLED), *_outline(POCKET, H))
    assert drawn.misread(1.5, style) == []


@pytest.mark.parametrize("cut", [9.0, 13.0])
def test_cut_hidden_corners_are_no_arcs(sketch: Sketch, cut: float) -> None:
    (x0, y0), (x1, y1) = POCKET[0], POCKET[2]
    corners = [
        (x0, y0 + cut), (x0 + cut, y0), (x1 - cut, y0), (x1, y0 + cut),
        (x1, y1 - cut), (x1 - cut, y1), (x0 + cut, y1), (x0, y1 - cut),
    ]  # fmt: skip
    drawn = sketch(400, 280).inked(*_outline(RIGHT_ANGLED), *_outline(corners, H))
    assert not [stroke for stroke in drawn.strokes() if isinstance(stroke, Arc)]


@pytest.mark.parametrize("radius", [17.0, 22.0])
@pytest.mark.parametrize("rounded", [True, False])
def test_a_hidden_line_comes_to_the_outline_by_an_arc_or_a_chamfer(
    sketch: Sketch, rounded: bool, radius: float
) -> None:
    wall = 60.3
    corner = (
        Arc((wall + radius, 120.0 + radius), radius, np.pi, QUARTER, H)
        if rounded
        else Segment((wall, 120.0 + radius), (wall + radius, 120.0), H)
    )
    lines = [Segment((300, 120), (wall + radius, 120), H), Segment((300, 120), (300, 150), H)]
    drawn = sketch(400, 280).inked(
        *_outline(RIGHT_ANGLED), corner, *lines, *_outline(POCKET, H)[::2]
    )
    arcs = [stroke for stroke in drawn.strokes() if isinstance(stroke, Arc)]
    assert [arc.radius for arc in arcs] == [pytest.approx(radius, abs=0.5)] * rounded


def _rib(radius: float, kind: Linetype, *ways: float) -> list[Stroke]:
    """Two lines from top to base of the outline, each rounded into the base: outward or inward."""
    strokes: list[Stroke] = []
    for x, side in ((150.4, -1.0), (240.7, 1.0)):
        strokes.append(Segment((x, 50.6), (x, 220.2 - radius), kind))
        for way in (side * turn for turn in ways):
            start = 0.0 if way < 0.0 else QUARTER
            centre = (x + way * radius, 220.2 - radius)
            strokes.append(Arc(centre, radius, start, QUARTER, kind))
    return strokes


@pytest.mark.parametrize(
    ("width", "radius", "ways", "style"),
    [
        (2.0, 8.0, (1.0,), ""),
        (2.0, 10.4, (-1.0,), "scan"),
        (3.0, 14.0, (1.0,), "scan"),
        (4.0, 18.0, (-1.0,), ""),
        (2.0, 12.0, (1.0, -1.0), ""),
    ],
)
def test_strokes_rounded_into_a_line_that_runs_past(
    sketch: Sketch, width: float, radius: float, ways: tuple[float, ...], style: str
) -> None:
    drawn = sketch(400, 280).inked(*_outline(RIGHT_ANGLED), *_rib(radius, V, *ways), width=width)
    found = drawn.strokes(style)
    arcs = [stroke for stroke in found if isinstance(stroke, Arc)]
    assert [arc.radius for arc in arcs] == [pytest.approx(radius, abs=0.5)] * (2 * len(ways))
    assert [arc.sweep for arc in arcs] == [pytest.approx(QUARTER, abs=0.1)] * (2 * len(ways))
    # The base runs past.
    straight = sum(stroke.length for stroke in found if isinstance(stroke, Segment))
    assert straight == pytest.approx(2 * (280.1 + 169.6) + 2 * (169.6 - radius), abs=3.0)


@pytest.mark.parametrize("radius", [24.0, 31.0])
def test_hidden_strokes_rounded_into_an_edge(sketch: Sketch, radius: float) -> None:
    drawn = sketch(400, 280).inked(*_outline(RIGHT_ANGLED), *_rib(radius, H, 1.0))
    arcs = [stroke for stroke in drawn.strokes() if isinstance(stroke, Arc)]
    assert [arc.linetype for arc in arcs] == [H, H]
    assert [arc.radius for arc in arcs] == [pytest.approx(radius, abs=0.12 * radius)] * 2
    assert [arc.sweep for arc in arcs] == [pytest.approx(QUARTER, abs=0.1)] * 2


@pytest.mark.parametrize(("kind", "style"), [(V, ""), (V, "scan"), (H, ""), (H, "scan")])
def test_strokes_that_meet_a_line_stay_straight(sketch: Sketch, kind: Linetype, style: str) -> None:
    drawn = sketch(400, 280).inked(*_outline(RIGHT_ANGLED), *_rib(0.0, kind))
    assert drawn.misread(1.0, style) == []


@pytest.mark.parametrize("left", [0.0, 18.0])
def test_a_rounding_beside_what_is_left_of_erased_lines(sketch: Sketch, left: float) -> None:
    """Extension lines that touched it lie beside the arc at both of its ends."""
    radius = 55.0
    drawn = sketch(300, 300).lines((40 + radius, 260), (280, 260), (280, 20), (40, 20), width=5.0)
    drawn.line((40, 20), (40, 260 - radius), 5.0)
    drawn.arc((40 + radius, 260 - radius), radius, 5.0, QUARTER, QUARTER)
    drawn.ink((40 + radius, 260), (40 + radius - left, 260), width=5.0)
    drawn.ink((40, 260 - radius), (40, 260 - radius + left), width=5.0)
    arcs = [stroke for stroke in drawn.strokes() if isinstance(stroke, Arc)]
    assert [arc.radius for arc in arcs] == [pytest.approx(radius, abs=3.5)]


def _keyway(sketch: Sketch, rise: float, long: float, *, bent: bool = True) -> Any:  # noqa: ANN401
    """The end of a keyway in a shaft: its outline rises to a wall's dashes, and goes on."""
    low, foot, wall = 60.0, 100.0, 150.0
    radius = (long**2 + rise**2) / (2.0 * rise)
    drawn = sketch(200, 140).line((20, low), (foot, low))
    if bent:
        turn = float(np.arcsin(long / radius))
        drawn.arc((foot, low - radius), radius, 3.0, QUARTER - turn, turn)
    else:
        drawn.line((foot, low), (foot + long, low - rise))
    drawn.line((foot + long, low - rise), (wall, low - rise))
    drawn.broken((foot + long, low - rise), (foot + long, 110.0), (10.0, 5.0))
    return drawn.box(wall, 30, 190, 120).lines((wall, 120), (20, 120), (20, low))


@pytest.mark.parametrize(("rise", "long"), [(2.2, 25.0), (3.1, 24.8), (4.4, 25.0), (5.0, 25.0)])
def test_an_outline_that_rises_to_the_end_of_a_keyway_is_an_arc(
    sketch: Sketch, rise: float, long: float
) -> None:
    strokes = _keyway(sketch, rise, long).strokes()
    (arc,) = (stroke for stroke in strokes if isinstance(stroke, Arc))
    ends = sorted(tuple(end) for end in (arc.sample(1.0)[[0, -1]] - 0.5).tolist())
    assert np.array(ends) == pytest.approx(
        np.array([[100.0, 60.0], [100.0 + long, 60.0 - rise]]), abs=1.8
    )
    beyond = [
        sorted(x - 0.5 for x, _ in (item.start, item.end))
        for item in strokes
        if isinstance(item, Segment)
        and max(abs(y - 60.5 + rise) for _, y in (item.start, item.end)) < 0.5
    ]
    assert beyond == [pytest.approx([100.0 + long, 150.0], abs=0.7)]


def test_a_slant_to_the_end_of_a_keyway_is_no_arc(sketch: Sketch) -> None:
    strokes = _keyway(sketch, 3.0, 24.0, bent=False).strokes()
    assert not [stroke for stroke in strokes if isinstance(stroke, Arc)]


@pytest.mark.parametrize("rise", [3.1, 4.4])
def test_both_ends_of_a_line_rise(sketch: Sketch, rise: float) -> None:
    low, long, ends = 60.0, 25.0, (110.0, 190.0)
    radius = (long**2 + rise**2) / (2.0 * rise)
    turn = float(np.arcsin(long / radius))
    drawn = sketch(300, 140).line((ends[0], low), (ends[1], low))
    for x, start, wall in ((ends[0], QUARTER, 20.0), (ends[1], QUARTER - turn, 250.0)):
        corner = (x + np.copysign(long, wall - x), low - rise)
        drawn.arc((x, low - radius), radius, 3.0, start, turn).line(corner, (wall, low - rise))
        drawn.broken(corner, (corner[0], 110.0), (10.0, 5.0))
    drawn.box(250, 30, 290, 120).lines((250, 120), (20, 120), (20, low - rise))
    assert not [text for text in drawn.misread(2.0) if "Arc" in text]


@pytest.mark.parametrize(
    ("height", "wide", "stroke"),
    [
        (1.4, 36.0, False),
        (2.0, 46.0, False),
        (2.4, 46.0, False),
        (1.6, 46.0, True),
        (2.0, 46.0, True),
    ],
)
def test_the_mouth_of_a_cross_bore_bows_the_outline(
    sketch: Sketch, height: float, wide: float, stroke: bool
) -> None:
    """Where another stroke begins it, it ends at that."""
    first, last, top = 130.0, 130.0 + wide, 40.0
    radius = ((wide / 2.0) ** 2 + height**2) / (2.0 * height)
    half = float(np.arcsin(wide / 2.0 / radius))
    drawn = sketch(300, 200).line((20, top), (first, top), 2.7)
    drawn.arc((first + wide / 2.0, top + height - radius), radius, 2.7, QUARTER - half, 2.0 * half)
    drawn.lines((last, top), (280, top), (280, 160), (20, 160), (20, top), width=2.7)
    if stroke:
        drawn.line((first, top), (first, 160), 2.7)
    assert drawn.misread(4.0) == []
    (arc,) = (item for item in drawn.strokes() if isinstance(item, Arc))
    assert arc.sample(1.0)[:, 1].max() - 0.5 == pytest.approx(top + height, abs=0.25)


@pytest.mark.parametrize(("turn", "radius"), [(25.0, 50.0), (30.0, 50.0), (35.0, 70.0)])
def test_a_flat_arc_from_edge_to_edge(sketch: Sketch, turn: float, radius: float) -> None:
    """It leaves the lower line and bends by a pixel on its way to the upper one."""
    above, below = 80.0, 97.0
    first = np.radians(180.0 + turn)
    centre = (120.0 - radius * np.cos(first), below - radius * np.sin(first))
    sweep = np.pi + np.arcsin((centre[1] - above) / radius) - first
    drawn = sketch(260, 180).box(12, 12, 248, 168)
    drawn.line((12, above), (248, above)).line((12, below), (248, below))
    drawn.arc(centre, radius, 3.0, float(first), float(sweep))
    (found,) = (s for s in drawn.strokes() if 15.0 < np.ptp(s.sample(0.5)[:, 1]) < 19.0)
    points = found.sample(0.5) - 0.5
    assert np.abs(np.hypot(*(points - centre).T) - radius).max() < 0.8
    assert [points[:, 1].min(), points[:, 1].max()] == pytest.approx([above, below], abs=0.5)


def test_a_blot_between_edges_is_none(sketch: Sketch) -> None:
    drawn = (
        sketch(260, 180).box(12, 12, 248, 168).line((12, 80), (248, 80)).line((12, 97), (248, 97))
    )
    assert drawn.ink((120.0, 86.0), (124.0, 92.0), width=4.0).misread() == []
