"""The views of a picture: its ink labelled by the network, its words read, its figures named."""

from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt

from gaussiancad_core.axes import Projection, Role
from gaussiancad_core.errors import NoModelError
from gaussiancad_core.sheet.annotations.separate import SeparatedSheet
from gaussiancad_core.sheet.clean import CleanSheet
from gaussiancad_core.sheet.deskew import Turn
from gaussiancad_core.sheet.labels.network import ink_labels
from gaussiancad_core.sheet.labels.separation import separate_by_labels
from gaussiancad_core.sheet.layout import Layout
from gaussiancad_core.sheet.notes.captions import captions_of
from gaussiancad_core.sheet.options import Box
from gaussiancad_core.sheet.read import SheetImage
from gaussiancad_core.sheet.scale.find import WrittenSheet, read_texts
from gaussiancad_core.sheet.special_views.finding import LayoutRequest
from gaussiancad_core.sheet.special_views.symbol import find_symbol
from gaussiancad_core.sheet.view_search import STUB, arranged, lone_view, with_symbol


@dataclass(frozen=True, eq=False)
class PictureViews:
    """What was found on a picture.

    Attributes:
        separated: the part's ink, and the annotations.
        layout: where the views are.
        written: the texts; they are read before the views, as captions name these.
    """

    separated: SeparatedSheet
    layout: Layout
    written: WrittenSheet


def picture_views(
    image: SheetImage, sheet: CleanSheet, given: dict[Role, Box], projection: Projection | None
) -> PictureViews:
    """Label a picture's ink and find its views.

    Args:
        image: as stored.
        sheet: the same, upright.
        given: boxes that the user named, in px of the upright sheet.
        projection: as told by the user, or nothing: then captions tell it, or the sheet's symbol.

    Raises:
        NoModelError: there are fewer than two views that belong together, and not one alone.
        UsageError: a given box holds no ink.
    """
    separated = separate_by_labels(sheet, ink_labels(_upright(image.grey, sheet.turn)))
    written = read_texts(image, sheet, separated.marks)
    symbol = find_symbol(sheet) if projection is None else None
    told = symbol.projection if symbol else projection
    request = LayoutRequest(
        given,
        told,
        STUB * separated.part.stroke_width,
        captions=() if given else captions_of(written.texts),
    )
    try:
        found = arranged(sheet, separated, request)
    except NoModelError as error:
        alone = None
        if error.code == "one-view" and not given:
            alone = lone_view(sheet, separated, replace(request, captions=()))
        if alone is None:
            raise
        found = alone
    return PictureViews(*with_symbol(*found, symbol), written)


def _upright(grey: npt.NDArray[np.uint8], turn: Turn) -> npt.NDArray[np.uint8]:
    """(h, w) the picture as it was stored, turned level."""
    if not turn.angle:
        return grey
    ink = turn.upright(1.0 - grey.astype(np.float32) / 255.0)
    return np.rint(255.0 * (1.0 - ink)).astype(np.uint8)
