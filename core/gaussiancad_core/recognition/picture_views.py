"""The views of a picture: its ink labelled by the network, its words read, its figures named."""

from dataclasses import dataclass, replace

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.errors import NoModelError
from gaussiancad_core.messages import Message
from gaussiancad_core.model.axes import Projection, Role
from gaussiancad_core.recognition.picture_layout import Stated, picture_layout
from gaussiancad_core.sheet.annotations.annotation_marks import values_at
from gaussiancad_core.sheet.annotations.separated_ink import SeparatedSheet
from gaussiancad_core.sheet.image.deskew import Turn
from gaussiancad_core.sheet.image.opened_sheet import OpenedSheet
from gaussiancad_core.sheet.image.sheet_files import SheetImage
from gaussiancad_core.sheet.image.working_scale import resampled, working_factor
from gaussiancad_core.sheet.labels.labelled_ink import separate_by_labels
from gaussiancad_core.sheet.labels.labels_network import InkLabels, ink_labels, labels_problem
from gaussiancad_core.sheet.labels.plain_labels import plain_labels
from gaussiancad_core.sheet.reading_options import Box
from gaussiancad_core.sheet.special_views.pictorial_alone import as_pictorial
from gaussiancad_core.sheet.special_views.symbol_shape import ProjectionSymbol
from gaussiancad_core.sheet.views.sheet_layout import Layout
from gaussiancad_core.writing.sheet_scale import read_texts
from gaussiancad_core.writing.sheet_texts import SheetText
from gaussiancad_protocol.codes import Code

_MOST_PIECES = 15_000
"""Pieces of ink of a sheet: crowded screenshots and scans have 3,000, letters among them."""


@dataclass(frozen=True, eq=False)
class PictureViews:
    """What was found on a picture.

    Attributes:
        separated: the part's ink, and the annotations.
        layout: where the views are.
        texts: all that is written; they are read before the views, as captions name these.
        problem: why the picture was read without the network; None where it was not.
    """

    separated: SeparatedSheet
    layout: Layout
    texts: tuple[SheetText, ...]
    problem: Message | None = None


def picture_views(
    sheet: OpenedSheet,
    given: dict[Role, Box],
    projection: Projection | None,
    symbol: ProjectionSymbol | None = None,
) -> PictureViews:
    """Label a picture's ink and find its views.

    Args:
        sheet: as stored and upright.
        given: boxes that the user named, in px of the upright sheet.
        projection: as told by the user, or nothing: then captions tell it, or the sheet's symbol.
        symbol: of the sheet, where it was looked for and found.

    Raises:
        NoModelError: there are fewer than two views that belong together, and not one alone; or
            ``part-too-complex``, there are more pieces of ink than any drawing has.
        UsageError: a given box holds no ink.
    """
    problem = labels_problem()
    clean = sheet.clean
    _check_pieces(clean.ink)
    labels = _labels(sheet.image, sheet.turn) if problem is None else plain_labels(clean)
    seen = replace(clean, hidden_odds=labels.hidden_odds()) if problem is None else clean
    separated = separate_by_labels(seen, labels, _upright_tint(sheet.image.tint, sheet.turn))
    texts = read_texts(sheet, separated.marks)
    try:
        found = picture_layout(sheet, separated, Stated(given, projection, symbol, texts))
    except NoModelError as error:
        raise as_pictorial(error, separated) from error
    return PictureViews(*_with_symbol(*found, symbol), texts, problem)


def _with_symbol(
    separated: SeparatedSheet, layout: Layout, symbol: ProjectionSymbol | None
) -> tuple[SeparatedSheet, Layout]:
    """The same with the place of the projection symbol, where there is one."""
    if symbol is None:
        return separated, layout
    return replace(separated, marks=(*separated.marks, symbol.mark)), layout


def _check_pieces(ink: npt.NDArray[np.bool_]) -> None:
    """Refuse before they are labelled, and each followed, more strokes than any drawing has.

    Raises:
        NoModelError: ``part-too-complex``.
    """
    count = cv2.connectedComponents(ink.astype(np.uint8), connectivity=8)[0] - 1
    if count > _MOST_PIECES:
        raise NoModelError(
            Code.PART_TOO_COMPLEX,
            "the sheet has {count:,} separate strokes, at most {most:,} are followed: draw less in "
            "one sheet, or cut the views out of it",
            case="pieces",
            count=count,
            most=_MOST_PIECES,
        )


def _labels(image: SheetImage, turn: Turn) -> InkLabels:
    """The labels of a sheet's pixels; the picture of a file is labelled at working scale."""
    grey = _upright(image.grey, turn)
    factor = working_factor(grey) if image.vectors is not None else 1.0
    if factor == 1.0:
        return ink_labels(grey)
    height, width = grey.shape
    seen = ink_labels(resampled(grey, (round(width * factor), round(height * factor))))
    return seen.at_size(width, height)


def _upright_tint(tint: npt.NDArray[np.uint8] | None, turn: Turn) -> npt.NDArray[np.uint8] | None:
    """The colours of a picture turned level: each pixel that of the nearest one."""
    if tint is None or not turn.angle:
        return tint
    height, width = tint.shape
    columns, rows = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    level = replace(turn, scale=1.0)
    stored = level.to_stored(np.stack([columns.ravel(), rows.ravel()], axis=1)) - 0.5
    return np.asarray(values_at(tint, stored).reshape(height, width), dtype=np.uint8)


def _upright(grey: npt.NDArray[np.uint8], turn: Turn) -> npt.NDArray[np.uint8]:
    """(h, w) the picture as it was stored, turned level."""
    if not turn.angle:
        return grey
    ink = turn.upright(1.0 - grey.astype(np.float32) / 255.0)
    return np.rint(255.0 * (1.0 - ink)).astype(np.uint8)
