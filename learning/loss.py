"""What training makes small: how unlikely the network finds the truth, rare things counting more.

Paper is most of a sheet and easy, hidden lines are rare and matter: each class has a weight.  What
lies beside known ink counts little for the two extra outputs, and what is not known for nothing.
"""

import torch
from torch import Tensor
from torch.nn import functional

from gaussiancad_core.sheet.labels.ink_classes import PART, InkClass
from learning.training_samples import (
    EITHER,
    HEAT_MOST,
    HEAT_SHIFT,
    ON_HIDDEN,
    SOME_ANNOTATION,
    UNKNOWN,
)

_WEIGHTS = {
    InkClass.PAPER: 0.12,
    InkClass.VISIBLE: 1.0,
    InkClass.HIDDEN: 2.0,
    InkClass.CENTRE: 2.0,
    InkClass.DIMENSION: 1.2,
    InkClass.HATCHING: 0.8,
    InkClass.TEXT: 0.6,
    InkClass.FRAME: 0.8,
    InkClass.PICTORIAL: 1.0,
    InkClass.OTHER: 1.5,
    InkClass.THIN: 1.5,
}
"""Weight of a pixel of each class; that of some annotation is 1."""

_EXTRA = 0.4
"""Weight of each of the extra outputs beside the classes."""

_BESIDE = 0.06
"""Weight of a blank pixel for the extra outputs; that of an inked one is 1."""

_TRACK, _CORNER = 2.0, 6.0
"""What a pixel on a hidden line, and one at a corner, count more for their own output."""


def labels_loss(logits: Tensor, classes: Tensor, extra: Tensor) -> Tensor:
    """The loss of a batch, a number.

    Args:
        logits: (n, classes + 2, h, w) of the network.
        classes: (n, h, w) uint8, as in :class:`.Sample`.
        extra: (n, h, w) uint8, likewise.
    """
    logits = logits.float()
    track, corner = logits[:, len(InkClass)], logits[:, len(InkClass) + 1]
    ink = ((classes > InkClass.PAPER) & (classes != UNKNOWN)).float()
    return (
        _of_classes(logits[:, : len(InkClass)], classes)
        + _EXTRA * _of_tracks(track, extra, ink)
        + _EXTRA * _of_corners(corner, extra, ink)
    )


def _of_classes(logits: Tensor, classes: Tensor) -> Tensor:
    """Cross entropy; where only annotation is known, the kinds of it count together."""
    log_p = functional.log_softmax(logits, 1)
    plain = torch.where(classes < len(InkClass), classes, 0).long()
    cost = -log_p.gather(1, plain[:, None])[:, 0]
    some = -torch.logsumexp(log_p[:, max(PART) + 1 :], 1)
    cost = torch.where(classes == SOME_ANNOTATION, some, cost)
    return _mean(cost, _class_weights(classes.device)[classes.long()])


def _of_tracks(logits: Tensor, extra: Tensor, ink: Tensor) -> Tensor:
    """Cross entropy of lying on a hidden line, on a dash or between two."""
    truth = ((extra & EITHER) == ON_HIDDEN).float()
    counts = ((extra != UNKNOWN) & ((extra & EITHER) != EITHER)).float()
    cost = functional.binary_cross_entropy_with_logits(logits, truth, reduction="none")
    return _mean(cost, counts * (_BESIDE + ink + _TRACK * truth))


def _of_corners(logits: Tensor, extra: Tensor, ink: Tensor) -> Tensor:
    """Cross entropy with the heat of corners, 0 to 1."""
    heat = (extra >> HEAT_SHIFT).clamp(max=HEAT_MOST).float() / HEAT_MOST
    counts = (extra != UNKNOWN).float()
    cost = functional.binary_cross_entropy_with_logits(logits, heat, reduction="none")
    return _mean(cost, counts * (_BESIDE + ink + _CORNER * heat))


def _class_weights(device: torch.device) -> Tensor:
    """(256,) weight of a pixel by its class."""
    weights = torch.zeros(256)
    weights[SOME_ANNOTATION] = 1.0
    for ink, weight in _WEIGHTS.items():
        weights[ink] = weight
    return weights.to(device)


def _mean(cost: Tensor, weights: Tensor) -> Tensor:
    return (cost * weights).sum() / weights.sum().clamp(min=1.0)
