"""The same examples in every run: a check that fails can be repeated.  Drawn sample parts."""

from collections.abc import Callable, Iterator
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, settings

from gaussiancad_core.model.meshes import TriangleMesh, make_mesh

if TYPE_CHECKING:
    from pathlib import Path

    from OCP.TopoDS import TopoDS_Shape

    from gaussiancad_core.evidence.drawn_views import DrawnViews
    from gaussiancad_core.files.content import FileContent
    from gaussiancad_core.files.file_kinds import FileKind
    from gaussiancad_core.model.axes import Role
    from gaussiancad_core.model.views import ViewSet

Corner = tuple[float, float, float]

# No clock decides: a busy machine is no failure.
settings.register_profile(
    "repeatable", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow]
)
settings.load_profile("repeatable")


@pytest.fixture(scope="session", autouse=True)
def _files_are_read_in_this_process() -> "Iterator[None]":
    """Sheets are read as the child process does, without starting one for each: hundreds of tests
    read files, and only those of the isolation and of the command need the process."""
    from gaussiancad_core.files.file_child import answer_of
    from gaussiancad_core.files.isolation import content_in

    def read_here(kind: "FileKind", path: "Path", page: int) -> "FileContent":
        return content_in(answer_of(kind, path.absolute(), page), kind, path)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("gaussiancad_core.sheet.image.sheet_files.read_isolated", read_here)
        yield


@pytest.fixture(scope="session")
def sample_solid() -> "Callable[[str], TopoDS_Shape]":
    """Builds the sample part of a name, its bounding box starting at the origin."""
    from sample_parts import sample

    return cache(lambda name: sample(name).build())


@pytest.fixture(scope="session")
def drawn() -> "Callable[[TopoDS_Shape, tuple[Role, ...]], DrawnViews]":
    """Draws the exact lines of a solid in the views of some roles."""
    from gaussiancad_core.evidence.drawn_views import exact_views
    from gaussiancad_core.kernel.brep import bounding_box
    from gaussiancad_core.lines.hlr import LineDrawing
    from gaussiancad_core.model.axes import Role

    three = (Role.FRONT, Role.TOP, Role.RIGHT)

    def draw(solid: "TopoDS_Shape", roles: "tuple[Role, ...]" = three) -> "DrawnViews":
        low, high = bounding_box(solid)
        drawing = LineDrawing(solid)
        size = tuple(float(extent) for extent in high - low)
        return exact_views({role: drawing.view(role) for role in roles}, size)

    return draw


@pytest.fixture(scope="session")
def iou() -> "Callable[[TopoDS_Shape, TopoDS_Shape], float]":
    """Intersection over union of two solids by OpenCASCADE's Booleans."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common

    from gaussiancad_core.kernel.brep import volume

    def measure(one: "TopoDS_Shape", other: "TopoDS_Shape") -> float:
        first, second = volume(one), volume(other)
        assert first > 0.0
        assert second > 0.0
        common = BRepAlgoAPI_Common(one, other)
        common.Build()
        shared = volume(common.Shape())
        return shared / (first + second - shared)

    return measure


@pytest.fixture(scope="session")
def sample_views(
    sample_solid: "Callable[[str], TopoDS_Shape]", drawn: "Callable[..., DrawnViews]"
) -> "Callable[[str], DrawnViews]":
    """The exact front, top and right view of the sample part of a name, drawn once."""
    return cache(lambda name: drawn(sample_solid(name)))


@pytest.fixture(scope="session")
def pin_as_read(sample_views: "Callable[[str], DrawnViews]") -> "DrawnViews":
    """The bored pin as read from a picture, 0.1 mm a pixel: the bore's rims in the front view are
    arcs that nearly follow them, and reach beyond the outline."""
    from dataclasses import replace
    from math import pi, radians

    from gaussiancad_core.lines.strokes import Polyline
    from gaussiancad_core.model.axes import Role
    from gaussiancad_core.model.views import Arc, Linetype

    views = sample_views("cross-bored-pin")
    low = Arc((30.0, -17.54), 21.06, radians(55.2), radians(69.6), Linetype.VISIBLE)
    high = replace(low, centre=(30.0, 61.54), start_angle=low.start_angle + pi)
    strokes = {
        role: tuple(
            stroke
            for stroke in this_stroke
            if role is not Role.FRONT or not isinstance(stroke, Polyline)
        )
        for role, this_stroke in views.strokes.items()
    }
    strokes[Role.FRONT] += (low, high)
    return replace(views, strokes=strokes, tolerance=0.1, apart=0.03)


@pytest.fixture(scope="session")
def viewed() -> "Callable[..., ViewSet]":
    """Views of a solid with its exact lines and its own shadows as masks, 0.1 mm a pixel."""
    import numpy as np

    from gaussiancad_core.kernel.brep import bounding_box, tessellate
    from gaussiancad_core.lines.hlr import LineDrawing
    from gaussiancad_core.lines.mesh_rays import RayCaster, RayGrid
    from gaussiancad_core.model.axes import Role
    from gaussiancad_core.model.meshes import make_mesh
    from gaussiancad_core.model.views import View, ViewSet

    pixel = 0.1

    def draw(
        solid: "TopoDS_Shape",
        roles: "tuple[Role, ...]" = (Role.FRONT, Role.TOP, Role.RIGHT),
        *,
        lines: bool = True,
    ) -> "ViewSet":
        mesh = make_mesh(*tessellate(solid, 0.005, 0.05))
        caster, drawing = RayCaster(mesh), LineDrawing(solid)
        views = []
        for role in roles:
            flat = mesh.vertices @ np.array([role.frame.right, role.frame.up], dtype=float).T
            low, high = flat.min(axis=0) - 3.3 * pixel, flat.max(axis=0) + 3.0 * pixel
            grid = RayGrid.of_view(role, (low[0], low[1], high[0], high[1]), pixel)
            mask = caster.first_hits(grid).triangle >= 0
            strokes = tuple(drawing.view(role)) if lines else ()
            colour = np.zeros((*mask.shape, 3), np.uint8)
            place = (grid.left, grid.top)
            views.append(View(role, (0, 0, 1, 1), strokes, mask, colour, place, pixel))
        size = tuple(float(extent) for extent in bounding_box(solid)[1])
        return ViewSet(tuple(views), size)

    return draw


def placed_box(low: Corner, high: Corner) -> trimesh.Trimesh:
    solid = trimesh.creation.box(np.subtract(high, low))
    solid.apply_translation(np.add(low, high) / 2)
    return solid


@pytest.fixture(scope="session")
def box() -> Callable[..., TriangleMesh]:
    """Makes a box between two corners."""

    def make(low: Corner, high: Corner) -> TriangleMesh:
        solid = placed_box(low, high)
        return make_mesh(solid.vertices, solid.faces)

    return make


@pytest.fixture(scope="session")
def blind_hole() -> TriangleMesh:
    """A block of 40 x 30 x 20 mm with a hole of radius 6 about (25, 12), 13 deep, from above."""
    drill = trimesh.creation.cylinder(6.0, 20.0, sections=180)
    drill.apply_translation((25, 12, 17))
    solid = trimesh.boolean.difference([placed_box((0, 0, 0), (40, 30, 20)), drill])
    mesh = make_mesh(solid.vertices, solid.faces)
    assert mesh.watertight
    return mesh


@pytest.fixture(scope="session")
def rounded_block(blind_hole: TriangleMesh) -> TriangleMesh:
    """The block with the blind hole as a Poisson surface of noisy points."""
    from gaussiancad_core.kernel.bare_open3d import open3d

    exact = blind_hole.to_trimesh()
    points, faces = trimesh.sample.sample_surface(exact, 20_000, seed=1)
    points += np.random.default_rng(1).normal(scale=0.02, size=points.shape)
    cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
    cloud.normals = open3d.utility.Vector3dVector(exact.face_normals[faces])
    surface, _ = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(
        cloud, depth=7, n_threads=1
    )
    return make_mesh(np.asarray(surface.vertices), np.asarray(surface.triangles))
