"""A sheet whose only drawing is a pictorial: it illustrates, and tells no measures."""

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.messages import boxes_of
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.drawing_names import inside, special_kind
from gaussiancad_core.sheet.special_views.view_kinds import SpecialKind
from gaussiancad_core.sheet.views.sheet_layout import find_clusters
from gaussiancad_protocol.codes import Code


def as_pictorial(error: NoModelError, separated: SeparatedSheet) -> NoModelError:
    """Why a sheet has no views that belong together: that it has a pictorial alone, where no group
    of lines lies beside one; else the same error.

    Args:
        error: with the boxes of the groups that might be views, px of the upright sheet.
        separated: the sheet without annotations.
    """
    found = _pictorials(separated)
    groups = boxes_of(error.message)
    if not found or not all(any(inside(box, pair) for pair in found) for box in groups):
        return error
    places = "; ".join("({:.0f}, {:.0f})-({:.0f}, {:.0f})".format(*box) for box in found)
    return NoModelError(
        Code.PICTORIAL_ALONE,
        "the sheet shows the part in a pictorial view alone, at {places} px, from which no "
        "measures follow: add or export views at right angles, such as front, top and side",
        boxes=found,
        places=places,
    )


def _pictorials(separated: SeparatedSheet) -> list[Box]:
    if separated.askew is None or separated.strokes_known is None:
        return []
    boxes = find_clusters(separated.askew)
    return [
        box for box in boxes if special_kind(separated.strokes_known, box) is SpecialKind.PICTORIAL
    ]
