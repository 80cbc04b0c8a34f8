"""Layouts of sheets that the engine drew itself."""

from gaussiancad_core.drawing.drawn_sheet import Sheet
from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.views.sheet_layout import Layout, view_clusters


def drawn_layout(sheet: Sheet, clean: CleanSheet) -> Layout:
    """Where the views were drawn, and where their ink is."""
    boxes = {}
    for view in sheet.views:
        x, y = (view.box[0] + view.box[2]) / 2.0, (view.box[1] + view.box[3]) / 2.0
        boxes[view.role] = next(
            box
            for box in view_clusters(clean.ink, 0.0)
            if box[0] <= x <= box[2] and box[1] <= y <= box[3]
        )
    return Layout(boxes, sheet.projection, "given", (), ())
