"""What a drawing shows between two neighbouring rays: nothing, a visible line or a hidden one.

Both rays run along the line of sight, one on either side of the place.  From the viewer on, each
meets surfaces of the part.  Two crossings are *shared* if both rays go the same way, in or out,
through one surface: its depth differs by no more than the tangent planes at both crossings allow.
The rays *differ* where a crossing has no partner (a step), or where partners are no continuation of
each other (a bend).  Where they differ nowhere, nothing is drawn.  Otherwise the nearest difference
decides: the line is visible if nothing shared comes before it, and hidden if something does.

This is the only statement of the rule.  :func:`difference` applies it to crossings with depths and
normals, of exact solids and of meshes; :func:`linetype_between` to crossings whose surfaces are
there or not, as the labels of cells say.
"""

from collections.abc import Iterable
from enum import IntEnum
from math import isnan

from numba import njit

from gaussiancad_core.model.views import Linetype


class Difference(IntEnum):
    """The nearest difference of two rays.

    The smooth ones are no difference, but a surface that goes over into another one: a line is
    drawn there only on sheets with tangent edges.
    """

    NONE = 0
    VISIBLE_STEP = 1
    VISIBLE_BEND = 2
    HIDDEN_STEP = 3
    HIDDEN_BEND = 4
    VISIBLE_SMOOTH = 5
    HIDDEN_SMOOTH = 6


def linetype_between(steps: Iterable[tuple[bool, bool]]) -> Linetype | None:
    """How a line between two rays is drawn; None where there is none.

    Args:
        steps: from the viewer on, of each depth: whether the rays differ there, and whether any
            surface is there that covers what lies behind.
    """
    covered = False
    for differs, covers in steps:
        if differs:
            return Linetype.HIDDEN if covered else Linetype.VISIBLE
        covered |= covers
    return None


@njit(cache=True)
def difference(crossings, one, other, rule):  # noqa: ANN001, ANN201
    """The nearest difference of two rays, a :class:`Difference`; compiled.

    Args:
        crossings: of all rays, ascending by depth within each: depths; whether a ray enters the
            material; growth of depth from the one ray to the other, on the tangent plane (NaN
            where that runs along the ray); (n, 3) unit normals; numbers of faces, or none.
        one, other: first crossing of a ray, and the one after its last.
        rule: by how much depths of partners may leave the range of the tangent planes; cosine of
            the angle of normals from which partners are no continuation, unless they lie on one
            face; whether steps count, or bends of one surface only.
    """
    depths, entering, slopes, normals, faces = crossings
    room, crease, steps = rule
    i, j = one[0], other[0]
    shared, smooth = 0, -1
    while i < one[1] or j < other[1]:
        if i < one[1] and j < other[1] and entering[i] == entering[j]:
            low, high = min(slopes[i], slopes[j]) - room, max(slopes[i], slopes[j]) + room
            level = not (isnan(slopes[i]) or isnan(slopes[j]))
            if level and low <= depths[j] - depths[i] <= high:
                same = faces.size > 0 and faces[i] == faces[j]
                cosine = (
                    normals[i, 0] * normals[j, 0]
                    + normals[i, 1] * normals[j, 1]
                    + normals[i, 2] * normals[j, 2]
                )
                if cosine < crease and not same:
                    return Difference.HIDDEN_BEND if shared else Difference.VISIBLE_BEND
                if smooth < 0 and faces.size > 0 and not same:
                    smooth = shared
                shared += 1
                i += 1
                j += 1
                continue
        if steps:
            return Difference.HIDDEN_STEP if shared else Difference.VISIBLE_STEP
        if not shared:
            # Two different surfaces begin here: there is no bend of one.
            return Difference.NONE
        if j >= other[1] or (i < one[1] and depths[i] <= depths[j]):
            i += 1
        else:
            j += 1
    if smooth < 0:
        return Difference.NONE
    return Difference.HIDDEN_SMOOTH if smooth else Difference.VISIBLE_SMOOTH
