"""The ink that is writing: told before lines are followed, as letters are full of short ones.

What is taken for writing is followed no more, so that it has to be sure: by itself, or by the
letters in one line with it.
"""

import cv2
import numpy as np
import numpy.typing as npt

from gaussiancad_core.sheet.annotations.annotation_marks import Mask
from gaussiancad_core.sheet.labels.ink_classes import InkClass
from gaussiancad_core.sheet.labels.labels_network import InkLabels, part_odds
from gaussiancad_core.sheet.labels.writing_lines import written_groups
from gaussiancad_core.sheet.log_odds import SURE
from gaussiancad_core.sheet.votes import HALF


def writing_ink(ink: Mask, labels: InkLabels) -> Mask:
    """(h, w) bool, ink that is writing.

    Args:
        ink: (h, w) bool.
        labels: of the same picture.
    """
    written = _writing(ink, labels.best())
    count, numbered, stats, _ = cv2.connectedComponentsWithStats(
        written.astype(np.uint8), connectivity=8
    )
    if count == 1:
        return written
    pieces = np.asarray(numbered, dtype=np.int32)
    sure = _mean_odds(pieces, labels, count) <= -SURE
    x, y, width, height = stats[1:, :4].T.astype(float)
    boxes = list(zip(x, y, x + width, y + height, strict=True))
    kept = np.zeros(count, bool)
    for group in written_groups(boxes):
        numbers = np.array(group) + 1
        kept[numbers] = sure[numbers].any()
    return kept[pieces]


def _writing(ink: Mask, best: npt.NDArray[np.uint8]) -> Mask:
    """All of a piece of ink of which most is, else by the pixel."""
    item = ink & (best == InkClass.TEXT)
    count, labels = cv2.connectedComponents(ink.astype(np.uint8), connectivity=8)
    sizes = np.bincount(labels.ravel(), minlength=count)
    inside = np.bincount(labels[item], minlength=count)
    most = inside > HALF * sizes
    most[0] = False
    return most[labels] | item


def _mean_odds(
    pieces: npt.NDArray[np.int32], labels: InkLabels, count: int
) -> npt.NDArray[np.float64]:
    """(count,) mean log-odds of the part in the pixels of each piece."""
    rows, columns = np.nonzero(pieces)
    numbers = pieces[rows, columns]
    odds = part_odds(labels.at(np.stack([columns, rows], axis=1).astype(np.float64)))
    sizes = np.bincount(numbers, minlength=count)
    return np.bincount(numbers, weights=odds, minlength=count) / np.maximum(sizes, 1)
