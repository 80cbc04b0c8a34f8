"""Extension lines that come out of a view, by the gaps before their edges."""

from typing import Any

import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.led_out import Weight, mark_led_out
from gaussiancad_core.sheet.clean import clean_sheet
from gaussiancad_core.sheet.geometry import Circle, Line
from gaussiancad_core.sheet.runs import Run

Sketch = Any
"""The class that the fixture gives."""

WIDTH = 2.0

Told = list[tuple[float, float, AnnotationKind | None]]


def _upright(x: float, *parts: tuple[float, float, bool]) -> tuple[InkedShape, list]:
    runs = tuple(InkedRun(Run(start, end), WIDTH) for start, end, _ in parts)
    kinds = [AnnotationKind.EXTENSION if told else None for _, _, told in parts]
    return InkedShape(Line((x, 0.0), (0.0, 1.0)), runs), kinds


def _sheet(sketch: Sketch, gap: float, off: float) -> Weight:
    return clean_sheet(_drawn(sketch, gap, off).grey).weight


def _drawn(sketch: Sketch, gap: float, off: float) -> Sketch:
    """A view from (60, 60) to (240, 240) with an edge at y = 140 and its left half lower, and
    extension lines above it: three off the outline, one that runs in as far as that edge."""
    drawn = sketch(300, 300).lines((60, 60), (240, 60), (240, 240), (60, 240), (60, 60))
    drawn.line((60, 140), (240, 140), WIDTH)
    for x in (60, 100, 240):
        drawn.line((x, 20), (x, 60 - off), WIDTH)
    drawn.line((160, 20), (160, 140 - gap), WIDTH)
    return drawn.line((160, 140), (160, 240), WIDTH)


def _told(weight: Weight, end: float, way: bool) -> Told:
    """What is told of the line that runs in, its own run ended at a place."""
    off = [_upright(x, (20.0, 54.0, True)) for x in (60.0, 100.0, 240.0)]
    inner = _upright(160.0, (20.0, 60.0, True), (60.0, end, False))
    shapes = [shape for shape, _ in (*off, inner)]
    kinds = [own for _, own in (*off, inner)]
    if way:
        # The same line, told from its other end.
        runs = tuple(InkedRun(Run(-r.run.end, -r.run.start), r.width) for r in shapes[-1].runs)
        shapes[-1] = InkedShape(Line((160.0, 0.0), (0.0, -1.0)), runs[::-1])
        kinds[-1] = kinds[-1][::-1]
    mark_led_out(shapes, kinds, weight, weight > 0.5, WIDTH)
    sign = -1.0 if way else 1.0
    told = [
        (*sorted((sign * run.run.start, sign * run.run.end)), kind)
        for run, kind in zip(shapes[-1].runs, kinds[-1], strict=True)
    ]
    return sorted(told, key=lambda own: own[0])


@pytest.mark.parametrize("way", [False, True])
def test_it_is_followed_to_the_gap_before_its_edge(sketch: Sketch, way: bool) -> None:
    weight = _sheet(sketch, gap=6.0, off=6.0)
    told = _told(weight, 134.0, way)
    assert [kind for _, _, kind in told] == [AnnotationKind.EXTENSION] * 2
    # The run goes on as the edge beyond the gap: there it is cut.
    told = _told(weight, 240.0, way)
    assert [kind for _, _, kind in told] == [AnnotationKind.EXTENSION] * 2 + [None]
    assert told[1][1] == pytest.approx(135.0, abs=1.5)
    assert told[2][0] == pytest.approx(139.0, abs=1.5)


@pytest.mark.parametrize(
    ("gap", "off"),
    [
        # No gap inside: it cannot be told where the edge begins.
        (0.0, 6.0),
        # No habit on this sheet.
        (6.0, 0.0),
        # A gap of a dashed line, far wider than the habit.
        (14.0, 4.0),
    ],
)
def test_without_the_sheets_gap_it_stays(sketch: Sketch, gap: float, off: float) -> None:
    told = _told(_sheet(sketch, gap, off), 240.0, False)
    assert [kind for _, _, kind in told] == [AnnotationKind.EXTENSION, None]


def test_beside_a_slot_it_ends_before_the_slots_round_end(sketch: Sketch) -> None:
    """The side of a slot begins where its end touches it: there is ink all the way."""
    drawn = sketch(300, 300).lines((60, 60), (240, 60), (240, 240), (60, 240), (60, 60))
    for x in (60, 100, 240):
        drawn.line((x, 20), (x, 54), WIDTH)
    drawn.line((160, 20), (160, 144), WIDTH).line((160, 150), (160, 200), WIDTH)
    drawn.arc((176, 150), 16.0, WIDTH).arc((176, 200), 16.0, WIDTH)
    off = [_upright(x, (20.0, 54.0, True)) for x in (60.0, 100.0, 240.0)]
    inner = _upright(160.0, (20.0, 60.0, True), (60.0, 200.0, False))
    ends = [
        (InkedShape(Circle((176.0, y), 16.0), (InkedRun(Run(0.0, 100.0), WIDTH),)), [None])
        for y in (150.0, 200.0)
    ]
    shapes = [shape for shape, _ in (*off, inner, *ends)]
    kinds = [own for _, own in (*off, inner, *ends)]
    # The round end fills the gap: at 144 to 150 px it is less than a pixel beside the line.
    weight = clean_sheet(drawn.grey).weight
    mark_led_out(shapes, kinds, weight, weight > 0.5, WIDTH)
    assert kinds[3] == [AnnotationKind.EXTENSION, AnnotationKind.EXTENSION, None]
    assert shapes[3].runs[1].run.end == pytest.approx(144.0, abs=2.0)
    assert shapes[3].runs[2].run.start == pytest.approx(150.0, abs=1.0)


def test_an_outline_is_never_followed(sketch: Sketch) -> None:
    """A copy closed the gap between an edge of the outline and its extension line."""
    drawn = sketch(300, 300).line((60, 60), (240, 60)).line((240, 60), (240, 240))
    drawn.line((60, 60), (60, 144)).line((60, 150), (60, 240)).line((60, 240), (240, 240))
    for x in (100, 160, 240):
        drawn.line((x, 20), (x, 54), WIDTH)
    drawn.line((60, 20), (60, 60), WIDTH)
    off = [_upright(x, (20.0, 54.0, True)) for x in (100.0, 160.0, 240.0)]
    edge = _upright(60.0, (20.0, 60.0, True), (60.0, 144.0, False), (150.0, 240.0, False))
    shapes = [shape for shape, _ in (*off, edge)]
    kinds = [own for _, own in (*off, edge)]
    weight = clean_sheet(drawn.grey).weight
    mark_led_out(shapes, kinds, weight, weight > 0.5, WIDTH)
    assert kinds[-1] == [AnnotationKind.EXTENSION, None, None]


def test_where_it_crosses_the_outline_aslant_paper_is_beside_it(sketch: Sketch) -> None:
    """Its run in the view begins on the paper, and crosses a round outline."""
    drawn = sketch(400, 300).arc((200, 200), 120.0, WIDTH)
    drawn.line((330, 60), (390, 60), WIDTH).line((120, 20), (120, 164), WIDTH)
    for x in (340, 360, 380):
        drawn.line((x, 20), (x, 54), WIDTH)
    drawn.line((120, 170), (120, 230), WIDTH).line((120, 170), (160, 170), WIDTH)
    drawn.line((120, 230), (160, 230), WIDTH).line((160, 170), (160, 230), WIDTH)
    off = [_upright(x, (20.0, 54.0, True)) for x in (340.0, 360.0, 380.0)]
    inner = _upright(120.0, (20.0, 96.0, True), (96.0, 164.0, False), (170.0, 230.0, False))
    shapes = [shape for shape, _ in (*off, inner)]
    kinds = [own for _, own in (*off, inner)]
    weight = clean_sheet(drawn.grey).weight
    left = weight > 0.5
    for x, end in ((120, 96), (340, 55), (360, 55), (380, 55)):
        left[:end, x - 2 : x + 3] = False
    mark_led_out(shapes, kinds, weight, left, WIDTH)
    assert kinds[-1] == [AnnotationKind.EXTENSION, AnnotationKind.EXTENSION, None]


def test_gaps_for_numbers_are_no_habit(sketch: Sketch) -> None:
    """Dimension lines that were taken for extension lines, each broken for its number."""
    drawn = _drawn(sketch, gap=6.0, off=6.0)
    rows = (255.0, 265.0, 275.0, 285.0)
    for y in rows:
        drawn.line((60, y), (90, y), WIDTH).line((106, y), (140, y), WIDTH)
    weight = clean_sheet(drawn.grey).weight
    off = [_upright(x, (20.0, 54.0, True)) for x in (60.0, 100.0, 240.0)]
    inner = _upright(160.0, (20.0, 60.0, True), (60.0, 134.0, False), (140.0, 240.0, False))
    broken = []
    for y in rows:
        runs = tuple(InkedRun(Run(*ends), WIDTH) for ends in ((60.0, 90.0), (106.0, 140.0)))
        broken.append(
            (InkedShape(Line((0.0, y), (1.0, 0.0)), runs), [AnnotationKind.EXTENSION] * 2)
        )
    shapes = [shape for shape, _ in (*off, inner, *broken)]
    kinds = [own for _, own in (*off, inner, *broken)]
    left = weight > 0.5
    left[250:] = False
    mark_led_out(shapes, kinds, weight, left, WIDTH)
    assert kinds[3] == [AnnotationKind.EXTENSION, AnnotationKind.EXTENSION, None]


@pytest.mark.parametrize("way", [False, True])
def test_what_is_loose_within_a_view_leads_nothing_in(sketch: Sketch, way: bool) -> None:
    """The end of an edge parts nothing in a corner full of ink; it did not come out of the view."""
    weight = _sheet(sketch, gap=6.0, off=6.0)
    off = [_upright(x, (20.0, 54.0, True)) for x in (60.0, 100.0, 240.0)]
    # The edge from its far end on, as far as the gap before the extension line's own end.
    edge = _upright(160.0, (140.0, 210.0, False), (210.0, 230.0, True))
    shapes, kinds = [shape for shape, _ in (*off, edge)], [own for _, own in (*off, edge)]
    if way:
        runs = tuple(InkedRun(Run(-r.run.end, -r.run.start), r.width) for r in shapes[-1].runs)
        shapes[-1] = InkedShape(Line((160.0, 0.0), (0.0, -1.0)), runs[::-1])
        kinds[-1] = kinds[-1][::-1]
    mark_led_out(shapes, kinds, weight, weight > 0.5, WIDTH)
    assert kinds[-1].count(None) == 1
