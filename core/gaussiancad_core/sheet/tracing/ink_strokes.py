"""The strokes of one view: lines, circles and ellipses, cut by the ink under them, with exact ends.

The shapes with the most ink come first; every accepted stroke explains its ink, and a shape that
explains little that is new is dropped: a chord of a circle, or an arc that cuts a corner.  What no
of them explains (free curves) is traced as short segments.
"""

from dataclasses import replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.geometry.ellipses import WholeEllipse
from gaussiancad_core.geometry.similarities import Similarity
from gaussiancad_core.geometry.whole_curves import Circle, ClosedCurve, Line, WholeCurve
from gaussiancad_core.model.views import Arc, Ellipse, Linetype, Segment, Stroke
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.picture_noise import MEETING
from gaussiancad_core.sheet.tracing.behind_edges import with_ends_behind_edges
from gaussiancad_core.sheet.tracing.borrowed_dashes import unshared_runs
from gaussiancad_core.sheet.tracing.close_fits import with_close_fits
from gaussiancad_core.sheet.tracing.closed_circles import is_closed_by_others
from gaussiancad_core.sheet.tracing.corner_dashes import find_corner_dashes
from gaussiancad_core.sheet.tracing.corner_stubs import Placed
from gaussiancad_core.sheet.tracing.dangling import with_met_ends
from gaussiancad_core.sheet.tracing.edged_chamfers import with_edged_chamfers
from gaussiancad_core.sheet.tracing.explained_ink import (
    Explained,
    is_new,
    is_next_dash,
    joins_arcs,
    labelled_linetypes,
    path_points,
    with_nearby_dashes,
)
from gaussiancad_core.sheet.tracing.hidden_fillets import find_hidden_fillets
from gaussiancad_core.sheet.tracing.ink_runs import (
    InkField,
    Piece,
    Rhythm,
    Run,
    bridged,
    with_dashes_led_to,
)
from gaussiancad_core.sheet.tracing.ink_shapes import (
    refit_circle,
)
from gaussiancad_core.sheet.tracing.junctions import FULL_TURN, ended_at_junctions, is_full_circle
from gaussiancad_core.sheet.tracing.leftover_tracing import trace_remainder
from gaussiancad_core.sheet.tracing.line_widths import Pens
from gaussiancad_core.sheet.tracing.linetype_changes import with_changes_at_junctions
from gaussiancad_core.sheet.tracing.linetype_odds import run_odds
from gaussiancad_core.sheet.tracing.outline_bows import with_bows
from gaussiancad_core.sheet.tracing.outline_jogs import find_jogs
from gaussiancad_core.sheet.tracing.parted_lines import parted_at_corners
from gaussiancad_core.sheet.tracing.remaining_dashes import find_remaining_dashes
from gaussiancad_core.sheet.tracing.run_linetypes import classify
from gaussiancad_core.sheet.tracing.run_outs import with_run_outs
from gaussiancad_core.sheet.tracing.rungs import find_rungs
from gaussiancad_core.sheet.tracing.shadows import without_shadows
from gaussiancad_core.sheet.tracing.short_hidden_lines import with_corners_reached
from gaussiancad_core.sheet.tracing.short_legs import with_short_legs
from gaussiancad_core.sheet.tracing.short_strokes import find_short_strokes
from gaussiancad_core.sheet.tracing.slant_fits import with_fitted_slants
from gaussiancad_core.sheet.tracing.slanted_ends import ended_before_slants
from gaussiancad_core.sheet.tracing.slanted_rungs import find_slanted_rungs
from gaussiancad_core.sheet.tracing.small_chamfers import with_chamfers
from gaussiancad_core.sheet.tracing.small_fillets import Fillet, find_fillets, is_chord
from gaussiancad_core.sheet.tracing.square_corners import has_square_corner
from gaussiancad_core.sheet.tracing.touching_arcs import ended_where_lines_touch, up_to_tangents
from gaussiancad_core.sheet.tracing.view_shapes import MIN_SAGITTA, ViewShapes, radius_of

_OPEN = 0.4
"""Share of a circle that is blank at most: dashes at a corner lie on many small circles."""


def classify_strokes(
    view: ViewShapes, rhythm: Rhythm, pens: Pens | None = None
) -> tuple[Stroke, ...]:
    """Visible and hidden strokes of a view in px of the sheet (y down, pixel centres at .5).

    Args:
        view: its shapes.
        rhythm: of the sheet's dashes.
        pens: what widths tell; nothing if left out.
    """
    explained = Explained.blank(view.sheet)
    pieces = _seen_pieces(view, rhythm, pens, explained)
    rows = find_remaining_dashes(view.sheet.ink & (explained.around == 0), view.sheet, rhythm)
    for geometry, piece in rows:
        explained.add(geometry, piece, close=True)
    pieces = without_shadows([*pieces, *rows], view.sheet.stroke_width, rhythm.dash)
    pieces = ended_where_lines_touch(pieces, view.sheet.stroke_width)
    pieces += find_corner_dashes(pieces, view.sheet, rhythm)
    pieces = ended_before_slants(pieces, view.sheet)
    ended = ended_at_junctions(pieces, rhythm, view.sheet.stroke_width)
    jogs = find_jogs(ended, view.sheet)
    rungs = find_rungs([*ended, *jogs], view.sheet, pens)
    slanted = find_slanted_rungs([*ended, *jogs, *rungs], view.sheet, pens)
    pieces += [*jogs, *rungs, *slanted]
    pieces = _refitted(pieces, ended, view.sheet)
    pieces = with_fitted_slants(pieces, ended, view.sheet)
    pieces = with_close_fits(pieces, ended, view.sheet)
    ended = ended_at_junctions(pieces, rhythm, view.sheet.stroke_width)
    parted = parted_at_corners(ended, view.sheet, rhythm)
    if len(parted) > len(ended):
        ended = ended_at_junctions(parted, rhythm, view.sheet.stroke_width)
    ended, cuts = with_edged_chamfers(view.sheet.weight, ended, view.sheet.stroke_width)
    rounded = find_fillets(view.sheet.weight, ended, view.sheet.stroke_width, cuts)
    ended = _with_fillets(ended, rounded, explained)
    ended = _with_fillets(ended, find_hidden_fillets(ended, view.sheet, rhythm), explained)
    ended = with_chamfers(view.sheet.weight, ended, view.sheet.stroke_width)
    ended = with_short_legs(ended, view.sheet, rhythm)
    ended = with_bows(with_corners_reached(ended, rhythm), view.sheet)
    ended = with_run_outs(ended, view.sheet)
    ended = with_ends_behind_edges(ended, view.sheet, rhythm)
    # Strokes that were drawn out to a junction explain the ink up to there.
    for placed in ended:
        explained.add(*placed)
    remainder = view.sheet.ink & (explained.around == 0)
    short = find_short_strokes(remainder, ended, view.sheet, rhythm, pens)
    for placed in short:
        explained.add(*placed)
    ended += short
    remainder &= explained.around == 0
    ended = with_met_ends(ended, remainder, view.sheet.stroke_width)
    if pens is None or not pens.distinct:
        ended = with_changes_at_junctions(ended, rhythm, view.sheet.stroke_width)
    strokes = [_stroke(geometry, piece) for geometry, piece in ended]
    strokes += trace_remainder(remainder, view.sheet.stroke_width, rhythm.dash)
    shift = Similarity(offset=(view.offset[0] + 0.5, view.offset[1] + 0.5))
    return tuple(stroke.mapped(shift) for stroke in strokes if stroke.length > 1.5)


def _seen_pieces(
    view: ViewShapes, rhythm: Rhythm, pens: Pens | None, explained: Explained
) -> list[Placed]:
    """The pieces of all shapes where their ink is seen, those with most ink first; ``explained``
    has their ink at last."""
    pieces: list[Placed] = []
    order = sorted(view.shapes, key=lambda shape: -shape.support)
    # Along the flat sides of ellipses run lines that are none.
    joins = not any(isinstance(shape.geometry, WholeEllipse) for shape in order)
    lines = [
        (this_shape.geometry, this_shape.runs)
        for this_shape in order
        if isinstance(this_shape.geometry, Line)
    ]
    known = explained
    for index, shape in enumerate(order):
        # Of two that share their ink neither explains the other's.
        if not shape.twin:
            known = explained
        elif known is explained or not order[index - 1].twin:
            known = explained.copy()
        width = view.sheet.stroke_width
        inked = unshared_runs(shape.geometry, shape.runs, lines, rhythm, width)
        # The ink of twins is as wide as both.
        own_pens = Pens() if pens is None or shape.twin else pens
        runs = run_odds(view.sheet, shape.geometry, inked, own_pens)
        fresh = [
            (run, odds)
            for k, (run, odds) in enumerate(runs)
            if is_new(shape.geometry, run, known.near(shape.close))
            or is_next_dash(shape.geometry, runs, k, known, rhythm)
            or (joins and joins_arcs(shape.geometry, run, known.around))
        ]
        if not isinstance(shape.geometry, Line):
            fresh = with_nearby_dashes(shape.geometry, runs, fresh, rhythm, width)
        touches = [_touches(view.field, shape.geometry, run) for run, _ in fresh]
        stated = labelled_linetypes(shape.geometry, fresh, explained.around, rhythm)
        found = classify([run for run, _ in fresh], rhythm, touches, shape.geometry.around, stated)
        if not isinstance(shape.geometry, Line):
            curved = [piece for piece in found if _is_curved(shape.geometry, piece, view.sheet)]
            found = with_dashes_led_to(view.field, shape.geometry, found, curved, rhythm)
        if isinstance(shape.geometry, Circle):
            circle = shape.geometry
            found = [
                this_piece
                for this_piece in found
                if not has_square_corner(circle, this_piece, view.sheet)
            ]
        joined = bridged(view.field, shape.geometry, found, rhythm)
        if not is_closed_by_others(shape.geometry, (found, joined), lines, view.sheet, rhythm):
            found = joined
        if not isinstance(shape.geometry, Line):
            found = _closed(shape.geometry, found, rhythm)
        for piece in found:
            pieces.append((shape.geometry, piece))
            up = up_to_tangents(shape.geometry, piece, lines, view.sheet.stroke_width)
            explained.add(shape.geometry, up)
    return pieces


def _is_curved(curve: ClosedCurve, piece: Piece, sheet: CleanSheet) -> bool:
    length = piece.end - piece.start
    sagitta = length**2 / (8 * radius_of(curve))
    return sagitta > MIN_SAGITTA + sheet.stroke_width / 2 or length > curve.around / 2


def _closed(curve: ClosedCurve, pieces: list[Piece], rhythm: Rhythm) -> list[Piece]:
    """Make a piece that leaves only a dash's gap open the full circle or ellipse."""
    around = curve.around
    if len(pieces) == 1:
        piece = pieces[0]
        slack = 2.5 * rhythm.gap + 1.0 if piece.linetype is Linetype.HIDDEN else 6.0
        slack = min(slack, _OPEN * around)
        if around - (piece.end - piece.start) <= slack:
            return [replace(piece, end=piece.start + around)]
    elif len(pieces) == 2 and pieces[0].linetype is pieces[1].linetype is Linetype.HIDDEN:
        # One dashed circle that was cut at angle 0.
        first, last = pieces
        if first.start + around - last.end <= 2.5 * rhythm.gap + 1.0:
            return [replace(last, end=first.end + around)]
    return pieces


def _touches(field: InkField, geometry: WholeCurve, run: Run) -> tuple[bool, bool]:
    """Whether the start and the end of a run lie on another stroke: there is ink beside it."""
    half = field.stroke_width / 2
    offset = half + 2.0

    def inked(place: npt.NDArray[np.float64]) -> bool:
        x, y = np.rint(place).astype(int)
        inside = 0 <= y < field.weight.shape[0] and 0 <= x < field.weight.shape[1]
        return bool(inside and field.weight[y, x] > 0.45)

    def touch(position: float, outward: float) -> bool:
        for share in (-1.0, 0.0, 1.0, 2.0):
            along = position + share * outward * half
            here, ahead = path_points(geometry, along, along + 1.0)[[0, -1]]
            tangent = (ahead - here) / max(float(np.hypot(*(ahead - here))), 1e-9)
            if share > 1.0 and not (np.abs(tangent).min() > MEETING and inked(here)):
                break
            normal = np.array([-tangent[1], tangent[0]])
            if inked(here + offset * normal) or inked(here - offset * normal):
                return True
        return False

    return touch(run.start, -1.0), touch(run.end, 1.0)


def _refitted(pieces: list[Placed], ended: list[Placed], sheet: CleanSheet) -> list[Placed]:
    """The pieces with their arcs fitted to the ink between their ends alone."""
    better: dict[Circle, Circle] = {}
    for geometry in {geometry: None for geometry, _ in ended if isinstance(geometry, Circle)}:
        stretches = [piece for other, piece in ended if other == geometry]
        if not any(is_full_circle(geometry, piece) for piece in stretches):
            spans = [(piece.start, piece.end) for piece in stretches]
            better[geometry] = refit_circle(sheet, geometry, spans)
    return [
        (better[geometry], _scaled(piece, better[geometry].radius / geometry.radius))
        if isinstance(geometry, Circle) and geometry in better
        else (geometry, piece)
        for geometry, piece in pieces
    ]


def _with_fillets(ended: list[Placed], fillets: list[Fillet], explained: Explained) -> list[Placed]:
    """The pieces with the arcs that round their corners; what was taken for a chord goes."""
    rounded = list(ended)
    arcs: list[Placed] = []
    for fillet in fillets:
        for index, piece in fillet.pieces:
            rounded[index] = (rounded[index][0], piece)
        arcs.append(fillet.arc)
        explained.add(*fillet.arc)
    gone = {index for fillet in fillets for index in fillet.instead}
    left = [pair for index, pair in enumerate(rounded) if index not in gone]
    return [pair for pair in left if not any(is_chord(pair, arc) for arc in arcs)] + arcs


def _scaled(piece: Piece, factor: float) -> Piece:
    """The piece at the same angles of a circle of another radius."""
    return replace(piece, start=piece.start * factor, end=piece.end * factor)


def _stroke(geometry: WholeCurve, piece: Piece) -> Stroke:
    kind = piece.linetype, piece.confidence
    if isinstance(geometry, Line):
        return Segment(geometry.at(piece.start), geometry.at(piece.end), *kind)
    if isinstance(geometry, WholeEllipse):
        first, last = geometry.parameters(np.array([piece.start, piece.end]))
        turn = FULL_TURN if is_full_circle(geometry, piece) else float(last - first)
        axes = geometry.semi_major, geometry.semi_minor, geometry.rotation
        return Ellipse(geometry.centre, *axes, float(first % FULL_TURN), turn, *kind)
    sweep = min((piece.end - piece.start) / geometry.radius, FULL_TURN)
    start = (piece.start / geometry.radius) % FULL_TURN
    return Arc(geometry.centre, geometry.radius, start, sweep, *kind)
