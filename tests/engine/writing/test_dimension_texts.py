"""Texts and the lengths that they belong to."""

import pytest

from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.model.views import Arc, Linetype
from gaussiancad_core.sheet.annotations.annotation_marks import line_mark
from gaussiancad_core.sheet.tracing.level_rules import Rule
from gaussiancad_core.writing.dimension_texts import Span, adjacent_extents, spans_of
from gaussiancad_core.writing.leaders import circles_at, leaders_of, shelves_of
from gaussiancad_core.writing.sheet_texts import SheetText

Box = tuple[float, float, float, float]


def level(at: float, low: float, high: float) -> Rule:
    return Rule(True, at, low, high)


def upright(at: float, low: float, high: float) -> Rule:
    return Rule(False, at, low, high)


def text(box: Box, along: bool = True) -> SheetText:
    return SheetText("40", box, along)


def turned(rule: Rule) -> Rule:
    return Rule(not rule.level, rule.at, rule.low, rule.high)


ISO = [level(200, 100, 300), upright(100.2, 150, 208), upright(299.9, 150, 208)]
ABOVE = (188.0, 176.0, 212.0, 194.0)


def test_a_text_above_its_line_has_what_is_between_the_extension_lines() -> None:
    assert spans_of(text(ABOVE), ISO, []) == (Span(True, 100.2, 299.9),)


@pytest.mark.parametrize("along", [True, False])
def test_a_level_text_interrupts_its_line(along: bool) -> None:
    box = (186.0, 191.0, 214.0, 209.0)
    rules = [level(200, 100, 180), level(200, 220, 300), *ISO[1:]]
    if not along:
        box = (186.0, 191.0, 214.0, 209.0)
        rules = [
            upright(200, 100, 185),
            upright(200, 215, 300),
            level(100.2, 150, 208),
            level(299.9, 150, 208),
        ]
    (span,) = spans_of(text(box), rules, [])
    assert (span.level, span.low, span.high) == (along, 100.2, 299.9)


def test_in_a_chain_each_text_has_its_own_link() -> None:
    rules = [level(200, 100, 500), *(upright(x, 150, 208) for x in (100.0, 180.0, 330.0, 500.0))]
    for low, high in ((100.0, 180.0), (180.0, 330.0), (330.0, 500.0)):
        middle = (low + high) / 2
        box = (middle - 12, 176.0, middle + 12, 194.0)
        first, *others = spans_of(text(box), rules, [])
        assert first == Span(True, low, high)
        assert all(span.weight < first.weight for span in others)


def test_arrows_outside_measure_what_is_between_them() -> None:
    rules = [level(200, 60, 170), upright(100, 150, 208), upright(130, 150, 208)]
    assert spans_of(text((103, 176, 127, 194)), rules, [])[0] == Span(True, 100, 130)
    # The text beside the extension lines, above the line that goes on.
    rules[0] = level(200, 60, 190)
    assert spans_of(text((160, 176, 184, 194)), rules, [])[0] == Span(True, 100, 130)


def test_the_arrowheads_at_its_ends_are_part_of_a_line() -> None:
    # They are wider than lines: 16 px at both ends were not followed.
    rules = [level(200, 116, 284), *ISO[1:]]
    assert spans_of(text(ABOVE), rules, [])[0] == Span(True, 100.2, 299.9)
    # The next dimension's extension line, farther away than a head is long, is not its own.
    rules = [level(200, 116, 284), ISO[1], upright(330, 150, 208)]
    assert spans_of(text(ABOVE), rules, []) == ()


@pytest.mark.parametrize("along", [True, False])
@pytest.mark.parametrize("beyond", [True, False])
def test_two_lines_that_point_at_each_other_measure_what_is_between(
    along: bool, beyond: bool
) -> None:
    # The number stands at the outer end of one of them, or above it.
    rules = [
        level(200, 60, 84),
        level(200, 156, 190),
        upright(100, 150, 208),
        upright(140, 150, 208),
    ]
    box = (194.0, 191.0, 216.0, 209.0) if beyond else (162.0, 176.0, 184.0, 194.0)
    if not along:
        rules = [turned(rule) for rule in rules]
        box = (box[1], box[0], box[3], box[2])
    found = spans_of(text(box, along), rules, [])
    assert max(found, key=lambda span: span.weight) == Span(along, 100, 140, 0.9)


@pytest.mark.parametrize("along", [True, False])
def test_an_arrow_of_its_own_points_at_the_next_line_where_the_other_was_not_found(
    along: bool,
) -> None:
    rules = [level(200, 156, 190), *(upright(x, 150, 208) for x in (60, 100, 140, 192))]
    box = (162.0, 176.0, 184.0, 194.0)
    if not along:
        rules = [turned(rule) for rule in rules]
        box = (box[1], box[0], box[3], box[2])
    found = spans_of(text(box, along), rules, [])
    assert Span(along, 100, 140, 0.5) in found
    # Nothing beyond the next one, and likelier is what the line itself lies between.
    assert not any(span.low == 60 for span in found)
    assert found[0] == Span(along, 140, 192)


def test_a_level_text_need_not_stand_on_the_middle_of_the_line_it_interrupts() -> None:
    rules = [
        upright(157, 300, 388),
        upright(157, 412, 500),
        level(300, 150, 210),
        level(500, 150, 210),
    ]
    assert spans_of(text((153, 393, 183, 407)), rules, [])[0] == Span(False, 300, 500)
    assert spans_of(text((158, 393, 188, 407)), rules, []) == ()


def test_edges_serve_where_there_is_no_extension_line() -> None:
    edges = [upright(100.0, 20, 400), upright(300.0, 20, 400)]
    (span,) = spans_of(text(ABOVE), ISO[:1], edges)
    assert (span.low, span.high) == (100.0, 300.0)
    assert span.weight < 1.0


def test_pieces_of_a_centre_line_are_one_stop() -> None:
    pieces = [upright(300.0, 100, 140), upright(300.1, 146, 152), upright(300.2, 158, 210)]
    (span,) = spans_of(text(ABOVE), [*ISO[:2], *pieces], [])
    assert span.high == 300.2


def test_a_leader_tells_the_circle_that_it_points_at() -> None:
    marks = [
        line_mark(AnnotationKind.EXTENSION, (130, 70), (170, 30)),
        line_mark(AnnotationKind.EXTENSION, (170, 30), (230, 30)),
    ]
    small, large = (
        Arc((100.0, 100.0), radius, 0.0, 6.28, Linetype.VISIBLE) for radius in (20.0, 42.4)
    )
    neighbour = Arc((100.0, 20.0), 58.0, 0.0, 6.28, Linetype.VISIBLE)
    note = text((175.0, 8.0, 225.0, 26.0))
    ways = leaders_of(marks), shelves_of(marks)
    assert circles_at(note, *ways, [small, large, neighbour]) == (large,)
    assert circles_at(note, *ways, [small, neighbour]) == ()
    assert circles_at(text((400.0, 8.0, 450.0, 26.0)), *ways, [large]) == ()


def test_a_leader_that_an_edge_cuts_may_point_at_either_circle() -> None:
    marks = [
        line_mark(AnnotationKind.EXTENSION, (132, 68), (170, 30)),
        line_mark(AnnotationKind.EXTENSION, (114.5, 85.5), (128, 72)),
        line_mark(AnnotationKind.EXTENSION, (170, 30), (230, 30)),
    ]
    arcs = [Arc((100.0, 100.0), radius, 0.0, 6.28, Linetype.VISIBLE) for radius in (20.0, 42.4)]
    note = text((175.0, 8.0, 225.0, 26.0))
    found = circles_at(note, leaders_of(marks), shelves_of(marks), arcs)
    assert {arc.radius for arc in found} == {20.0, 42.4}


@pytest.mark.parametrize("level", [True, False])
def test_a_text_in_the_middle_of_a_side_may_tell_the_extent(level: bool) -> None:
    box = (100.0, 100.0, 300.0, 106.0) if level else (100.0, 100.0, 106.0, 300.0)
    neighbour = (320.0, 94.0, 370.0, 112.0) if level else (78.0, 320.0, 128.0, 338.0)
    thin = Span(not level, 100.0, 106.0, 0.4)
    assert adjacent_extents(text(neighbour), [box]) == (thin,)
    # Far away, or off the middle, it tells nothing.
    x0, y0, x1, y1 = neighbour
    far = 200.0
    away = (x0 + far, y0, x1 + far, y1) if level else (x0, y0 + far, x1, y1 + far)
    off = (x0, y0 + 30.0, x1, y1 + 30.0) if level else (x0 + 40.0, y0, x1 + 40.0, y1)
    assert adjacent_extents(text(away), [box]) == ()
    assert adjacent_extents(text(off), [box]) == ()
