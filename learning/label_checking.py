"""How much of the ink of sheets a network takes for what it is."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np
import numpy.typing as npt
import torch

from gaussiancad_core.sheet.labels.ink_classes import PART, InkClass
from learning.published import PublishedSheet
from learning.training_samples import UNKNOWN, Bytes
from learning.unet import LabelsNetwork

KINDS = ("visible", "hidden", "annotation")
"""What is told apart."""

FACTORS = (1.0, 0.6, 0.4)
"""By which a sheet is made smaller, and brought back, before it is labelled."""

ALL = "all"
"""Source of the sums over all sources."""

_MULTIPLE = 32
"""Px that the sides of what the network takes are multiples of."""


@dataclass(frozen=True)
class Figure:
    """How the ink of a source's sheets was taken.

    Attributes:
        source: of the sheets.
        factor: by which they had been made smaller.
        px: three rows of three counts: of the pixels of each of :data:`KINDS`, how many were taken
            for each.
        precision: share of what was taken for a kind that is of it; None where nothing was.
        recall: share of what is of a kind that was taken for it; None where nothing is.
    """

    source: str
    factor: float
    px: tuple[tuple[int, int, int], tuple[int, int, int], tuple[int, int, int]]
    precision: dict[str, float | None]
    recall: dict[str, float | None]


def figure_of(source: str, factor: float, px: npt.NDArray[np.int64]) -> Figure:
    """The figure that counts (3, 3) give."""
    right = px.diagonal()
    first, second, third = ((int(a), int(b), int(c)) for a, b, c in px.tolist())
    return Figure(
        source,
        factor,
        (first, second, third),
        _shares(right, px.sum(axis=0)),
        _shares(right, px.sum(axis=1)),
    )


def figures_of(
    network: LabelsNetwork,
    sheets: Sequence[PublishedSheet],
    device: torch.device,
    factors: Iterable[float] = FACTORS,
) -> tuple[Figure, ...]:
    """Label sheets at several factors; by source and over all of them.

    Args:
        network: on the device, in its mode of use.
        sheets: with the truth.
        device: where.
        factors: by which they are made smaller.
    """
    found = []
    for factor in factors:
        sums: defaultdict[str, npt.NDArray[np.int64]] = defaultdict(
            lambda: np.zeros((3, 3), np.int64)
        )
        for sheet in sheets:
            logits = logits_of(network, coarser(sheet.truth.grey, factor), device)
            px = _confusion(sheet.truth.classes, logits.argmax(axis=0))
            sums[sheet.source] += px
            sums[ALL] += px
        names = sorted(sums, key=lambda this_sum: (this_sum == ALL, this_sum))
        found += [figure_of(name, factor, sums[name]) for name in names]
    return tuple(found)


def coarser(grey: Bytes, factor: float) -> Bytes:
    """(h, w) a picture as it is when it was saved with fewer pixels and brought back."""
    if factor == 1.0:
        return grey
    small = cv2.resize(grey, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)
    again = cv2.resize(small, (grey.shape[1], grey.shape[0]), interpolation=cv2.INTER_CUBIC)
    return np.asarray(again, dtype=np.uint8)


def logits_of(network: LabelsNetwork, grey: Bytes, device: torch.device) -> npt.NDArray[np.float32]:
    """(classes, h, w) what a network says of a picture (h, w)."""
    height, width = grey.shape
    padding = ((0, -height % _MULTIPLE), (0, -width % _MULTIPLE))
    padded = np.pad(grey, padding, constant_values=255)
    ink = 1.0 - torch.from_numpy(padded).to(device)[None, None].float() / 255.0
    with torch.inference_mode():
        logits = network(ink.contiguous(memory_format=torch.channels_last))
    return logits[0, : len(InkClass), :height, :width].float().cpu().numpy()


def known_kinds(classes: Bytes) -> npt.NDArray[np.int64]:
    """(h, w) index in :data:`KINDS` of what is ink and known, else -1."""
    kinds = np.full(classes.shape, KINDS.index("annotation"))
    kinds[classes == InkClass.VISIBLE] = KINDS.index("visible")
    kinds[classes == InkClass.HIDDEN] = KINDS.index("hidden")
    kinds[(classes == InkClass.PAPER) | (classes == UNKNOWN)] = -1
    return kinds


def _confusion(classes: Bytes, best: npt.NDArray[np.int64]) -> npt.NDArray[np.int64]:
    """(3, 3) pixels of each kind by the kind that they are taken for; paper is taken for none of
    the part's, as annotation is."""
    true = known_kinds(classes)
    taken = np.where(np.isin(best, PART), best - min(PART), KINDS.index("annotation"))
    known = true >= 0
    return np.bincount(3 * true[known] + taken[known], minlength=9).reshape(3, 3)


def _shares(right: npt.NDArray[np.int64], of: npt.NDArray[np.int64]) -> dict[str, float | None]:
    return {
        kind: round(int(item) / int(all_), 4) if all_ else None
        for kind, item, all_ in zip(KINDS, right, of, strict=True)
    }
