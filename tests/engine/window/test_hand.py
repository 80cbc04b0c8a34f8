"""What presses and releases of the mouse mean, without a window."""

import sys
from dataclasses import replace
from math import hypot
from pathlib import Path

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

sys.path.insert(0, str(Path(__file__).resolve().parents[3]))

from freecad.gaussiancad.canvas.ground import Ground
from freecad.gaussiancad.canvas.hand import Hand
from freecad.gaussiancad.canvas.sheet import Sheet, Stroke, View
from freecad.gaussiancad.canvas.tools import (
    CLICKS,
    DRAGS,
    TOOLS,
    Boxed,
    Chosen,
    Cut,
    Drawn,
    Meaning,
    Measured,
    Said,
    Traced,
)

Place = tuple[float, float]

_LEVEL = Stroke("s1", "front", "visible", ("line", ((0.0, 0.0), (100.0, 0.0))))
_CIRCLE = Stroke("s2", "front", "hidden", ("arc", (60.0, 60.0, 15.0, 0.0, 6.283185)))
_FRONT = View("front", "front", (0.0, 0.0, 200.0, 100.0))
_GROUND = Ground(Sheet((_LEVEL, _CIRCLE), (_FRONT,), (), "", None), frozenset(), 1.0)
_places = st.tuples(st.floats(0.0, 200.0), st.floats(0.0, 100.0))


def _drag(
    hand: Hand,
    start: Place,
    end: Place,
    ground: Ground = _GROUND,
    *,
    free: bool = False,
    more: bool = False,
) -> Meaning | None:
    hand.press(start, ground)
    return hand.release(end, ground, free=free, more=more)


def _with(tool: str) -> Hand:
    hand = Hand()
    hand.take(tool)
    return hand


def test_every_tool_takes_clicks_or_a_drag() -> None:
    assert set(CLICKS) | set(DRAGS) == set(TOOLS.values())
    assert not set(CLICKS) & set(DRAGS)


@pytest.mark.parametrize(
    ("tool", "kind", "stays"),
    [
        ("line", Drawn, True),
        ("circle", Drawn, True),
        ("view", Boxed, True),
        ("plane", Cut, False),
        ("ignore-area", Said, True),
    ],
)
def test_a_drag_means_what_its_tool_makes(tool: str, kind: type, stays: bool) -> None:
    hand = _with(tool)
    assert isinstance(_drag(hand, (20.0, 40.0), (90.0, 80.0)), kind)
    assert hand.tool == (tool if stays else "")
    assert not hand.began


def test_a_plane_outside_of_all_views_means_nothing() -> None:
    hand = _with("plane")
    assert _drag(hand, (300.0, 300.0), (400.0, 300.0)) is None
    assert hand.tool == "plane"


def test_clicks_are_gathered_until_the_tool_has_enough() -> None:
    hand = _with("scale")
    assert _drag(hand, (1.0, 2.0), (1.0, 2.0)) is None
    assert _drag(hand, (99.0, 2.0), (99.0, 2.0)) == Measured(((0.0, 0.0), (100.0, 0.0)))
    assert hand.tool == ""
    hand = _with("arc")
    for at in ((0.0, 0.0), (50.0, 0.0)):
        assert _drag(hand, at, at) is None
    assert _drag(hand, (100.0, 0.0), (100.0, 0.0)) is None, "three places in line"
    assert hand.tool == "arc"
    assert _drag(_with("pick"), (1.0, 2.0), (1.0, 2.0)) == Traced((1.0, 2.0)), "ink does not snap"


def test_another_tool_forgets_clicks() -> None:
    hand = _with("scale")
    _drag(hand, (1.0, 2.0), (1.0, 2.0))
    hand.take("scale")
    assert _drag(hand, (99.0, 2.0), (99.0, 2.0)) is None


@given(_places, _places, st.booleans())
def test_a_line_is_level_or_upright_unless_it_is_free(a: Place, b: Place, free: bool) -> None:
    bare = replace(_GROUND, sheet=replace(_GROUND.sheet, strokes=()))
    made = _drag(_with("line"), a, b, bare, free=free)
    if isinstance(made, Drawn):
        first, last = made.shape[1]
        assert first == made.at == a
        level = [(b[0], a[1]), (a[0], b[1])]
        low, high = sorted((abs(a[0] - b[0]), abs(a[1] - b[1])))
        # A free line that hardly leans is straightened, too.
        assert last in ([b, *(level if low <= 0.021 * high else [])] if free else level)
    else:
        assert isinstance(made, Chosen), "too short for a line"


@given(_places, _places)
def test_what_is_selected_with_others_stays(a: Place, b: Place) -> None:
    ground = replace(_GROUND, chosen=frozenset({"s2"}))
    hand = Hand()
    # No handle is held.
    hand.press(a, replace(ground, chosen=frozenset()))
    made = hand.release(b, ground, free=False, more=True)
    clicked = max(abs(a[0] - b[0]), abs(a[1] - b[1])) < 4.0
    assert "s2" in made.ids or clicked


def test_a_click_with_others_takes_back_what_was_selected() -> None:
    ground = replace(_GROUND, chosen=frozenset({"s1", "s2"}))
    assert _drag(Hand(), (50.0, 0.0), (50.0, 0.0), ground, more=True) == Chosen(frozenset({"s2"}))


def test_a_handle_moves_a_stroke_in_one_step() -> None:
    ground = replace(_GROUND, chosen=frozenset({"s2"}))
    made = _drag(Hand(), (75.0, 60.0), (90.0, 61.0), ground)
    erase, draw = made.operations
    assert (erase["op"], erase["target"]["id"]) == ("erase", "s2")
    assert (draw["op"], draw["kind"], draw["arc"][:2]) == ("draw", "hidden", (60.0, 60.0))
    assert draw["arc"][2] > 29.0


def test_a_corner_of_a_view_moves_and_the_other_stays() -> None:
    ground = replace(_GROUND, chosen=frozenset({"front"}))
    (item,) = _drag(Hand(), (200.0, 100.0), (230.0, 120.0), ground).operations
    assert item == {"op": "view", "id": "front", "role": "front", "box": [0.0, 0.0, 230.0, 120.0]}


@given(st.sampled_from(["", *TOOLS.values()]), _places, _places)
def test_what_would_be_made_ends_at_the_mouse(tool: str, a: Place, b: Place) -> None:
    assume(hypot(a[0] - b[0], a[1] - b[1]) > 1.0)
    hand = _with(tool)
    assert hand.rubber(b, _GROUND, free=True) is None
    hand.press(a, _GROUND)
    around = hand.rubber(b, _GROUND, free=True).boundingRect()
    inside = around.adjusted(-1e-6, -1e-6, 1e-6, 1e-6).contains(*b)
    # The path of a circle is made of curves that are near it.
    assert inside or tool == "circle"
    hand.drop()
    assert hand.rubber(b, _GROUND, free=True) is None
    assert hand.release(b, _GROUND, free=True, more=False) is None
