"""Which solids carve the hull that a job starts from, and what the report says of it."""

from collections.abc import Callable
from pathlib import Path

import pytest
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.evidence.drawn_views import views_as_read
from gaussiancad_core.kernel.brep import volume
from gaussiancad_core.model.views import ViewSet
from gaussiancad_core.report.job import Job
from gaussiancad_core.report.report_entries import HullReport
from gaussiancad_core.run.exact_stage import ExactModel
from gaussiancad_core.run.surface_stage import hull_report, make_hull
from gaussiancad_core.solid.exact import ExactResult
from gaussiancad_core.solid.verify import verify
from gaussiancad_protocol.modes import Recipe, Status
from sample_parts.modelling import box, cut

BLOCK = box((0, 0, 0), (40, 30, 20))
POCKETED = cut(BLOCK, box((10, 8, 12), (30, 22, 21)))


def _model(views: ViewSet, shape: TopoDS_Shape) -> ExactModel:
    verification = verify(shape, views_as_read(views, 0.02))
    result = ExactResult(Status.VERIFIED, shape, verification, (), (), {})
    return ExactModel(None, result, False)


def _job(recipe: Recipe) -> Job:
    return Job(Path("sheet.png"), Path("model"), recipe=recipe)


def test_an_exact_solid_carves_the_hull_of_parallel_views(viewed: Callable[..., ViewSet]) -> None:
    views = viewed(POCKETED)
    hull = make_hull(_job(Recipe.ORTHOGRAPHIC), views, _model(views, POCKETED))
    assert hull.mesh.volume == pytest.approx(volume(POCKETED), rel=0.005)
    assert hull_report(hull) == HullReport("verified", 1, 0, "")


def test_no_solid_and_the_papers_recipe_leave_the_hull_plain(
    viewed: Callable[..., ViewSet],
) -> None:
    views = viewed(POCKETED)
    for recipe, model in ((Recipe.ORTHOGRAPHIC, None), (Recipe.PAPER, _model(views, POCKETED))):
        hull = make_hull(_job(recipe), views, model)
        assert hull_report(hull) == HullReport(None, 0, 0, "")
