"""What presses and releases of the mouse mean, without a window."""

from dataclasses import replace
from math import hypot

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from freecad.gaussiancad.canvas.gestures import GestureController
from freecad.gaussiancad.canvas.hit_test import HitTest
from freecad.gaussiancad.canvas.sheet import Sheet, Stroke, View
from freecad.gaussiancad.canvas.tools import (
    TOOLS,
    Boxed,
    Chosen,
    Cut,
    Drawn,
    Meaning,
    Measured,
    Operations,
    Traced,
)

Place = tuple[float, float]

_LEVEL = Stroke("s1", "front", "visible", ("line", ((0.0, 0.0), (100.0, 0.0))))
_CIRCLE = Stroke("s2", "front", "hidden", ("arc", (60.0, 60.0, 15.0, 0.0, 6.283185)))
_FRONT = View("front", "front", (0.0, 0.0, 200.0, 100.0))
_HITS = HitTest(Sheet((_LEVEL, _CIRCLE), (_FRONT,), (), "", None), frozenset(), 1.0)
_places = st.tuples(st.floats(0.0, 200.0), st.floats(0.0, 100.0))


def _drag(
    gestures: GestureController,
    start: Place,
    end: Place,
    hits: HitTest = _HITS,
    *,
    free: bool = False,
    more: bool = False,
) -> Meaning | None:
    gestures.press(start, hits)
    return gestures.release(end, hits, free=free, more=more)


def _with(tool: str) -> GestureController:
    gestures = GestureController()
    gestures.take(tool)
    return gestures


@pytest.mark.parametrize(
    ("tool", "kind", "stays"),
    [
        ("line", Drawn, True),
        ("circle", Drawn, True),
        ("view", Boxed, True),
        ("plane", Cut, False),
        ("ignore-area", Operations, True),
    ],
)
def test_a_drag_means_what_its_tool_makes(tool: str, kind: type, stays: bool) -> None:
    gestures = _with(tool)
    assert isinstance(_drag(gestures, (20.0, 40.0), (90.0, 80.0)), kind)
    assert gestures.tool == (tool if stays else "")
    assert not gestures.began


def test_a_plane_outside_of_all_views_means_nothing() -> None:
    gestures = _with("plane")
    assert _drag(gestures, (300.0, 300.0), (400.0, 300.0)) is None
    assert gestures.tool == "plane"


def test_clicks_are_gathered_until_the_tool_has_enough() -> None:
    gestures = _with("scale")
    assert _drag(gestures, (1.0, 2.0), (1.0, 2.0)) is None
    assert _drag(gestures, (99.0, 2.0), (99.0, 2.0)) == Measured(((0.0, 0.0), (100.0, 0.0)))
    assert gestures.tool == ""
    gestures = _with("arc")
    for at in ((0.0, 0.0), (50.0, 0.0)):
        assert _drag(gestures, at, at) is None
    assert _drag(gestures, (100.0, 0.0), (100.0, 0.0)) is None, "three places in line"
    assert gestures.tool == "arc"
    assert _drag(_with("pick"), (1.0, 2.0), (1.0, 2.0)) == Traced((1.0, 2.0)), "ink does not snap"


def test_another_tool_forgets_clicks() -> None:
    gestures = _with("scale")
    _drag(gestures, (1.0, 2.0), (1.0, 2.0))
    gestures.take("scale")
    assert _drag(gestures, (99.0, 2.0), (99.0, 2.0)) is None


@given(_places, _places, st.booleans())
def test_a_line_is_level_or_upright_unless_it_is_free(a: Place, b: Place, free: bool) -> None:
    bare = replace(_HITS, sheet=replace(_HITS.sheet, strokes=()))
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
    hits = replace(_HITS, chosen=frozenset({"s2"}))
    gestures = GestureController()
    # No handle is held.
    gestures.press(a, replace(hits, chosen=frozenset()))
    made = gestures.release(b, hits, free=False, more=True)
    clicked = max(abs(a[0] - b[0]), abs(a[1] - b[1])) < 4.0
    assert "s2" in made.ids or clicked


def test_a_click_with_others_takes_back_what_was_selected() -> None:
    hits = replace(_HITS, chosen=frozenset({"s1", "s2"}))
    assert _drag(GestureController(), (50.0, 0.0), (50.0, 0.0), hits, more=True) == Chosen(
        frozenset({"s2"})
    )


@given(st.sampled_from(["", *TOOLS.values()]), _places, _places)
def test_what_would_be_made_ends_at_the_mouse(tool: str, a: Place, b: Place) -> None:
    assume(hypot(a[0] - b[0], a[1] - b[1]) > 1.0)
    gestures = _with(tool)
    assert gestures.rubber(b, _HITS, free=True) is None
    gestures.press(a, _HITS)
    around = gestures.rubber(b, _HITS, free=True).boundingRect()
    inside = around.adjusted(-1e-6, -1e-6, 1e-6, 1e-6).contains(*b)
    # The path of a circle is made of curves that are near it.
    assert inside or tool == "circle"
    gestures.drop()
    assert gestures.rubber(b, _HITS, free=True) is None
    assert gestures.release(b, _HITS, free=True, more=False) is None
