"""The strokes of a drawing: straight, circular, and everything else as a fine chain.

The lines of a solid are segments, arcs and chains; ellipses come from sheets that were read, and
from :func:`as_plain_strokes`, which knows the chains that run along one.
"""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from gaussiancad_core.geometry.chains import Chain
from gaussiancad_core.geometry.ellipses import LEAST_SWEEP, LONGEST_CHORD, ellipse_through
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke


@dataclass(frozen=True)
class Polyline(Chain):
    """A stroke along a curve that is neither line nor circle: an ellipse, a spline.

    It stays one stroke, so that dashes run along the curve and not along its chords.

    Attributes:
        linetype: visible or hidden.
        confidence: 0 to 1, how sure the linetype is.
    """

    linetype: Linetype
    confidence: float = 1.0

    def segments(self) -> tuple[Segment, ...]:
        """The chords as strokes."""
        return tuple(
            Segment(start, end, self.linetype, self.confidence)
            for start, end in pairwise(self.points)
        )


DrawnStroke = Segment | Arc | Ellipse | Polyline

_ON_ELLIPSE = 2e-4
"""Share of a chain's size by which its points may lie beside an ellipse that replaces it."""


def as_plain_strokes(strokes: tuple[DrawnStroke, ...]) -> tuple[Stroke, ...]:
    """The strokes as :data:`gaussiancad_core.model.views.Stroke`: chains along an ellipse become
    that
    ellipse, others their chords."""
    plain: list[Stroke] = []
    for stroke in strokes:
        if not isinstance(stroke, Polyline):
            plain.append(stroke)
            continue
        ellipse = _ellipse_along(stroke)
        plain.extend(stroke.segments() if ellipse is None else [ellipse])
    return tuple(plain)


def _ellipse_along(chain: Polyline) -> Ellipse | None:
    """The ellipse that a chain's points lie on, from one end to the other."""
    points = np.array(chain.points)
    found = ellipse_through(points)
    if found is None:
        return None
    away, parameters = found.away(points)
    size = float(np.ptp(points, axis=0).max())
    steps = np.diff(np.unwrap(parameters))
    way = np.sign(steps.sum())
    sweep = abs(float(steps.sum()))
    # Chains may hold a point twice.
    even = (way * steps > -1e-9).all() and np.abs(steps).max() < LONGEST_CHORD
    if np.abs(away).max() > _ON_ELLIPSE * size or not even or sweep < LEAST_SWEEP:
        return None
    first = float(np.mod(parameters[0] if way > 0.0 else parameters[-1], 2.0 * np.pi))
    axes = found.semi_major, found.semi_minor, found.rotation
    turn = min(sweep, 2.0 * np.pi)
    return Ellipse(found.centre, *axes, first, turn, chain.linetype, chain.confidence)
