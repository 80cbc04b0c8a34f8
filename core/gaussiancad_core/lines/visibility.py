"""Whether a line of a drawing of an exact solid is visible, hidden, or no line at all.

Two rays just beside the line decide, by the rule of :mod:`.two_rays`.
"""

from enum import Enum

import numpy as np

from gaussiancad_core.kernel.solid_edges import SMOOTH_ANGLE
from gaussiancad_core.kernel.solid_rays import SolidRays
from gaussiancad_core.kernel.surface_crossings import Array
from gaussiancad_core.lines.two_rays import Difference, difference
from gaussiancad_core.model.axes import ViewFrame

_OFFSETS = (1.0, 2.0, 0.5, 4.0, 12.0)
"""Distances beside the line that are tried in turn, in multiples of the first."""

_FAR_OFFSETS = (40.0, 100.0)
"""Distances tried where faces overlap or gape at their borders, as in loosely sewn solids."""

_CREASE = float(np.cos(SMOOTH_ANGLE))
"""Cosine of the angle from which two faces meet in an edge."""

_GRAZING = 1e-9
"""Share of a normal along a ray below which the ray runs along the surface."""


class Visibility(Enum):
    """What two rays beside a point say about a line through it.

    The smooth ones are where one face passes smoothly into another; nothing is to be seen there
    unless tangent edges are wanted.
    """

    VISIBLE = "visible"
    HIDDEN = "hidden"
    SMOOTH_VISIBLE = "smooth-visible"
    SMOOTH_HIDDEN = "smooth-hidden"
    BLANK = "blank"
    UNCERTAIN = "uncertain"


_UNSETTLED = tuple(set(Visibility) - {Visibility.VISIBLE, Visibility.HIDDEN})


class RayTest:
    """Looks beside lines of one view.

    Args:
        sight: the solid's sight lines.
        frame: the view.
        offset: mm between a line and the sight lines beside it.
    """

    def __init__(self, sight: SolidRays, frame: ViewFrame, offset: float) -> None:
        self._sight = sight
        self._look = np.array(frame.look, dtype=np.float64)
        self._plane = np.array([frame.right, frame.up], dtype=np.float64)
        self._offset = offset

    def visibility_of(self, points: Array, normals: Array, slacks: Array) -> list[Visibility]:
        """What lines through points show.

        Args:
            points: (n, 2) mm on the lines.
            normals: (n, 2) unit vectors across the lines.
            slacks: (n,) mm by which the solid's faces may miss the lines.
        """
        steps = np.maximum(self._offset, 1.5 * slacks)[:, None] * normals
        answers = [Visibility.UNCERTAIN] * len(points)
        for factor in (*_OFFSETS, *_FAR_OFFSETS):
            # A line that is known to a tolerance only may lie beside both near sight lines.
            unsettled = _UNSETTLED if factor in _OFFSETS else (Visibility.UNCERTAIN,)
            self._ask(answers, unsettled, points, factor * steps)
        self._ask(answers, (Visibility.UNCERTAIN,), points, steps, trusting=True)
        return answers

    def _ask(
        self,
        answers: list[Visibility],
        again: tuple[Visibility, ...],
        points: Array,
        across: Array,
        *,
        trusting: bool = False,
    ) -> None:
        """Replace those answers that are to be asked again by better ones.

        A solid may have a fault; ``trusting`` takes what faulty rays say.
        """
        asked = [number for number, answer in enumerate(answers) if answer in again]
        if not asked:
            return
        found = self._compared(points[asked], across[asked], trusting)
        for number, answer in zip(asked, found, strict=True):
            if answer is not Visibility.UNCERTAIN:
                answers[number] = answer

    def _compared(self, points: Array, across: Array, trusting: bool = False) -> list[Visibility]:
        rays = self._sight.crossings_at(np.concatenate([points - across, points + across]))
        splits = np.concatenate([[0], np.cumsum([len(ray.depth) for ray in rays])])
        normals = np.concatenate([ray.normal for ray in rays])
        towards = normals @ self._look
        ways = np.tile(2.0 * across, (2, 1)) @ self._plane
        along = np.einsum("ij,ij->i", normals, np.repeat(ways, np.diff(splits), axis=0))
        crossings = (
            np.concatenate([ray.depth for ray in rays]),
            towards < 0.0,
            -along / np.where(np.abs(towards) < _GRAZING, np.nan, towards),
            normals,
            np.concatenate([ray.face for ray in rays]),
        )
        found = []
        for number, way in enumerate(across):
            one, other = number, number + len(across)
            if not trusting and not (rays[one].sound and rays[other].sound):
                found.append(Visibility.UNCERTAIN)
                continue
            first = int(splits[one]), int(splits[one + 1])
            second = int(splits[other]), int(splits[other + 1])
            rule = float(np.hypot(*way)), _CREASE, True
            found.append(_SHOWN[Difference(difference(crossings, first, second, rule))])
        return found


_SHOWN = {
    Difference.NONE: Visibility.BLANK,
    Difference.VISIBLE_STEP: Visibility.VISIBLE,
    Difference.VISIBLE_BEND: Visibility.VISIBLE,
    Difference.HIDDEN_STEP: Visibility.HIDDEN,
    Difference.HIDDEN_BEND: Visibility.HIDDEN,
    Difference.VISIBLE_SMOOTH: Visibility.SMOOTH_VISIBLE,
    Difference.HIDDEN_SMOOTH: Visibility.SMOOTH_HIDDEN,
}
