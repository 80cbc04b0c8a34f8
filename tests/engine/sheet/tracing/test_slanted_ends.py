"""Hidden lines end in the corners that slanted ones leave, and short ones are found."""

from dataclasses import replace

import numpy as np
import pytest

from gaussiancad_core.drawing.degrade import finished
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.drawing.stroke_raster import rasterise
from gaussiancad_core.model.views import Linetype, Segment, Stroke
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.tracing.ink_strokes import classify_strokes
from gaussiancad_core.sheet.tracing.view_shapes import find_shapes, view_rhythm

Point = tuple[float, float]

V, H = Linetype.VISIBLE, Linetype.HIDDEN


def _read(strokes: list[Stroke]) -> list[Stroke]:
    """The hidden strokes of a framed drawing."""
    style = replace(PRESETS["clean"], width=400, height=280)
    corners = [(60.0, 50.0), (340.0, 50.0), (340.0, 220.0), (60.0, 220.0)]
    frame = [
        Segment(one, other, V)
        for one, other in zip(corners, [*corners[1:], corners[0]], strict=True)
    ]
    image = finished(rasterise((*frame, *strokes), style), style, 0)
    sheet = clean_sheet(image.mean(axis=2).astype(np.uint8) if image.ndim == 3 else image)
    view = find_shapes(sheet, (50.0, 40.0, 350.0, 230.0))
    found = classify_strokes(view, view_rhythm([view], sheet.stroke_width))
    return [stroke for stroke in found if stroke.linetype is H]


def _are(found: list[Stroke], wanted: list[Stroke], slack: float) -> bool:
    """Whether each stroke is one of those wanted, and the other way round."""

    def alike(one: Stroke, other: Stroke) -> bool:
        ends = [np.asarray(item.sample(1e9))[[0, -1]] for item in (one, other)]
        return min(np.abs(ends[0] - ends[1]).max(), np.abs(ends[0] - ends[1][::-1]).max()) < slack

    return len(found) == len(wanted) and all(any(alike(f, w) for w in wanted) for f in found)


@pytest.mark.parametrize("deep", [6.3, 7.0, 8.1])
def test_a_shallow_step_behind_an_edge(deep: float) -> None:
    """Its sides are shorter than a dash: all their ink is one piece."""
    y = 50.0 + deep
    step = [
        Segment((120.4, y), (263.7, y), H),
        Segment((120.4, 50.0), (120.4, y), H),
        Segment((263.7, 50.0), (263.7, y), H),
    ]
    assert _are(_read(step), step, 1.0)


@pytest.mark.parametrize("deep", [13.5, 14.3, 15.5])
def test_an_edge_that_goes_on_hidden_down_to_a_corner(deep: float) -> None:
    """A visible edge ends above it: what is drawn below is no dash of that."""
    y = 130.3 + deep
    above = [Segment((60.0, 130.3), (340.0, 130.3), V), Segment((200.4, 50.0), (200.4, 130.3), V)]
    below = [Segment((60.0, y), (200.4, y), H), Segment((200.4, 130.3), (200.4, y), H)]
    assert _are(_read([*above, *below]), below, 1.0)
