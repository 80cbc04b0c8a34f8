"""Round corners down to a few px are arcs; sharp and cut corners stay what they are."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from gaussiancad_core.drawing.degrade import finished
from gaussiancad_core.drawing.drawn_sheet import compose_sheet, part_lines
from gaussiancad_core.drawing.sheet_style import PRESETS, SheetStyle
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.geometry.whole_curves import Line
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment, Stroke
from gaussiancad_core.recognition.picture_views import picture_views
from gaussiancad_core.samples.classed import PartClass, classed_part
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.sheet_stages import read_views
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.pen_profile import Pen, fit_pen
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

V = Linetype.VISIBLE
RIGHT_ANGLED = [(60.3, 50.6), (340.4, 50.6), (340.4, 220.2), (60.3, 220.2)]
SLANTED = [(70.2, 60.9), (330.5, 90.1), (280.8, 230.4), (110.7, 200.6)]


def _rounded(corners: list[tuple[float, float]], radius: float) -> list[Stroke]:
    """A polygon with its corners rounded."""
    points = np.array(corners)
    arcs: list[Stroke] = []
    touching = []
    for before, corner, after in zip(
        np.roll(points, 1, 0), points, np.roll(points, -1, 0), strict=True
    ):
        ways = [(other - corner) / np.hypot(*(other - corner)) for other in (before, after)]
        half = 0.5 * np.arccos(ways[0] @ ways[1])
        bisector = sum(ways) / np.hypot(*sum(ways))
        touching.append([corner + radius / np.tan(half) * way for way in ways])
        if radius:
            centre = corner + radius / np.sin(half) * bisector
            angles = [np.arctan2(*(place - centre)[::-1]) for place in touching[-1]]
            sweep = (angles[1] - angles[0]) % (2 * np.pi)
            start, sweep = (angles[0], sweep) if sweep < np.pi else (angles[1], 2 * np.pi - sweep)
            arcs.append(Arc(tuple(centre), radius, float(start), float(sweep), V))
    sides = [
        Segment(tuple(one[1]), tuple(other[0]), V)
        for one, other in zip(touching, [*touching[1:], touching[0]], strict=True)
    ]
    return [*arcs, *sides]


def _read(strokes: list[Stroke], style: SheetStyle) -> tuple[Stroke, ...]:
    image = finished(rasterise(tuple(strokes), style), style, 0)
    sheet = clean_sheet(image.mean(axis=2).astype(np.uint8) if image.ndim == 3 else image)
    view = find_shapes(sheet, (40.0, 30.0, 360.0, 250.0))
    return classify_strokes(view, view_rhythm([view], sheet.stroke_width))


def _style(preset: str, width: float) -> SheetStyle:
    return replace(PRESETS[preset], width=400, height=280, visible_width=width)


@pytest.mark.parametrize("preset", ["clean", "scan"])
@pytest.mark.parametrize(
    ("width", "radius"), [(1.5, 8.0), (2.0, 6.0), (2.0, 9.0), (3.0, 8.0), (3.0, 13.0), (5.0, 12.0)]
)
@pytest.mark.parametrize("corners", [RIGHT_ANGLED, SLANTED], ids=["right", "slanted"])
def test_fillets_are_arcs_that_touch_their_lines(
    corners: list[tuple[float, float]], width: float, radius: float, preset: str
) -> None:
    drawn = _rounded(corners, radius)
    found = _read(drawn, _style(preset, width))
    arcs = [stroke for stroke in found if isinstance(stroke, Arc)]
    assert (len(arcs), len(found)) == (4, 8)
    for true in drawn[:4]:
        errors = [
            max(*np.abs(np.subtract(arc.centre, true.centre)), abs(arc.radius - true.radius))
            for arc in arcs
        ]
        nearest = arcs[int(np.argmin(errors))]
        assert min(errors) < 0.7
        # Tangent joins: each end of the arc is the end of a line that runs along the tangent.
        points = nearest.sample(0.01)
        for end, inner in ((points[0], points[1]), (points[-1], points[-2])):
            joined = [
                (stroke, np.hypot(*np.subtract(place, end)))
                for stroke in found
                if isinstance(stroke, Segment)
                for place in (stroke.start, stroke.end)
            ]
            line, gap = min(joined, key=lambda pair: pair[1])
            way, tangent = np.subtract(line.end, line.start), inner - end
            assert gap < 0.3
            sine = (way[0] * tangent[1] - way[1] * tangent[0]) / np.hypot(*way)
            assert abs(sine) / np.hypot(*tangent) < 0.05


@pytest.mark.parametrize("preset", ["clean", "scan", "photocopy"])
@pytest.mark.parametrize("width", [2.0, 3.0, 5.0])
@pytest.mark.parametrize("corners", [RIGHT_ANGLED, SLANTED], ids=["right", "slanted"])
def test_sharp_corners_stay_sharp(
    corners: list[tuple[float, float]], width: float, preset: str
) -> None:
    style = replace(_style(preset, width), skew=0.0)
    found = _read(_rounded(corners, 0.0), style)
    assert [type(stroke) for stroke in found] == [Segment] * 4
    ends = np.array([place for stroke in found for place in (stroke.start, stroke.end)])
    for corner in corners:
        assert np.sort(np.hypot(*(ends - corner).T))[:2].max() < 0.6


@pytest.mark.parametrize("cut", [5.0, 8.0, 12.0])
def test_cut_corners_are_no_arcs(cut: float) -> None:
    (x0, y0), _, (x1, y1), _ = RIGHT_ANGLED
    corners = [
        (x0 + cut, y0), (x1 - cut, y0), (x1, y0 + cut), (x1, y1 - cut),
        (x1 - cut, y1), (x0 + cut, y1), (x0, y1 - cut), (x0, y0 + cut),
    ]  # fmt: skip
    found = _read(_rounded(corners, 0.0), _style("clean", 2.0))
    assert not [stroke for stroke in found if isinstance(stroke, Arc)]


@pytest.mark.parametrize("width", [1.2, 2.0, 3.0, 6.0])
def test_the_pen_is_as_wide_as_it_was(sketch, width: float) -> None:  # noqa: ANN001
    drawn = sketch().line((20.2, 30.4), (180.0, 61.9), width)
    way = np.array([159.8, 31.5])
    length = float(np.hypot(*way))
    line = Line((20.2, 30.4), (float(way[0] / length), float(way[1] / length)))
    pen = fit_pen(drawn.weight, [(line, 0.0, length)], 3.0)
    assert pen.width == pytest.approx(width, abs=0.1)
    across = np.linspace(0.0, 6.0, 200)
    assert 2.0 * np.trapezoid(pen.ink(across), across) == pytest.approx(width, rel=0.02)
    assert fit_pen(drawn.weight, [], 3.0) == Pen(3.0, 0.5, 1.0)


@pytest.mark.parametrize("apart", [20.0, 25.0, 30.0])
def test_lines_that_end_apart_on_a_line_are_not_joined(apart: float) -> None:
    """They would meet beyond it, and the line is where an arc between them would be."""
    frame = [(60.3, 50.6), (340.4, 50.6), (340.4, 220.2), (60.3, 220.2), (60.3, 50.6)]
    sides = [Segment(a, b, V) for a, b in pairwise(frame)]
    left, right = 200.0 - apart / 2.0, 200.0 + apart / 2.0
    slants = [((left - 60.0, 74.6), (left, 50.6)), ((right, 50.6), (right + 60.0, 74.6))]
    found = _read([*sides, *(Segment(a, b, V) for a, b in slants)], _style("clean", 2.6))
    assert not [stroke for stroke in found if isinstance(stroke, Arc)]
    ends = sorted(
        float(x)
        for stroke in found
        for x, y in stroke.sample(500.0)[[0, -1]]
        if 100.0 < x < 300.0 and abs(y - 50.6) < 1.0
    )
    assert ends == pytest.approx([left, right], abs=1.0)


def test_a_line_that_was_seen_in_an_arc_has_no_fillet_of_its_own() -> None:
    """The top view has two quarters of 15 px; in one of them eight px were taken for straight."""
    solid = classed_part(PartClass.FILLETS, 4004, 0)
    lines = part_lines(solid, (Role.FRONT, Role.TOP, Role.RIGHT))
    title = "FILLETS-4004"
    drawn = compose_sheet(lines, Projection.THIRD, PRESETS["clean"], 4004, title=title)
    grey = drawn.image.mean(axis=2) if drawn.image.ndim == 3 else drawn.image
    image = SheetImage(Path("sheet.png"), grey.astype(np.uint8), "")
    seen = picture_views(OpenedSheet(image), {}, Projection.THIRD)
    views = {view.role: view.strokes for view in read_views(seen.separated.part, seen.layout)}
    arcs = [stroke for stroke in views[Role.TOP] if isinstance(stroke, Arc)]
    assert [arc.radius for arc in arcs] == pytest.approx([15.09, 15.09], abs=0.15)
    assert [arc.sweep for arc in arcs] == pytest.approx([np.pi / 2] * 2, abs=0.02)
    assert min(stroke.length for stroke in views[Role.TOP]) > 20.0
