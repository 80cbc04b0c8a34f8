"""Centre lines by their rhythm, dimension lines by their weight, hidden lines spared."""

import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.sheet.annotations.inked import InkedRun, InkedShape
from gaussiancad_core.sheet.annotations.lines import (
    Weights,
    kinds_of_runs,
    line_weights,
)
from gaussiancad_core.sheet.geometry import Line
from gaussiancad_core.sheet.runs import Run

EXTENSION, CENTRE = AnnotationKind.EXTENSION, AnnotationKind.CENTRE_LINE
LEVEL = Line((0.0, 0.0), (1.0, 0.0))


def _shape(*pieces: tuple[float, float, float | None]) -> InkedShape:
    """Runs given as start, end and width."""
    return InkedShape(LEVEL, tuple(InkedRun(Run(a, b), width) for a, b, width in pieces))


def _solid(length: float, width: float | None) -> InkedShape:
    return _shape((0.0, length, width))


def _row(lengths: list[float], gap: float, width: float) -> InkedShape:
    pieces, at = [], 0.0
    for length in lengths:
        pieces.append((at, at + length, width))
        at += length + gap
    return _shape(*pieces)


@pytest.mark.parametrize(
    ("middle", "before", "kind"),
    [
        # Strokes that cross in gaps join two dashes, or three.
        (30.0, 12.0, None),
        (48.0, 12.0, None),
        # An extension line between two dashes is longer.
        (80.0, 12.0, EXTENSION),
        # At the end of a hidden line it is one, and beside the dot of a centre line.
        (30.0, 0.0, EXTENSION),
        (30.0, 5.0, EXTENSION),
    ],
)
def test_dashes_that_a_crossing_joins(
    middle: float, before: float, kind: AnnotationKind | None
) -> None:
    row = [length for length in (12.0, before, middle, 12.0, 12.0) if length]
    if not before:
        row = row[1:]
    shapes = [_row(row, 6, 2.0), _row([12, 12, 12, 12, 12], 6, 2.0), _solid(90, 3.0)]
    kinds = kinds_of_runs(shapes, Weights(3.0, 2.4), 2.6)[0]
    assert [kinds[k] for k, length in enumerate(row) if length == middle] == [kind]


@pytest.mark.parametrize(("second", "kind"), [(14.5, None), (26.0, EXTENSION)])
def test_an_edge_that_crosses_beside_a_dash_covers_some_of_the_gap(
    second: float, kind: AnnotationKind | None
) -> None:
    """A line as long as two dashes that faded somewhere is no dash for all that."""
    ends = 15.5 + second, 22.0 + second, 33.5 + second, 40.0 + second, 52.5 + second
    row = [(0.0, 12.5, 2.0), (15.5, ends[0], 2.0), (ends[1], ends[2], 2.0), (ends[3], ends[4], 2.0)]
    shapes = [_shape(*row), _row([12, 12, 12, 12, 12], 6.5, 2.0), _solid(90, 3.0)]
    kinds = kinds_of_runs(shapes, Weights(3.0, 2.4), 2.6)[0]
    assert kinds[:2] == [kind] * 2
    assert kinds[2:] == [None] * 2


@pytest.mark.parametrize(("way", "kind"), [((0.0, 1.0), None), ((1.0, 0.0), CENTRE)])
def test_a_line_that_ends_in_a_corner_is_no_centre_line(
    way: tuple[float, float], kind: AnnotationKind | None
) -> None:
    """Another line ends where this one does, or goes on in it."""
    row = _row([40, 6, 40], 5, 2.0)
    beside = InkedShape(Line((96.5, 0.0), way), (InkedRun(Run(0.5, 60.0), 2.0),))
    kinds = kinds_of_runs([row, beside], Weights(2.0, 0.0), 2.0)
    assert kinds[0] == [kind] * 3


@pytest.mark.parametrize(("dashes", "kind"), [(4, None), (1, EXTENSION)])
def test_the_last_dash_may_go_on_as_another_lines_first(
    dashes: int, kind: AnnotationKind | None
) -> None:
    """Two hidden lines meet in an edge at a small angle."""
    shapes = [_row([12.0] * dashes + [24.0], 6, 2.0), _row([12.0] * 5, 6, 2.0), _solid(90, 3.0)]
    kinds = kinds_of_runs(shapes, Weights(3.0, 2.4), 2.6)[0]
    assert kinds[-1] == kind


def test_a_dash_may_look_a_little_wide() -> None:
    """Three dashes on a copy, the middle one as wide as the narrowest edges."""
    pieces = [(0, 12, 2.2), (18, 30, 2.5), (36, 48, 2.1)]
    shapes = [_shape(*pieces), _row([12, 12, 12, 12, 12], 6, 2.0), _solid(90, 3.0)]
    assert kinds_of_runs(shapes, Weights(3.0, 2.4), 2.6)[0] == [None] * 3


def test_the_first_dash_may_go_on_from_an_edge() -> None:
    """The line is hidden from a corner on: its first dash belongs to it, not to the edge."""
    pieces = [(0, 100, 3.0), (100, 112, 2.0), (118, 130, 2.0), (136, 148, 2.0), (154, 166, 2.0)]
    shapes = [_shape(*pieces), _row([12, 12, 12, 12, 12], 6, 2.0), _solid(90, 1.9)]
    kinds = kinds_of_runs(shapes, Weights(3.0, 2.4), 2.6)
    assert kinds[0] == [None] * 5
    # An extension line that goes on from an edge has nothing behind it.
    stub = [_shape((0, 100, 3.0), (100, 112, 1.6)), _row([12, 12, 12, 12, 12], 6, 2.0)]
    assert kinds_of_runs(stub, Weights(3.0, 2.4), 2.6)[0] == [None, EXTENSION]


def test_a_centre_line_may_begin_where_an_extension_line_ends() -> None:
    """A dimension to the middle of a hole: its extension line ends just before the centre mark."""
    row = [(0.0, 56.0), (59.0, 82.0), (88.5, 107.5), (112.5, 116.5), (122.5, 140.5)]
    row += [(145.5, 149.5), (154.0, 173.0)]
    dashes = _row([14.0] * 9, 6.0, 1.7)
    shapes = [_shape(*((*ends, 1.7) for ends in row)), dashes, _solid(300, 3.0), _solid(200, 1.7)]
    kinds = kinds_of_runs(shapes, Weights(3.0, 2.4), 2.6)
    assert kinds[0] == [EXTENSION] * 2 + [CENTRE] * 5
    assert kinds[1] == [None] * 9


def test_dashes_that_faded_in_part_are_no_centre_line() -> None:
    dashes = [[20.0 * k, 20.0 * k + 14.0] for k in range(9)]
    for short, shift in ((4.0, 0.0), (5.0, 9.0), (6.0, 1.0)):
        faded = [list(ends) for ends in dashes]
        for k in (2, 4):
            faded[k] = [dashes[k][0] + shift, dashes[k][0] + shift + short]
        shapes = [_shape(*((a, b, 1.7) for a, b in own)) for own in (faded, dashes)]
        kinds = kinds_of_runs([*shapes, _solid(300, 3.0), _solid(200, 1.7)], Weights(3.0, 2.4), 2.6)
        assert kinds[0] == [None] * 9


def test_two_families_of_widths() -> None:
    shapes = [
        _solid(300, 3.0),
        _solid(250, 3.1),
        _solid(80, 2.9),
        _solid(200, 1.5),
        _solid(90, 1.6),
    ]
    weights = line_weights(shapes, 2.4)
    assert weights.visible == pytest.approx(3.0)
    assert 1.7 < weights.limit < 2.6


@pytest.mark.parametrize(("narrow", "wide"), [(1.0, 2.0), (1.5, 3.0), (1.8, 3.6), (2.0, 2.8)])
def test_the_limit_is_between_the_families(narrow: float, wide: float) -> None:
    spread = 0.04 * narrow
    shapes = [_solid(100 + k, wide + spread * (k % 3 - 1)) for k in range(12)]
    shapes += [_solid(60 + k, narrow + spread * (k % 3 - 1)) for k in range(9)]
    weights = line_weights(shapes, 2.0)
    assert narrow + 2 * spread < weights.limit < wide - 2 * spread
    assert weights.visible == pytest.approx(wide, abs=2 * spread)
    # In any order.
    backwards = line_weights(shapes[::-1], 2.0)
    assert backwards.limit == pytest.approx(weights.limit)
    assert backwards.visible == weights.visible


@pytest.mark.parametrize(
    "shapes",
    [
        [_solid(300, 3.0), _solid(200, 3.0)],
        [_solid(300, 3.0), _solid(200, 3.2), _solid(100, 2.8), _solid(50, 3.1)],
        # Too little of it: a scratch, a smudge.
        [_solid(900, 3.0), _solid(300, 3.1), _solid(30, 1.5)],
        [_solid(900, 1.5), _solid(300, 1.6), _solid(30, 3.0)],
        # Of all widths: badly scanned.
        [_solid(100, 2.0 + 0.1 * k) for k in range(15)],
        # One pen of less than two px, as its lines' places make it wider and narrower.
        [
            *(_solid(60, width) for width in (1.2, 1.42, 1.45, 1.54, 1.56)),
            *(_solid(300, width) for width in (1.77, 1.8, 1.84, 1.96, 1.98, 1.98, 1.98)),
        ],
        # Nothing long, nothing measured, nothing at all.
        [_solid(12, 1.0), _solid(12, 3.0)],
        [_solid(100, None)],
        [],
    ],
)
def test_one_family_has_no_limit(shapes: list[InkedShape]) -> None:
    assert line_weights(shapes, 3.0).limit == 0.0


def test_heads_of_arrows_are_no_wide_lines() -> None:
    lines = [_solid(2300, 0.9), _solid(2300, 1.2), _solid(4000, 1.8), _solid(4000, 2.0)]
    heads = [_solid(27, width) for width in (3.2, 3.6, 4.0, 5.5, 6.0, 6.2) for _ in range(5)]
    weights = line_weights([*lines, *heads], 2.0)
    assert 1.2 < weights.limit < 1.8
    assert weights.visible == pytest.approx(2.0)


def test_nothing_measured_is_as_wide_as_the_sheet() -> None:
    assert line_weights([_solid(12, 1.0)], 2.7) == Weights(2.7, 0.0)


TWO = Weights(3.0, 2.2)


def _kinds(*shapes: InkedShape, weights: Weights = TWO) -> list[list[AnnotationKind | None]]:
    return kinds_of_runs(shapes, weights, 2.4)


def test_wide_lines_stay_and_narrow_ones_go() -> None:
    found = _kinds(_solid(200, 3.0), _solid(200, 1.5), _solid(100, None))
    assert found == [[None], [EXTENSION], [None]]


def test_hidden_lines_stay_though_they_are_narrow() -> None:
    dashes = _row([12.0] * 8, 6.0, 1.5)
    assert _kinds(dashes, dashes, _solid(200, 3.0)) == [[None] * 8, [None] * 8, [None]]


@pytest.mark.parametrize("width", [1.5, 3.0])
@pytest.mark.parametrize("weights", [TWO, Weights(3.0, 0.0)])
def test_centre_lines_go_whatever_their_weight(width: float, weights: Weights) -> None:
    centre = _row([24.0, 6.0, 24.0, 6.0, 24.0], 4.5, width)
    hidden = _row([12.0] * 8, 6.0, 1.5)
    assert _kinds(centre, hidden, weights=weights) == [[CENTRE] * 5, [None] * 8]


def test_an_extension_line_and_the_edge_that_it_goes_on_as() -> None:
    both = _shape((0.0, 60.0, 1.5), (60.0, 200.0, 3.0), (200.0, 230.0, 1.5))
    assert _kinds(both, _row([12.0] * 8, 6.0, 1.5))[0] == [EXTENSION, None, EXTENSION]


def test_without_weights_only_rhythm_tells() -> None:
    assert _kinds(_solid(200, 1.5), _solid(200, 3.0), weights=Weights(3.0, 0.0)) == [[None], [None]]


def test_two_centre_lines_in_a_row_are_told_apart_from_what_lies_between() -> None:
    """A gap wider than that of any dashed line parts them."""
    first = [(0.0, 24.0), (28.5, 34.5), (39.0, 63.0)]
    pieces = [(a + shift, b + shift, 1.5) for shift in (0.0, 300.0) for a, b in first]
    assert _kinds(_shape(*pieces[:3], (120.0, 220.0, 3.0), *pieces[3:]))[0] == (
        [CENTRE] * 3 + [None] + [CENTRE] * 3
    )


def test_no_shapes_no_kinds() -> None:
    assert _kinds() == []
    assert _kinds(_shape()) == [[]]


def test_hidden_dashes_that_lead_to_an_edge_are_no_centre_line() -> None:
    """A circle that touches the line makes one dash longer, the edge another."""
    pieces = [(0.0, 13.5, 2.0), (20.5, 51.5, 2.1), (58.5, 71.0, 2.0), (77.5, 142.5, 2.7)]
    (own,) = kinds_of_runs([_shape(*pieces)], Weights(2.9, 0.0), 2.6)
    assert own == [None] * 4
    (even,) = kinds_of_runs([_shape(*((a, b, 2.0) for a, b, _ in pieces))], Weights(2.9, 0.0), 2.6)
    assert even == [CENTRE] * 4


def test_an_edge_with_extension_lines_at_both_ends_is_no_centre_line() -> None:
    """One dash between two lines that are far longer than any dash of a centre line."""
    pieces = [(0.0, 159.0, 2.4), (163.5, 179.0, 2.4), (183.0, 653.0, 2.4)]
    (own,) = kinds_of_runs([_shape(*pieces)], Weights(2.4, 0.0), 2.4)
    assert own == [None] * 3
    # Beside a dot a dash may be as long as standards have it.
    dotted = [(0.0, 60.0, 2.4), (67.0, 69.0, 2.4), (76.0, 136.0, 2.4)]
    (own,) = kinds_of_runs([_shape(*dotted)], Weights(2.4, 0.0), 2.4)
    assert own == [CENTRE] * 3


def test_a_dash_that_an_edge_cuts_is_one_beside_others() -> None:
    """Long, short, long and short it seems, but for the gap in which the edge lies."""
    gap = 12.8
    pieces = [(0.0, 24.4, 1.4), (37.0, 43.5, 1.4), (46.0, 62.0, 1.4), (62.0 + gap, 83.3, 1.4)]
    (own,) = kinds_of_runs([_shape(*pieces)], Weights(3.0, 0.0), 2.6, gap)
    assert own == [None] * 4
    # A centre line that an edge cuts as well is still one.
    centre = [(0.0, 30.0), (42.0, 47.0), (59.0, 66.0), (68.5, 89.0), (101.0, 106.0), (118.0, 148.0)]
    (own,) = kinds_of_runs(
        [_shape(*((a, b, 1.4) for a, b in centre))], Weights(3.0, 0.0), 2.6, 12.0
    )
    assert own == [CENTRE] * 6
