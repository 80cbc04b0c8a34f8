"""The shapes of one view before their linetypes are known: each with the runs of ink along it.

Ridge points of the ink grow lines, circles and ellipses; each is fitted to its ink, and of a curve
only the runs count that follow it, not a tangent or a polygon.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.geometry.whole_curves import Circle, ClosedCurve, Line, WholeCurve
from gaussiancad_core.sheet.dash_noise import FEWEST, LIKE_A_DASH
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import ON_LINE, STEP
from gaussiancad_core.sheet.tracing.arc_ends import without_arc_ends
from gaussiancad_core.sheet.tracing.close_lines import with_close_lines
from gaussiancad_core.sheet.tracing.dash_pairs import paired_rhythm
from gaussiancad_core.sheet.tracing.ellipse_fits import ellipse_profile, refit_ellipse
from gaussiancad_core.sheet.tracing.hidden_labels import TOLD, label_odds
from gaussiancad_core.sheet.tracing.ink_runs import (
    SHORTEST_DASH,
    SHORTEST_DOT,
    InkField,
    Rhythm,
    Run,
    circle_runs,
    ink_field,
    labelled_rhythm,
    learn_rhythm,
    line_runs,
    runs_spans,
)
from gaussiancad_core.sheet.tracing.ink_shapes import (
    fit_circle,
    following,
    line_support,
    radial_profile,
    refit_line,
)
from gaussiancad_core.sheet.tracing.junctions import FULL_TURN
from gaussiancad_core.sheet.tracing.line_widths import Pens, learn_pens, run_width
from gaussiancad_core.sheet.tracing.offset_lines import (
    lines_across,
    parted_slants,
    runs_along,
    without_offset_ink,
)
from gaussiancad_core.sheet.tracing.ridges import ridge_points
from gaussiancad_core.sheet.tracing.shape_growth import GrowthRules, grow_all
from gaussiancad_core.sheet.tracing.tangent_runs import without_tangent_ends, without_tangents
from gaussiancad_core.sheet.votes import LARGELY
from gaussiancad_protocol.codes import Code

MIN_SAGITTA = 1.2
"""Height in px of the flattest arc that is told from a straight line, beyond half a stroke."""

_MOST_LINES = 1500
"""Straight lines of a view: each is looked at beside the others, and no solid follows from 900."""

_SMALL_BEND = 2.0
"""Radius in line widths up to which the ink at a corner may look like an arc."""

_CURVED = 0.85
"""What a circle's ink counts for against a line's, which a flat arc follows about as well."""


_FOLLOWING_IN_PART = 0.4
"""Share of a dash that runs into another stroke whose ink lies on its curve."""


@dataclass(frozen=True)
class Shape:
    """A line, circle or ellipse with the runs of ink along it.

    Attributes:
        geometry: the fitted shape.
        runs: in order along it.
        support: px of its ink whose centre line it follows, in doubt less than its length.
        close: whether another line is known to run right beside it.
        twin: whether it is one of two, one after the other, that share their ink.
    """

    geometry: WholeCurve
    runs: tuple[Run, ...]
    support: float
    close: bool = False
    twin: bool = False

    @property
    def line(self) -> Line:
        """Its geometry, of a straight one."""
        if not isinstance(self.geometry, Line):
            raise ValueError("the shape is not straight")
        return self.geometry

    @property
    def circle(self) -> Circle:
        """Its geometry, of a circle."""
        if not isinstance(self.geometry, Circle):
            raise ValueError("the shape is no circle")
        return self.geometry


@dataclass(frozen=True)
class ViewShapes:
    """Shapes of one view before their linetypes are known.

    Attributes:
        sheet: the view's part of the sheet.
        field: its ink with directions.
        shapes: ellipses and circles, then lines.
        offset: (x, y) px of the crop on the sheet.
    """

    sheet: CleanSheet
    field: InkField
    shapes: tuple[Shape, ...]
    offset: tuple[int, int]


def find_shapes(sheet: CleanSheet, box: tuple[float, float, float, float]) -> ViewShapes:
    """Lines, circles and ellipses of the view inside a box of the sheet.

    Raises:
        NoModelError: ``part-too-complex``: there are more lines than any part has.
    """
    crop, offset = _crop(sheet, box)
    field = ink_field(crop)
    height, width = crop.ink.shape
    candidates, close = _candidates(crop)
    straight = [line for line in candidates if isinstance(line, Line)]
    corners = np.array([[0, 0], [width, 0], [0, height], [width, height]], dtype=np.float64)
    circles = [curve for curve in candidates if isinstance(curve, Circle)]
    found = []
    for line in straight:
        along, _ = line.coordinates(corners)
        reach = float(along.min()), float(along.max())
        runs = line_runs(field, line, *reach)
        for this_runs in parted_slants(crop, line, runs) if runs else ():
            spans = runs_spans(runs_along(crop, line, this_runs))
            refitted = refit_line(crop, line, without_arc_ends(line, spans, circles))
            found.append((refitted, line_runs(field, refitted, *reach), line in close))
    for line, runs, _ in list(found):
        for other in lines_across(crop, line, runs, [this_line for this_line, _, _ in found]):
            along, _ = other.coordinates(corners)
            found.append((other, line_runs(field, other, along.min(), along.max()), False))
    curves = [curve for curve in candidates if not isinstance(curve, Line)]
    drawn = [(line, runs) for line, runs, _ in found]
    shapes = [shape for curve in curves if (shape := _curve_shape(crop, field, curve, drawn))]
    lines = [line for line, _, _ in found]
    for line, runs, adjacent in found:
        items = without_offset_ink(crop, line, runs, lines)
        support = line_support(crop, line, runs_spans(items))
        shapes.append(Shape(line, tuple(items), support, adjacent))
    return ViewShapes(crop, field, tuple(shapes), offset)


def _candidates(sheet: CleanSheet) -> tuple[list[WholeCurve], set[Line]]:
    """Ellipses first, then circles, then lines; and the lines that run right beside others."""
    rules = GrowthRules.of_width(sheet.stroke_width, sheet.dash_gap)
    grown = grow_all(ridge_points(sheet.weight, sheet.stroke_width), rules)
    shapes = [shape.geometry for shape in grown]
    ellipses = [shape for shape in shapes if isinstance(shape, WholeEllipse)]
    circles = [_better_fit(sheet, shape) for shape in shapes if isinstance(shape, Circle)]
    straight = [shape for shape in shapes if isinstance(shape, Line)]
    _check_amount(len(straight))
    lines, close = with_close_lines(sheet, straight)
    return [*ellipses, *circles, *lines], close


def _check_amount(count: int) -> None:
    if count > _MOST_LINES:
        raise NoModelError(
            Code.PART_TOO_COMPLEX,
            "a view of the picture has {count:,} lines, more than the {most:,} that a part is made "
            "from: draw less in one sheet, or box the view alone",
            count=count,
            most=_MOST_LINES,
        )


def _better_fit(sheet: CleanSheet, circle: Circle) -> Circle:
    """The circle fitted to the ink, exact where it is whole; tangents pull a fillet away."""
    fitted = fit_circle(sheet, circle)
    if fitted is None:
        return circle
    moved = (*np.subtract(fitted.centre, circle.centre), fitted.radius - circle.radius)
    return fitted if np.abs(moved).max() < ON_LINE else circle


def view_rhythm(views: list[ViewShapes], stroke_width: float) -> Rhythm:
    """The rhythm of dashes of a sheet, learnt from all its views; from the runs that labels tell to
    be hidden, where these are enough."""
    labelled = [
        list(runs) for view in views for shape in view.shapes for runs in _hidden(view, shape)
    ]
    if rhythm := labelled_rhythm(labelled, SHORTEST_DOT * stroke_width):
        return rhythm
    series = [list(shape.runs) for view in views for shape in view.shapes]
    if rhythm := labelled_rhythm(series, SHORTEST_DASH * stroke_width):
        return rhythm
    drawn = [(view.field, shape.geometry, shape.runs) for view in views for shape in view.shapes]
    return paired_rhythm(drawn, stroke_width) or learn_rhythm(series, stroke_width)


def _hidden(view: ViewShapes, shape: Shape) -> list[list[Run]]:
    """The runs of a shape, one after the other, that labels tell to be hidden."""

    def is_hidden(run: Run) -> bool:
        points = shape.geometry.points_at(np.arange(run.start, run.end, STEP))
        return float(np.median(label_odds(view.sheet, points))) >= TOLD

    return [list(runs) for hidden, runs in groupby(shape.runs, is_hidden) if hidden]


def view_pens(views: list[ViewShapes], rhythm: Rhythm) -> Pens:
    """What the widths of a sheet's lines tell of their linetypes, learnt from all its views."""
    lines = [
        [(run, run_width(view.sheet, shape.geometry, run, edges=True)) for run in shape.runs]
        for view in views
        for shape in view.shapes
    ]
    return learn_pens(lines, rhythm)


def _crop(
    sheet: CleanSheet, box: tuple[float, float, float, float]
) -> tuple[CleanSheet, tuple[int, int]]:
    margin = int(np.ceil(sheet.stroke_width)) + 6
    x0, y0 = max(0, int(box[0]) - margin), max(0, int(box[1]) - margin)
    x1, y1 = int(np.ceil(box[2])) + margin, int(np.ceil(box[3])) + margin
    pair = np.s_[y0:y1, x0:x1]
    odds = None if sheet.hidden_odds is None else sheet.hidden_odds[pair].copy()
    ink, weight = sheet.ink[pair], sheet.weight[pair].copy()
    part = replace(sheet, ink=ink, weight=weight, hidden_odds=odds)
    return part, (x0, y0)


def _curve_shape(
    sheet: CleanSheet,
    field: InkField,
    curve: ClosedCurve,
    lines: Sequence[tuple[Line, Sequence[Run]]],
) -> Shape | None:
    """The curve with its runs, if the ink follows it and not a tangent or a polygon."""
    if isinstance(curve, WholeEllipse):
        curve = refit_ellipse(sheet, curve, runs_spans(circle_runs(field, curve)))
        along, residual = ellipse_profile(sheet, curve)
    else:
        angles, radii = radial_profile(sheet, curve, sheet.stroke_width / 2 + 1.5)
        along, residual = angles * curve.radius, radii - curve.radius
    followed = along[np.abs(residual) < 0.6]
    seen = circle_runs(field, curve)
    # By then a line that touches the curve has left it by half of its ink.
    touch = float(np.sqrt(radius_of(curve) * sheet.stroke_width))
    this_runs = [without_tangent_ends(curve, run, lines, touch) for run in seen]
    shares = [_share_followed(followed, run, curve.around, touch) for run in this_runs]
    runs = without_tangents(curve, _followed_runs(seen, shares, curve.around), lines)
    rules = GrowthRules.of_width(sheet.stroke_width, sheet.dash_gap)
    longest = _longest_stretch(runs, rules.gap, curve.around)
    covered = sum(run.length for run in runs) / curve.around
    bowed = longest**2 / (8 * radius_of(curve)) > MIN_SAGITTA + sheet.stroke_width / 2
    # What bends within two line widths is a corner, or two, where fillets are looked for.
    large = radius_of(curve) > _SMALL_BEND * sheet.stroke_width
    if covered < 0.45 and not (bowed and longest > 6 and large):
        return None
    return Shape(curve, tuple(runs), _CURVED * following(residual))


def _followed_runs(runs: list[Run], shares: Sequence[float], around: float) -> list[Run]:
    """The runs of a curve that follow it, by the share of each that does.

    A dash that ends in another stroke at a flat angle follows it in part only.  It counts if it
    carries on the rhythm of dashes that do follow it.
    """
    follows = [share > LARGELY for share in shares]
    whole = [run.length for run, follow in zip(runs, follows, strict=True) if follow]
    blanks = [(runs[k].start - runs[k - 1].end) % around for k in range(len(runs))]
    gaps = [blanks[k] for k in range(len(runs)) if follows[k] and follows[k - 1]]
    if len(whole) < FEWEST:
        return [run for run, follow in zip(runs, follows, strict=True) if follow]
    dash, gap = float(np.median(whole)), float(np.median(gaps)) if gaps else 0.0

    def carries_on(k: int) -> bool:
        after = (k + 1) % len(runs)
        led = follows[k - 1] and abs(blanks[k] - gap) < LIKE_A_DASH * gap
        leads = follows[after] and abs(blanks[after] - gap) < LIKE_A_DASH * gap
        even = abs(runs[k].length - dash) < LIKE_A_DASH * dash
        return shares[k] > _FOLLOWING_IN_PART and even and (led or leads)

    return [run for k, run in enumerate(runs) if follows[k] or carries_on(k)]


def _longest_stretch(runs: list[Run], gap: float, around: float) -> float:
    """px of the longest series of runs with no wider gap between them, over position 0 too."""
    longest = length = 0.0
    for before, run in zip([None, *runs, *runs], [*runs, *runs], strict=False):
        if before is not None and (run.start - before.end) % around <= gap:
            length += (run.end - before.end) % around
        else:
            length = run.length
        longest = max(longest, length)
    return min(longest, around)


def radius_of(curve: ClosedCurve) -> float:
    """px of a circle's radius, of an ellipse the mean one."""
    return curve.around / FULL_TURN


def _share_followed(
    followed: npt.NDArray[np.float64], run: Run, around: float, touch: float
) -> float:
    """Share of a run at positions that follow the curve; up to ``touch`` px at each of its ends it
    may run along a tangent."""
    within = np.sort((followed - run.start) % around)
    within = within[within <= run.length]
    if not len(within):
        return 0.0
    tangents = min(within[0], touch) + min(run.length - within[-1], touch)
    # Of dashes nothing is left out: they end anywhere.
    length = run.length - (tangents if run.length > 4.0 * touch else 0.0)
    return len(within) / max(length, STEP)
