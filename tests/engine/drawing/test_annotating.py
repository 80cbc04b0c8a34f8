from dataclasses import replace
from functools import cache

import pytest

from gaussiancad_core.drawing.annotating import reserved_corner, scale_note, sheet_dpi
from gaussiancad_core.drawing.annotation import AnnotationKind
from gaussiancad_core.drawing.drawn_sheet import PartLines, Sheet, compose_sheet, part_lines
from gaussiancad_core.drawing.frame import block_box, border
from gaussiancad_core.drawing.sheet_style import PRESETS, SheetStyle
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.samples import sample
from gaussiancad_core.samples.random_parts import random_part

STYLE = PRESETS["dimensioned"]
Kind = AnnotationKind

ARRANGEMENTS = [
    ((Role.FRONT, Role.TOP, Role.RIGHT), Projection.THIRD),
    ((Role.FRONT, Role.TOP, Role.LEFT), Projection.FIRST),
    ((Role.FRONT, Role.BOTTOM, Role.RIGHT), Projection.THIRD),
    (tuple(Role), Projection.THIRD),
]


@cache
def _lines(part: str | int) -> PartLines:
    shape = sample(part).build() if isinstance(part, str) else random_part(part)
    return part_lines(shape, tuple(Role))


def _sheet(part: str | int, arrangement: int, style: SheetStyle = STYLE) -> Sheet:
    roles, projection = ARRANGEMENTS[arrangement]
    lines = _lines(part)
    chosen = PartLines(lines.size, {role: lines.views[role] for role in roles})
    return compose_sheet(chosen, projection, style)


@pytest.mark.parametrize(
    ("switches", "kinds"),
    [
        ({}, set()),
        ({"frame": True}, {Kind.FRAME, Kind.TITLE_BLOCK, Kind.TEXT, Kind.SYMBOL}),
        ({"centre_lines": True}, {Kind.CENTRE_LINE, Kind.CENTRE_MARK}),
        ({"annotations": True}, {Kind.DIMENSION, Kind.EXTENSION, Kind.LEADER, Kind.TEXT}),
    ],
)
def test_each_switch_draws_its_kinds(switches: dict[str, bool], kinds: set[Kind]) -> None:
    # At this height of the text the small holes have marks, the large ones lines.
    style = SheetStyle(margin=130.0, view_gap=170.0, text_height=70.0 / 1.2, **switches)
    if "annotations" in switches or "frame" in switches:
        style = replace(style, text_height=18.0)
    assert {mark.kind for mark in _sheet("boss-plate", 0, style).annotations} == kinds


@pytest.mark.parametrize("part", ["boss-plate", "wedge-block", 3, 8])
@pytest.mark.parametrize("arrangement", range(len(ARRANGEMENTS)))
def test_only_some_kinds_enter_the_views(part: str | int, arrangement: int) -> None:
    sheet = _sheet(part, arrangement)
    outside = (Kind.FRAME, Kind.TITLE_BLOCK, Kind.TEXT, Kind.DIMENSION, Kind.SYMBOL)
    frame = border(STYLE)
    for mark in sheet.annotations:
        if mark.kind in outside:
            pieces = [mark.box]
            if mark.kind is Kind.FRAME:
                # The border goes around everything: its lines one by one.
                pieces = [replace(mark, strokes=(stroke,)).box for stroke in mark.strokes]
            for x0, y0, x1, y1 in pieces:
                for view in sheet.views:
                    u0, v0, u1, v1 = view.box
                    assert x1 <= u0 or u1 <= x0 or y1 <= v0 or v1 <= y0, (mark.kind, view.role)
        if mark.kind in (Kind.DIMENSION, Kind.EXTENSION, Kind.LEADER, Kind.CENTRE_LINE):
            x0, y0, x1, y1 = mark.box
            assert frame[0] < x0 and frame[1] < y0 and x1 < frame[2] and y1 < frame[3]


@pytest.mark.parametrize("part", ["boss-plate", "wedge-block", 3, 8])
@pytest.mark.parametrize("arrangement", range(len(ARRANGEMENTS)))
def test_the_views_leave_the_title_block_its_corner(part: str | int, arrangement: int) -> None:
    x0, y0, _, _ = block_box(STYLE)
    for view in _sheet(part, arrangement).views:
        assert view.box[2] < x0 or view.box[3] < y0


def test_without_a_frame_no_corner_is_reserved() -> None:
    assert reserved_corner(SheetStyle(annotations=True, centre_lines=True)) == (0.0, 0.0)
    width, height = reserved_corner(STYLE)
    x0, y0, _, _ = block_box(STYLE)
    assert (STYLE.width - width, STYLE.height - height) < (x0, y0)


@pytest.mark.parametrize("mm_per_pixel", [0.001, 0.02, 0.13, 0.4, 1.0, 7.3])
def test_the_scale_is_a_standard_one_and_true_at_the_sheet_s_resolution(
    mm_per_pixel: float,
) -> None:
    note, dpi = scale_note(mm_per_pixel), sheet_dpi(mm_per_pixel)
    drawn, real = (int(number) for number in note.split(":"))
    assert 1 in (drawn, real)
    assert str(max(drawn, real)).rstrip("0") in ("1", "2", "5")
    on_paper = 25.4 / dpi
    assert on_paper * real / drawn == pytest.approx(mm_per_pixel)
    assert 120.0 < dpi < 330.0


def test_the_title_block_says_what_the_sheet_is() -> None:
    roles, projection = ARRANGEMENTS[1]
    lines = _lines("boss-plate")
    chosen = PartLines(lines.size, {role: lines.views[role] for role in roles})
    sheet = compose_sheet(chosen, projection, STYLE, title="Lager 7")
    texts = {mark.label.text for mark in sheet.annotations if mark.label is not None}
    assert {"Lager 7", scale_note(sheet.mm_per_pixel), "mm"} <= texts
    assert sheet.dpi == sheet_dpi(sheet.mm_per_pixel)
    assert _sheet("boss-plate", 0, PRESETS["clean"]).dpi is None


def test_notes_have_numbers_of_their_own() -> None:
    marks = _sheet("boss-plate", 0).annotations
    numbered = [mark for mark in marks if mark.group]
    kinds = {mark.group: set() for mark in numbered}
    for mark in numbered:
        kinds[mark.group].add(mark.kind)
    assert sorted(kinds) == list(range(1, len(kinds) + 1))
    assert set(map(frozenset, kinds.values())) == {
        frozenset({Kind.CENTRE_LINE}),
        frozenset({Kind.DIMENSION, Kind.EXTENSION, Kind.TEXT}),
        frozenset({Kind.LEADER, Kind.TEXT}),
    }
