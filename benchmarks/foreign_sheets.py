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
import numpy.typing as npt
import resvg_py
from PIL import Image

from gaussiancad_core.axes import Role
from gaussiancad_core.drawing.sheet import PartLines
from gaussiancad_core.drawing.strokes import DrawnStroke, extent
from gaussiancad_core.views import Linetype, Segment

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

Floats = npt.NDArray[np.float64]


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

    @classmethod
    def drawn_by_lot(cls, seed: int) -> "Conventions":
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
        )


def foreign_sheet(lines: PartLines, how: Conventions) -> bytes:
    """A PNG of the front, top and right view of a part, in third angle.

    Args:
        lines: of these views at least.
        how: it looks.
    """
    x, y, z = (float(value) for value in lines.size)
    gap = how.gap * max(x, y, z)
    scale = _USED * min(how.width / (x + gap + y), how.height / (z + gap + y))
    left = (how.width - scale * (x + gap + y)) / 2.0
    top = (how.height - scale * (z + gap + y)) / 2.0
    below, beside = top + scale * (y + gap), left + scale * (x + gap)
    places = {
        Role.TOP: (left, top, x, y),
        Role.FRONT: (left, below, x, z),
        Role.RIGHT: (beside, below, y, z),
    }
    body: list[str] = []
    for role, (left_px, top_px, wide, high) in places.items():
        strokes = lines.views[role]
        low = extent(strokes)[0]
        origin = np.array([left_px, top_px + scale * high])
        body += _paths(strokes, low, (origin, scale), how)
        if how.captions:
            middle = left_px + scale * wide / 2.0
            body.append(_caption(f"{role.value.upper()} VIEW", middle, origin[1] + 1.7 * _TEXT_PX))
    if how.frame:
        body.append(
            f'<rect x="12" y="12" width="{how.width - 24}" height="{how.height - 24}" '
            f'fill="none" stroke="black" stroke-width="{how.visible}"/>'
        )
    picture = (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{how.width}" height="{how.height}">'
        f'<rect width="{how.width}" height="{how.height}" fill="white"/>{"".join(body)}</svg>'
    )
    drawn = Image.open(BytesIO(bytes(resvg_py.svg_to_bytes(svg_string=picture))))
    png = BytesIO()
    drawn.convert("L").save(png, "PNG")
    return png.getvalue()


def _paths(
    strokes: Sequence[DrawnStroke], low: Floats, place: tuple[Floats, float], how: Conventions
) -> list[str]:
    """SVG of a view's strokes, the hidden ones below the others."""
    origin, scale = place
    found = []
    for stroke in sorted(strokes, key=lambda own: own.linetype is not Linetype.HIDDEN):
        points = (
            np.array([stroke.start, stroke.end])
            if isinstance(stroke, Segment)
            else stroke.sample(stroke.length / _CHORDS)
        )
        x, y = (scale * (points - low) * (1.0, -1.0) + origin).T
        chain = " ".join(f"{a:.2f},{b:.2f}" for a, b in zip(x, y, strict=True))
        look = f'stroke="black" stroke-width="{how.visible}" stroke-linecap="{how.cap}"'
        if stroke.linetype is Linetype.HIDDEN:
            grey, (dash, gap) = how.grey, how.dash
            look = (
                f'stroke="rgb({grey},{grey},{grey})" stroke-width="{how.hidden}" '
                f'stroke-dasharray="{dash:.1f},{gap:.1f}"'
            )
        found.append(f'<polyline fill="none" {look} points="{chain}"/>')
    return found


def _caption(text: str, x: float, y: float) -> str:
    return (
        f'<text x="{x:.1f}" y="{y:.1f}" font-size="{_TEXT_PX}" text-anchor="middle" '
        f'font-family="DejaVu Sans, sans-serif">{escape(text)}</text>'
    )
