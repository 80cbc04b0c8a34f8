from collections import Counter

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform
from OCP.gp import gp_Ax1, gp_Dir, gp_Pnt, gp_Trsf
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.geometry.curves import bounds
from gaussiancad_core.kernel.brep import bounding_box, tessellate
from gaussiancad_core.lines.hlr import LineDrawing, LineOptions, draw_view
from gaussiancad_core.lines.strokes import DrawnStroke, Polyline, as_plain_strokes
from gaussiancad_core.model.axes import Axis, Role
from gaussiancad_core.model.views import Arc, Linetype, Segment
from sample_parts import SAMPLES, sample
from sample_parts.modelling import box, cone, cut, cylinder, edges_along, filleted, fuse, sphere

TURN = 2.0 * np.pi
V, H = "visible", "hidden"


def _key(stroke: DrawnStroke) -> tuple:
    """A stroke as comparable numbers; the direction of segments does not matter."""
    kind = stroke.linetype.value
    if isinstance(stroke, Segment):
        ends = sorted(
            tuple(round(value, 6) + 0.0 for value in end) for end in (stroke.start, stroke.end)
        )
        return (kind, *ends)
    if isinstance(stroke, Arc):
        centre = tuple(round(value, 6) + 0.0 for value in stroke.centre)
        angles = (0.0, 360.0)
        if stroke.sweep < TURN - 1e-6:
            angles = tuple(
                round(float(np.degrees(value)), 3) for value in (stroke.start_angle, stroke.sweep)
            )
        return (kind, centre, round(stroke.radius, 6), *angles)
    return (kind, len(stroke.points))


def _keys(strokes: tuple[DrawnStroke, ...]) -> set[tuple]:
    keys = [_key(stroke) for stroke in strokes]
    assert len(set(keys)) == len(keys)
    return set(keys)


def _rectangle(x0: float, y0: float, x1: float, y1: float, kind: str = V) -> set[tuple]:
    return {
        (kind, (x0, y0), (x1, y0)),
        (kind, (x0, y1), (x1, y1)),
        (kind, (x0, y0), (x0, y1)),
        (kind, (x1, y0), (x1, y1)),
    }


@pytest.mark.parametrize(
    ("role", "rectangle"),
    [
        (Role.FRONT, (0, 0, 40, 20)),
        (Role.TOP, (0, 0, 40, 30)),
        (Role.RIGHT, (0, 0, 30, 20)),
        (Role.LEFT, (-30, 0, 0, 20)),
        (Role.BOTTOM, (0, -30, 40, 0)),
        (Role.REAR, (-40, 0, 0, 20)),
    ],
)
def test_a_box_is_a_rectangle_in_the_role_s_own_coordinates(
    role: Role, rectangle: tuple[float, ...]
) -> None:
    assert _keys(draw_view(box((0, 0, 0), (40, 30, 20)), role)) == _rectangle(*rectangle)


def test_a_blind_pocket_is_hidden_from_all_sides_but_one() -> None:
    part = cut(box((0, 0, 0), (70, 50, 30)), box((15, 10, 12), (50, 40, 31)))
    drawing = LineDrawing(part)
    assert _keys(drawing.view(Role.TOP)) == _rectangle(0, 0, 70, 50) | _rectangle(15, 10, 50, 40)
    assert _keys(drawing.view(Role.BOTTOM)) == _rectangle(0, -50, 70, 0) | _rectangle(
        15, -40, 50, -10, H
    )
    assert _keys(drawing.view(Role.FRONT)) == _rectangle(0, 0, 70, 30) | {
        (H, (15, 12), (50, 12)),
        (H, (15, 12), (15, 30)),
        (H, (50, 12), (50, 30)),
    }
    assert _keys(drawing.view(Role.LEFT)) == _rectangle(-50, 0, 0, 30) | {
        (H, (-40, 12), (-10, 12)),
        (H, (-40, 12), (-40, 30)),
        (H, (-10, 12), (-10, 30)),
    }


def test_a_counterbore_and_a_boss_have_their_exact_lines() -> None:
    body = fuse(box((0, 0, 0), (60, 40, 10)), cylinder(Axis.Z, (30, 20), 15, 9, 30))
    part = cut(body, cylinder(Axis.Z, (30, 20), 5, -1, 31), cylinder(Axis.Z, (30, 20), 9, 22, 31))
    assert _keys(draw_view(part, Role.TOP)) == _rectangle(0, 0, 60, 40) | {
        (V, (30.0, 20.0), radius, 0.0, 360.0) for radius in (15.0, 9.0, 5.0)
    }
    assert _keys(draw_view(part, Role.FRONT)) == _rectangle(0, 0, 60, 10) | {
        (V, (15, 10), (15, 30)),
        (V, (45, 10), (45, 30)),
        (V, (15, 30), (45, 30)),
        (H, (21, 22), (39, 22)),
        (H, (21, 22), (21, 30)),
        (H, (39, 22), (39, 30)),
        (H, (25, 0), (25, 22)),
        (H, (35, 0), (35, 22)),
    }
    bottom = draw_view(part, Role.BOTTOM)
    assert _keys(bottom) == _rectangle(0, -40, 60, 0) | {
        (V, (30.0, -20.0), 5.0, 0.0, 360.0),
        (H, (30.0, -20.0), 9.0, 0.0, 360.0),
        (H, (30.0, -20.0), 15.0, 0.0, 360.0),
    }


def test_a_line_behind_another_one_changes_from_visible_to_hidden_where_it_goes_behind() -> None:
    part = fuse(box((0, 20, 0), (60, 40, 30)), box((10, 0, 0), (30, 20, 18)))
    assert _keys(draw_view(part, Role.FRONT)) == {
        (V, (0, 0), (60, 0)),
        (V, (0, 30), (60, 30)),
        (V, (0, 0), (0, 30)),
        (V, (60, 0), (60, 30)),
        (V, (10, 0), (10, 18)),
        (V, (30, 0), (30, 18)),
        (V, (10, 18), (30, 18)),
    }
    step = fuse(box((0, 0, 0), (40, 30, 10)), box((0, 0, 10), (20, 30, 20)))
    slit = cut(step, box((-1, 10, 5), (41, 14, 8)))
    assert _keys(draw_view(slit, Role.TOP)) == _rectangle(0, 0, 40, 30) | {
        (V, (20, 0), (20, 30)),
        (H, (0, 10), (40, 10)),
        (H, (0, 14), (40, 14)),
    }


@pytest.mark.parametrize("turn", [0.0, 45.0, 90.0, 137.0, 180.0])
@pytest.mark.parametrize("axis", Axis)
def test_a_cylinder_shows_its_silhouettes_wherever_its_seam_is(axis: Axis, turn: float) -> None:
    rod = cylinder(axis, (20, 20), 15, 0, 50)
    middle = [20.0, 20.0, 20.0]
    middle[axis.value] = 0.0
    direction = [0.0, 0.0, 0.0]
    direction[axis.value] = 1.0
    motion = gp_Trsf()
    motion.SetRotation(gp_Ax1(gp_Pnt(*middle), gp_Dir(*direction)), np.radians(turn))
    turned = BRepBuilderAPI_Transform(rod, motion, True).Shape()
    for role in Role:
        strokes = draw_view(turned, role)
        if role.frame.look_axis[0] is axis:
            assert [(type(stroke), stroke.length) for stroke in strokes] == [
                (Arc, pytest.approx(15 * TURN))
            ]
        else:
            assert sorted(stroke.length for stroke in strokes) == pytest.approx([30, 30, 50, 50])
        assert {stroke.linetype for stroke in strokes} == {Linetype.VISIBLE}


def test_a_ball_is_a_circle_and_a_cone_a_triangle() -> None:
    for role in Role:
        ball = draw_view(sphere((0, 0, 0), 7), role)
        assert _keys(ball) == {(V, (0.0, 0.0), 7.0, 0.0, 360.0)}
    point = cone(Axis.Z, (0, 0), (10, 0), 0, 30)
    assert _keys(draw_view(point, Role.FRONT)) == {
        (V, (-10.0, 0.0), (10.0, 0.0)),
        (V, (-10.0, 0.0), (0.0, 30.0)),
        (V, (0.0, 30.0), (10.0, 0.0)),
    }
    assert _keys(draw_view(point, Role.TOP)) == {(V, (0.0, 0.0), 10.0, 0.0, 360.0)}


def test_smooth_edges_are_no_lines_unless_wanted_and_seams_never() -> None:
    block = box((0, 0, 0), (80, 60, 30))
    rounded = filleted(block, edges_along(block, Axis.Z, [(0, 0), (80, 0), (80, 60), (0, 60)]), 12)
    part = cut(rounded, cylinder(Axis.Z, (40, 30), 15, -1, 31))
    plain = _keys(draw_view(part, Role.FRONT))
    hole = {(H, (25, 0), (25, 30)), (H, (55, 0), (55, 30))}
    assert plain == _rectangle(0, 0, 80, 30) | hole
    with_tangents = _keys(draw_view(part, Role.FRONT, LineOptions(tangent_edges=True)))
    assert with_tangents == plain | {(V, (12, 0), (12, 30)), (V, (68, 0), (68, 30))}


def test_a_full_round_keeps_its_outline() -> None:
    part = sample("slotted-link").build()
    assert _keys(draw_view(part, Role.TOP)) == {
        (V, (20, 0), (100, 0)),
        (V, (20, 40), (100, 40)),
        (V, (20.0, 20.0), 20.0, 90.0, 180.0),
        (V, (100.0, 20.0), 20.0, 270.0, 180.0),
        (V, (20.0, 20.0), 9.0, 0.0, 360.0),
        (V, (62, 12), (100, 12)),
        (V, (62, 28), (100, 28)),
        (V, (62.0, 20.0), 8.0, 90.0, 180.0),
        (V, (100.0, 20.0), 8.0, 270.0, 180.0),
    }
    right = draw_view(part, Role.RIGHT)
    assert Counter(stroke.linetype for stroke in right) == {Linetype.VISIBLE: 4, Linetype.HIDDEN: 4}


def test_the_rim_of_a_leaning_bore_is_one_ellipse() -> None:
    strokes = draw_view(sample("angled-bore-block").build(), Role.TOP)
    chains = [stroke for stroke in strokes if isinstance(stroke, Polyline)]
    assert [chain.linetype.value for chain in chains] == [V, H]
    # The bore leans by 3 : 4 in the XZ plane, so that its rims are 5 / 4 as long as wide.
    for chain, x in zip(chains, (40 + 0.75 * 23, 40 - 0.75 * 22), strict=True):
        assert chain.points[0] == pytest.approx(chain.points[-1], abs=1e-9)
        points = (np.array(chain.points) - [x, 25.0]) / [9 * 1.25, 9]
        np.testing.assert_allclose(np.hypot(*points.T), 1.0, atol=1e-9)
        middles = (points[1:] + points[:-1]) / 2.0
        assert np.abs(np.hypot(*middles.T) - 1.0).max() * 11.25 < 80 * 1e-5


def test_a_solid_that_is_inside_out_has_the_same_outline() -> None:
    block = box((0, 0, 0), (40, 30, 20)).Reversed()
    assert _keys(draw_view(block, Role.TOP)) == _rectangle(0, 0, 40, 30)


@pytest.mark.parametrize("part", SAMPLES, ids=lambda part: part.name)
def test_no_hidden_line_runs_under_a_visible_one_and_none_is_drawn_twice(part: object) -> None:
    shape = part.build()
    size = float(bounding_box(shape)[1].max())
    drawing = LineDrawing(shape)
    for role in (Role.FRONT, Role.TOP, Role.LEFT):
        strokes = drawing.view(role)
        assert min(stroke.length for stroke in strokes) >= 2e-4 * size
        for index, stroke in enumerate(strokes):
            samples = stroke.sample(stroke.length / 40.0)
            for other in strokes[:index]:
                assert (other.distances(samples) < 1e-5 * size).mean() < 0.2
            if stroke.linetype is Linetype.HIDDEN:
                visible = [other for other in strokes if other.linetype is Linetype.VISIBLE]
                near = np.min([other.distances(samples) for other in visible], axis=0)
                assert (near < 1e-5 * size).mean() < 0.35


sizes = st.tuples(*[st.integers(4, 40).map(float)] * 3)


@settings(max_examples=10, deadline=None)
@given(sizes, st.floats(0.15, 0.85), st.floats(0.15, 0.85), st.floats(0.05, 0.14))
def test_the_extents_of_all_views_agree_on_shared_axes(
    size: tuple[float, float, float], u: float, v: float, share: float
) -> None:
    x, y, z = size
    radius = share * min(x, y)
    base = box((0, 0, 0), (x, y, z))
    part = cut(
        fuse(base, cylinder(Axis.Z, (u * x, v * y), radius, z / 2, 1.4 * z)),
        box((-1, v * y, 0.6 * z), (0.3 * x, y + 1, z + 1)),
    )
    corners = bounding_box(part)
    drawing = LineDrawing(part)
    for role in Role:
        plane = corners @ np.array([role.frame.right, role.frame.up], dtype=float).T
        expected = *plane.min(axis=0), *plane.max(axis=0)
        np.testing.assert_allclose(bounds(drawing.view(role)), expected, atol=1e-6)


# What follows compares the lines with the solid itself, seen through a mesh of it that is exact
# because all faces are planes: neighbouring lines of sight that meet different planes have a line
# of the drawing between them, and those that meet the same have none.


def _stacks(
    shape: TopoDS_Shape, role: Role, points: npt.NDArray[np.float64]
) -> list[tuple[tuple[int, ...], ...]]:
    """For each (n, 2) point the planes that its line of sight meets, nearest first."""
    vertices, triangles = tessellate(shape, 1.0)
    corners = vertices[triangles]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    planes = np.round(
        np.column_stack([normals, (normals * corners[:, 0]).sum(axis=1)]) * 1e4
    ).astype(int)
    frame = np.array([role.frame.right, role.frame.up, role.frame.look], dtype=float)
    local = corners @ frame.T
    first, second, third = (local[:, k, :2] for k in range(3))
    area = _cross(second - first, third - first)
    solid = np.abs(area) > 1e-9
    hits: list[list[tuple[float, tuple[int, ...]]]] = [[] for _ in points]
    for index in np.flatnonzero(solid):
        weights = (
            np.stack(
                [
                    _cross(second[index] - points, third[index] - points),
                    _cross(third[index] - points, first[index] - points),
                    _cross(first[index] - points, second[index] - points),
                ],
                axis=1,
            )
            / area[index]
        )
        for row in np.flatnonzero(np.all(weights >= 0.0, axis=1)):
            depth = float(weights[row] @ local[index, :, 2])
            hits[row].append((depth, tuple(planes[index].tolist())))
    return [tuple(plane for _, plane in sorted(stack)) for stack in hits]


def _cross(one: npt.NDArray[np.float64], other: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
    return one[..., 0] * other[..., 1] - one[..., 1] * other[..., 0]


def _crossings(
    strokes: tuple[Segment, ...], starts: npt.NDArray[np.float64], ends: npt.NDArray[np.float64]
) -> npt.NDArray[np.int64]:
    """(n,) how many strokes cross the way from a start to its end."""
    a, b = (np.array([getattr(stroke, end) for stroke in strokes]) for end in ("start", "end"))
    starts, ends = starts[:, None], ends[:, None]
    sides = _cross(b - a, starts - a) * _cross(b - a, ends - a)
    across = _cross(ends - starts, a - starts) * _cross(ends - starts, b - starts)
    return np.sum((sides < 0.0) & (across < 0.0), axis=1)


PLANAR = (
    *("stepped-block", "pocket-block", "t-slot-block", "wedge-block"),
    *("dovetail-block", "vee-block"),
)


@pytest.mark.parametrize("name", PLANAR)
@pytest.mark.parametrize("role", [Role.FRONT, Role.TOP, Role.LEFT])
def test_lines_stand_exactly_where_what_is_seen_changes(name: str, role: Role) -> None:
    shape = sample(name).build()
    strokes = as_plain_strokes(draw_view(shape, role))
    visible = tuple(stroke for stroke in strokes if stroke.linetype is Linetype.VISIBLE)
    low, high = np.array(bounds(strokes)).reshape(2, 2)
    # Odd offsets: no line of sight may hit an edge.
    columns, rows = (
        np.arange(low[k] - 1.62877, high[k] + 2.5, 2.50123, dtype=float) for k in (0, 1)
    )
    grid = np.stack(np.meshgrid(columns, rows, indexing="ij"), axis=2)
    stacks = np.empty(grid.shape[:2], dtype=object)
    stacks.ravel()[:] = _stacks(shape, role, grid.reshape(-1, 2))
    for one, other in ((np.s_[:-1], np.s_[1:]), (np.s_[:, :-1], np.s_[:, 1:])):
        starts, ends = grid[one].reshape(-1, 2), grid[other].reshape(-1, 2)
        pairs = list(zip(stacks[one].ravel(), stacks[other].ravel(), strict=True))
        for lines, differs in (
            (visible, np.array([before[:1] != after[:1] for before, after in pairs])),
            (strokes, np.array([before != after for before, after in pairs])),
        ):
            count = _crossings(lines, starts, ends)
            assert np.all(count[differs] > 0)
            # Across the tip of a corner there are two lines and yet no difference.
            assert np.all(differs[count == 1])
            assert differs.sum() > 20
