import numpy as np
import pytest

from gaussiancad_core.lines.mesh_crossings import (
    Layers,
    Rule,
    compare_columns,
    compare_rows,
    warm_up,
)
from gaussiancad_core.lines.two_rays import Difference

_FLAT = (0.0, 0.0, -1.0)
_BACK = (0.0, 0.0, 1.0)
_SLOPE = (-np.sqrt(0.5), 0.0, -np.sqrt(0.5))
"""A surface seen from the front that recedes to the left: its depth falls by 1 px per px."""

Ray = list[tuple[float, bool, tuple[float, float, float]]]
SHARP = Rule(1, float(np.cos(np.radians(20.0))), True)


def _layers(rays: list[Ray], width: int) -> Layers:
    """Crossings (depth, entering, normal) of each ray, row by row."""
    hits = [hit for ray in rays for hit in ray]
    return Layers(
        np.concatenate([[0], np.cumsum([len(ray) for ray in rays])]).astype(np.int64),
        np.array([hit[0] for hit in hits], dtype=np.float32),
        np.array([hit[1] for hit in hits], dtype=bool),
        np.array([hit[2] for hit in hits], dtype=np.float32).reshape(-1, 3),
        width,
        len(rays) // width,
    )


def _slab(*depths: float) -> Ray:
    """Flat faces at the given depths, in and out in turn."""
    return [(depth, k % 2 == 0, (_FLAT, _BACK)[k % 2]) for k, depth in enumerate(depths)]


@pytest.mark.parametrize(
    ("left", "right", "line"),
    [
        ([], [], Difference.NONE),
        (_slab(0, 10), _slab(0, 10), Difference.NONE),
        ([], _slab(0, 10), Difference.VISIBLE_STEP),
        (_slab(0, 10), _slab(5, 10), Difference.VISIBLE_STEP),
        (_slab(0, 10), _slab(0, 5), Difference.HIDDEN_STEP),
        (_slab(0, 20), _slab(0, 5, 9, 20), Difference.HIDDEN_STEP),
        (_slab(0, 20), _slab(5, 9), Difference.VISIBLE_STEP),
        (
            [(0, True, _FLAT), (9, False, _BACK)],
            [(0.5, True, _SLOPE), (9, False, _BACK)],
            Difference.VISIBLE_BEND,
        ),
        (
            [(0, True, _FLAT), (9, False, _BACK)],
            [(0, True, _FLAT), (9, False, (0.6, 0.0, 0.8))],
            Difference.HIDDEN_BEND,
        ),
    ],
)
def test_every_kind_of_line(left: Ray, right: Ray, line: Difference) -> None:
    for one, two in ((left, right), (right, left)):
        assert compare_rows(_layers([one, two], 2), SHARP).tolist() == [[0, line, 0]]
        upright = compare_columns(_layers([one, two], 1), SHARP)
        if line not in (Difference.VISIBLE_BEND,):
            assert upright.tolist() == [[0], [line], [0]]


def test_a_slope_is_no_step() -> None:
    """Depths that differ as the tangent planes say belong to one surface."""
    steep = (0.9950, 0.0, -0.0995)
    rays = [[(10.0 * k, True, steep), (200.0, False, _BACK)] for k in range(4)]
    assert not compare_rows(_layers(rays, 4), SHARP).any()
    rays[2][0] = (45.0, True, steep)
    assert compare_rows(_layers(rays, 4), SHARP).tolist() == [
        [0, 0, Difference.VISIBLE_STEP, Difference.VISIBLE_STEP, 0]
    ]


def test_a_wide_rule_finds_an_edge_that_bends_slowly() -> None:
    angles = np.radians([0, 0, 0, 15, 30, 45, 60, 75, 90, 90, 90]) * 0.8
    depth = np.concatenate([[0], np.cumsum(np.tan(angles))[:-1]])
    rays = [
        [(float(d), True, (-float(np.sin(a)), 0.0, -float(np.cos(a))))]
        for d, a in zip(depth, -angles, strict=True)
    ]
    layers = _layers(rays, len(rays))
    narrow = Rule(1, float(np.cos(np.radians(30.0))), False)
    wide = Rule(5, float(np.cos(np.radians(30.0))), False)
    assert not compare_rows(layers, narrow).any()
    found = np.flatnonzero(compare_rows(layers, wide)[0] == Difference.VISIBLE_BEND)
    assert len(found) and found.mean() == pytest.approx(6.0, abs=1.0)


def test_warming_up_compiles_what_drawing_needs() -> None:
    from gaussiancad_core.lines import mesh_crossings

    warm_up()
    before = len(mesh_crossings._compare_all.signatures)
    assert before
    compare_rows(_layers([_slab(0, 10), _slab(5, 10)], 2), SHARP)
    compare_columns(_layers([_slab(0, 10), _slab(5, 10)], 1), SHARP)
    assert len(mesh_crossings._compare_all.signatures) == before
