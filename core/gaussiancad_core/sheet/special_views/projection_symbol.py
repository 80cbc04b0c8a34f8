"""The projection symbol of a sheet: by the strokes of its file, else in its picture."""

from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol, largest_symbol
from gaussiancad_core.sheet.special_views.symbol_strokes import stroke_symbol


def find_symbol(sheet: OpenedSheet, *, pictured: bool = False) -> ProjectionSymbol | None:
    """Find the projection symbol of a sheet; nothing where there is none, or several disagree.

    Args:
        sheet: with frame and title block.
        pictured: whether the picture of a file counts that tells its strokes: what it shows besides
            these may show the symbol.
    """
    image = sheet.image
    drawing = image.vectors
    on_paper = image.pixels_per_inch is not None and (drawing is None or drawing.has_paper)
    largest = largest_symbol(sheet.shape, image.pixels_per_inch if on_paper else None)
    if drawing is not None and drawing.strokes and not sheet.turn.angle:
        found = stroke_symbol(drawing, largest)
        if found is not None or not pictured or drawing.complete:
            return found
    # What reads pixels is compiled: a sheet whose strokes tell its symbol waits for none of it.
    from gaussiancad_core.sheet.special_views.symbol_pixels import pixel_symbol

    return pixel_symbol(sheet.clean, largest)
