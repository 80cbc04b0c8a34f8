"""What ink stands for where the network is missing: writing by its size, all else undecided.

The widths of lines, the frame and the ends of lines still tell what they can
(:mod:`.pen_widths`, :mod:`.line_relations`).
"""

import cv2
import numpy as np

from gaussiancad_core.sheet.image.inked_sheet import CleanSheet
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.labels_network import InkLabels
from gaussiancad_core.sheet.labels.writing_lines import written_groups
from gaussiancad_core.sheet.log_odds import IMPOSSIBLE

_LETTER = (3.0, 14.0)
"""Size of a letter, in stroke widths."""

_LINE = {
    InkClass.VISIBLE: 0.4,
    InkClass.HIDDEN: 0.2,
    InkClass.DIMENSION: 0.25,
    InkClass.CENTRE: 0.1,
    InkClass.TEXT: 0.05,
}
"""Probabilities of what a line is of which nothing is known: in doubt until a pen tells it."""

_DASH = {InkClass.HIDDEN: 0.5, InkClass.VISIBLE: 0.2, InkClass.CENTRE: 0.2, InkClass.TEXT: 0.1}
"""The same of a short piece of ink that stands by itself."""

_WRITING = {InkClass.TEXT: 0.96, InkClass.VISIBLE: 0.02, InkClass.HIDDEN: 0.02}
"""The same of ink that stands like writing."""


def plain_labels(sheet: CleanSheet) -> InkLabels:
    """What ink stands for by the sizes of its pieces.

    Args:
        sheet: upright.
    """
    _, pieces, stats, _ = cv2.connectedComponentsWithStats(
        sheet.ink.astype(np.uint8), connectivity=8
    )
    sizes = stats[1:, [cv2.CC_STAT_WIDTH, cv2.CC_STAT_HEIGHT]].max(axis=1) / sheet.stroke_width
    letters = 1 + np.flatnonzero((sizes >= _LETTER[0]) & (sizes <= _LETTER[1]))
    x, y, width, height = stats[letters, :4].T.astype(float)
    boxes = list(zip(x, y, x + width, y + height, strict=True))
    words = np.zeros(len(stats), bool)
    for group in written_groups(boxes):
        words[letters[group]] = len(group) > 1
    log_p = np.full((len(InkClass), *sheet.ink.shape), IMPOSSIBLE, np.float16)
    short = np.concatenate([[False], sizes <= _LETTER[1]]) & ~words
    written, dashes = words[pieces], short[pieces]
    kinds = ((~written & ~dashes, _LINE), (dashes, _DASH), (written, _WRITING))
    for where, shares in kinds:
        for ink, share in shares.items():
            log_p[ink][where] = np.log(share)
    return InkLabels(log_p, is_learnt=False)
