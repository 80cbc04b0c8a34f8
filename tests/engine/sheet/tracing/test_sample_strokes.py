"""Drawn parts: every stroke is read as one stroke, to a fraction of a pixel."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from engine.sheet.layouts_drawn import drawn_layout
from OCP.TopoDS import TopoDS_Shape

from gaussiancad_core.drawing.drawn_sheet import compose_sheet, draw_sheet, part_lines
from gaussiancad_core.drawing.sheet_style import PRESETS
from gaussiancad_core.lines.strokes import as_plain_strokes
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.model.views import Arc, Linetype, Stroke
from gaussiancad_core.recognition.picture_views import picture_views
from gaussiancad_core.sheet.image.clean_ink import clean_sheet
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.sheet_stages import read_views
from sample_parts.classed import PartClass, classed_part

Read = Callable[..., Any]
Differences = Callable[..., list[str]]
Grey = Callable[[np.ndarray], np.ndarray]

VIEWS = Role.FRONT, Role.TOP, Role.RIGHT

CASES = [
    ("l-bracket", "clean", "front,top,right", "third"),
    ("three-axis-block", "thin", "front,top,left", "first"),
    ("slotted-link", "thick", "front,top,right", "third"),
    ("dovetail-block", "iso", "front,bottom,left", "third"),
    ("pulley", "clean", "front,top,right", "third"),
    ("boss-plate", "even", "front,bottom,left", "third"),
    ("filleted-block", "binary", "front,top,left", "first"),
    ("bored-plate", "clean", "front,top,right", "third"),
    ("counterbored-block", "clean", "front,top,right", "third"),
    ("rib-bracket", "thin", "front,top,right", "third"),
    ("vee-block", "clean", "front,top,right", "third"),
    # A hidden line goes on where a visible one ends, its first dash without a gap before it.
    ("stepped-block", "iso", "front,bottom,left", "third"),
    # Dashes across dashes.
    ("three-axis-block", "clean", "front,top,left", "first"),
    # Two arcs of one radius that tangents join.
    ("slotted-link", "clean", "front,bottom,left", "third"),
    ("chamfered-block", "iso", "front,top,left", "first"),
    ("countersunk-plate", "even", "front,top,right", "third"),
    # A bore that leans: its rims are ellipses, one of them hidden.
    ("angled-bore-block", "clean", "front,top,right", "third"),
]


@pytest.mark.parametrize("case", CASES, ids="-".join)
def test_every_stroke_is_read_as_one_stroke(
    read: Read, differences: Differences, case: tuple[str, ...]
) -> None:
    result = read(*case)
    # Without grey edges a line lies up to half a pixel beside its place.
    within, of_box = (0.6, 0.5) if case[1] == "binary" else (0.4, 0.1)
    for view in result.views:
        drawn = result.drawn[view.role]
        assert differences(as_plain_strokes(drawn.strokes), view.strokes, within) == []
        assert view.box == pytest.approx(drawn.box, abs=of_box)


def _view(part: TopoDS_Shape, role: Role, grey: Grey) -> tuple[list[Stroke], list[Stroke]]:
    """The strokes of a part's view as they were drawn, and as read from a clean sheet."""
    sheet = draw_sheet(part, VIEWS, Projection.THIRD, PRESETS["clean"])
    clean = clean_sheet(grey(sheet.image))
    layout = drawn_layout(sheet, clean)
    found = next(view for view in read_views(clean, layout) if view.role is role)
    drawn = next(view for view in sheet.views if view.role is role)
    return list(as_plain_strokes(drawn.strokes)), list(found.strokes)


@pytest.mark.parametrize(
    ("kind", "seed", "level", "role"),
    [
        # A flat under a shaft's chamfer: at either end two dashes meet at a flat angle.
        (PartClass.REVOLVED, 700, 0, Role.TOP),
        # Edges cross the dashes that lead to the ends of hidden arcs.
        (PartClass.FILLETS, 10, 3, Role.RIGHT),
        # They would touch the rest of their circles.
        (PartClass.REVOLVED, 16, 2, Role.TOP),
        # Bores under a stepped plate: edges, pockets and slots run through their dashes.
        (PartClass.HOLES, 3, 3, Role.TOP),
        # The dashes of a slot's round ends go on in those of its sides; a boss crosses them.
        (PartClass.HOLES, 313, 5, Role.TOP),
    ],
)
def test_hidden_arcs_that_other_strokes_cross(  # noqa: PLR0917
    grey: Grey, differences: Differences, kind: PartClass, seed: int, level: int, role: Role
) -> None:
    drawn, found = (
        [s for s in strokes if isinstance(s, Arc) and s.linetype is Linetype.HIDDEN]
        for strokes in _view(classed_part(kind, seed, level), role, grey)
    )
    assert drawn
    assert not [text for text in differences(drawn, found, 0.7) if text.startswith("not read")]


def test_a_line_that_was_seen_in_an_arc_has_no_fillet_of_its_own() -> None:
    """The top view has two quarters of 15 px; in one of them eight px were taken for straight."""
    lines = part_lines(classed_part(PartClass.FILLETS, 4004, 0), VIEWS)
    look = PRESETS["clean"]
    drawn = compose_sheet(lines, Projection.THIRD, look, 4004, title="FILLETS-4004")
    grey = drawn.image.mean(axis=2) if drawn.image.ndim == 3 else drawn.image
    image = SheetImage(Path("sheet.png"), grey.astype(np.uint8), "")
    seen = picture_views(OpenedSheet(image), {}, Projection.THIRD)
    views = {view.role: view.strokes for view in read_views(seen.separated.part, seen.layout)}
    arcs = [stroke for stroke in views[Role.TOP] if isinstance(stroke, Arc)]
    assert [arc.radius for arc in arcs] == pytest.approx([15.09, 15.09], abs=0.15)
    assert [arc.sweep for arc in arcs] == pytest.approx([np.pi / 2] * 2, abs=0.02)
    assert min(stroke.length for stroke in views[Role.TOP]) > 20.0
