"""Bodies, tunnels and cavities of solids where they are known."""

from collections.abc import Callable

import numpy as np
import trimesh

from gaussiancad_core.comparison.topology import topology_of
from gaussiancad_core.model.meshes import TriangleMesh, joined, make_mesh


def test_a_hollow_box_beside_a_torus(box: Callable[..., TriangleMesh]) -> None:
    outer = box(4, 4, 4)
    inner = make_mesh(box(2, 2, 2).vertices + 1.0, box(2, 2, 2).triangles).flipped()
    torus = trimesh.creation.torus(3.0, 1.0)
    neighbour = make_mesh(torus.vertices + np.array([20.0, 0.0, 0.0]), torus.faces)
    assert topology_of(joined([outer, inner, neighbour])).betti == (2, 1, 1)


def test_boxes_that_touch_in_a_corner_are_two(box: Callable[..., TriangleMesh]) -> None:
    """Welded, they share one vertex and no edge."""
    second = make_mesh(box(1, 1, 1).vertices + 1.0, box(1, 1, 1).triangles)
    both = joined([box(1, 1, 1), second])
    vertices, inverse = np.unique(both.vertices, axis=0, return_inverse=True)
    assert len(vertices) == 15
    assert topology_of(make_mesh(vertices, inverse.ravel()[both.triangles])).betti == (2, 0, 0)


def test_an_open_box_has_no_numbers(box: Callable[..., TriangleMesh]) -> None:
    opened = make_mesh(box(1, 1, 1).vertices, box(1, 1, 1).triangles[:-1])
    found = topology_of(opened)
    assert found.betti is None
    assert found.open_edges == 3
