"""Three-view sheets as other programs draw them, for what was made with the engine's own sheets.

The lines are the engine's; how they look is not: written as SVG and drawn by resvg, with widths,
greys, caps, dashes, captions, frames and distances that differ from sheet to sheet.  Dashes begin
at one end of an edge and leave off wherever they are at the other, as most programs have them.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from io import BytesIO

import numpy as np
import resvg_py
from PIL import Image

from benchmarks.sheets.foreign_dimensions import DimensionLook, view_dimensions
from gaussiancad_core.drawing.drawn_sheet import PartLines, Sheet
from gaussiancad_core.drawing.drawn_view import DrawnView, drawn_view
from gaussiancad_core.drawing.sheet_style import SheetStyle
from gaussiancad_core.drawing.view_placing import place_views
from gaussiancad_core.lines.strokes import DrawnStroke
from gaussiancad_core.model.axes import Projection
from gaussiancad_core.model.views import Linetype, Segment

_WIDTHS = (1200, 1600, 2000, 2800)
_RATIOS = (0.7071, 0.75)
_DASHES = ((6.0, 4.0), (8.0, 5.0), (12.0, 6.0), (10.0, 4.0), (16.0, 8.0), (9.0, 9.0))
"""px of dash and gap on sheets up to 1600 px wide; wider ones have longer ones."""

_LONGER = 1.6
_FINE_PX = 2000

_USED = 0.85
"""Share of a sheet that its views take."""

_CHORDS = 200
"""Points along a curve."""

_TEXT_PX = 22.0

_ROWS = 3
"""Most dimension lines on a side of a view."""

_CLOSER = 0.2
"""Factor on the gap between views that have dimensions, beside the room of these."""


@dataclass(frozen=True)
class Conventions:
    """How a program draws.

    Attributes:
        width, height: px of the sheet.
        visible, hidden: px, widths of lines.
        grey: level of hidden lines, 0 for black.
        dash: px of dash and gap.
        cap: ends of visible lines, as SVG has them.
        gap: between views, as a share of the part's longest extent.
        captions: whether the views' names stand below them.
        frame: whether there is a border.
        dimensions: how these look, None without any.
    """

    width: int
    height: int
    visible: float
    hidden: float
    grey: int
    dash: tuple[float, float]
    cap: str
    gap: float
    captions: bool
    frame: bool
    dimensions: DimensionLook | None = None

    @classmethod
    def drawn_by_lot(cls, seed: int, *, dimensioned: bool = False) -> "Conventions":
        """Those of some program."""
        lot = np.random.default_rng(seed)
        width = int(lot.choice(_WIDTHS))
        visible = float(lot.integers(2, 5))
        longer = _LONGER if width >= _FINE_PX else 1.0
        dash, gap = _DASHES[int(lot.integers(len(_DASHES)))]
        return cls(
            width=width,
            height=int(width * lot.choice(_RATIOS)),
            visible=visible,
            hidden=float(lot.choice([visible, max(1.0, visible - 1.0)])),
            grey=int(lot.choice([0, 0, 90, 140])),
            dash=(longer * dash, longer * gap),
            cap=str(lot.choice(["butt", "round", "square"])),
            gap=float(lot.choice([0.12, 0.2, 0.35])),
            captions=bool(lot.random() < 0.5),
            frame=bool(lot.random() < 0.5),
            dimensions=DimensionLook.drawn_by_lot(seed, visible, width) if dimensioned else None,
        )


def foreign_sheet(
    lines: PartLines,
    how: Conventions,
    projection: Projection = Projection.THIRD,
    turned: float = 0.0,
) -> Sheet:
    """The views of a part.

    Args:
        lines: of the views.
        how: it looks.
        projection: decides where the views stand.
        turned: degrees that everything is turned by on the sheet, clockwise; the views of the
            result are told as they were before.
    """
    views, scale = _placed(lines, how, projection)
    # What is drawn later lies above: the hidden lines of all views come first.
    body = [_path(stroke, how) for view in views for stroke in _hidden_first(view.strokes)]
    if how.dimensions is not None:
        for view in views:
            sides = _outer_sides(view, views)
            body += view_dimensions(view, how.dimensions, 1.0 / scale, sides, _ROWS)
    if how.captions:
        for view in views:
            x, y = 0.5 * (view.box[0] + view.box[2]), view.box[3] + 1.7 * _TEXT_PX
            if how.dimensions is not None:
                y += how.dimensions.reach(_ROWS)
            body.append(_caption(f"{view.role.value.upper()} VIEW", x, y))
    if how.frame:
        body.append(
            f'<rect x="12" y="12" width="{how.width - 24}" height="{how.height - 24}" '
            f'fill="none" stroke="black" stroke-width="{how.visible}"/>'
        )
    picture = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{how.width}" height="{how.height}">'
        f'<rect width="{how.width}" height="{how.height}" fill="white"/>'
        f'<g transform="rotate({turned} {how.width / 2} {how.height / 2})">'
        f"{''.join(body)}</g></svg>"
    )
    drawn = Image.open(BytesIO(bytes(resvg_py.svg_to_bytes(svg_string=picture))))
    return Sheet(np.asarray(drawn.convert("RGB")), 1.0 / scale, projection, views)


def _placed(
    lines: PartLines, how: Conventions, projection: Projection
) -> tuple[tuple[DrawnView, ...], float]:
    """The views on the sheet, and px per mm."""
    roles = tuple(lines.views)
    slots = {role: role.slot(projection) for role in roles}
    wide = {slots[role][0]: float(lines.size[role.frame.right_axis[0].value]) for role in roles}
    high = {slots[role][1]: float(lines.size[role.frame.up_axis[0].value]) for role in roles}
    gap = how.gap * float(max(lines.size))
    room = margin = 0.0
    if how.dimensions is not None:
        margin = how.dimensions.reach(_ROWS)
        room = margin + _TEXT_PX + (2.0 * _TEXT_PX if how.captions else 0.0)
        gap *= _CLOSER
    # px per mm: columns, or rows, with a gap in mm and room in px between them fill the sheet.
    scale = min(
        (_USED * side - 2.0 * margin - (len(extents) - 1) * room)
        / (sum(extents.values()) + (len(extents) - 1) * gap)
        for side, extents in ((how.width, wide), (how.height, high))
    )
    style = SheetStyle(
        width=how.width,
        height=how.height,
        margin=0.0,
        view_gap=scale * gap + room,
        mm_per_pixel=1.0 / scale,
    )
    places = place_views(lines.size, roles, projection, style)
    return tuple(drawn_view(place, lines.views[place.role]) for place in places), scale


def _outer_sides(view: DrawnView, views: Sequence[DrawnView]) -> tuple[int, int]:
    """Where a view's level and upright dimensions stand: 1 for below and right, -1 else."""
    lowest = all(view.box[3] >= other.box[3] - 1.0 for other in views)
    rightmost = all(view.box[2] >= other.box[2] - 1.0 for other in views)
    return (1 if lowest else -1), (1 if rightmost else -1)


def _hidden_first(strokes: Sequence[DrawnStroke]) -> list[DrawnStroke]:
    return sorted(strokes, key=lambda stroke: stroke.linetype is not Linetype.HIDDEN)


def _path(stroke: DrawnStroke, how: Conventions) -> str:
    """SVG of a stroke."""
    points = (
        np.array([stroke.start, stroke.end])
        if isinstance(stroke, Segment)
        else stroke.sample(stroke.length / _CHORDS)
    )
    chain = " ".join(f"{x:.2f},{y:.2f}" for x, y in points)
    look = f'stroke="black" stroke-width="{how.visible}" stroke-linecap="{how.cap}"'
    if stroke.linetype is Linetype.HIDDEN:
        grey, (dash, gap) = how.grey, how.dash
        look = (
            f'stroke="rgb({grey},{grey},{grey})" stroke-width="{how.hidden}" '
            f'stroke-dasharray="{dash:.1f},{gap:.1f}"'
        )
    return f'<polyline fill="none" {look} points="{chain}"/>'


def _caption(text: str, x: float, y: float) -> str:
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" font-size="{_TEXT_PX}" text-anchor="middle" '
        f'font-family="DejaVu Sans, sans-serif">{escape(text)}</text>'
    )
