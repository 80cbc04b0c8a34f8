"""How a sketched part is put together, as data."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from gaussiancad_core.evidence.dimension_constraints import (
    DimensionConstraints,
    LengthDimension,
    RadiusDimension,
)
from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.model.axes import Axis
from gaussiancad_core.report.construction_file import write_construction
from gaussiancad_core.report.construction_sentences import construction_in_words
from gaussiancad_core.sketch.constructing import construction_of
from gaussiancad_core.sketch.sketching import sketch

GRID = 0.1


def test_a_bored_plate_is_a_slab_with_holes_and_says_what_fixes_it(
    sample_views: Callable[[str], DrawnViews], tmp_path: Path
) -> None:
    views = sample_views("bored-plate")
    wide, _, high = views.size
    plain = construction_of(sketch(views, GRID), None)
    (slab,) = plain.slabs
    assert (plain.axis, slab.low, slab.high) == ("z", 0.0, pytest.approx(high))
    outer, *inner = slab.loops
    assert not outer.is_hole
    assert all(item.is_hole for item in inner)
    assert len(inner) == len(plain.holes) > 0
    assert all(
        this_hole.is_through and (this_hole.low, this_hole.high) == (0.0, slab.high)
        for this_hole in plain.holes
    )
    assert all(loop.strokes for loop in slab.loops)
    assert [level.at for level in plain.levels] == [0.0, pytest.approx(high)]
    assert all({stroke.view for stroke in level.strokes} >= {"front"} for level in plain.levels)

    hole = plain.holes[0]
    stated = DimensionConstraints(
        (
            LengthDimension(Axis.Z, 0.0, high, high),
            LengthDimension(Axis.X, 0.0, wide, wide),
            RadiusDimension(Axis.Z, hole.centre, hole.diameter / 2.0, hole.diameter / 2.0),
        ),
        0.05,
        0.01,
    )
    numbered = construction_of(sketch(replace(views, dimensions=stated), GRID), stated)
    assert all(level.numbers == (high,) for level in numbered.levels)
    assert numbered.slabs[0].loops[0].numbers == (wide,)
    assert [this_hole.numbers for this_hole in numbered.holes].count((hole.diameter,)) == 1
    write_construction(numbered.as_json(), tmp_path)
    written = json.loads((tmp_path / "construction.json").read_text(encoding="utf-8"))
    assert written["schema"] == "gaussiancad-construction/1"
    words = construction_in_words(written)
    assert words[0].startswith(f"- from 0 to {high:.4g} mm along z: 1 outline(s) with")
    assert sum("a hole of" in line for line in words) == len(inner)
    assert sum("as a number tells" in line for line in words) == 1
    assert len(written["holes"]) == len(inner)


def test_a_counterbore_is_two_holes_one_of_which_goes_on(
    sample_views: Callable[[str], DrawnViews],
) -> None:
    found = construction_of(sketch(sample_views("counterbored-block"), GRID), None)
    first = found.holes[0].centre
    low, high = sorted(
        (hole for hole in found.holes if hole.centre == first), key=lambda item: item.low
    )
    assert low.high == pytest.approx(high.low)
    assert low.diameter < high.diameter
    assert low.is_through and high.is_through
