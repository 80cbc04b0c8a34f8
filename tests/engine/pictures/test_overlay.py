from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.labelling.conflict_lines import ConflictLine
from gaussiancad_core.lines.line_agreement import match_lines
from gaussiancad_core.lines.line_points import lines_of_strokes
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Linetype, Segment, Stroke, View
from gaussiancad_core.pictures.overlay import ViewOverlay, draw_overlay, matched_overlay

_SIZE = (40.0, 30.0, 20.0)
_BOX = (100.0, 60.0, 500.0, 260.0)
_BLUE, _LIGHT_BLUE = (0, 114, 178), (86, 180, 233)
_ORANGE, _MAGENTA = (213, 94, 0), (204, 51, 153)
_YELLOW = (240, 228, 66)


def _overlay(sheet: list[Stroke], result: list[Stroke], role: Role = Role.FRONT) -> ViewOverlay:
    blank = np.zeros((1, 1), dtype=bool)
    colour = np.zeros((1, 1, 3), dtype=np.uint8)
    view = View(role, _BOX, tuple(sheet), blank, colour, (0.0, 20.0), 0.1)
    matched = match_lines(sheet, lines_of_strokes(result, 0.05), 0.3)
    return ViewOverlay(view, _SIZE, matched_overlay(matched))


def _level(height: float, linetype: Linetype) -> Segment:
    return Segment((0, height), (40, height), linetype)


@pytest.mark.parametrize(
    ("role", "low", "high"),
    [
        (Role.FRONT, (0, 0), (40, 20)),
        (Role.LEFT, (-30, 0), (0, 20)),
        (Role.TOP, (0, 0), (40, 30)),
        (Role.BOTTOM, (0, -30), (40, 0)),
        (Role.REAR, (-40, 0), (0, 20)),
    ],
)
def test_the_part_fills_its_box(
    role: Role, low: tuple[float, float], high: tuple[float, float]
) -> None:
    pixels = _overlay([], [], role).to_sheet(np.array([low, high], dtype=float))
    assert pixels == pytest.approx(np.array([[100, 260], [500, 60]]))


def test_each_kind_has_its_colour() -> None:
    sheet = [_level(4, Linetype.VISIBLE), _level(8, Linetype.HIDDEN), _level(12, Linetype.VISIBLE)]
    result = [*sheet[:2], _level(16, Linetype.HIDDEN)]
    image = draw_overlay(np.full((400, 600, 3), 255, np.uint8), [_overlay(sheet, result)])
    colours = {4: _BLUE, 8: _LIGHT_BLUE, 12: _ORANGE, 16: _MAGENTA}
    for height, colour in colours.items():
        row = round(260 - height * 10)
        assert (image[row, 105:495] == colour).all()


def test_the_sheet_stays_under_it_and_fades() -> None:
    sheet = np.full((400, 600), 255, np.uint8)
    sheet[300] = 0
    image = draw_overlay(sheet, [_overlay([], [])])
    assert image.shape[1] == 600 and image.shape[0] > 400
    assert (image[300] == image[300, 0]).all() and 120 < image[300, 0, 0] < 220
    assert (image[350] == 255).all()


def test_the_view_is_framed_and_named() -> None:
    image = draw_overlay(np.full((400, 600), 255, np.uint8), [_overlay([], [])])
    frame = (image[:, 300] < 200).all(axis=1)
    assert frame[50:60].sum() == 1 and frame[260:270].sum() == 1
    assert (image[35:54, 92:140] < 128).any()


def test_all_colours_are_in_the_legend() -> None:
    image = draw_overlay(np.full((400, 600), 255, np.uint8), [])
    legend = image[400:].reshape(-1, 3)
    for colour in (_BLUE, _LIGHT_BLUE, _ORANGE, _MAGENTA):
        assert (legend == colour).all(axis=1).any()


def test_a_huge_sheet_is_reduced() -> None:
    image = draw_overlay(np.full((300, 9000), 255, np.uint8), [])
    assert image.shape[1] == 4000


def test_what_lies_outside_the_sheet_is_cut_off() -> None:
    image = draw_overlay(
        np.full((200, 300), 255, np.uint8),
        [_overlay([_level(12, Linetype.VISIBLE)], [_level(12, Linetype.VISIBLE)])],
    )
    assert (image[140, 105:295] == _BLUE).all()


@pytest.mark.parametrize("suspect", [False, True])
def test_lines_that_contradict_each_other_are_marked_under_all_others(suspect: bool) -> None:
    line = _level(8, Linetype.VISIBLE)
    marked = ConflictLine(Role.FRONT, np.array([line.start, line.end]), line.linetype, suspect)
    blank = np.full((400, 600, 3), 255, np.uint8)
    plain = draw_overlay(blank, [_overlay([line], [line])])
    image = draw_overlay(blank, [replace(_overlay([line], [line]), conflict=(marked,))])
    column = image[:, 300]
    assert (column[180] == _BLUE).all()
    yellow = (column[:300] == _YELLOW).all(axis=1)
    black = (column[:300] == 0).all(axis=1)
    assert yellow.sum() >= 5 and set(np.flatnonzero(yellow)) <= set(range(172, 190))
    assert (black.sum() >= 4) == suspect
    assert (image[410:] == _YELLOW).all(axis=2).any() and not (plain == _YELLOW).all(axis=2).any()
    assert image.shape[1] > plain.shape[1]


def test_a_single_marked_curve_follows_its_points() -> None:
    angles = np.linspace(0.0, np.pi, 40)
    points = np.array([20.0, 8.0]) + 6.0 * np.stack([np.cos(angles), np.sin(angles)], 1)
    marked = ConflictLine(Role.FRONT, points, None)
    overlay = replace(_overlay([], []), conflict=(marked,))
    image = draw_overlay(np.full((400, 600), 255, np.uint8), [overlay])
    rows, columns = np.nonzero((image[:300] == _YELLOW).all(axis=2))
    radii = np.hypot(columns - 300.0, rows - 180.0)
    assert np.abs(radii - 60.0).max() < 8.0 and rows.max() < 190
