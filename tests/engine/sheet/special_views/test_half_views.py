"""Half views are completed by their mirror image, and said to be."""

from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.model.axes import Role
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.reading_options import ReadingOptions
from gaussiancad_core.sheet.sheet_stages import read_views, register_views
from gaussiancad_core.sheet.special_views.half_views import Half, completed, find_halves
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind


def _halves(found) -> list:  # noqa: ANN001
    return [view for view in found.layout.special if view.kind is SpecialKind.HALF]


@pytest.mark.parametrize(
    ("part", "style", "role"),
    [
        ("bored-plate", "clean", "front"),
        ("u-bracket", "photocopy", "top"),
        ("slotted-link", "scan", "front"),
    ],
)
def test_the_other_half_is_its_mirror_image(find, part: str, style: str, role: str) -> None:  # noqa: ANN001
    found = find(part, f"{style},half={role}")
    (half,) = _halves(found)
    assert half.used
    assert set(found.layout.boxes) == {Role.FRONT, Role.TOP, Role.RIGHT}
    # The views agree about the whole part: the mirror image lies exactly where it should.
    drawn = read_views(found.separated.part, found.layout)
    extents = register_views(drawn, ReadingOptions()).extents
    assert max(extents.spread.values()) < 0.15
    assert max(residual.largest for residual in extents.residuals.values()) < 0.1
    box = found.layout.boxes[Role(role)]
    x0, _, x1, _ = half.box
    assert (box[2] - box[0]) / (x1 - x0) == pytest.approx(2.0, abs=0.05)


def test_a_side_along_which_an_edge_runs_is_not_open(find) -> None:  # noqa: ANN001
    """The same view, its side closed by a line where the centre line is."""
    found = find("bored-plate", "clean,half=front")
    part, stated = found.separated.part, found.separated.strokes_known
    box = next(view.box for view in found.layout.special if view.kind is SpecialKind.HALF)
    ink = part.ink.copy()
    at = round(box[2] - 2.0)
    # What the reader added goes first.
    ink[int(box[1]) : int(box[3]) + 1, at + 2 :] = False
    assert [type(half) for half in find_halves(ink, stated, [box], part.stroke_width)] == [Half]
    ink[int(box[1]) : int(box[3]) + 1, at - 1 : at + 2] = True
    assert find_halves(ink, stated, [box], part.stroke_width) == []


def test_the_whole_is_twice_the_half() -> None:
    half = Half((10.0, 20.0, 60.0, 90.0), True, 59.0, True, (10.0, 100.0))
    assert half.whole == (10.0, 20.0, 108.0, 90.0)
    level = Half((10.0, 20.0, 60.0, 90.0), False, 21.0, False, (0.0, 70.0))
    assert level.whole == (10.0, -48.0, 60.0, 90.0)
    assert half.marks((50.0, 95.0, 68.0, 105.0)) and not half.marks((70.0, 95.0, 88.0, 105.0))


@pytest.mark.parametrize("upright", [True, False])
def test_labels_are_mirrored_with_their_ink(upright: bool) -> None:
    grey = np.full((120, 160), 255, np.uint8)
    grey[30:90, 40:43] = grey[30:33, 40:80] = grey[87:90, 40:80] = 0
    odds = np.where(grey == 0, 5.0, -5.0).astype(np.float16)
    if not upright:
        grey, odds = grey.T.copy(), odds.T.copy()
    sheet = replace(clean_sheet(grey), hidden_odds=odds)
    box = (40.0, 30.0, 80.0, 90.0) if upright else (30.0, 40.0, 90.0, 80.0)
    whole = completed(sheet, Half(box, upright, 80.0, True, (25.0, 95.0)), [])
    assert whole is not None
    # On the centre line itself each half keeps its own.
    ink, item = (each if upright else each.T for each in (whole.ink, whole.hidden_odds))
    assert ink[:, 82:].sum() > 200
    assert (item[:, 82:][ink[:, 82:]] == 5.0).all()
