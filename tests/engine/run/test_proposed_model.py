"""A part that slabs do not explain is put together of features, where no solid has all lines."""

import json
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import DrawnViews
from gaussiancad_core.kernel.booleans import common
from gaussiancad_core.kernel.brep import volume
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Linetype, Segment
from gaussiancad_core.proposing.proposed_part import ProposedPart
from gaussiancad_core.report.construction_file import write_construction
from gaussiancad_core.report.construction_sentences import construction_in_words
from gaussiancad_core.run.exact_stage import find_exact
from gaussiancad_core.run.model_construction import construction_values
from gaussiancad_core.run.proposed_model import proposed_result
from gaussiancad_core.solid.limits import Limits
from gaussiancad_core.solid.search_trace import ModelKind
from gaussiancad_protocol.codes import Code
from gaussiancad_protocol.modes import Status
from sample_parts.modelling import box, cut, cylinder, fuse

Draw = Callable[[TopoDS_Shape], DrawnViews]


@dataclass(frozen=True)
class _Lines:
    """Views of no sheet, as what was read of one."""

    drawn: DrawnViews
    is_alone: bool = False
    grid: float = 0.01

    @property
    def numbered(self) -> DrawnViews:
        return self.drawn


def _corner() -> TopoDS_Shape:
    """Three walls that meet, with pockets that run three ways."""
    walls = fuse(
        box((0.0, 0.0, 0.0), (60.0, 40.0, 8.0)),
        box((0.0, 32.0, 8.0), (60.0, 40.0, 45.0)),
        box((52.0, 0.0, 8.0), (60.0, 32.0, 30.0)),
    )
    return cut(
        walls,
        cylinder(Axis.Z, (15.0, 15.0), 5.0, -1.0, 9.0),
        box((20.0, 36.0, 15.0), (35.0, 41.0, 40.0)),
        box((56.0, 5.0, 12.0), (61.0, 20.0, 25.0)),
        box((5.0, 22.0, -1.0), (30.0, 28.0, 4.0)),
        box((10.0, 31.0, 20.0), (25.0, 34.0, 35.0)),
        cylinder(Axis.Y, (43.0, 30.0), 6.0, 36.0, 41.0),
        cylinder(Axis.Y, (43.0, 30.0), 3.0, 31.0, 41.0),
        cylinder(Axis.X, (26.0, 19.0), 4.0, 51.0, 57.0),
        cylinder(Axis.X, (26.0, 19.0), 2.0, 51.0, 61.0),
    )


@pytest.fixture(scope="module")
def views(drawn: Draw) -> DrawnViews:
    """Its views, with a line that it has not."""
    exact = drawn(_corner())
    stray = Segment((3.0, 12.0), (3.0, 40.0), Linetype.VISIBLE)
    front = (*exact.strokes[Role.FRONT], stray)
    return replace(exact, strokes={**exact.strokes, Role.FRONT: front})


def test_a_part_is_put_together_and_told_as_that(views: DrawnViews) -> None:
    found = proposed_result(views, 0.01)
    assert found is not None
    result, part = found
    assert result.status is Status.APPROXIMATE
    assert result.trace[0].model is ModelKind.FEATURES
    code, message = result.reasons[0]
    assert code == Code.SKETCHED
    assert message.args["case"] == "features"
    # The line that it has not, and not much more.
    assert part.cost == pytest.approx(28.0, rel=0.2)


def test_it_takes_the_place_of_a_sketch_that_explains_less(views: DrawnViews) -> None:
    # With as little work as this no solid is found whose lines are given up.
    model = find_exact(_Lines(views), None, Limits(work=1.0))
    assert isinstance(model.made_of, ProposedPart)
    taken = [attempt.model for attempt in model.result.trace if attempt.taken]
    assert taken == [ModelKind.FEATURES]
    part = _corner()
    both = volume(common(model.result.shape, part))
    assert both / (volume(model.result.shape) + volume(part) - both) > 0.98


def test_its_construction_is_its_features(views: DrawnViews, tmp_path: Path) -> None:
    model = find_exact(_Lines(views), None, Limits(work=1.0))
    values = construction_values(model)
    assert values is not None
    write_construction(values, tmp_path)
    written = json.loads((tmp_path / "construction.json").read_text(encoding="utf-8"))
    assert written["schema"] == "gaussiancad-construction/2"
    assert isinstance(model.made_of, ProposedPart)
    assert len(written["features"]) == len(model.made_of.features)
    assert written["features"][0]["operation"] == "add"
    # Edges go on where those before them end.
    loops = [
        loop["edges"]
        for feature in written["features"]
        for part in feature["parts"]
        for loop in part.get("loops", [{"edges": part.get("edges")}])
    ]
    for edges in loops:
        for before, after in zip(edges, edges[1:] + edges[:1], strict=True):
            assert before["end"] == pytest.approx(after["start"], abs=1e-5)
    words = construction_in_words(written)
    assert len(words) == len(written["features"]) + len(written["breaks"])
    assert words[0].startswith("- 1. ")
    assert ", added" in words[0]


def test_sheets_of_too_many_lines_are_left_alone(views: DrawnViews) -> None:
    many = views.strokes[Role.FRONT] * 100
    assert proposed_result(replace(views, strokes={**views.strokes, Role.FRONT: many}), 1.0) is None
