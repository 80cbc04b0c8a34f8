"""How far ink lies beside lines: to a few hundredths of a pixel, where it is one pen's alone."""

from math import tau

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from gaussiancad_core.evidence.ink_offsets import ink_offsets
from gaussiancad_core.model.axes import Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.registration.view_registration import Placement

_SIDE, _WIDTH, _PX = 200, 3.0, 0.5
"""px of the sheet, px of the pen, mm per px."""

_CENTRE = 100.0
_PLACEMENT = Placement(Role.TOP, (0.0, 0.0, _SIDE, _SIDE), (0.0, _SIDE * _PX), (0.0, _SIDE * _PX))


def _sheet(*distances: np.ndarray) -> CleanSheet:
    """A sheet of lines, of each of which the distance of all pixels is given."""
    nearest = np.minimum.reduce(distances)
    ink = np.clip(0.5 * _WIDTH + 0.5 - nearest, 0.0, 1.0)
    return clean_sheet(np.rint(255.0 * (1.0 - ink)).astype(np.uint8), 0)


def _pixels() -> tuple[np.ndarray, np.ndarray]:
    y, x = np.mgrid[:_SIDE, :_SIDE] + 0.5
    return x, y


def _circle(radius: float) -> np.ndarray:
    x, y = _pixels()
    return np.abs(np.hypot(x - _CENTRE, y - _CENTRE) - radius)


def _arc(radius: float, sweep: float = tau, linetype: Linetype = Linetype.VISIBLE) -> Arc:
    """An arc about the middle, whose radius is told in px."""
    return Arc((_CENTRE * _PX, _CENTRE * _PX), radius * _PX, 0.3, sweep, linetype)


@settings(deadline=None, max_examples=30)
@given(radius=st.floats(15.0, 90.0), off=st.floats(-1.5, 1.5), sweep=st.floats(1.2, tau))
def test_an_arc_is_as_far_from_its_ink_as_the_radii_differ(
    radius: float, off: float, sweep: float
) -> None:
    (found,) = ink_offsets(
        Role.TOP, [_arc(radius + off, sweep)], _PLACEMENT, _sheet(_circle(radius))
    )
    assert found.offset == pytest.approx(abs(off), abs=0.06)
    middle = np.hypot(*(np.array(found.place) / _PX - _CENTRE))
    assert middle == pytest.approx(radius + off, abs=0.1)


@settings(deadline=None, max_examples=20)
@given(turn=st.floats(0.0, 0.0055))
def test_a_leaning_line_is_farthest_off_towards_its_end(turn: float) -> None:
    x, y = _pixels()
    sheet = _sheet(np.where((x > 20) & (x < 180), np.abs(y - _CENTRE), _SIDE))
    rise = 160.0 * turn
    line = Segment(
        (20.0 * _PX, _CENTRE * _PX), (180.0 * _PX, (_CENTRE + rise) * _PX), Linetype.VISIBLE
    )
    (found,) = ink_offsets(Role.TOP, [line], _PLACEMENT, sheet)
    # The mean over the last eighth of the line.
    assert found.offset == pytest.approx(rise * 15 / 16, abs=0.05)


def test_ink_of_another_line_is_no_offset() -> None:
    x, _ = _pixels()
    crossed = _sheet(_circle(60.0), np.abs(x - _CENTRE))
    (found,) = ink_offsets(Role.TOP, [_arc(60.0)], _PLACEMENT, crossed)
    assert found.offset < 0.03


def test_a_line_whose_ink_is_nowhere_alone_says_nothing() -> None:
    doubled = _sheet(_circle(60.0), _circle(64.0))
    assert not ink_offsets(Role.TOP, [_arc(60.0)], _PLACEMENT, doubled)


def test_hidden_lines_are_not_asked() -> None:
    hidden = _arc(61.0, linetype=Linetype.HIDDEN)
    assert not ink_offsets(Role.TOP, [hidden], _PLACEMENT, _sheet(_circle(60.0)))
