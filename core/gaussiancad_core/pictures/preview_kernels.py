"""Pixels of a preview: their normals, where edges run between them, and their shades."""

import numpy as np
from numba import njit


@njit(cache=True, error_model="numpy")
def interpolated(triangle, weights, corners):  # noqa: ANN001, ANN201
    """(h, w, k) float32 of (m, 3, k) values at the triangles' corners; 0 where nothing is hit.

    Args:
        triangle: (h, w) int64, or -1.
        weights: (h, w, 3) of the triangle's corners.
        corners: (m, 3, k) float32.
    """
    height, width = triangle.shape
    count = corners.shape[2]
    found = np.zeros((height, width, count), dtype=np.float32)
    for y in range(height):
        for x in range(width):
            item = triangle[y, x]
            if item < 0:
                continue
            for k in range(count):
                found[y, x, k] = (
                    weights[y, x, 0] * corners[item, 0, k]
                    + weights[y, x, 1] * corners[item, 1, k]
                    + weights[y, x, 2] * corners[item, 2, k]
                )
    return found


@njit(cache=True, error_model="numpy")
def make_units(vectors):  # noqa: ANN001, ANN201
    """Give (h, w, 3) vectors the length 1, in place; those without length stay."""
    height, width, _ = vectors.shape
    for y in range(height):
        for x in range(width):
            a, b, c = vectors[y, x, 0], vectors[y, x, 1], vectors[y, x, 2]
            length = np.sqrt(a * a + b * b + c * c)
            if length > 0.0:
                vectors[y, x, 0] = a / length
                vectors[y, x, 1] = b / length
                vectors[y, x, 2] = c / length


@njit(cache=True, error_model="numpy")
def mark_edges(depth, normals, axes, rule):  # noqa: ANN001, ANN201
    """(h, w) uint8: outlines, and where neighbouring pixels differ in depth, or bend.

    Args:
        depth: (h, w) mm, infinite where nothing is hit.
        normals: (h, w, 3) unit vectors.
        axes: (3, 3) float32: right, up and look of the grid.
        rule: mm per pixel; mm by which depths may leave the range of the tangent planes; cosine
            of the angle from which a bend is an edge, -2 for none.
    """
    pitch, room, crease = rule
    height, width = depth.shape
    marked = np.zeros((height, width), dtype=np.uint8)
    for y in range(height):
        for x in range(width):
            for down in range(2):
                v, u = y + down, x + 1 - down
                if v >= height or u >= width:
                    continue
                one, two = np.isfinite(depth[y, x]), np.isfinite(depth[v, u])
                if one != two:
                    marked[y, x] = marked[v, u] = 1
                if not one or not two:
                    continue
                a, b = normals[y, x], normals[v, u]
                if a[0] * b[0] + a[1] * b[1] + a[2] * b[2] < crease:
                    marked[y, x] = 1
                step = depth[v, u] - depth[y, x]
                if abs(step) <= room:
                    continue
                first, second = _growth(a, axes, down, pitch), _growth(b, axes, down, pitch)
                if step < min(first, second) - room or step > max(first, second) + room:
                    marked[y, x] = 1
    return marked


@njit(cache=True, error_model="numpy")
def _growth(normal, axes, down, pitch):  # noqa: ANN001, ANN202
    """mm by which a surface gets deeper from a pixel to the next; at most 10 times the pitch."""
    across = -axes[1] if down else axes[0]
    facing = normal[0] * axes[2, 0] + normal[1] * axes[2, 1] + normal[2] * axes[2, 2]
    along = normal[0] * across[0] + normal[1] * across[1] + normal[2] * across[2]
    return -pitch * along / min(facing, -0.1)


@njit(cache=True, error_model="numpy")
def shaded(triangle, normals, colours, edges, lighting):  # noqa: ANN001, ANN201
    """(h, w, 3) float32 RGB, 0 to 255 or more.

    Args:
        triangle: (h, w), -1 where nothing is hit.
        normals: (h, w, 3) unit vectors.
        colours: (h, w, 3) or (1, 1, 3) float32 RGB of the part.
        edges: (h, w) uint8, not 0 where an edge runs.
        lighting: (3,) unit vector towards the light; share of it that faces lose that look away;
            (3,) RGB of the background.
    """
    light, contrast, background = lighting
    height, width = triangle.shape
    image = np.empty((height, width, 3), dtype=np.float32)
    plain = colours.shape[0] == 1
    for y in range(height):
        for x in range(width):
            if triangle[y, x] < 0:
                image[y, x] = background
                continue
            base = colours[0, 0] if plain else colours[y, x]
            if edges[y, x]:
                # Darker than the part, or lighter where the part is nearly black.
                dark = (base[0] + base[1] + base[2]) / 3.0 < 48.0
                for k in range(3):
                    image[y, x, k] = 0.55 * base[k] + 80.0 if dark else 0.28 * base[k]
                continue
            # Half-Lambert: faces that look away from the light keep their form.
            item = normals[y, x]
            facing = (1.0 + item[0] * light[0] + item[1] * light[1] + item[2] * light[2]) / 2.0
            shade = 1.02 - contrast * (1.0 - facing**1.3)
            for k in range(3):
                image[y, x, k] = base[k] * shade
    return image
